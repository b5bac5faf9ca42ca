#include "report.hpp"

#include "ogive/io/write_error.hpp"
#include "options_material.hpp"

#include <omp.h>

#include <cstdio>
#include <iostream>

namespace {

enum ExitStatus { success = 0, failure = 1, bad_input = 2, stopped_by_fault = 3 };

int run(int argc, const char *const *argv) {
  using namespace perforate;
  const auto options = parse(argc, argv, std::cout);
  if (!options) return success;
  const auto plate = plate_of(*options);
  prepare_out(*options);
  if (options->threads) omp_set_num_threads(*options->threads);

  const auto test = find_test(*options);
  const Shot shot = shoot(*options, plate);
  print_table(*options, shot, test);
  write_summary(*options, shot, test);
  const std::string left_out = draw(*options, shot, test);
  if (!left_out.empty()) std::fprintf(stderr, "perforate: left out: %s\n", left_out.c_str());
  if (!shot.fault) return success;
  std::fprintf(stderr, "perforate: stopped at %.3f us: %s (%s %d)\n", shot.fault->time_us, shot.fault->what.c_str(),
               shot.fault->body.c_str(), shot.fault->id);
  return stopped_by_fault;
}

} // namespace

int main(int argc, char **argv) {
  try {
    return run(argc, argv);
  } catch (const ogive::SetupError &error) {
    std::fprintf(stderr, "perforate: error: %s\n", error.what());
    return bad_input;
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "perforate: error: %s\n", error.what());
    return stopped_by_fault;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "perforate: error: %s\n", error.what());
    return failure;
  }
}
