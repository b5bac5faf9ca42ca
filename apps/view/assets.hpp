// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// \file
/// The texts of the page, from the folder page/. The build makes their source.

namespace view::assets {

extern const std::string_view html;   ///< with a mark such as {{TITLE}} for each text that is filled in
extern const std::string_view css;    ///< style sheet
extern const std::string_view script; ///< all scripts of the page, in the order of their use

} // namespace view::assets
