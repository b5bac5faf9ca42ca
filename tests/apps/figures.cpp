// SPDX-License-Identifier: BSD-3-Clause
#include "figures/campaign.hpp"

#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "ogive/io/write_error.hpp"
#include "parse.hpp"

#include <algorithm>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

using namespace figures;

namespace {

const std::filesystem::path data = FIGURES_DATA_FOLDER;

const Campaign steel{"steel_blunt", "", {6, 7, 8, 9, 10}, {}};
const Campaign noses{"nose_shapes", "", {11}, {}};
const Campaign aluminium{"aluminium_conical", "", {12, 13, 14}, {}};

ShotKey shot_at(double velocity, double thickness = 12) {
  return {"sfm", "mjc", "weldox_460e", "blunt", thickness, velocity, 0.6};
}

/// A shot that perforated above `limit`, with numbers that a few digits do not hold.
ShotRow shot_row(ShotKey key, double limit = 200) {
  ShotRow row;
  row.key = key;
  row.perforated = key.initial_velocity_mps > limit;
  row.residual_velocity_mps =
      row.perforated != 0 ? 0.8 * std::sqrt(std::pow(key.initial_velocity_mps, 2) - limit * limit) : 0;
  row.energy_error = 1.0 / 3, row.momentum_error = 4.9e-324, row.hourglass_fraction = 0.1 + 0.2, row.steps = 1e15 + 2;
  row.wall_s = 12345.678901234567, row.dishing_mm = -0.0;
  row.state_hash = "0123456789abcdef", row.version = "0.1.0";
  return row;
}

/// All values of a row: texts, and numbers with all their bits.
std::vector<std::string> values_of(const ShotRow &row) {
  std::vector<std::string> values;
  for_each_column(row, [&]<class V>(const char *, const V &value) {
    if constexpr (std::is_same_v<V, double>)
      values.emplace_back(reinterpret_cast<const char *>(&value), sizeof value);
    else
      values.push_back(value);
  });
  return values;
}

std::vector<double> velocities_of(const std::vector<ShotRow> &rows) {
  std::vector<double> velocities;
  for (const ShotRow &row : rows) velocities.push_back(row.key.initial_velocity_mps);
  return velocities;
}

/// A line of a row file with other text in one column.
std::string changed(std::string text, const std::string &from, const std::string &to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

Options options_for(std::optional<int> figure, const std::string &model = "both") {
  Options o;
  o.figure = figure, o.model = model;
  return o;
}

long lines_in(const std::string &text) { return std::count(text.begin(), text.end(), '\n'); }

} // namespace

TEST_CASE("Rows of shots are read back exactly") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  CHECK(read_rows(file).empty());
  const ShotRow first = shot_row(shot_at(303.5)), second = shot_row(shot_at(1.0 / 3));
  append_row(file, first);
  append_row(file, second);
  const auto rows = read_rows(file);
  REQUIRE(rows.size() == 2);
  CHECK(values_of(rows[0]) == values_of(first));
  CHECK(values_of(rows[1]) == values_of(second));
  CHECK(find_row(rows, second.key) == &rows[1]);
  CHECK(find_row(rows, shot_at(303)) == nullptr);
  CHECK(folder_name(first.key) == "mjc_weldox_460e_blunt_12mm_303.5mps_0.6mm");
}

TEST_CASE("A row that a killed process left half written is passed over and overwritten") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv", whole = folder.path / "whole.csv";
  for (const double velocity : {200.0, 300.0}) append_row(whole, shot_row(shot_at(velocity)));
  const std::string text = read_text(whole);
  const std::size_t header = text.find('\n') + 1, row = text.find('\n', header) + 1;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    write(file, text.substr(0, length));
    const std::size_t known = length < row ? 0 : length < text.size() ? 1 : 2;
    CAPTURE(length);
    REQUIRE(read_rows(file).size() == known);
    if (length % 7 != 0 && length + 2 < text.size()) continue; // appending waits for the disk
    append_row(file, shot_row(shot_at(400)));
    REQUIRE(velocities_of(read_rows(file)).back() == 400);
    REQUIRE(read_rows(file).size() == known + 1);
    REQUIRE(lines_in(read_text(file)) == static_cast<long>(known + 2));
  }
}

