// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "given.hpp"

/// \file
/// Flat TOML files: key = value, one a line.

namespace options {

/// Contents of a file of at most `most_mebibytes` MiB; a device such as /dev/zero has no end. Throws SetupError
/// "<what> = <name>: must be a <kind> file ...".
std::string text_of_file(const std::filesystem::path &name, const std::string &what, const std::string &kind = "TOML",
                         std::size_t most_mebibytes = 1);

/// The entries of TOML text, ordered by key. A number's value is its text in the file. Throws SetupError with
/// file and line for damaged text, and for text so deeply nested that it would overflow the stack; `example` is a line
/// that would be right.
std::vector<Given> toml_entries(std::string_view text, const std::string &file, const std::string &example);

/// Text as TOML writes it, in quotation marks.
std::string toml_string(std::string_view text);

} // namespace options
