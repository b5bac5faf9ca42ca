// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include "materials/library.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"
#include "options/folder_lock.hpp"
#include "options/out_folder.hpp"
#include "options/threads.hpp"
#include "plates.hpp"
#include "report.hpp"
#include "signals.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace shot {

namespace {

namespace fs = std::filesystem;

/// Text as a shell takes it for one word.
std::string shell_word(const std::string &text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return ogive::is_letter_or_digit(c) || std::strchr("/._-+=:,@%", c) != nullptr;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Bytes that a run will write at most, by a generous guess for each particle and each hex of the projectile. Two
/// checkpoints are there while the new one is written.
double estimated_bytes(const Options &o) {
  constexpr double fixed = 4e6, per_particle_and_frame = 120, per_particle_of_checkpoint = 600;
  const double time_us = std::max(0.0, o.end_us + o.settle_us - (o.restart ? o.restart->time_us : 0));
  const double frames = o.vtk ? time_us / o.output_every_us + 2 : 1;
  return fixed + (frames * per_particle_and_frame + 2 * per_particle_of_checkpoint) * estimated_particles(o);
}

/// Prints why a run did not come to its end, and how it resumes.
void print_problem(const Options &options, const std::string &problem) {
  std::fprintf(stderr, "ogive shoot: %s\n", problem.c_str());
  const auto file = options.out / checkpoint_name;
  std::error_code ignored;
  if (fs::exists(file, ignored))
    std::fprintf(stderr, "ogive shoot: this resumes from the last checkpoint:\n  %s\n", restart_command(file).c_str());
}

} // namespace

std::string restart_command(const fs::path &checkpoint) {
  std::error_code ignored;
  return shell_word(fs::read_symlink("/proc/self/exe", ignored).string()) + " shoot --restart " +
         shell_word(checkpoint.string());
}

void prepare_out(const Options &o) {
  std::error_code missing;
  for (const std::string &material : materials_of(o))
    if (!o.restart && materials::is_material_file(material) && fs::equivalent(o.out / "case.toml", material, missing))
      options::refuse(o.layer_materials.empty() ? "--material" : "--layer-materials", material,
                      "must not be case.toml in the folder for the results: that is overwritten");
  options::prepare_out(o.out, estimated_bytes(o), "; a longer --output-every-us or --no-vtk needs less");
}

void use_threads(const Options &o) {
  options::require_threads(o.threads.value_or(omp_get_max_threads()));
  if (o.threads) omp_set_num_threads(*o.threads);
}

Outcome run(const Options &o, Output output) {
  const auto plates = plates_of(o);
  // A study has seen to the threads of all its shots.
  if (output == Output::all) use_threads(o);
  prepare_out(o);

  const options::FolderLock lock(o.out / ".lock", options::FolderLock::exclusive,
                                 "another run writes its results there; wait for its end, or give another folder");
  const bool prints = output == Output::all;
  const auto test = find_test(o);
  Outcome outcome;
  Result &shot = outcome.shot;
  const auto ends_with = [&](int status, const std::string &problem) {
    outcome.status = status;
    outcome.problem = problem;
    return outcome;
  };
  try {
    shot = run_model(o, plates);
  } catch (const ogive::WriteError &error) {
    if (prints) print_problem(o, std::string("error: ") + error.what());
    return ends_with(not_finished, error.what());
  }
  if (shot.interrupted_by != 0) {
    const std::string text = "interrupted by " + signal_name(shot.interrupted_by) + " at " +
                             ogive::with_decimals(shot.simulated_us, 3) + " us";
    if (prints) print_problem(o, text);
    return ends_with(interrupted + shot.interrupted_by, text);
  }
  if (prints) print_table(o, shot, test);
  write_summary(o, shot, test);
  if (prints)
    if (const std::string left_out = draw(o, shot, test); !left_out.empty())
      std::fprintf(stderr, "ogive shoot: left out: %s\n", left_out.c_str());
  if (!shot.fault) return outcome;
  const std::string text = "stopped at " + ogive::with_decimals(shot.fault->time_us, 3) +
                           " us: " + shot.fault->what.substr(0, 120) + " (" + shot.fault->body.substr(0, 30) + " " +
                           std::to_string(shot.fault->id) + ")";
  if (prints) std::fprintf(stderr, "ogive shoot: %s\n", text.c_str());
  return ends_with(not_finished, text);
}

} // namespace shot
