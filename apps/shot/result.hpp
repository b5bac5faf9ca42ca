// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plates.hpp"

#include "ogive/io/frame.hpp"
#include "ogive/perforation/flight.hpp"
#include "ogive/perforation/motion.hpp"
#include "ogive/perforation/shape.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/run.hpp"

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shot {

/// Sizes of a model, known before the run.
struct Sizes {
  long particles = 0;
  long hexes = 0;
  double spacing_mm = 0;
  double projectile_mass_g = 0;
  double projectile_volume_mm3 = 0;
  std::vector<std::pair<std::string, double>> part_masses_g; ///< of a projectile of several parts, with their names
  double added_mass_g = 0;                                   ///< for the time step, at a sharp tip
  double projectile_jacobian = 0;                            ///< smallest scaled one of its hexes, 1 for bricks
  double time_step_us = 0;
};

/// State of one of several plates at the end.
struct LayerResult {
  std::string material; ///< name of its metal
  ogive::Fragments<double> fragments;
  ogive::PlateShape<double> shape;
};

/// A part of a projectile whose parts touch, at the end.
struct PartResult {
  std::string name;         ///< without that of the projectile
  double mass_g = 0;        ///< of the whole model
  double velocity_mps = 0;  ///< along the line of flight
  bool is_followed = false; ///< it is the one that verdict, velocities and depths are of
};

/// The plate's swing after the shot has been decided, of the first plate.
struct Swing {
  double begun_us = -1;      ///< when it was decided; -1: not yet
  double until_us = 0;       ///< of the last sample
  double dishing_mm = 0;     ///< then
  double integral_mm_us = 0; ///< of the dishing since it was decided
};

/// Results of a shot.
struct Result {
  std::string material; ///< name of the plate's metal; of several "first + second + ..." if they differ
  Sizes sizes;
  ogive::Flight<double> flight;
  std::optional<ogive::Fault> fault;
  int interrupted_by = 0;                 ///< signal; 0: the run came to its end
  ogive::Way<double> way;                 ///< of the projectile at the end
  ogive::ProjectileMotion<double> motion; ///< likewise
  ogive::Fragments<double> fragments;     ///< of all plates
  std::vector<LayerResult> layers;        ///< one for each plate
  long removed_hexes = 0;                 ///< of the projectile, by erosion, of the computed part
  double removed_mass_g = 0;              ///< of those, of the whole model
  std::vector<PartResult> parts;          ///< of a projectile whose parts touch; empty: they are tied
  Swing swing;                            ///< for --settle-us
  double intrusion_mm = 0;                ///< particle behind the projectile's surface, deepest of all times of a check
  double hourglass_fraction = 0;          ///< of the initial energy, at the end
  double energy_error = 0;                ///< largest over the run, of the initial energy
  double momentum_error = 0; ///< largest over the run, against the supports' impulse, of the initial momentum
  double loop_s = 0;         ///< wall time of the time loop without writing files
  double wall_s = 0;         ///< wall time of the whole run
  double cpu_s = 0;          ///< processor time of all threads, of the whole run
  long steps = 0;
  double simulated_us = 0;
  ogive::PhaseTimes times; ///< wall time of the parts of the time loop
  std::uint64_t state_hash = 0;
  ogive::Frame last_frame;
  ogive::SymmetryPlanes symmetry;
};

/// Radians as degrees.
inline double in_degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// Outcomes of a shot.
enum class Verdict { perforated, stopped, undecided };

/// The verdict of a shot: undecided if its time ended or a fault stopped it before the projectile's motion decided.
Verdict verdict(const Result &shot);

/// Residual velocity in m/s, 0 if the projectile was stopped; none while that is undecided.
std::optional<double> residual_mps(const Result &shot);

/// Mean dishing of the first plate over the time of --settle-us, mm; none without.
std::optional<double> dishing_at_rest_mm(const Result &shot);

/// Runs the case with these metals (of plates_of()) as the plates, from the start or from the checkpoint of the
/// options, and writes history, VTK files and checkpoints into `options.out`. Throws SetupError for a case that cannot
/// be built or a checkpoint that does not fit it, WriteError for a file that cannot be written.
Result run_model(const Options &options, const Plates &plates);

/// Sizes of a body before the run, masses of the whole model.
struct BodySizes {
  std::string name{};
  long nodes = 0;
  long hexes = 0; ///< 0: particles
  double mass_g = 0;
  double volume_mm3 = 0;  ///< of hexes, of the whole model
  double shortest_mm = 0; ///< edge of a hex, or the particle distance
  double longest_mm = 0;
  double largest_aspect = 0;
  double smallest_scaled_jacobian = 0; ///< 1 for a brick
  double time_step_us = 0;
};

/// Writes the bodies of a case into `options.out` for ParaView without running it, and returns their sizes. Throws
/// SetupError for a case that cannot be built, WriteError.
std::vector<BodySizes> write_model(const Options &options, const Plates &plates);

/// Prints what is about to be computed, unless the options are quiet.
void announce(const Options &options, const Result &shot);

} // namespace shot
