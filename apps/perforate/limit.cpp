// SPDX-License-Identifier: BSD-3-Clause
#include "limit.hpp"

#include "draw/plot.hpp"
#include "files.hpp"
#include "ogive/fit/ballistic_limit.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/perforation/limit_search.hpp"
#include "options_material.hpp"
#include "options_table.hpp"
#include "run_case.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>

namespace perforate {

namespace {

namespace fs = std::filesystem;

/// What a shot left of its velocity.
struct Residual {
  double initial_mps = 0;
  double residual_mps = 0;
  bool perforated = false;
};

/// What `perforate limit` has besides the options of a case.
struct Search {
  double width_mps = 5;                ///< of the bracket
  bool velocity_given = false;         ///< that of the first shot
  std::vector<const char *> arguments; ///< the rest
};

Search search_of(int argc, const char *const *argv) {
  Search search;
  search.arguments.push_back(argv[0]);
  for (int k = 2; k < argc; ++k) {
    const std::string_view argument = argv[k];
    if (argument == "--velocity-mps" || argument.starts_with("--velocity-mps=")) search.velocity_given = true;
    if (argument != "--width-mps" && !argument.starts_with("--width-mps=")) {
      search.arguments.push_back(argv[k]);
      continue;
    }
    const bool joined = argument.size() > std::strlen("--width-mps");
    const std::string value = joined         ? std::string(argument.substr(std::strlen("--width-mps=")))
                              : k + 1 < argc ? argv[++k]
                                             : "";
    search.width_mps = input::number_within({"width_mps", "--width-mps", value}, {0.1, 500, "m/s"});
  }
  return search;
}

/// The text of a file; empty if there is none.
std::string text_of_file(const fs::path &name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The result of a shot that lies in a folder; nothing if there is none or it ended by a fault.
std::optional<Residual> known_result(const fs::path &folder, double velocity_mps) {
  const auto j = nlohmann::json::parse(text_of_file(folder / "summary.json"), nullptr, false);
  const auto is = [&](const char *key, auto kind) { return j.contains(key) && (j[key].*kind)(); };
  using Json = nlohmann::json;
  if (!j.is_object() || !is("perforated", &Json::is_boolean) || !is("residual_velocity_mps", &Json::is_number) ||
      !is("fault", &Json::is_null))
    return std::nullopt;
  return Residual{velocity_mps, j["residual_velocity_mps"], j["perforated"]};
}

/// The shots of a search in the folder of its options.
struct Shots {
  Options options;
  const char *program;
  std::vector<Residual> done;
  int status = success;
};

/// Runs the shot at this velocity, or reads what an earlier search found; false if it did not come to its end.
bool add_shot(Shots &shots, double velocity_mps) {
  Options o = shots.options;
  o.velocity_mps = velocity_mps;
  o.out = shots.options.out / (shortest(velocity_mps) + "mps");
  auto known = has_case(o, plates_of(o)) ? known_result(o.out, velocity_mps) : std::nullopt;
  if (!known) {
    const Outcome outcome = run_case(resumed(o), shots.program, Telling::problems);
    shots.status = outcome.status;
    if (outcome.status != success) {
      std::fprintf(stderr, "perforate limit: the same command goes on with the shot at %g m/s\n", velocity_mps);
      return false;
    }
    known = Residual{velocity_mps, residual_mps(outcome.shot), perforated(outcome.shot)};
  }
  shots.done.push_back(*known);
  std::printf("  %8.1f m/s  %s\n", velocity_mps,
              known->perforated ? ("residual " + shortest(std::round(10 * known->residual_mps) / 10) + " m/s").c_str()
                                : "stopped");
  std::fflush(stdout);
  return true;
}

/// Velocities above the limit that show the curve, over the limit.
constexpr std::array<double, 4> shown_velocities{1.1, 1.25, 1.5, 2.0};

std::string csv_of(std::vector<Residual> shots) {
  std::sort(shots.begin(), shots.end(), [](auto &a, auto &b) { return a.initial_mps < b.initial_mps; });
  std::string csv = "initial_velocity_mps,residual_velocity_mps,perforated\n";
  for (const Residual &s : shots)
    csv += shortest(s.initial_mps) + "," + shortest(s.residual_mps) + "," + (s.perforated ? "1" : "0") + "\n";
  return csv;
}

void draw_curve(const Shots &shots, const std::optional<ogive::BallisticFit<double>> &fit) {
  const fs::path &out = shots.options.out;
  double fastest = 0;
  for (const Residual &s : shots.done) fastest = std::max(fastest, s.initial_mps);
  std::string curves;
  if (fit) {
    constexpr int points = 200;
    std::string line = "initial_velocity_mps,residual_velocity_mps\n";
    for (int k = 0; k <= points; ++k) {
      // Dense near the limit, where the curve is steep.
      const double part = static_cast<double>(k) / points,
                   v = fit->curve.limit + (fastest * 1.02 - fit->curve.limit) * part * part;
      line += shortest(v) + "," + shortest(ogive::residual_velocity(fit->curve, v)) + "\n";
    }
    ogive::write_atomically(out / "limit_fit.csv", line);
    curves = ", " + draw::gnuplot_file(out / "limit_fit.csv") +
             " using 1:2 with lines linecolor rgb '#1f4e79' linewidth 2 title 'fit'";
  }
  const std::string commands =
      "set key left top reverse Left; set xlabel 'initial velocity, m/s'; set ylabel 'residual velocity, m/s'; "
      "set yrange [0:*]; plot " +
      draw::gnuplot_file(out / "limit.csv") +
      " using 1:2 with points linecolor rgb '#b03a2e' pointtype 7 pointsize 1.2 title 'computed'" + curves;
  for (const char *kind : {"limit.svg", "limit.png"}) draw::draw_with_gnuplot(commands, out / kind);
}

std::string with_error(double value, const ogive::ParameterReport<double> &report, const char *form) {
  char text[64];
  int n = std::snprintf(text, sizeof text, form, value);
  if (report.standard_error) {
    std::string both = std::string(text, static_cast<std::size_t>(n)) + " +- ";
    n = std::snprintf(text, sizeof text, form, *report.standard_error);
    return both + text;
  }
  return std::string(text) + (report.origin == ogive::ParameterOrigin::held ? " (held)" : "");
}

} // namespace

int find_limit(int argc, const char *const *argv) {
  const Search search = search_of(argc, argv);
  const auto parsed = parse(static_cast<int>(search.arguments.size()), search.arguments.data(), std::cout);
  if (!parsed) return success;
  Shots shots{*parsed, argv[0], {}};
  Options &o = shots.options;
  if (o.restart) input::refuse("--restart", o.restart->file.string(), "cannot be given to perforate limit");
  // The limits of the tests grow about so with the thickness; the search leaves a wrong guess quickly.
  const double guess = search.velocity_given ? o.velocity_mps : 5 * std::round((90 + 9 * o.thickness_mm) / 5);
  if (o.out == default_out(o)) {
    o.velocity_mps = 1;
    const std::string shot = default_out(o).string();
    o.out = shot.substr(0, shot.rfind("_1mps")) + "_limit" + shot.substr(shot.rfind("_1mps") + std::strlen("_1mps"));
  }
  o.vtk = o.picture = false;
  o.quiet = true;
  std::printf("Ballistic limit within %g m/s, %s\n", search.width_mps / 2, o.out.c_str());
  std::fflush(stdout);

  const auto tried = [&] {
    std::vector<ogive::TriedShot<double>> all;
    for (const Residual &s : shots.done) all.push_back({s.initial_mps, s.perforated});
    return all;
  };
  const auto fit_now = [&] {
    std::vector<ogive::ResidualShot<double>> residuals;
    for (const Residual &s : shots.done) residuals.push_back({s.initial_mps, s.residual_mps});
    return ogive::fit_ballistic_curve<double>(residuals, ogive::BallisticCurve<double>{1, 2, 0});
  };
  const auto next = [&] {
    return ogive::next_velocity(tried(), guess, search.width_mps, 1, ogive::expected_limit(fit_now()));
  };
  while (const auto velocity = next())
    if (!add_shot(shots, *velocity)) return shots.status;
  const auto bracket = ogive::bracket(tried());
  const auto estimate = ogive::limit_estimate(bracket);
  if (estimate) {
    std::printf("\n  %-22s %.1f +- %.1f m/s%s\n\n", "limit by bisection", estimate->limit, estimate->half_width,
                bracket.consistent ? "" : "; shots above it were stopped, too");
    std::fflush(stdout);
    for (const double times : shown_velocities)
      if (!add_shot(shots, 5 * std::ceil(estimate->limit * times / 5))) return shots.status;
    std::printf("\n");
  } else {
    std::printf("\n  no limit: %s\n", bracket.lowest_perforated ? "all shots perforated" : "all shots were stopped");
  }

  const auto fit = fit_now();
  ogive::write_atomically(o.out / "limit.csv", csv_of(shots.done));
  if (fit) {
    std::printf("  %-22s %s m/s\n", "limit of the fit", with_error(fit->curve.limit, fit->limit, "%.1f").c_str());
    std::printf("  %-22s a %s, p %s, %zu shots, rms %.1f m/s\n", "v_r = a (v^p-v_l^p)^1/p",
                with_error(fit->curve.a, fit->a, "%.3f").c_str(), with_error(fit->curve.p, fit->p, "%.2f").c_str(),
                fit->points, fit->rms);
  }
  try {
    draw_curve(shots, fit);
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "perforate: left out: %s\n", error.what());
  }
  std::printf("  %-22s %s\n", "files", (o.out / "limit.csv").c_str());
  return success;
}

} // namespace perforate
