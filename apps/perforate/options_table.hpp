#pragma once

#include "options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

/// \file
/// The one table of the options: names, limits, units, meaning, and where the default comes from. Command line, TOML
/// files, --help and the checks all read it.

namespace perforate {

/// What a number may be.
struct Limits {
  double low = 0;
  double high = 0;
  const char *unit = "";
};

/// One option. Its flag is `key` with hyphens and two in front.
struct Entry {
  const char *group;
  const char *key;
  const char *meaning;
  const char *source; ///< of the default
  Limits limits{};    ///< of numbers only
};

/// A choice and its name.
template <class E> struct Choice {
  E value{};
  std::string_view name{};
};

constexpr auto choices(PlateMaterial) {
  return std::to_array<Choice<PlateMaterial>>({{PlateMaterial::weldox_460e, "weldox_460e"},
                                               {PlateMaterial::aa5083_h116, "aa5083_h116"},
                                               {PlateMaterial::aa5083_h116_25mm, "aa5083_h116_25mm"}});
}
constexpr auto choices(FlowModel) {
  return std::to_array<Choice<FlowModel>>({{FlowModel::mjc, "mjc"}, {FlowModel::jc, "jc"}});
}
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

/// Name of a choice.
template <class E> std::string choice_name(E value) {
  for (const auto &choice : choices(value))
    if (choice.value == value) return std::string(choice.name);
  return "";
}

/// All names of a kind of choice, separated by commas.
template <class E> std::string choice_names(E kind) {
  std::string names;
  for (const auto &choice : choices(kind)) names.append(names.empty() ? "" : ", ").append(choice.name);
  return names;
}

/// Most threads that may be asked for.
inline double most_threads() { return std::max(64.0, 4.0 * std::thread::hardware_concurrency()); }

/// Calls `f(entry, value)` for each option, in the order of --help.
template <class O, class F> void for_each_option(O &o, F &&f) {
  const char *const plate = "Plate";
  f(Entry{plate, "material", "of the plate", "paper"}, o.material);
  f(Entry{plate, "model", "flow stress, modified or classical Johnson-Cook", "paper"}, o.model);
  f(Entry{plate, "thickness_mm", "of the plate", "paper, Fig. 11", {0.5, 100, "mm"}}, o.thickness_mm);
  f(Entry{plate, "clamp_radius_mm", "radius at which the plate is clamped", "tests", {12, 2000, "mm"}},
    o.clamp_radius_mm);

  const char *const projectile = "Projectile";
  f(Entry{projectile, "nose", "20 mm in diameter, 197 g", "paper, Fig. 11"}, o.nose);
  f(Entry{projectile, "projectile", "deformable tool steel, or rigid", "paper"}, o.projectile);
  f(Entry{projectile, "velocity_mps", "initial velocity", "tests", {1, 3000, "m/s"}}, o.velocity_mps);
  f(Entry{projectile,
          "friction",
          "Coulomb friction between plate and projectile",
          "0 blunt; else 0.08 on weldox_460e, 0.02 on aa5083_h116: paper",
          {0, 2, ""}},
    o.friction);

  const char *const numerics = "Discretisation";
  f(Entry{numerics, "spacing_mm", "particle distance, at most half the thickness", "paper", {0.05, 5, "mm"}},
    o.spacing_mm);
  f(Entry{numerics,
          "sph_radius_mm",
          "radius of the particles' disc, from 10 mm + 2 spacings to less than the clamp radius",
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

  const char *const run = "Run and output";
  f(Entry{run,
          "end_us",
          "time at which the run ends",
          "500 blunt, else 1500; most runs end by themselves: ours",
          {1, 100000, "us"}},
    o.end_us);
  f(Entry{run, "out", "folder for the results", "vtk_out/MATERIAL_MODEL_NOSE_THICKNESSmm_VELOCITYmps"}, o.out);
  f(Entry{run, "output_every_us", "time between two frames", "ours", {0.5, 100000, "us"}}, o.output_every_us);
  f(Entry{run, "vtk", "write VTK files", "ours"}, o.vtk);
  f(Entry{run, "picture", "draw the section picture", "ours"}, o.picture);
  f(Entry{run, "quiet", "no progress on the terminal", "ours"}, o.quiet);
  f(Entry{run, "threads", "OpenMP threads", "all: OMP_NUM_THREADS or the number of cores", {1, most_threads(), ""}},
    o.threads);
}

/// The flag of a key: thickness_mm is --thickness-mm.
inline std::string flag_of(std::string_view key) {
  std::string flag = "--" + std::string(key);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

/// The shortest text that reads back as the same number.
inline std::string shortest(double number) {
  std::array<char, 32> digits{};
  const double size = std::abs(number);
  const bool plain = size == 0 || (size >= 1e-5 && size < 1e15);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, format).ptr;
  return {digits.data(), end};
}

/// "0.5 and 100 mm", or with another word between.
inline std::string text_of(const Limits &limits, const char *between = " and ") {
  const std::string unit = *limits.unit == 0 ? "" : std::string(" ") + limits.unit;
  return shortest(limits.low) + between + shortest(limits.high) + unit;
}

/// A value as text for messages: on one line and short, whatever the user typed.
inline std::string printable(std::string_view text) {
  constexpr std::size_t longest = 160;
  std::string line(text.substr(0, longest));
  for (char &c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text.size() > longest ? line + "..." : line;
}

/// Throws the one-line error "<what> = <value>: <allowed>".
[[noreturn]] inline void refuse(const std::string &what, std::string_view value, const std::string &allowed) {
  throw ogive::SetupError(printable(what) + " = " + printable(value) + ": " + allowed);
}

/// What the user gave for one option.
struct Given {
  enum Kind { untyped, number, integer, boolean, text, other };
  std::string key;
  std::string where; ///< the flag, or file, line and key
  std::string value;
  Kind kind = untyped; ///< the command line has only text, a TOML file has types
};

/// The entries of a TOML file. Throws SetupError if it cannot be read, is damaged or has unknown keys.
std::vector<Given> read_toml(const std::string &file);

} // namespace perforate