TEST_CASE("Rows that cannot be written or read are errors with their place") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  append_row(file, shot_row(shot_at(200)));
  const std::string text = read_text(file);
  const auto error = [&](const std::string &from, const std::string &to) {
    write(file, changed(text, from, to));
    const std::string message = message_of([&] { read_all_rows(folder.path); });
    CHECK(lines_in(message) == 0);
    return changed(message, file.string(), "shots.csv");
  };
  int fields = 0;
  for_each_column(ShotRow{}, [&](const char *, const auto &) { ++fields; });
  const auto count = [&](int more) { return std::to_string(fields + more); };
  CHECK(error("nose", "nase") == "shots.csv:1: nose = nase: must be the column nose");
  CHECK(error("nose", "steel,nose").starts_with("shots.csv:1: fields in the row: must be at most " + count(0)));
  CHECK(error("nose,", "") == "shots.csv:1: fields in the row = " + count(-1) + ": must be " + count(0));
  CHECK(error(",12,", ",12mm,") == "shots.csv:2: thickness_mm = 12mm: must be a finite number");
  CHECK(error(",12,", ",,") == "shots.csv:2: thickness_mm = : must be a finite number");
  CHECK(error(",12,", ",nan,") == "shots.csv:2: thickness_mm = nan: must be a finite number");
  CHECK(error(",0.6,", ",inf,") == "shots.csv:2: spacing_mm = inf: must be a finite number");
  CHECK(error(",12,", ",") == "shots.csv:2: fields in the row = " + count(-1) + ": must be " + count(0));

  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  CHECK(message_of([&] { read_all_rows(folder.path); }).ends_with("shots.csv: must be a file that can be read"));
  CHECK_THROWS_AS(append_row(file, shot_row(shot_at(200))), ogive::WriteError);
}

TEST_CASE("A full disk costs no row that was there") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  append_row(file, shot_row(shot_at(200)));
  {
    const FullDisk full(std::filesystem::file_size(file) + 20);
    CHECK_THROWS_AS(append_row(file, shot_row(shot_at(300))), ogive::WriteError);
  }
  CHECK(velocities_of(read_rows(file)) == std::vector<double>{200});
  append_row(file, shot_row(shot_at(400)));
  CHECK(velocities_of(read_rows(file)) == std::vector<double>{200, 400});
}

TEST_CASE("The rows of shards are merged, each shot once, whatever the order of the files") {
  const TemporaryFolder one, other;
  const auto row = [](double velocity, const std::string &hash) {
    ShotRow r = shot_row(shot_at(velocity));
    r.state_hash = hash;
    return r;
  };
  const auto fill = [&](const std::filesystem::path &folder, const char *a, const char *b, const char *c) {
    append_row(folder / a, row(300, "b"));
    append_row(folder / a, row(100, "a"));
    append_row(folder / b, row(300, "a"));
    append_row(folder / c, row(200, "a"));
    append_row(folder / c, row(300, "a"));
    write(folder / "steel_blunt_limits.csv", "no rows\n");
  };
  fill(one.path, "shots.csv", "shots.1-of-3.csv", "shots.2-of-3.csv");
  fill(other.path, "shots.2-of-3.csv", "shots.csv", "shots.3-of-3.csv");
  const auto rows = read_all_rows(one.path);
  CHECK(velocities_of(rows) == std::vector<double>{100, 200, 300});
  CHECK(rows[2].state_hash == "a");
  const auto again = read_all_rows(other.path);
  REQUIRE(again.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(values_of(rows[k]) == values_of(again[k]));
  CHECK(read_all_rows(one.path / "missing").empty());
}

TEST_CASE("Processes append to one file of rows at the same time") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  for (int process = 0; process < 4; ++process)
    if (::fork() == 0) {
      for (int k = 0; k < 25; ++k) append_row(file, shot_row(shot_at(100 + 100 * process + k)));
      ::_exit(0);
    }
  for (int process = 0; process < 4; ++process) {
    int status = 1;
    ::wait(&status);
    CHECK(status == 0);
  }
  CHECK(read_rows(file).size() == 100);
  CHECK(read_all_rows(folder.path).size() == 100);
  CHECK(lines_in(read_text(file)) == 101);
}

