// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include "cases.hpp"
#include "finish.hpp"
#include "options/data_folder.hpp"
#include "options/exit_status.hpp"
#include "plots.hpp"
#include "shot/experiment.hpp"
#include "shot/table.hpp"

#include <iostream>

namespace study {

namespace {

using options::Given;

constexpr double bracket_width_mps = 5;

/// The methods whose curves the figures show, the paper's first.
const Texts methods{"paper", "stabilised"};

/// An option with some texts to choose from.
void add_choice(options::Table &t, std::string &value, const options::Entry &entry, const Texts &names) {
  options::Option &option = options::add(t, value, entry);
  option.names = names;
  option.placeholder = "NAME";
  option.assign = [&value, names, allowed = std::string(entry.allowed)](const Given &given) {
    if (std::find(names.begin(), names.end(), given.value) == names.end()) refuse(given, "must be " + allowed);
    value = given.value;
  };
}

// clang-format off
options::Table table_of(const Figures &figures, FigureOptions &o, StudyOptions &s) {
  options::Table t;
  options::Option &figure = options::add(t, o.figure, {.key = "figure",
      .meaning = "number of the only figure to compute",
      .source = "all: ours", .brief = "number of the only figure to compute", .limits = {1, 99, ""}});
  figure.allowed_text = "one of " + options::joined(figures.figures);
  figure.range = ", of " + options::joined(figures.figures);
  figure.assign = [&o, list = figures.figures, allowed = figure.allowed_text](const Given &given) {
    const auto number = number_given(given);
    if (!number || *number != static_cast<int>(*number)) refuse(given, "must be a whole number, " + allowed);
    o.figure = static_cast<int>(*number);
    if (std::find(list.begin(), list.end(), o.figure) == list.end()) refuse(given, "must be " + allowed);
  };
  options::add(t, o.quick, {.key = "quick", .meaning = "coarse shots, particles 1.5 mm apart, in vtk_out/figures_quick",
      .source = "no: ours", .brief = "coarse shots, particles 1.5 mm apart"});
  add_choice(t, o.method, {.key = "method",
      .meaning = "numerical method; stabilised adds its curves, of mjc alone, to the plots",
      .source = "paper", .brief = "paper or stabilised", .allowed = "one of paper, stabilised"},
      methods);
  add_choice(t, o.model, {.key = "model", .meaning = "flow law: mjc, jc or both; pictures have mjc alone",
      .source = "ours", .brief = "flow law: mjc, jc or both", .allowed = "mjc, jc or both"},
      {"mjc", "jc", "both"});
  options::add(t, o.spacing_mm, {.key = "spacing_mm",
      .meaning = "particle distance of all shots; as listed: 0.6 mm for blunt, 1 mm for sharp noses",
      .source = "as listed: paper, for blunt noses", .brief = "particle distance of all shots",
      .limits = {0.05, 5, "mm"}});
  options::add(t, o.limits, {.key = "limits", .meaning = "bisect the ballistic limits", .source = "ours"});
  options::add(t, o.pictures, {.key = "pictures", .meaning = "run the shots that only pictures need, and write frames",
      .source = "ours"});
  options::add(t, o.out, {.key = "out", .meaning = "folder for rows, shots and pictures; shards may share it",
      .source = "vtk_out/figures: ours", .brief = "folder for the results"});
  add_study_options(t, s);
  return t;
}
// clang-format on

std::vector<Series> curves_in(const std::vector<FigureShot> &shots, const Study &study) {
  std::vector<Case> cases;
  for (const FigureShot &listed : shots)
    if (!listed.picture) cases.push_back(listed.shot);
  return series_in(share_of_series(cases, study));
}

/// Draws what is known of the options' method and of those that have rows.
void draw(const Figures &figures, const FigureOptions &o, const Study &study) {
  const auto rows = read_all_rows(o.out, {});
  std::vector<Series> series;
  for (const std::string &method : methods) {
    if (method != o.method &&
        std::none_of(rows.begin(), rows.end(), [&](const Row &row) { return row.key.values[method_column] == method; }))
      continue;
    FigureOptions other = o;
    other.method = method;
    for (const Series &one : curves_in(listed_shots(figures, other), study)) series.push_back(one);
  }
  const auto limits = write_limits(o.out / (figures.name + "_limits.csv"), series, rows, {});
  for (const FigurePlot &figure : figures.plots) {
    if (o.figure != 0 && o.figure != figure.figure) continue;
    const Plot plot{"figure_" + std::to_string(figure.figure), figure.title};
    if (figure.kind == FigurePlot::residual_velocity ? draw_residuals(plot, series, rows, {}, o.out)
                                                     : draw_limits(plot, limits, {}, o.out))
      std::printf("figure %d: %s\n", figure.figure, (o.out / plot.name).c_str());
  }
}

int run(const Figures &figures, const options::Arguments &arguments) {
  FigureOptions o;
  StudyOptions s;
  const options::Table table = table_of(figures, o, s);
  const options::Command command{
      .name = figures.name,
      .purpose = figures.purpose + "\nShots that have a row in OUT/shots*.csv are not run again; one that was stopped "
                                   "resumes from its checkpoint.\n",
      .usage = "[options]"};
  const auto line = options::read_values(command, table, arguments, std::cout);
  if (!line) return options::only_printed;
  if (o.quick && line->find("spacing_mm") == nullptr) o.spacing_mm = 1.5;
  if (o.quick && line->find("out") == nullptr) o.out = "vtk_out/figures_quick";

  const Study study = study_of(s, o.out);
  const auto shots = listed_shots(figures, o);
  const auto run_shots = [&](const Report &report) {
    Outcome all = run_cases(study, share_of_series(cases_in(shots), study), report);
    if (o.limits && all.stopped_by == 0)
      add(all, find_limits(study, curves_in(shots, study), bracket_width_mps, report));
    return all;
  };
  return run_study(figures.name.c_str(), study, s.run, run_shots, [&] { draw(figures, o, study); });
}

} // namespace

std::vector<FigureShot> listed_shots(const Figures &figures, const FigureOptions &o) {
  const auto file = options::data_folder() / "figure_shots.csv";
  std::vector<FigureShot> shots;
  for (const char *model : {"mjc", "jc"}) {
    if (o.method != methods[0] ? model != std::string_view("mjc") : o.model != "both" && o.model != model) continue;
    for (const auto &row : experiment::read_rows(file)) {
      if (row.size() != 10) throw ogive::SetupError(file.string() + ": fields in a row: must be 10");
      if (row[1] != figures.name || (row[3] != "both" && row[3] != model)) continue;
      const bool picture = row[2] == "picture";
      if (picture && !o.pictures) continue;
      const int figure = static_cast<int>(ogive::number_from(row[0]).value_or(0));
      // Figs. 9 and 13 are the limits of the plates of Figs. 6 and 12.
      const bool limits_too = !picture && o.figure != 0 && o.figure == (figure == 6 ? 9 : figure == 12 ? 13 : -1);
      if (o.figure != 0 && o.figure != figure && !limits_too) continue;
      const bool frames = o.pictures && !row[9].empty();
      std::vector<Given> given;
      const auto give = [&](const std::string &key, const std::string &value) {
        given.push_back({key, file.string() + ": " + key, value});
      };
      give("method", o.method), give("model", model), give("material", row[4]), give("nose", row[5]);
      give("thickness_mm", row[6]), give("velocity_mps", row[7]);
      give("spacing_mm", o.spacing_mm == 0 ? row[8] : options::shortest(o.spacing_mm));
      give("vtk", frames ? "true" : "false");
      if (frames) give("output_every_us", row[9]);
      shots.push_back({figure, picture, case_of(shot::settled({{given}}), {}, "")});
    }
  }
  if (shots.empty()) throw ogive::SetupError(file.string() + ": has no shots for " + figures.name);
  return shots;
}

std::vector<Case> cases_in(const std::vector<FigureShot> &shots) {
  std::vector<Case> cases;
  for (const FigureShot &listed : shots) {
    const auto found =
        std::find_if(cases.begin(), cases.end(), [&](const Case &c) { return c.key == listed.shot.key; });
    if (found == cases.end()) {
      cases.push_back(listed.shot);
    } else if (const shot::Options &with = listed.shot.options; with.vtk) {
      shot::Options &o = found->options;
      o.output_every_us = o.vtk ? std::min(o.output_every_us, with.output_every_us) : with.output_every_us;
      o.vtk = true;
    }
  }
  return cases;
}

std::vector<Case> share_of_series(const std::vector<Case> &all, const Study &study) {
  std::vector<Key> series;
  std::vector<Case> mine;
  for (const Case &shot : all) {
    auto place = std::find(series.begin(), series.end(), series_key(shot.key));
    if (place == series.end()) place = series.insert(place, series_key(shot.key));
    if ((place - series.begin()) % study.shards == study.shard - 1) mine.push_back(shot);
  }
  return mine;
}

int run_figures(const Figures &figures, const options::Arguments &arguments) {
  return options::run_main(figures.name, [&] { return run(figures, arguments); });
}

} // namespace study
