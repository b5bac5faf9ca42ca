// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include "files.hpp"
#include "materials/library.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"
#include "options/folder_lock.hpp"
#include "options/out_folder.hpp"
#include "options/threads.hpp"
#include "plates.hpp"
#include "report.hpp"
#include "resume.hpp"
#include "signals.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

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

std::unique_ptr<options::FolderLock> lock_results(const Options &o) {
  return std::make_unique<options::FolderLock>(
      o.out / ".lock", options::FolderLock::exclusive,
      "another run writes its results there; wait for its end, or give another folder");
}

/// Description of results in the folder that this run must not overwrite; empty if there are none.
std::string other_results(const Options &o) {
  if (is_in_place(o)) return "";
  const auto other = other_case(o);
  if (other) return other->empty() ? "" : "its results are of a case with another " + *other;
  std::error_code none;
  for (const char *name : {"case.toml", "summary.json", "history.csv", checkpoint_name})
    if (fs::exists(o.out / name, none)) return "its results are of a case that cannot be read";
  return "";
}

/// A fault with its subject, and with a remedy where there is a usual one.
std::string described(const ogive::Fault &fault) {
  using enum ogive::FaultKind;
  const char *remedy = "";
  switch (fault.kind) {
  case inverted:
  case small_step:
    remedy = "; try --rigid, or --element one_point";
    break;
  case lost:
    remedy = "; try a finer --spacing-mm or a larger --contact-stiffness";
    break;
  case energy:
  case not_finite:
    remedy = "; please report this case.toml unless its material is extreme";
    break;
  case astray:
    break;
  }
  const std::string subject = fault.id < 0 ? fault.body : fault.body + ", number " + std::to_string(fault.id);
  return subject + ": " + fault.what + remedy;
}

/// Share of the projectile's mass that may be removed with its hexes without a warning.
constexpr double much_removed = 0.03;

/// Prints why a run did not come to its end, and how it resumes.
void print_problem(const Options &options, const std::string &problem) {
  std::fprintf(stderr, "ogive shoot: %s\n", problem.c_str());
  const auto file = options.out / checkpoint_name;
  std::error_code ignored;
  if (fs::exists(file, ignored))
    std::fprintf(stderr, "ogive shoot: this resumes from the last checkpoint:\n  %s\n", restart_command(file).c_str());
}

} // namespace

std::vector<std::string> doubts_of(const Result &shot) {
  std::vector<std::string> doubts;
  if (const double share = shot.removed_mass_g / shot.sizes.projectile_mass_g; share > much_removed)
    doubts.push_back(
        options::printed("%.2g %% of the projectile's mass was in hexes that have been removed because they "
                         "were too distorted: take the result with care, or compute with a finer --spacing-mm",
                         100 * share));
  if (shot.intrusion_mm > 0.5 * shot.sizes.spacing_mm)
    doubts.push_back(
        options::printed("a particle was %.2g mm inside the projectile, more than half of a particle distance: "
                         "take the result with care, or compute with a finer --spacing-mm",
                         shot.intrusion_mm));
  return doubts;
}

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
  const bool prints = output == Output::all;
  // A study has seen to the threads of all its shots.
  if (prints) use_threads(o);
  prepare_out(o);

  auto lock = lock_results(o);
  if (const std::string reason = other_results(o); !reason.empty()) {
    const fs::path name = options::set_aside(o.out, reason);
    if (prints)
      std::fprintf(stderr, "ogive shoot: %s: %s; they are now in %s\n", o.out.c_str(), reason.c_str(), name.c_str());
    prepare_out(o);
    lock = lock_results(o);
  }
  if (prints)
    for (const std::string &doubt : doubts_of(o, plates))
      std::fprintf(stderr, "ogive shoot: warning: %s\n", doubt.c_str());
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
  if (prints) {
    print_table(o, shot, test);
    for (const std::string &doubt : doubts_of(shot)) std::fprintf(stderr, "ogive shoot: warning: %s\n", doubt.c_str());
  }
  write_summary(o, shot, test);
  if (prints)
    if (const std::string left_out = draw(o, shot, test); !left_out.empty())
      std::fprintf(stderr, "ogive shoot: left out: %s\n", left_out.c_str());
  if (!shot.fault) return outcome;
  const std::string problem =
      "stopped at " + ogive::with_decimals(shot.fault->time_us, 3) + " us: " + described(*shot.fault);
  if (prints) std::fprintf(stderr, "ogive shoot: %s\n", problem.c_str());
  return ends_with(not_finished, problem);
}

} // namespace shot
