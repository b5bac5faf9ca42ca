// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/commands.hpp"
#include "options/exit_status.hpp"
#include "options/out_folder.hpp"
#include "results.hpp"

#include <iostream>

namespace commands {

options::Table calibrate_table() { return unbound(calibrate::table_of); }

int calibrate(const options::Arguments &arguments) {
  const auto o = calibrate::parse(arguments, std::cout);
  if (!o) return options::only_printed;
  std::vector<std::string> messages;
  auto curves = calibrate::read_tables(*o, messages);
  // Tables and pictures of all curves are smaller.
  constexpr double estimated_bytes = 50e6;
  const auto created = options::prepare_out(o->out, estimated_bytes);
  calibrate::Results results;
  try {
    results = calibrate::fitted(*o, std::move(curves), std::move(messages));
  } catch (...) {
    options::remove_empty(created);
    throw;
  }
  write_json(*o, results);
  const std::string no_material = write_materials(*o, results), no_plot = write_plots(*o, results);
  print_table(*o, results);
  for (const std::string &left_out : {no_material, no_plot})
    if (!left_out.empty()) std::fprintf(stderr, "ogive calibrate: left out: %s\n", left_out.c_str());
  return options::success;
}

} // namespace commands
