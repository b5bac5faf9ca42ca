// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/fit/curve_table.hpp"

using namespace ogive;

namespace {

const std::string header = "strain_rate_per_s,temperature_K,plastic_strain,stress_MPa\n";

std::vector<StressCurve> read(const std::string &text, CurveTableFormat format = {false, 200e9, 1800}) {
  std::vector<std::string> messages;
  return read_curves({{"t.csv", text}}, format, messages);
}

std::string refusal(const std::string &text, CurveTableFormat format = {false, 200e9, 1800}) {
  try {
    read(text, format);
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a table is read whatever its line ends, quotes, blanks, comments and order of columns") {
  const auto curves = read("\xef\xbb\xbf# tests, \"not closed\r\n\r\n"
                           "stress_MPa, \"temperature_K\" ,specimen,plastic_strain,strain_rate_per_s,plate\r\n"
                           "600,293,\"a, \"\"1\"\"\",0.1,1e-3,12 mm\r\n"
                           "  # in between\n"
                           "500 ,+293, \"a, \"\"1\"\"\",0,0.001,12 mm\n"
                           "500,293,b,0,0.001,12 mm\n510,293,b,0.1,0.001,12 mm");
  REQUIRE(curves.size() == 2);
  CHECK(curves[0].specimen == "a, \"1\"");
  CHECK(curves[0].plate == "12 mm");
  CHECK(curves[0].rate == 1e-3);
  CHECK(curves[0].strain == std::vector<double>{0, 0.1});
  CHECK(curves[0].stress == std::vector<double>{500e6, 600e6});
  CHECK(curves[1].stress == std::vector<double>{500e6, 510e6});
}

TEST_CASE("rows of the same strain keep their order") {
  CHECK(read(header + "1,293,0.1,30\n1,293,0.1,20\n1,293,0,90\n1,293,0.1,10\n")[0].stress ==
        std::vector<double>{90e6, 30e6, 20e6, 10e6});
}

TEST_CASE("a point that is there twice counts once") {
  std::vector<std::string> messages;
  const std::string rows = "1,293,0,500\n1,293,0.1,600\n1,293,0.1,610\n1,293,0.2,600\n";
  const auto curves = read_curves({{"a.csv", header + rows}, {"b.csv", header + rows}}, {false, 0, 1800}, messages);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].stress == std::vector<double>{500e6, 600e6, 610e6, 600e6});
  REQUIRE(messages.size() == 1);
  CHECK(messages[0] == "1 1/s, 293 K: 4 points that are there more than once count once");
}

TEST_CASE("numbers that look like other units need the user's word") {
  CurveTableFormat insisting{false, 200e9, 1800, true};
  const auto named = [&](const std::string &row, const std::string &message) {
    CHECK(refusal(header + row) == message);
    CHECK(refusal(header + row, insisting).empty());
  };
  named("1,20,0,500\n1,20,0.1,600\n", "t.csv:2: temperature_K = 20: is unlikely: kelvin are needed, not degrees "
                                      "Celsius; tests that are meant so need unusual = true");
  named(
      "1,293,0,0.5\n1,293,0.1,0.6\n",
      "t.csv:2: stress_MPa = 0.5: is unlikely for the yield stress, which is between 10 and 5000 MPa in metals; tests "
      "that are meant so need unusual = true");
  CHECK_FALSE(refusal(header + "1,293,0,5e5\n1,293,0.1,6e5\n").empty()); // kPa
}

TEST_CASE("separators other than commas are named") {
  CHECK(refusal("strain_rate_per_s;temperature_K;plastic_strain;stress_MPa\n1;293;0;500\n") ==
        "t.csv:1: columns are separated by semicolons: must be separated by commas, with points in decimal numbers");
  CHECK(refusal("strain_rate_per_s\ttemperature_K\n") ==
        "t.csv:1: columns are separated by tabs: must be separated by commas, with points in decimal numbers");
  CHECK(refusal(header + "0,001,293,0,500\n") ==
        "t.csv:2: fields = 5: must be as many as there are columns, 4; decimals have points, not commas");
}

TEST_CASE("curves may be spread over tables") {
  std::vector<std::string> messages;
  const std::string a = header + "1,293,0,500\n", b = header + "1,293,0.1,600\n";
  CHECK(read_curves({{"a.csv", a}, {"b.csv", b}}, {false, 0, 1800}, messages)[0].strain.size() == 2);
}

