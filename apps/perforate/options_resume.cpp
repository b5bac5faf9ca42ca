// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"
#include "options_material.hpp"
#include "saved_case.hpp"

#include "ogive/version.hpp"

#include <array>
#include <sstream>
#include <utility>

namespace perforate {

Options resumed(const Options &options) {
  const auto file = options.out / checkpoint_name;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored) || std::filesystem::exists(options.out / "summary.json", ignored))
    return options;
  try {
    const SavedCase saved = read_saved_case(file);
    if (saved.version != ogive::version || saved.metal_toml != metals_text(options, plates_of(options))) return options;
    const std::string name = file.string();
    const std::array arguments{"perforate", "--restart", name.c_str()};
    std::ostringstream none;
    Options left = parse(static_cast<int>(arguments.size()), arguments.data(), none).value();
    const auto restart = std::exchange(left.restart, std::nullopt);
    left.out = options.out;
    left.checkpoint_every_us = options.checkpoint_every_us;
    left.picture = options.picture;
    left.quiet = options.quiet;
    left.threads = options.threads;
    if (left != options) return options;
    left.restart = restart;
    return left;
  } catch (const ogive::SetupError &) {
    return options; // damaged, or of another program
  }
}

} // namespace perforate
