// SPDX-License-Identifier: BSD-3-Clause
#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"
#include "locale.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/archive.hpp"
#include "ogive/io/csv.hpp"
#include "ogive/io/read_frame.hpp"
#include "ogive/io/text.hpp"

#include "catch.hpp"

#include <cstdio>
#include <map>

using namespace ogive;

namespace {

/// The bytes of all files that are written for the frame, by name.
std::map<std::string, std::string> files_of(const Frame &frame) {
  const TemporaryFolder folder;
  auto series = open_series(folder.path, "plate");
  add_frame(series, frame);
  auto csv = continue_csv(folder.path / "history.csv", {"time_us", "velocity_m_per_s"});
  add_row(csv, {2.07519013, -12345.5});
  std::map<std::string, std::string> files;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder.path))
    if (entry.is_regular_file()) files[entry.path().filename().string()] = read_text(entry.path());
  return files;
}

Frame sample_frame() {
  Frame frame = sample::perforated_plate(8e-3F, 2.4e-3F);
  frame.time = 2.07519013e-6;
  return frame;
}

std::string refusal(double value) {
  try {
    require(false, "thickness (m)", value, "must be less");
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("files have the same bytes whatever the locale of the program") {
  const Frame frame = sample_frame();
  const auto plain = files_of(frame);
  REQUIRE(plain.size() == 5);
  CHECK(plain.at("plate.pvd").find("timestep=\"2.07519013\"") != std::string::npos);
  const GermanLocale german;
  if (!german.also_c) WARN("only the C++ locale is tried: there is no locale de_DE, and localedef cannot build it");
  std::ostringstream stream;
  stream << 1234.5;
  REQUIRE(stream.str() == "1.234,5");
  for (const auto &[name, bytes] : files_of(frame)) {
    INFO(name);
    CHECK(bytes == plain.at(name));
  }
}

TEST_CASE("files read alike whatever the locale of the program") {
  const TemporaryFolder folder;
  const Frame frame = sample_frame();
  const auto write = [&] {
    auto series = open_series(folder.path, "plate");
    add_frame(series, frame);
  };
  const auto read = [&] {
    const StoredSeries series = read_series(folder.path / "plate.pvd");
    REQUIRE(series.frames.size() == 1);
    CHECK(series.frames[0].time == Approx(frame.time).epsilon(1e-8));
    return read_frame(series, 0);
  };
  write();
  const Frame plain = read();
  const GermanLocale german;
  for (const bool again : {false, true}) {
    if (again) write();
    const Frame now = read();
    REQUIRE(now.clouds.size() == 1);
    REQUIRE(now.grids.size() == 2);
    CHECK(now.clouds[0].diameter == plain.clouds[0].diameter);
    CHECK(now.clouds[0].positions == plain.clouds[0].positions);
    CHECK(now.grids[0].positions == plain.grids[0].positions);
    CHECK(now.grids[1].cell_fields[0].values == plain.grids[1].cell_fields[0].values);
  }
}

TEST_CASE("numbers as text are those of the locale C, whatever the locale of the program") {
  const GermanLocale german;
  CHECK(shortest(1234.5) == "1234.5");
  CHECK(number_from("1234.5") == 1234.5);
  CHECK(!number_from("1234,5"));
  CHECK(with_digits(1234.5678, 6) == "1234.57");
  CHECK(with_digits(1e-7, 3) == "1e-07");
  CHECK(with_digits(2.07519013e6, 3) == "2.08e+06");
  CHECK(with_decimals(-1234.5678, 2) == "-1234.57");
  CHECK(with_decimals(1e300, 0).size() == 301);
  CHECK(refusal(1234567.5) == "thickness (m) = 1.23457e+06: must be less");
  CHECK(refusal(1234.5) == "thickness (m) = 1234.5: must be less");
}

TEST_CASE("digits and decimals are what printf writes") {
  for (const double number : {0.0, -0.0, 1.0, -303.5, 2.5, 3.5, 1.0 / 3, 1e-5, 1e15, 123456789.0, 5e-324, 1.7e308})
    for (int precision = 0; precision < 12; ++precision) {
      char text[400];
      std::snprintf(text, sizeof text, "%.*g", precision, number);
      CHECK(with_digits(number, precision) == text);
      std::snprintf(text, sizeof text, "%.*f", precision, number);
      CHECK(with_decimals(number, precision) == text);
    }
}

TEST_CASE("names of files are made of ASCII, whatever the locale of the program") {
  const GermanLocale german;
  CHECK(plain_file_name("plate_1-a.B"));
  CHECK(!plain_file_name("pl\xe4te"));
  CHECK(!plain_file_name("plate 1"));
}
