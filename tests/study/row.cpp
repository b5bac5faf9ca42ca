// SPDX-License-Identifier: BSD-3-Clause
#include "sample.hpp"

#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "ogive/io/write_error.hpp"

#include <nlohmann/json.hpp>

using namespace study;

namespace {

/// A text with another part.
std::string changed(std::string text, const std::string &from, const std::string &to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

bool same(const Row &a, const Row &b) { return a.key == b.key && a.results == b.results; }

/// The summary of a shot whose results are all 1.5.
nlohmann::ordered_json sample_summary() {
  nlohmann::ordered_json json{{"fault", nullptr}, {"state_hash", "00ff"}, {"version", "0.1.0"}};
  for (const std::string &column : result_columns())
    if (!json.contains(column)) json[column] = 1.5;
  return json;
}

} // namespace

TEST_CASE("Rows of shots are read back exactly") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  const std::vector<std::string> own{"layers_mm", "layer_materials"};
  CHECK(read_rows(file, own).empty());
  Row first = sample_row(key_at(303.5)), second = sample_row(key_at(1.0 / 3));
  first.key.values.insert(first.key.values.end(), {"6,6", "my \"best\" steel.toml,weldox_460e"});
  second.key.values.insert(second.key.values.end(), {"", ""});
  append_row(file, first, own);
  append_row(file, second, own);
  const auto rows = read_rows(file, own);
  REQUIRE(rows.size() == 2);
  CHECK(same(rows[0], first));
  CHECK(same(rows[1], second));
  CHECK(find_row(rows, second.key) == &rows[1]);
  CHECK(find_row(rows, key_at(1.0 / 3)) == nullptr);
  CHECK(number(rows[0], "hourglass_fraction") == 0.1 + 0.2);
  CHECK(number(rows[1].key, velocity_column) == 1.0 / 3);
}

TEST_CASE("A shot has a folder that is named by its case") {
  CHECK(folder_name(key_at(303.5), {}) == "paper_mjc_weldox_460e_blunt_12mm_303.5mps_0.6mm");
  Key key = key_at(200);
  key.values[method_column] = "stabilised", key.values[material_column] = "metals/mine.toml";
  key.values.emplace_back("a/b,c");
  CHECK(folder_name(key, {"layer_materials"}) == "stabilised_mjc_mine_blunt_12mm_200mps_0.6mm_layer_materials=a_b,c");
}

TEST_CASE("A row that a killed process left half written is passed over and overwritten") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv", whole = folder.path / "whole.csv";
  for (const double velocity : {200.0, 300.0}) append_row(whole, sample_row(key_at(velocity)), {});
  const std::string text = read_text(whole);
  const std::size_t header = text.find('\n') + 1, row = text.find('\n', header) + 1;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    write(file, text.substr(0, length));
    const std::size_t known = length < row ? 0 : length < text.size() ? 1 : 2;
    CAPTURE(length);
    REQUIRE(read_rows(file, {}).size() == known);
    if (length % 23 != 0 && length + 2 < text.size()) continue; // appending waits for the disk
    append_row(file, sample_row(key_at(400)), {});
    REQUIRE(velocities_of(read_rows(file, {})).back() == 400);
    REQUIRE(read_rows(file, {}).size() == known + 1);
    REQUIRE(lines_in(read_text(file)) == static_cast<long>(known + 2));
  }
}

TEST_CASE("Rows that cannot be written or read are errors with their place") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  append_row(file, sample_row(key_at(200)), {});
  const std::string text = read_text(file);
  const auto error = [&](const std::string &from, const std::string &to) {
    write(file, changed(text, from, to));
    const std::string message = message_of([&] { read_all_rows(folder.path, {}); });
    CHECK(lines_in(message) == 0);
    return changed(message, file.string(), "shots.csv");
  };
  const auto count = [](int more) {
    return std::to_string(static_cast<int>(key_columns().size() + result_columns().size()) + more);
  };
  CHECK(error("nose", "nase") == "shots.csv:1: nose = nase: must be the column nose");
  CHECK(error("nose", "steel,nose").starts_with("shots.csv:1: fields in the row: must be at most " + count(0)));
  CHECK(error("nose,", "") == "shots.csv:1: fields in the row = " + count(-1) + ": must be " + count(0));
  CHECK(error(",12,", ",12mm,") == "shots.csv:2: thickness_mm = 12mm: must be a finite number");
  CHECK(error(",12,", ",,") == "shots.csv:2: thickness_mm = : must be a finite number");
  CHECK(error(",12,", ",nan,") == "shots.csv:2: thickness_mm = nan: must be a finite number");
  CHECK(error(",0.6,", ",inf,") == "shots.csv:2: spacing_mm = inf: must be a finite number");
  CHECK(error(",12,", ",") == "shots.csv:2: fields in the row = " + count(-1) + ": must be " + count(0));

  // The rows of a study with other columns.
  write(file, text);
  CHECK(message_of([&] { read_all_rows(folder.path, {"friction"}); }).find("shots.csv:1: fields in the row") !=
        std::string::npos);

  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  CHECK(message_of([&] { read_all_rows(folder.path, {}); }).ends_with("shots.csv: must be a file that can be read"));
  CHECK_THROWS_AS(append_row(file, sample_row(key_at(200)), {}), ogive::WriteError);
}

