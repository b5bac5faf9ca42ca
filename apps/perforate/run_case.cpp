// SPDX-License-Identifier: BSD-3-Clause
#include "run_case.hpp"

#include "interrupt.hpp"
#include "ogive/io/write_error.hpp"
#include "options_material.hpp"
#include "report.hpp"

#include <omp.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>

namespace perforate {

namespace {

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

} // namespace

Outcome run_case(const Options &options, const char *program, Telling telling) {
  const auto plates = plates_of(options);
  prepare_out(options);
  if (options.threads) omp_set_num_threads(*options.threads);

  const auto test = find_test(options);
  Outcome outcome;
  Shot &shot = outcome.shot;
  try {
    shot = shoot(options, plates);
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "perforate: error: %s\n", error.what());
    print_restart(program, options);
    outcome.status = not_finished;
    return outcome;
  }
  if (shot.interrupted_by != 0) {
    std::fprintf(stderr, "perforate: interrupted by %s at %.3f us\n", signal_name(shot.interrupted_by).c_str(),
                 shot.simulated_us);
    print_restart(program, options);
    outcome.status = interrupted + shot.interrupted_by;
    return outcome;
  }
  if (telling == Telling::all) print_table(options, shot, test);
  write_summary(options, shot, test);
  if (telling == Telling::all)
    if (const std::string left_out = draw(options, shot, test); !left_out.empty())
      std::fprintf(stderr, "perforate: left out: %s\n", left_out.c_str());
  if (!shot.fault) return outcome;
  std::fprintf(stderr, "perforate: stopped at %.3f us: %s (%s %d)\n", shot.fault->time_us, shot.fault->what.c_str(),
               shot.fault->body.c_str(), shot.fault->id);
  outcome.status = not_finished;
  return outcome;
}

} // namespace perforate
