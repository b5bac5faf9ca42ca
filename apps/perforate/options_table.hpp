// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "shared/command_line.hpp"
#include "shared/input.hpp"
#include "shared/material_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

/// \file
/// The one table of the options: names, limits, units, meaning, and where the default comes from. Command line, TOML
/// files, --help and the checks all read it.

namespace perforate {

using input::Choice;
using input::flag_of;
using input::Given;
using input::Limits;
using input::printable;
using input::refuse;
using input::shortest;
using input::text_of;

/// Where each value comes from: the flag, or file, line and key.
using Origins = std::map<std::string, std::string>;

inline std::string origin_of(const Origins &origins, const std::string &key) {
  const auto found = origins.find(key);
  return found == origins.end() ? flag_of(key) : found->second;
}

/// One option. Its flag is `key` with hyphens and two in front.
struct Entry {
  const char *group;
  const char *key;
  const char *meaning;
  const char *source; ///< of the default
  Limits limits{};    ///< of numbers only
};

constexpr auto choices(FlowModel) { return material_file::models; }
inline auto choices(Nose) {
  std::array<Choice<Nose>, ogive::all_noses.size()> noses;
  std::transform(ogive::all_noses.begin(), ogive::all_noses.end(), noses.begin(), [](Nose nose) {
    return Choice<Nose>{nose, ogive::name(nose)};
  });
  return noses;
}
constexpr auto choices(ProjectileKind) {
  return std::to_array<Choice<ProjectileKind>>(
      {{ProjectileKind::deformable, "deformable"}, {ProjectileKind::rigid, "rigid"}});
}
constexpr auto choices(Extent) {
  return std::to_array<Choice<Extent>>({{Extent::quarter, "quarter"}, {Extent::half, "half"}, {Extent::full, "full"}});
}
constexpr auto choices(Lattice) {
  return std::to_array<Choice<Lattice>>({{Lattice::cubic, "cubic"}, {Lattice::ring, "ring"}});
}
constexpr auto choices(SphForm) {
  return std::to_array<Choice<SphForm>>({{SphForm::renormalised, "renormalised"}, {SphForm::standard, "standard"}});
}
constexpr auto choices(SphKernel) {
  return std::to_array<Choice<SphKernel>>(
      {{SphKernel::cubic_spline, "cubic_spline"}, {SphKernel::wendland_c2, "wendland_c2"}});
}
constexpr auto choices(Smoothing) {
  return std::to_array<Choice<Smoothing>>({{Smoothing::constant, "constant"}, {Smoothing::variable, "variable"}});
}
constexpr auto choices(ElementRule) {
  return std::to_array<Choice<ElementRule>>(
      {{ElementRule::one_point, "one_point"}, {ElementRule::selective_reduced, "selective_reduced"}});
}
constexpr auto choices(PressureLaw) {
  return std::to_array<Choice<PressureLaw>>(
      {{PressureLaw::linear, "linear"}, {PressureLaw::mie_gruneisen, "mie_gruneisen"}});
}

constexpr auto choices(Method) {
  return std::to_array<Choice<Method>>(
      {{Method::sfm, "sfm"}, {Method::stabilised, "stabilised"}, {Method::adaptive, "adaptive"}});
}
constexpr auto choices(DamageLaw) {
  return std::to_array<Choice<DamageLaw>>(
      {{DamageLaw::none, "none"}, {DamageLaw::johnson_cook, "jc"}, {DamageLaw::cockcroft_latham, "cockcroft_latham"}});
}
constexpr auto choices(LengthScope) {
  return std::to_array<Choice<LengthScope>>(
      {{LengthScope::everywhere, "everywhere"}, {LengthScope::in_shear, "in_shear"}});
}
constexpr auto choices(DamagePressure) {
  return std::to_array<Choice<DamagePressure>>(
      {{DamagePressure::own, "own"}, {DamagePressure::neighbours, "neighbours"}});
}
constexpr auto choices(FailureEffect) {
  return std::to_array<Choice<FailureEffect>>(
      {{FailureEffect::none, "none"}, {FailureEffect::no_tension, "no_tension"}, {FailureEffect::removal, "removal"}});
}

/// Name of a choice.
template <class E> std::string choice_name(E value) { return input::name_in(choices(value), value); }

/// All names of a kind of choice, separated by commas.
template <class E> std::string choice_names(E kind) { return input::names_in(choices(kind)); }

/// True for an option that takes a list.
template <class V> inline constexpr bool is_list = false;
template <class V> inline constexpr bool is_list<std::vector<V>> = true;

/// True of options that may be left unset.
template <class V> inline constexpr bool is_optional = false;
template <class V> inline constexpr bool is_optional<std::optional<V>> = true;

/// Texts with `separator` between them.
inline std::string joined(const std::vector<std::string> &texts, const std::string &separator) {
  std::string all;
  for (const std::string &text : texts) all += (all.empty() ? "" : separator) + text;
  return all;
}
inline std::string joined(const std::vector<double> &numbers, const std::string &separator) {
  std::vector<std::string> texts;
  for (const double number : numbers) texts.push_back(shortest(number));
  return joined(texts, separator);
}

/// Most threads that may be asked for.
inline double most_threads() { return std::max(64.0, 4.0 * std::thread::hardware_concurrency()); }

/// Group of the options that leave the case as it is.
inline constexpr char run_group[] = "Run and output";

/// Calls `f(entry, value)` for each option, in the order of --help.
template <class O, class F> void for_each_option(O &o, F &&f) {
  const char *const plate = "Plate";
  f(Entry{plate, "material", "of the plate", "paper"}, o.material);
  f(Entry{plate, "model", "flow stress, modified or classical Johnson-Cook; FILE.toml says its own", "paper"}, o.model);
  f(Entry{plate, "method",
          "how the plate holds together: particles as in the paper, which come apart by themselves; or stabilised by "
          "bonds, with damage; or hexes that turn into particles where damage has used them up",
          "paper"},
    o.method);
  f(Entry{plate, "damage", "how damage grows, by D1 to D5 or by critical_work_MPa of the material",
          "none, jc with the methods beyond the paper: paper, ours"},
    o.damage);
  f(Entry{plate, "failure", "what comes of damage 1, neither shear nor tension or no force at all",
          "none without --damage, else no_tension: ours"},
    o.failure);
  f(Entry{plate,
          "damage_softening",
          "part of the flow stress that damage 1 takes away",
          "0, 0.3 with --method stabilised, 0.6 with --method adaptive: Boervik et al. 2001, ours",
          {0, 1, ""}},
    o.damage_softening);
  f(Entry{plate,
          "damage_length_mm",
          "particle distance for which the constants of damage hold; failure strains grow with finer ones; 0: hold for "
          "any",
          "0, shear_length_mm of the material with --method stabilised, 0.22 with --method adaptive: ours",
          {0, 100, "mm"}},
    o.damage_length_mm);
  f(Entry{plate,
          "damage_length_exponent",
          "of --damage-length-mm over the particle distance in failure strains; 1 keeps the displacement that breaks a "
          "band, 0 the strain",
          "1, 0.25 with --method adaptive: ours",
          {0, 2, ""}},
    o.damage_length_exponent);
  f(Entry{plate, "damage_length_scope",
          "stresses at which failure strains follow --damage-length-mm: any, or in full up to triaxiality 0, less and "
          "less up to 1/3",
          "everywhere, in_shear with --method stabilised: ours"},
    o.damage_length_scope);
  f(Entry{plate, "damage_pressure", "whose pressure damage follows, each particle's own or the mean of its neighbours",
          "own, neighbours with --method stabilised: ours"},
    o.damage_pressure);
  f(Entry{plate, "thickness_mm", "of the plate", "paper, Fig. 11", {0.5, 100, "mm"}}, o.thickness_mm);
  f(Entry{plate,
          "layers_mm",
          "thicknesses of several plates behind each other, from front to rear, instead of --thickness-mm; one alone "
          "with "
          "--method adaptive",
          "none: one plate",
          {0.5, 100, "mm"}},
    o.layers_mm);
  f(Entry{plate,
          "gaps_mm",
          "free distances between the plates of --layers-mm, one for all or one less than plates",
          "0: they touch",
          {0, 1000, "mm"}},
    o.gaps_mm);
  f(Entry{plate, "layer_materials", "of the plates of --layers-mm, one for each",
          "that of --material: the same for all"},
    o.layer_materials);
  f(Entry{plate, "clamp_radius_mm", "radius at which the plate is clamped", "tests", {12, 2000, "mm"}},
    o.clamp_radius_mm);

  const char *const projectile = "Projectile";
  f(Entry{projectile, "nose", "20 mm in diameter and 197 g unless said otherwise", "paper, Fig. 11"}, o.nose);
  f(Entry{projectile, "diameter_mm", "of the shank", "paper", {1, 200, "mm"}}, o.diameter_mm);
  f(Entry{projectile,
          "length_mm",
          "from tip to tail",
          "80 blunt, 98 conical, 94.6 ogival, 83.2 hemispherical, times diameter/20 mm: paper",
          {1, 2000, "mm"}},
    o.length_mm);
  f(Entry{projectile,
          "nose_length_mm",
          "of a conical or ogival nose",
          "30 conical, 33 ogival, times diameter/20 mm: paper",
          {0, 1000, "mm"}},
    o.nose_length_mm);
  f(Entry{projectile,
          "calibre_radius_head",
          "radius of an ogive over the diameter, instead of --nose-length-mm",
          "none: that follows from the length",
          {0, 50, ""}},
    o.calibre_radius_head);
  f(Entry{projectile,
          "edge_radius_mm",
          "of the edge of a blunt nose, at most twice the particle distance",
          "0: sharp",
          {0, 25, "mm"}},
    o.edge_radius_mm);
  f(Entry{projectile, "mass_g", "of the projectile, by its density; 0: that of tool steel", "paper", {0, 1e6, "g"}},
    o.mass_g);
  f(Entry{projectile,
          "obliquity_deg",
          "angle between the line of flight and the plate's axis; needs --extent half or full",
          "tests",
          {0, 60, "deg"}},
    o.obliquity_deg);
  f(Entry{projectile, "projectile", "deformable tool steel, or rigid", "paper"}, o.projectile);
  f(Entry{projectile, "velocity_mps", "initial velocity", "tests", {1, 3000, "m/s"}}, o.velocity_mps);
  f(Entry{projectile,
          "friction",
          "Coulomb friction between plate and projectile",
          "0 blunt; else 0.08 on weldox_460e and on FILE.toml, 0.02 on aa5083_h116: paper",
          {0, 2, ""}},
    o.friction);

  const char *const numerics = "Discretisation";
  f(Entry{numerics,
          "spacing_mm",
          "particle distance, with --method adaptive size of the hexes, at most half the thickness",
          "paper",
          {0.05, 5, "mm"}},
    o.spacing_mm);
  f(Entry{numerics,
          "sph_radius_mm",
          "radius of the particles' disc, or of the hexes that can turn into particles, from 10 mm + 2 spacings to "
          "less than the clamp radius",
          "paper",
          {10.1, 2000, "mm"}},
    o.sph_radius_mm);
  f(Entry{numerics, "extent", "how much of the round model is computed", "paper"}, o.extent);
  f(Entry{numerics, "lattice", "how the particles are laid out", "ours"}, o.lattice);
  f(Entry{numerics, "form", "SPH with corrected gradients, or as in the textbook", "ours"}, o.form);
  f(Entry{numerics, "kernel", "of SPH", "ours"}, o.kernel);
  f(Entry{numerics, "smoothing", "smoothing length, constant or following the density", "ours"}, o.smoothing);
  f(Entry{numerics, "element", "integration of the hexes", "ours"}, o.element);
  f(Entry{numerics, "pressure", "pressure law", "ours"}, o.pressure);
  f(Entry{numerics,
          "control_stiffness",
          "of the bonds against zero-energy modes, over the shear modulus; 0: no bonds",
          "0, 0.3 with --method stabilised: paper, ours",
          {0, 2, ""}},
    o.control_stiffness);
  f(Entry{numerics,
          "contact_stiffness",
          "penalty stiffness of the contact, over mass/(time step)^2",
          "ours",
          {0.001, 0.5, ""}},
    o.contact_stiffness);
  f(Entry{numerics, "linear_viscosity", "alpha of the artificial viscosity of SPH", "ours", {0, 2, ""}},
    o.linear_viscosity);
  f(Entry{numerics, "quadratic_viscosity", "beta of the artificial viscosity of SPH", "ours", {0, 5, ""}},
    o.quadratic_viscosity);

  const char *const run = run_group;
  f(Entry{run,
          "end_us",
          "time at which the run ends",
          "500 blunt, else 1500; most runs end by themselves: ours",
          {1, 100000, "us"}},
    o.end_us);
  f(Entry{run,
          "settle_us",
          "time to go on once the shot is decided: the plate swings, dishing_at_rest_mm is its mean over that time",
          "0: none",
          {0, 100000, "us"}},
    o.settle_us);
  f(Entry{run, "out", "folder for the results",
          "vtk_out/MATERIAL_MODEL_NOSE_THICKNESSmm_VELOCITYmps, and each option that is not as usual"},
    o.out);
  f(Entry{run, "output_every_us", "time between two frames", "ours", {0.5, 100000, "us"}}, o.output_every_us);
  f(Entry{run,
          "checkpoint_every_us",
          "time between two checkpoints, from which --restart goes on; 0: one every 15 minutes of work. Ctrl-C "
          "(SIGINT), "
          "SIGTERM and SIGHUP write one in any case",
          "ours",
          {0, 100000, "us"}},
    o.checkpoint_every_us);
  f(Entry{run, "vtk", "write VTK files", "ours"}, o.vtk);
  f(Entry{run, "picture", "draw the section picture", "ours"}, o.picture);
  f(Entry{run, "quiet", "no progress on the terminal", "ours"}, o.quiet);
  f(Entry{run, "threads", "OpenMP threads", "all: OMP_NUM_THREADS or the number of cores", {1, most_threads(), ""}},
    o.threads);
}

/// Takes what follows from method, nose and material where it has not been given.
void take_defaults(Options &options, const Origins &given);

/// The entries of a TOML file. Throws SetupError if it cannot be read, is damaged or has unknown keys.
std::vector<Given> read_toml(const std::string &file);

/// The same from text; `file` is its name in errors.
std::vector<Given> entries_of(std::string_view text, const std::string &file);

} // namespace perforate
