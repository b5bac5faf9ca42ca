// SPDX-License-Identifier: BSD-3-Clause
#include "study/figures.hpp"
#include "sample.hpp"

#include "catch.hpp"

#include <set>

using namespace study;

namespace {

const Figures steel{"steel_blunt", "", {6, 7, 8, 9, 10}, {}};
const Figures noses{"nose_shapes", "", {11}, {}};
const Figures aluminium{"aluminium_conical", "", {12, 13, 14}, {}};

FigureOptions options_for(int figure, const std::string &model = "both") {
  FigureOptions o;
  o.figure = figure, o.model = model;
  return o;
}

/// The time between the frames of a shot, us; 0: it writes none.
double frames_us(const Case &shot) { return shot.options.vtk ? shot.options.output_every_us : 0; }

} // namespace

TEST_CASE("The list has the shots of a program, figure and law") {
  const auto all = listed_shots(steel, {});
  CHECK(all.size() == 81);
  CHECK(std::all_of(all.begin(), all.end(),
                    [](const FigureShot &s) { return s.shot.key.values[method_column] == "paper"; }));
  CHECK(listed_shots(noses, {}).size() == 36);
  CHECK(listed_shots(aluminium, {}).size() == 50);
  CHECK(listed_shots(aluminium, options_for(0, "jc")).size() == 25); // one more at 25 mm, where its limit is higher
  CHECK(listed_shots(steel, options_for(0, "jc")).size() == 36);
  CHECK(listed_shots(steel, options_for(6)).size() == 72);

  // Pictures are of the modified law only.
  for (const FigureShot &one : all)
    CHECK((!one.picture || (one.shot.key.values[model_column] == "mjc" && frames_us(one.shot) > 0)));
  const auto eight = listed_shots(steel, options_for(8));
  REQUIRE(eight.size() == 2);
  CHECK((eight[0].picture && eight[1].picture));
  CHECK(message_of([] { listed_shots(steel, options_for(8, "jc")); }).ends_with("no shots for steel_blunt"));

  // The other method has the modified law alone.
  FigureOptions stabilised;
  stabilised.method = "stabilised";
  for (const FigureShot &one : listed_shots(noses, stabilised)) {
    CHECK(one.shot.key.values[method_column] == "stabilised");
    CHECK(one.shot.key.values[model_column] == "mjc");
  }

  // The limits are those of the curves.
  for (const auto &[limits, curves, figures] : {std::tuple{9, 6, &steel}, std::tuple{13, 12, &aluminium}}) {
    const auto of_limits = cases_in(listed_shots(*figures, options_for(limits)));
    const auto of_curves = cases_in(listed_shots(*figures, options_for(curves)));
    REQUIRE(of_limits.size() == of_curves.size());
    for (std::size_t k = 0; k < of_limits.size(); ++k) CHECK(of_limits[k].key == of_curves[k].key);
  }

  // Each nose has its own particle distance, unless all get another one.
  for (const FigureShot &one : listed_shots(noses, {}))
    CHECK(one.shot.options.spacing_mm == (one.shot.options.nose == ogive::Nose::blunt ? 0.6 : 1.0));
  FigureOptions coarse;
  coarse.spacing_mm = 1.5;
  CHECK(listed_shots(noses, coarse).front().shot.options.spacing_mm == 1.5);
}

TEST_CASE("A shot of several figures is one case, with the most frequent frames") {
  const auto cases = cases_in(listed_shots(steel, {}));
  CHECK(cases.size() == 78);
  std::set<Key> keys;
  std::set<std::string> folders;
  for (const Case &shot : cases) {
    keys.insert(shot.key);
    folders.insert(shot.name);
    if (shot.key == key_at(180, "10")) CHECK(frames_us(shot) == 5); // of a curve, of Fig. 7 and of Fig. 8
    if (shot.key == key_at(195)) CHECK(frames_us(shot) == 50);
    if (shot.key == key_at(303.5)) CHECK(frames_us(shot) == 0);
  }
  CHECK(keys.size() == cases.size());
  CHECK(folders.size() == cases.size());

  const auto merged = [](const std::vector<double> &frames) {
    std::vector<FigureShot> shots;
    for (const double every : frames) {
      Case shot = small_case(180);
      shot.options.vtk = every > 0;
      if (every > 0) shot.options.output_every_us = every;
      shots.push_back({7, true, shot});
    }
    return frames_us(cases_in(shots).at(0));
  };
  CHECK(merged({0, 50, 5, 0}) == 5);
  CHECK(merged({5, 50}) == 5);
  CHECK(merged({50, 5}) == 5);
  CHECK(merged({0, 0}) == 0);

  // Figs. 6 and 11 share the blunt shots at 12 mm.
  int shared = 0;
  for (const Case &shot : cases_in(listed_shots(noses, {}))) shared += keys.contains(shot.key);
  CHECK(shared == 12);
}

TEST_CASE("Without pictures no shot writes frames, and the curves are the same") {
  FigureOptions with, without;
  without.pictures = false;
  const auto all = listed_shots(steel, with), few = listed_shots(steel, without);
  const auto writes = [](const FigureShot &one) { return frames_us(one.shot) > 0; };
  CHECK(std::any_of(all.begin(), all.end(), writes));
  CHECK(std::none_of(few.begin(), few.end(), writes));
  const auto points = [](const std::vector<FigureShot> &shots) {
    std::set<Key> keys;
    for (const FigureShot &one : shots)
      if (!one.picture) keys.insert(one.shot.key);
    return keys;
  };
  CHECK(points(few) == points(all));
}

TEST_CASE("Shards part the list, and no series is in two") {
  for (const Figures *figures : {&steel, &noses, &aluminium})
    for (const int shards : {1, 2, 3, 7, 40}) {
      const auto all = cases_in(listed_shots(*figures, {}));
      std::set<Key> series;
      std::size_t shots = 0, in_shards = 0;
      for (int shard = 1; shard <= shards; ++shard) {
        std::set<Key> here;
        for (const Case &shot : share_of_series(all, {.out = "", .shard = shard, .shards = shards}))
          ++shots, here.insert(series_key(shot.key));
        in_shards += here.size();
        series.merge(here);
      }
      CHECK(shots == all.size());
      CHECK(in_shards == series.size());
    }
}
