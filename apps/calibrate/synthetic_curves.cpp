// SPDX-License-Identifier: BSD-3-Clause
#include "shared/command_line.hpp"
#include "shared/exit_status.hpp"

#include "ogive/fit/stress_curve.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/material/library.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

/// \file
/// Tensile curves computed from published Johnson-Cook fits, with scatter: the paper's own test curves are not public.

namespace {

/// What the user asks for.
struct Wish {
  std::string material = "weldox_460e";
  double noise_percent = 1, seed = 1;
  std::string out;
};

/// One curve to be computed.
struct Specimen {
  std::string plate;
  double strength; ///< factor on A and B
  double rate, temperature, last_strain;
};

/// Tests keep their heat from this rate on, 1/s.
constexpr double adiabatic_above = 10;

std::vector<Specimen> specimens(const std::string &material) {
  std::vector<Specimen> all;
  if (material == "weldox_460e") {
    const double slow = 7.4e-4;
    all = {{"", 1, slow, 293, 0.3}, {"", 1, 2.16, 293, 0.2}, {"", 1, 1522, 293, 0.15}};
    for (const double hot : {373, 473, 573, 673, 773}) all.push_back({"", 1, slow, hot, 0.2});
    return all;
  }
  const double slow = 1e-3, weak = 0.85;
  for (const char *plate : {"15 mm", "20 mm", "25 mm", "30 mm"})
    all.push_back({plate, plate == std::string("25 mm") ? weak : 1.0, slow, 293, 0.3});
  for (const double rate : {3.95, 122.0, 1313.0}) all.push_back({"25 mm", weak, rate, 293, rate > 10 ? 0.15 : 0.2});
  for (const double hot : {473, 573, 673, 773}) all.push_back({"25 mm", weak, slow, hot, 0.2});
  return all;
}

/// Normal scatter that is the same with every standard library (Box & Muller 1958).
struct Scatter {
  std::mt19937_64 engine;

  double uniform() { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; }
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
};

std::string formatted(const char *format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

template <class Law>
std::string table(const Wish &wish, const ogive::Metal<double, Law> &metal, const std::string &fit) {
  const std::string seed = formatted("%.0f", wish.seed), noise = input::shortest(wish.noise_percent);
  std::string text = "# COMPUTED CURVES, NOT MEASURED ONES. Do not take them for tests of this metal.\n"
                     "# Law: classical Johnson-Cook fit of " +
                     fit + ", power rate factor,\n# A " + formatted("%g", metal.flow.A / 1e6) + " MPa, B " +
                     formatted("%g", metal.flow.B / 1e6) + " MPa, n " + formatted("%g", metal.flow.n) + ", C " +
                     formatted("%g", metal.flow.C) + ", m " + formatted("%g", metal.flow.m) + ", reference rate " +
                     formatted("%g", metal.flow.reference_rate) +
                     " 1/s; adiabatic from 10 1/s on.\n# Scatter of the stress: normal, standard deviation " + noise +
                     " %, seed " + seed + ".\n# Made by: synthetic_curves --material " + wish.material +
                     " --noise-percent " + noise + " --seed " + seed + " --out <this file>\n";
  const bool plates = !specimens(wish.material).front().plate.empty();
  if (plates)
    text += "# The 25 mm plate has 0.85 times the strength of the others: an assumption, see docs/assumptions.md.\n";
  text += std::string(plates ? "plate," : "") + "strain_rate_per_s,temperature_K,plastic_strain,stress_MPa\n";

  Scatter scatter{std::mt19937_64(static_cast<std::uint64_t>(wish.seed))};
  for (const Specimen &s : specimens(wish.material)) {
    auto law = metal.flow;
    law.A *= s.strength;
    law.B *= s.strength;
    constexpr double first = 0.002, step = 0.0025;
    std::vector<double> strains;
    for (int i = 0; first + i * step <= s.last_strain + 1e-9; ++i)
      strains.push_back(std::round(1e5 * (first + i * step)) / 1e5);
    const double heat = s.rate >= adiabatic_above ? metal.taylor_quinney / (metal.density * metal.specific_heat) : 0.0;
    for (const auto &p : adiabatic_curve(law, {metal.room_temperature, metal.melting_temperature}, s.rate,
                                         s.temperature, heat, strains)) {
      const double stress = p.stress * (1 + wish.noise_percent / 100 * scatter.normal());
      text += (plates ? s.plate + "," : "") + input::shortest(s.rate) + "," + input::shortest(s.temperature) + "," +
              input::shortest(p.strain) + "," + formatted("%.2f", stress / 1e6) + "\n";
    }
  }
  return text;
}

int run(int argc, const char *const *argv) {
  const input::Limits percent{0, 20, "%"}, seeds{0, 1e9, ""};
  const std::string materials = "one of weldox_460e, aa5083_h116";
  const auto line = input::read_command_line("synthetic_curves",
                                             {{"material", materials},
                                              {"noise_percent", "a number between " + text_of(percent)},
                                              {"seed", "a whole number between " + text_of(seeds)},
                                              {"out", "the name of a file"}},
                                             argc, argv);
  if (line.help || line.version) {
    std::printf("synthetic_curves --out FILE.csv [--material NAME] [--noise-percent X] [--seed N]\n"
                "Writes tensile curves computed from a published Johnson-Cook fit, as an example for calibrate.\n"
                "NAME: weldox_460e (default), aa5083_h116; X: 1; N: 1\n");
    return input::success;
  }
  Wish wish;
  for (const auto &given : line.given)
    if (given.key == "material")
      wish.material = given.value;
    else if (given.key == "noise_percent")
      wish.noise_percent = number_within(given, percent);
    else if (given.key == "seed")
      wish.seed = std::floor(number_within(given, seeds));
    else
      wish.out = line_given(given, "the name of a file");
  if (wish.out.empty()) throw ogive::SetupError("--out: is required: the name of a file");
  if (wish.material == "weldox_460e")
    ogive::write_atomically(wish.out, table(wish, ogive::library::weldox_460e_jc<double>(),
                                            "Boervik, Hopperstad, Berstad & Langseth 2001 (quoted)"));
  else if (wish.material == "aa5083_h116")
    ogive::write_atomically(wish.out, table(wish, ogive::library::aa5083_h116_jc<double>(),
                                            "Clausen, Boervik, Hopperstad & Benallal 2004 (quoted)"));
  else
    input::refuse("--material", wish.material, "must be " + materials);
  return input::success;
}

} // namespace

int main(int argc, char **argv) {
  return input::run_main("synthetic_curves", [&] { return run(argc, argv); });
}
