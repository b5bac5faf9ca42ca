// SPDX-License-Identifier: BSD-3-Clause
#include "view/pack.hpp"
#include "view/page.hpp"

#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

using namespace view;
using Json = nlohmann::ordered_json;

namespace {

/// The words of packed text, as a browser reads them.
Words unpacked(const std::string &text, std::size_t count) {
  std::vector<unsigned char> small(text.size()), bytes(2 * count);
  small.resize(vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char *>(text.data()), text.size(),
                                                small.data(), small.size()));
  vtkNew<vtkZLibDataCompressor> zlib;
  REQUIRE(zlib->Uncompress(small.data(), small.size(), bytes.data(), bytes.size()) == bytes.size());
  Words words(count);
  for (std::size_t k = 0; k < count; ++k) words[k] = static_cast<std::uint16_t>(bytes[k] | bytes[count + k] << 8);
  return words;
}

/// Takes the next values of a frame, one after the other.
struct Reader {
  Words words;
  std::size_t at = 0;

  std::vector<double> values(const Json &range, std::size_t count) {
    std::vector<double> read;
    for (std::size_t k = 0; k < count; ++k)
      read.push_back(range[0].get<double>() + range[1].get<double>() * words.at(at++) / 65535);
    return read;
  }
};

/// Values are equal within half a step of their range, and the rounding of single precision.
void check_values(const std::vector<double> &read, const Json &range, const std::vector<float> &expected) {
  REQUIRE(read.size() == expected.size());
  const double half_step = range[1].get<double>() / 65535 / 2;
  double worst = 0;
  for (std::size_t k = 0; k < read.size(); ++k)
    worst = std::max(worst, std::abs(read[k] - double(expected[k])) - 1e-6 * std::abs(double(expected[k])));
  CHECK(worst <= 1.001 * half_step);
}

void check_positions(Reader &reader, const Json &part, const std::vector<ogive::Vec3<float>> &positions) {
  REQUIRE(part["points"] == positions.size());
  for (int k = 0; k < 3; ++k) {
    std::vector<float> expected;
    for (const auto &x : positions) expected.push_back(1e3F * x[k]);
    const Json &range = part["position_mm"][static_cast<std::size_t>(k)];
    check_values(reader.values(range, positions.size()), range, expected);
  }
}

void write(const std::filesystem::path &file, const std::string &text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// A series of the sample at 0, 10, ..., and a folder that holds what stands in for three.js.
struct Sample {
  TemporaryFolder folder;
  std::filesystem::path three = folder.path / "three";
  Result result;

  explicit Sample(int frames) {
    auto series = ogive::open_series(folder.path, "perforation");
    for (int k = 0; k < frames; ++k) {
      auto frame = sample::perforated_plate(1e-3F * float(k), 3e-3F);
      frame.time = 10e-6 * k;
      frame.symmetry = {true, true};
      ogive::add_frame(series, frame);
    }
    write(three / "three.min.js", "three();");
    write(three / "examples/js/controls/OrbitControls.js", "orbit();");
    result.title = "a plate";
    result.series = ogive::read_series(folder.path / "perforation.pvd");
  }
};

/// The text between two others.
std::string between(const std::string &text, const std::string &before, const std::string &after) {
  const auto from = text.find(before);
  REQUIRE(from != std::string::npos);
  return text.substr(from + before.size(), text.find(after, from) - from - before.size());
}

Json model_of(const std::string &page) {
  return Json::parse(between(page, "<script type=\"application/json\" id=\"model\">", "</script>"));
}

} // namespace

TEST_CASE("65536 steps divide a range, and values that are not finite are the lowest") {
  const Steps steps = steps_of({3.F, INFINITY, -1.F, NAN, 1.F});
  CHECK(steps.low == -1);
  CHECK(steps.size == 4);
  CHECK(step_of(-1, steps) == 0);
  CHECK(step_of(3, steps) == 65535);
  CHECK(step_of(1, steps) == 32768);
  CHECK(step_of(NAN, steps) == 0);
  CHECK(step_of(99, steps) == 65535);
  CHECK(step_of(7, steps_of({7.F, 7.F})) == 0);
  CHECK(steps_of({}).size == 0);
}

