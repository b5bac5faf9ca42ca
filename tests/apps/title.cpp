// SPDX-License-Identifier: BSD-3-Clause
#include "shot/title.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "materials/material_file.hpp"
#include "ogive/results.hpp"

#include <nlohmann/json.hpp>

namespace {

nlohmann::ordered_json sample_summary() {
  return {{"material", "weldox_460e"}, {"model", "mjc"},
          {"method", "stabilised"},    {"nose", "blunt"},
          {"obliquity_deg", 0.0},      {"projectile_name", "blunt"},
          {"thickness_mm", 12.0},      {"initial_velocity_mps", 303.5}};
}

} // namespace

TEST_CASE("a title has the names of the field") {
  auto summary = sample_summary();
  CHECK(shot::title_of(summary) ==
        "Weldox 460 E, modified Johnson-Cook, blunt nose, 12 mm, 303.5 m/s, method stabilised");
  summary["material"] = "aa5083_h116 + my_metal";
  summary["model"] = "jc";
  summary["projectile_name"] = "fsp_20mm";
  summary["nose"] = "chisel";
  summary["obliquity_deg"] = 30.0;
  summary["layers"] = {{{"thickness_mm", 6.0}, {"gap_before_mm", 0}}, {{"thickness_mm", 4.5}, {"gap_before_mm", 10.0}}};
  CHECK(shot::title_of(summary) == "AA5083-H116 + my_metal, Johnson-Cook, 20 mm fragment simulator, 6 + 4.5 mm, 10 mm "
                                   "apart, 303.5 m/s at 30 deg, method stabilised");
  summary["layers"][1]["gap_before_mm"] = 0.0;
  CHECK_THAT(shot::title_of(summary), Catch::Matchers::Contains("simulator, 6 + 4.5 mm, 303.5 m/s"));
  summary["projectile_name"] = "my_bullet";
  CHECK_THAT(shot::title_of(summary), Catch::Matchers::Contains(", my_bullet, "));
  summary["projectile_name"] = summary["nose"] = "sphere";
  CHECK_THAT(shot::title_of(summary), Catch::Matchers::Contains(", sphere, "));
  summary.erase("material");
  CHECK_THROWS(shot::title_of(summary));
}

TEST_CASE("every flow law has a title") {
  using materials::Model;
  for (const Model model : {Model::mjc, Model::jc, Model::voce, Model::power_law, Model::bilinear}) {
    const std::string name = materials::name_of(model), title = materials::title_of_model(name);
    CHECK(title.find('_') == std::string::npos);
    CHECK(title != "mjc");
    CHECK(title != "jc");
  }
}

TEST_CASE("the folder of a result gives a title, and the velocity of the part that the verdict is of") {
  const TemporaryFolder folder;
  const auto result = folder.path / "first";
  std::filesystem::create_directory(result);
  CHECK(commands::case_title(result) == "first");
  CHECK(commands::motion_of(result).history.time_us.empty());
  write(result / "history.csv", "time_us,velocity_m_per_s\n0,300\n20,200\n");
  CHECK(draw::time_text(10e-6, commands::motion_of(result)) == "10 µs, 250 m/s");
  auto summary = sample_summary();
  summary["followed_part"] = "core";
  write(result / "summary.json", summary.dump());
  CHECK(draw::time_text(10e-6, commands::motion_of(result)) == "10 µs, 250 m/s (core)");
  CHECK(commands::case_title(result) == shot::title_of(summary));
}
