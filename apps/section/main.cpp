// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include "shared/exit_status.hpp"

#include <iostream>

namespace {

int run(int argc, const char *const *argv) {
  using namespace section;
  const auto options = parse(argc, argv, std::cout);
  if (!options) return input::success;
  if (options->figure == Figure::panel) draw_panel(*options);
  if (options->figure == Figure::projectiles) draw_projectiles(*options);
  if (options->figure == Figure::mesh) draw_mesh(*options);
  return input::success;
}

} // namespace

int main(int argc, char **argv) {
  return input::run_main("section", [&] { return run(argc, argv); });
}
