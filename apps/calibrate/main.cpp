// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "shared/exit_status.hpp"
#include "shared/out_folder.hpp"

#include <cstdio>
#include <iostream>

namespace {

/// Tables and pictures of all curves are smaller.
constexpr double estimated_bytes = 50e6;

int run(int argc, const char *const *argv) {
  using namespace calibrate;
  const auto options = parse(argc, argv, std::cout);
  if (!options) return input::success;
  std::vector<std::string> messages;
  auto curves = read_tables(*options, messages);
  const auto created = input::prepare_out(options->out, estimated_bytes);
  Results results;
  try {
    results = fitted(*options, std::move(curves), std::move(messages));
  } catch (...) {
    input::remove_empty(created);
    throw;
  }

  write_json(*options, results);
  const std::string no_material = write_materials(*options, results);
  const std::string no_plot = write_plots(*options, results);
  print_table(*options, results);
  for (const std::string &left_out : {no_material, no_plot})
    if (!left_out.empty()) std::fprintf(stderr, "calibrate: left out: %s\n", left_out.c_str());
  return input::success;
}

} // namespace

int main(int argc, char **argv) {
  return input::run_main("calibrate", [&] { return run(argc, argv); });
}
