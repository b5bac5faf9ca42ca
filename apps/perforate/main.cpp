// SPDX-License-Identifier: BSD-3-Clause
#include "limit.hpp"
#include "mesh.hpp"
#include "run_case.hpp"

#include <iostream>
#include <string_view>

namespace {

int run(int argc, const char *const *argv) {
  using namespace perforate;
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "limit") return find_limit(argc, argv);
  if (command == "mesh") return write_mesh(argc, argv);
  const auto options = parse(argc, argv, std::cout);
  if (!options) return success;
  return run_case(*options, argv[0], Telling::all).status;
}

} // namespace

int main(int argc, char **argv) {
  return input::run_main("perforate", [&] { return run(argc, argv); });
}
