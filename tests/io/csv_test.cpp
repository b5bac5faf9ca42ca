// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/csv.hpp"

#include "io/temporary_folder.hpp"

#include "catch.hpp"

#include <limits>

using ogive::add_row;
using ogive::continue_csv;

TEST_CASE("a table has one header and its rows are on the disk at once") {
  const TemporaryFolder folder;
  const auto path = folder.path / "history.csv";
  auto csv = continue_csv(path, {"time_us", "velocity_m_per_s"});
  CHECK(read_text(path) == "time_us,velocity_m_per_s\n");
  add_row(csv, {0.0, -303.5});
  CHECK(read_text(path) == "time_us,velocity_m_per_s\n0,-303.5\n");
  add_row(csv, {0.5, 1e-300});
  CHECK(read_text(path) == "time_us,velocity_m_per_s\n0,-303.5\n0.5,1e-300\n");
}

TEST_CASE("the numbers of a table read back as the same bits") {
  const TemporaryFolder folder;
  const auto path = folder.path / "history.csv";
  const double values[] = {1.0 / 3, std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min()};
  auto csv = continue_csv(path, {"a", "b", "c"});
  add_row(csv, values);
  std::istringstream text(read_text(path));
  std::string cell;
  std::getline(text, cell);
  for (const double value : values) {
    REQUIRE(std::getline(text, cell, ','));
    CHECK(std::strtod(cell.c_str(), nullptr) == value);
  }
}

TEST_CASE("a new table replaces an old one") {
  const TemporaryFolder folder;
  const auto path = folder.path / "history.csv";
  { auto old = continue_csv(path, {"old_table_with_a_long_header"}); }
  const auto csv = continue_csv(path, {"t"});
  CHECK(read_text(path) == "t\n");
}

TEST_CASE("a table goes on after the rows that it is given, whatever was there") {
  const TemporaryFolder folder;
  const auto path = folder.path / "history.csv";
  {
    auto csv = continue_csv(path, {"a", "b"});
    for (int k = 0; k < 5; ++k) add_row(csv, {double(k), 1.0 / 3});
  }
  const std::string whole = read_text(path);
  const double kept[] = {0, 1.0 / 3, 1, 1.0 / 3};
  {
    auto csv = continue_csv(path, {"a", "b"}, kept);
    CHECK(read_text(path) == "a,b\n0,0.3333333333333333\n1,0.3333333333333333\n");
    for (int k = 2; k < 5; ++k) add_row(csv, {double(k), 1.0 / 3});
  }
  CHECK(read_text(path) == whole);
  { auto csv = continue_csv(path, {"a", "b"}, {}); }
  CHECK(read_text(path) == "a,b\n");
  CHECK(count_files(folder.path) == 1);
  CHECK_THROWS_AS(continue_csv(path, {"a", "b"}, std::span(kept, 3)), ogive::SetupError);
  CHECK(read_text(path) == "a,b\n");
}

TEST_CASE("rows and column names that would spoil a table are refused") {
  const TemporaryFolder folder;
  const auto path = folder.path / "history.csv";
  auto csv = continue_csv(path, {"a", "b"});
  CHECK_THROWS_AS(add_row(csv, {1.0}), ogive::SetupError);
  CHECK_THROWS_AS(add_row(csv, {1.0, 2.0, 3.0}), ogive::SetupError);
  CHECK(read_text(path) == "a,b\n");
  for (const char *name : {"", "a,b", "a\nb", "a\"b"}) CHECK_THROWS_AS(continue_csv(path, {name}), ogive::SetupError);
  CHECK_THROWS_AS(continue_csv(path, {}), ogive::SetupError);
}

TEST_CASE("a table that cannot be written names the file and the reason") {
  const TemporaryFolder folder;
  const auto missing = folder.path / "gone" / "history.csv";
  CHECK_THROWS_WITH(continue_csv(missing, {"a"}), "cannot write " + missing.string() + ": No such file or directory");
  const auto path = folder.path / "history.csv";
  auto csv = continue_csv(path, {"a"});
  {
    const FullDisk full(6);
    add_row(csv, {1.0});
    // Two bytes of it fit.
    CHECK_THROWS_WITH(add_row(csv, {0.125}), "cannot write " + path.string() + ": File too large");
  }
  CHECK(read_text(path) == "a\n1\n");
  CHECK_THROWS_AS(add_row(csv, {2.0}), ogive::WriteError);
  CHECK(read_text(path) == "a\n1\n");
}

TEST_CASE("a full disk shows at the first row that does not fit") {
  if (!std::filesystem::exists("/dev/full")) {
    WARN("skipped: there is no /dev/full");
    return;
  }
  ogive::CsvWriter csv{"/dev/full", {"a"}, std::ofstream("/dev/full"), 0};
  CHECK_THROWS_WITH(add_row(csv, {1.0}), "cannot write /dev/full: No space left on device");
}
