// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include "ogive/io/write_error.hpp"

#include <cstdio>
#include <iostream>

namespace {

enum ExitStatus { success = 0, failure = 1, bad_input = 2, cannot_write = 3 };

int run(int argc, const char *const *argv) {
  using namespace section;
  const auto options = parse(argc, argv, std::cout);
  if (!options) return success;
  if (options->figure == Figure::panel) draw_panel(*options);
  if (options->figure == Figure::projectiles) draw_projectiles(*options);
  if (options->figure == Figure::mesh) draw_mesh(*options);
  return success;
}

int report(const std::exception &error, ExitStatus status) {
  std::fprintf(stderr, "section: error: %s\n", error.what());
  return status;
}

} // namespace

int main(int argc, char **argv) {
  try {
    return run(argc, argv);
  } catch (const ogive::SetupError &error) {
    return report(error, bad_input);
  } catch (const ogive::WriteError &error) {
    return report(error, cannot_write);
  } catch (const std::exception &error) {
    return report(error, failure);
  }
}
