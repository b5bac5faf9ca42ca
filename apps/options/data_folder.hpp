// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace options {

/// The folder of the tables and metals that come with the programs: beside an installed program, else that of the
/// sources.
std::filesystem::path data_folder();

} // namespace options
