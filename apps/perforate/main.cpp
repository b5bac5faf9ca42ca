#include "interrupt.hpp"
#include "report.hpp"

#include "ogive/io/write_error.hpp"
#include "options_material.hpp"

#include <omp.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <iostream>

namespace {

enum ExitStatus { success = 0, failure = 1, bad_input = 2, stopped_by_fault = 3, interrupted = 128 };

/// Text as a shell takes it for one word.
std::string shell_word(const std::string &text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || std::strchr("/._-+=:,@%", c) != nullptr;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Says how the run can go on from its last checkpoint, if there is one.
void print_restart(const char *program, const perforate::Options &options) {
  const auto file = options.out / perforate::checkpoint_name;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
    std::fprintf(stderr, "perforate: this goes on from the last checkpoint:\n  %s --restart %s\n",
                 shell_word(program).c_str(), shell_word(file.string()).c_str());
}

int run(int argc, const char *const *argv) {
  using namespace perforate;
  const auto options = parse(argc, argv, std::cout);
  if (!options) return success;
  const auto plate = plate_of(*options);
  prepare_out(*options);
  if (options->threads) omp_set_num_threads(*options->threads);

  const auto test = find_test(*options);
  Shot shot;
  try {
    shot = shoot(*options, plate);
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "perforate: error: %s\n", error.what());
    print_restart(argv[0], *options);
    return stopped_by_fault;
  }
  if (shot.interrupted_by != 0) {
    std::fprintf(stderr, "perforate: interrupted by %s at %.3f us\n", signal_name(shot.interrupted_by).c_str(),
                 shot.simulated_us);
    print_restart(argv[0], *options);
    return interrupted + shot.interrupted_by;
  }
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