TEST_CASE("a packed frame holds positions, corners and fields within half a step") {
  auto frame = sample::perforated_plate();
  frame.symmetry = {true, false};
  const auto fields = common_fields(frame);
  CHECK(fields == std::vector<std::string>{"plastic_strain", speed_field});
  const PackedFrame packed = pack(frame, fields);
  const Json description = Json::parse(packed.description);
  CHECK(description["time_us"].get<double>() == Approx(60));
  CHECK(description["mirrored_x"] == true);
  CHECK(description["mirrored_y"] == false);
  Reader reader{unpacked(packed.words, description["words"])};

  const Json &cloud = description["parts"][0];
  CHECK(cloud["name"] == "plate_sph");
  CHECK(cloud["diameter_mm"].get<double>() == Approx(1.2));
  check_positions(reader, cloud, frame.clouds[0].positions);
  const std::size_t particles = frame.clouds[0].positions.size();
  check_values(reader.values(cloud["fields"][0], particles), cloud["fields"][0], frame.clouds[0].fields[0].values);
  std::vector<float> speeds;
  for (std::size_t i = 0; i < particles; ++i) speeds.push_back(-frame.clouds[0].fields[1].values[3 * i + 2]);
  check_values(reader.values(cloud["fields"][1], particles), cloud["fields"][1], speeds);

  for (std::size_t p = 0; p < 2; ++p) {
    const auto &grid = frame.grids[p];
    const Json &part = description["parts"][p + 1];
    CHECK(part["name"] == grid.name);
    check_positions(reader, part, grid.positions);
    REQUIRE(part["hexes"] == grid.hexes.size());
    bool equal = true;
    for (std::size_t corner = 0; corner < 8; ++corner)
      for (const auto &hex : grid.hexes) equal = equal && reader.words.at(reader.at++) == hex[corner];
    CHECK(equal);
    check_values(reader.values(part["fields"][0], grid.hexes.size()), part["fields"][0], grid.cell_fields[0].values);
    // All nodes have the velocity (-100, -100, -100) m/s.
    const std::vector<float> all(grid.hexes.size(), 173.20508F);
    check_values(reader.values(part["fields"][1], grid.hexes.size()), part["fields"][1], all);
  }
  CHECK(reader.at == reader.words.size());
}

TEST_CASE("corners of grids beyond 65536 nodes have two words") {
  ogive::HexGrid grid{.name = "big", .part = 0, .positions = {}, .hexes = {}, .point_fields = {}, .cell_fields = {}};
  grid.positions.resize(65537, ogive::Vec3<float>::Zero());
  grid.hexes.push_back({65536, 1, 2, 3, 4, 5, 6, 7});
  ogive::Frame frame;
  frame.grids.push_back(grid);
  const PackedFrame packed = pack(frame, {});
  const std::size_t positions = 3 * 65537;
  const Words words = unpacked(packed.words, positions + 16);
  CHECK(words[positions] == 0);
  CHECK(words[positions + 1] == 1);
  CHECK(words[positions + 8] == 1);
  CHECK(words[positions + 9] == 0);
}

TEST_CASE("a page holds its frames, the scripts and the velocity, and nothing from elsewhere") {
  Sample sample(5);
  sample.result.most_frames = 3;
  write(sample.folder.path / "history.csv", "time_us,velocity_m_per_s,nose_depth_mm\n0,300,0\n20,250.5,1\n40,200,2\n");
  sample.result.velocity = read_velocity(sample.folder.path / "history.csv");
  const std::string html = page(sample.result, sample.three);
  const Json model = model_of(html);
  CHECK(model["title"] == "a plate");
  CHECK(model["fields"] == Json{"plastic_strain", speed_field});
  CHECK(model["velocity"]["velocity_mps"] == Json{300, 250.5, 200});
  REQUIRE(model["frames"].size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(model["frames"][k]["time_us"].get<double>() == Approx(20.0 * double(k)));
    const std::string words = between(html, "id=\"frame" + std::to_string(k) + "\">", "</script>");
    const auto frame = ogive::read_frame(sample.result.series, 2 * k);
    CHECK(words == pack(frame, {"plastic_strain", speed_field}).words);
  }
  CHECK(html.find("three();") < html.find("orbit();"));
  for (const char *link : {"src=", "href=", "url(", "{{"}) CHECK(html.find(link) == std::string::npos);
}

TEST_CASE("a title may hold anything") {
  Sample sample(1);
  sample.result.title = "</script><b>{{STYLE}} & \xff";
  const std::string html = page(sample.result, sample.three);
  CHECK(between(html, "<title>", "</title>") == "&lt;/script>&lt;b>{{STYLE}} &amp; \xff");
  CHECK(html.find("</script><b>") == std::string::npos);
  CHECK(model_of(html)["title"].get<std::string>().starts_with("</script><b>{{STYLE}}"));
}

TEST_CASE("what a page lacks is named") {
  Sample sample(2);
  sample.result.fields = {"plastic_strain"};
  CHECK(model_of(page(sample.result, sample.three))["fields"] == Json{"plastic_strain"});
  sample.result.fields = {"heat"};
  CHECK_THROWS_WITH(page(sample.result, sample.three), "--fields = heat: must be one of plastic_strain, speed_m_per_s");
  std::filesystem::remove(sample.three / "three.min.js");
  CHECK_THROWS_WITH(page(sample.result, sample.three), Catch::Contains("Debian: libjs-three"));
  write(sample.folder.path / "a.csv", "time_us,velocity_m_per_s\n0,fast\n");
  CHECK_THROWS_WITH(read_velocity(sample.folder.path / "a.csv"),
                    Catch::Contains("a.csv:2: time and velocity must be numbers"));
  write(sample.folder.path / "b.csv", "time_us\n0\n");
  CHECK_THROWS_WITH(read_velocity(sample.folder.path / "b.csv"), Catch::Contains("column velocity_m_per_s is missing"));
}