TEST_CASE("A full disk costs no row that was there") {
  const TemporaryFolder folder;
  const auto file = folder.path / "shots.csv";
  append_row(file, sample_row(key_at(200)), {});
  {
    const FullDisk full(std::filesystem::file_size(file) + 20);
    CHECK_THROWS_AS(append_row(file, sample_row(key_at(300)), {}), ogive::WriteError);
  }
  CHECK(velocities_of(read_rows(file, {})) == std::vector<double>{200});
  append_row(file, sample_row(key_at(400)), {});
  CHECK(velocities_of(read_rows(file, {})) == std::vector<double>{200, 400});
}

TEST_CASE("The rows of shards are merged, each shot once, whatever the order of the files") {
  const TemporaryFolder one, other;
  const auto row = [](double velocity, const std::string &hash) {
    Row r = sample_row(key_at(velocity));
    result(r, "state_hash") = hash;
    return r;
  };
  const auto fill = [&](const std::filesystem::path &folder, const char *a, const char *b, const char *c) {
    append_row(folder / a, row(300, "b"), {});
    append_row(folder / a, row(1000, "a"), {});
    append_row(folder / b, row(300, "a"), {});
    append_row(folder / c, row(200, "a"), {});
    append_row(folder / c, row(300, "a"), {});
    write(folder / "steel_blunt_limits.csv", "no rows\n");
  };
  fill(one.path, "shots.csv", "shots.1-of-3.csv", "shots.2-of-3.csv");
  fill(other.path, "shots.2-of-3.csv", "shots.csv", "shots.3-of-3.csv");
  const auto rows = read_all_rows(one.path, {});
  CHECK(velocities_of(rows) == std::vector<double>{200, 300, 1000}); // as numbers, not as texts
  CHECK(hashes_of(rows) == std::vector<std::string>{"a", "a", "a"});
  const auto again = read_all_rows(other.path, {});
  REQUIRE(again.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(same(rows[k], again[k]));
  CHECK(read_all_rows(one.path / "missing", {}).empty());
}

TEST_CASE("A row is made of the summary of a shot without a fault") {
  const auto reason = [](const nlohmann::ordered_json &summary) {
    const std::string message = message_of([&] { row_of(key_at(200), summary, "name"); });
    CHECK(lines_in(message) == 0);
    return message;
  };
  auto json = sample_summary();
  json["perforated"] = true;
  Row row = row_of(key_at(200), json, "name");
  CHECK(result(row, "perforated") == "1");
  CHECK(result(row, "cpu_s") == "1.5");
  CHECK(result(row, "state_hash") == "00ff");

  // An undecided shot has neither.
  CHECK_FALSE(is_undecided(row));
  auto undecided = json;
  undecided["perforated"] = undecided["residual_velocity_mps"] = nullptr;
  row = row_of(key_at(200), undecided, "name");
  CHECK(is_undecided(row));
  CHECK(result(row, "residual_velocity_mps").empty());
  const TemporaryFolder undecided_folder;
  append_row(undecided_folder.path / "shots.csv", row, {});
  CHECK(is_undecided(read_all_rows(undecided_folder.path, {}).at(0)));
  append_row(undecided_folder.path / "shots.csv", row_of(key_at(200), json, "name"), {});
  REQUIRE(read_all_rows(undecided_folder.path, {}).size() == 1);
  CHECK_FALSE(is_undecided(read_all_rows(undecided_folder.path, {}).at(0)));

  // Several plates have no shape.
  json.erase("dishing_mm");
  row = row_of(key_at(200), json, "name");
  CHECK(result(row, "dishing_mm") == "0");

  for (const std::string column : {"state_hash", "residual_velocity_mps", "steps"}) {
    auto part = sample_summary();
    part.erase(column);
    CHECK(reason(part).find(column) != std::string::npos);
  }
  json["steps"] = nullptr;
  CHECK(reason(json).find("must be number, but is null") != std::string::npos);
  json = sample_summary();
  json["fault"] = {{"what", "negative\nvolume"}};
  CHECK(reason(json) == "name: the run stopped: negative?volume");

  const TemporaryFolder folder;
  write(folder.path / "summary.json", "no json");
  CHECK(message_of([&] { read_summary(folder.path); }).ends_with("summary.json: is not the summary of a shot"));
  CHECK(message_of([&] {
          read_summary(folder.path / "none");
        }).ends_with("summary.json: must be a file that can be read"));
}