TEST_CASE("The list has the shots of a program, figure and law") {
  const auto all = listed_shots(steel, {}, data);
  CHECK(all.size() == 81);
  CHECK(std::all_of(all.begin(), all.end(), [](const ListedShot &s) { return s.task.key.method == "sfm"; }));
  CHECK(listed_shots(noses, {}, data).size() == 36);
  CHECK(listed_shots(aluminium, {}, data).size() == 49);
  CHECK(listed_shots(steel, options_for({}, "jc"), data).size() == 36);
  CHECK(listed_shots(steel, options_for(6), data).size() == 72);

  // Pictures are of the modified law only.
  for (const auto &shot : all) CHECK((!shot.picture || (shot.task.key.model == "mjc" && shot.task.frames_us > 0)));
  const auto eight = listed_shots(steel, options_for(8), data);
  REQUIRE(eight.size() == 2);
  CHECK((eight[0].picture && eight[1].picture));
  CHECK(series_in(eight).empty());
  CHECK(message_of([] { listed_shots(steel, options_for(8, "jc"), data); }).ends_with("no shots for steel_blunt"));

  // The limits are those of the curves.
  for (const auto &[limits, curves, campaign] : {std::tuple{9, 6, &steel}, std::tuple{13, 12, &aluminium}}) {
    const auto of_limits = tasks_of(listed_shots(*campaign, options_for(limits), data));
    const auto of_curves = tasks_of(listed_shots(*campaign, options_for(curves), data));
    REQUIRE(of_limits.size() == of_curves.size());
    for (std::size_t k = 0; k < of_limits.size(); ++k) CHECK(of_limits[k].key == of_curves[k].key);
  }

  Options coarse;
  coarse.spacing_mm = 1.5;
  CHECK(listed_shots(noses, coarse, data).front().task.key.spacing_mm == 1.5);
}

TEST_CASE("A shot of several figures is one task, with the most frequent frames") {
  const auto tasks = tasks_of(listed_shots(steel, {}, data));
  CHECK(tasks.size() == 78);
  std::set<ShotKey> keys;
  for (const Task &task : tasks) {
    keys.insert(task.key);
    if (task.key == shot_at(180, 10)) CHECK(task.frames_us == 5); // a curve's, Fig. 7's and Fig. 8's
    if (task.key == shot_at(195, 12)) CHECK(task.frames_us == 50);
    if (task.key == shot_at(303.5)) CHECK(task.frames_us == 0);
  }
  CHECK(keys.size() == tasks.size());

  const auto merged = [](std::vector<double> frames) {
    std::vector<ListedShot> shots;
    for (const double every : frames) shots.push_back({7, true, {shot_at(180), every}});
    return tasks_of(shots).at(0).frames_us;
  };
  CHECK(merged({0, 50, 5, 0}) == 5);
  CHECK(merged({5, 50}) == 5);
  CHECK(merged({0, 0}) == 0);

  // Figs. 6 and 11 share the blunt shots at 12 mm.
  int shared = 0;
  for (const Task &task : tasks_of(listed_shots(noses, {}, data))) shared += keys.contains(task.key);
  CHECK(shared == 12);
}

TEST_CASE("Shards part the list, and no series is in two") {
  for (const Campaign *campaign : {&steel, &noses, &aluminium})
    for (const int shards : {1, 2, 3, 7, 40}) {
      const auto all = listed_shots(*campaign, {}, data);
      std::set<SeriesKey> series;
      std::size_t shots = 0, in_shards = 0;
      for (int shard = 1; shard <= shards; ++shard) {
        Options o;
        o.shard = shard, o.shards = shards;
        std::set<SeriesKey> here;
        for (const auto &shot : share_of(all, o)) ++shots, here.insert(series_of(shot.task.key));
        in_shards += here.size();
        series.merge(here);
      }
      CHECK(shots == all.size());
      CHECK(in_shards == series.size());
    }
}