TEST_CASE("each damaged table is refused with one line that names table, line and what is allowed") {
  const std::string good = "1,293,0,500\n1,293,0.1,600\n";
  struct Bad {
    std::string text, message;
  };
  const std::vector<Bad> all{
      {"", "t.csv: rows = 0: must be one or more"},
      {"# nothing\n\n", "t.csv: rows = 0: must be one or more"},
      {header, "t.csv: rows = 0: must be one or more"},
      {header + good + "1,293,0.2,strong\n", "t.csv:4: stress_MPa = strong: must be a finite number"},
      {header + good + "1,293,0.2,\n", "t.csv:4: stress_MPa = nothing: must be a finite number"},
      {header + good + "1,293,0.2,6OO MPa\n", "t.csv:4: stress_MPa = 6OO MPa: must be a finite number"},
      {header + "1,293,nan,500\n", "t.csv:2: plastic_strain = nan: must be a finite number"},
      {header + "inf,293,0,500\n", "t.csv:2: strain_rate_per_s = inf: must be a finite number"},
      {header + "1e999,293,0,500\n", "t.csv:2: strain_rate_per_s = 1e999: must be a finite number"},
      {header + "1,293,-0.1,500\n", "t.csv:2: plastic_strain = -0.1: must lie between 0 and 10"},
      {header + "1,293,0,0\n", "t.csv:2: stress_MPa = 0: must be positive"},
      {header + "1,293,0,-5\n", "t.csv:2: stress_MPa = -5: must be positive"},
      {header + "0,293,0,500\n", "t.csv:2: strain_rate_per_s = 0: must be positive"},
      {header + "1,0,0,500\n", "t.csv:2: temperature_K = 0: must be positive, in kelvin"},
      {header + "1,1800,0,500\n", "t.csv:2: temperature_K = 1800: must lie below the melting temperature, 1800 K"},
      {header + "1,293,0\n", "t.csv:2: fields = 3: must be as many as there are columns, 4"},
      {header + "1,293,0,500,1\n", "t.csv:2: fields = 5: must be as many as there are columns, 4"},
      {header + "\n#\n1,293,0,500\n", "t.csv:4: curve 1 1/s, 293 K = 1 point: must have two or more"},
      {header + "1,293,0,\"500\n", "t.csv:2: field = \"500?: must end with a quotation mark"},
      {header + "1,293,0,\"500\"0\n", "t.csv:2: field = \"500\"0: nothing may follow the closing quotation mark"},
      {"a\x01"
       "b,temperature_K\n",
       "t.csv:1: column = a?b: is unknown; allowed are strain_rate_per_s, temperature_K"},
      {"strain_rate_per_s,temperature_K,stress_MPa\n", "t.csv:1: column = plastic_strain: is missing; needed are"},
      {"plate,plate\n", "t.csv:1: column = plate: must be given once"},
      {"engineering_strain\n", "t.csv:1: column = engineering_strain: is unknown; allowed are"},
      {std::string(5000, ','), "t.csv:1: fields in the row: must be at most 1000"},
      {std::string("\0\0\n", 3), "t.csv:1: column = ??: is unknown"},
  };
  for (const Bad &bad : all) {
    const std::string message = refusal(bad.text);
    CHECK_THAT(message, Catch::StartsWith(bad.message));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("engineering curves are converted, cut at necking, and what is left out is said") {
  const CurveTableFormat engineering{true, 200e9, 1800};
  const std::string columns = "strain_rate_per_s,temperature_K,engineering_strain,engineering_stress_MPa\n";
  std::vector<std::string> messages;
  const std::string table = columns + "1,293,0,0\n1,293,0.01,500\n1,293,0.1,600\n1,293,0.2,590\n1,293,0.3,500\n";
  const auto curves = read_curves({{"t.csv", table}}, engineering, messages);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].stress == std::vector<double>{500e6 * 1.01, 600e6 * 1.1});
  CHECK(curves[0].strain[1] == Approx(std::log(1.1) - 660e6 / 200e9));
  REQUIRE(messages.size() == 2);
  CHECK(messages[0] == "1 1/s, 293 K: cut at necking, plastic strain 0.092: 2 points behind the largest engineering "
                       "stress left out");
  CHECK(messages[1] == "1 1/s, 293 K: 1 points below plastic strain 0.002 left out");
  CHECK_THAT(refusal(columns + "1,293,0.1,600\n1,293,0.2,500\n", engineering),
             Catch::StartsWith("t.csv:2: curve 1 1/s, 293 K = 1 points between plastic strain 0.002 and necking"));
  CHECK_THAT(refusal(columns + "1,293,0.1,-1\n1,293,0.2,500\n", engineering),
             Catch::StartsWith("t.csv:2: engineering_stress_MPa = -1: must be positive where the curve is plastic"));
  CHECK_THAT(refusal(columns + "1,293,-0.9,1\n", engineering),
             Catch::StartsWith("t.csv:2: engineering_strain = -0.9: must lie between -0.5 and 10"));
}
