// SPDX-License-Identifier: BSD-3-Clause
#include "shot/projectile.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "materials/library.hpp"
#include "shot/defaults.hpp"
#include "shot/files.hpp"
#include "shot/named_projectile.hpp"

#include "ogive/material/projectile_metals.hpp"
#include "ogive/perforation/projectile_library.hpp"

using Catch::Matchers::StartsWith;
using shot::Options;

namespace {

/// Room for projectiles of up to 20 mm at a coarse plate.
Options coarse(std::vector<const char *> arguments) {
  for (const char *more : {"--spacing-mm", "1"}) arguments.push_back(more);
  return options_of(arguments);
}

} // namespace

TEST_CASE("the projectile is one of the paper's, scaled with its diameter, unless lengths are given") {
  const auto shape = [](const std::vector<const char *> &arguments) { return shot::shape_of(options_of(arguments)); };
  for (const ogive::Nose nose : ogive::all_noses) {
    // These have no sizes but those of their points or nodes.
    if (nose == ogive::Nose::profile || nose == ogive::Nose::mesh) continue;
    const std::string name(ogive::name(nose));
    const auto paper = ogive::default_projectile<double>(nose), own = shape({"--nose", name.c_str()}),
               small = shape({"--nose", name.c_str(), "--diameter-mm", "5"});
    CHECK(own.shank_length == paper.shank_length); // to the last bit
    CHECK(own.nose_length == paper.nose_length);
    CHECK(own.tip_diameter == paper.tip_diameter);
    CHECK(ogive::volume(small) == Approx(ogive::volume(paper) / 64));
    CHECK_NOTHROW(ogive::check(small));
  }
  const auto ogive = shape({"--nose", "ogival", "--calibre-radius-head", "3", "--length-mm", "100"});
  CHECK(ogive::ogive_radius(ogive) == Approx(3 * 20e-3));
  CHECK(ogive::length(ogive) == Approx(100e-3));
  const auto cone = shape({"--nose", "conical", "--nose-length-mm", "17.3", "--diameter-mm", "10"});
  CHECK(cone.nose_length == Approx(17.3e-3));
  CHECK(cone.shank_length == Approx(34e-3));
}

TEST_CASE("a projectile by name is the one of the library") {
  for (const auto &p : ogive::library::all_projectiles<double>()) {
    CAPTURE(p.name);
    const Options o = coarse({"--projectile", p.name.c_str()});
    const auto shape = shot::shape_of(o);
    CHECK(shape.nose == p.shape.nose);
    CHECK(ogive::volume(shape) == Approx(ogive::volume(p.shape)).epsilon(1e-6));
    CHECK(ogive::length(shape) == Approx(ogive::length(p.shape)));
    CHECK(shape.tip_diameter == Approx(p.shape.tip_diameter));
    CHECK(o.mass_g == Approx(p.mass * 1e3));
    CHECK(o.rigid == p.rigid);
    CHECK(o.projectile_metal == p.metal.name);
    CHECK(shape.inner.size() == p.shape.inner.size());
    CHECK(o.part_metals.size() == p.part_metals.size());
  }
  // A nose is no more than --nose, with its folder.
  CHECK(options_of({"--projectile", "conical"}) == options_of({"--nose", "conical"}));
  const Options fsp = coarse({"--projectile", "fsp_20mm"});
  CHECK(fsp.friction == 0);
  CHECK(fsp.out == "vtk_out/weldox_460e_mjc_fsp_20mm_12mm_303.5mps_spacing_mm=1");
}

TEST_CASE("options beside a named projectile override it, and a later projectile replaces an earlier one") {
  const Options o = coarse({"--mass-g", "6", "--no-rigid", "--projectile", "apm2_762_core"});
  CHECK(o.mass_g == 6);
  CHECK_FALSE(o.rigid);
  CHECK(o.diameter_mm == 6.17);
  CHECK_THAT(o.out.string(), Catch::Matchers::EndsWith("_mass_g=6_rigid=false_spacing_mm=1"));
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string();
  write(file, "projectile = \"apm2_762_core\"\nmass_g = 6\nspacing_mm = 1\n");
  const Options other = options_of({"--config", file.c_str(), "--projectile", "fsp_20mm"});
  CHECK(other == coarse({"--projectile", "fsp_20mm"}));
  // The older words.
  CHECK(options_of({"--projectile", "rigid"}).rigid);
  CHECK(options_of({"--projectile", "rigid"}) == options_of({"--rigid"}));
  CHECK(options_of({"--projectile", "deformable"}) == options_of({}));
}

TEST_CASE("a projectile of a file has names that count from its folder, and case.toml needs neither") {
  const TemporaryFolder folder;
  const auto &in = folder.path;
  write(in / "nose.csv", "z_mm,r_mm\n0,2\n8,6\n30,6\n");
  auto steel = ogive::library::fsp_steel<double>();
  steel.flow.yield = 950e6;
  write(in / "steel.toml", materials::to_toml(steel, ""));
  write(in / "mine.toml", "profile = \"nose.csv\"\nprojectile_metal = \"steel.toml\"\nmass_g = 25\nrigid = true\n");
  const std::string file = (in / "mine.toml").string();
  const Options o = coarse({"--projectile", file.c_str()});
  CHECK(o.nose == shot::Nose::profile);
  CHECK(o.diameter_mm == 12);
  CHECK(o.length_mm == 30);
  CHECK(o.mass_g == 25);
  CHECK(o.rigid);
  CHECK(o.profile_mm == std::vector<double>{0, 2, 8, 6, 30, 6});
  CHECK(o.out == "vtk_out/weldox_460e_mjc_mine_12mm_303.5mps_spacing_mm=1");
  std::visit([](const auto &metal) { CHECK(metal.name == "fsp_steel"); }, shot::projectile_metals_of(o).front());

  // The folder of the results has all that the case needs.
  write(in / "case.toml", shot::case_text(o));
  write(in / "projectile_metal.toml", materials::to_toml(shot::projectile_metals_of(o).front(), ""));
  std::filesystem::remove(in / "nose.csv"), std::filesystem::remove(in / "mine.toml");
  const std::string again = (in / "case.toml").string();
  const Options same = options_of({"--config", again.c_str()});
  CHECK(same.profile_mm == o.profile_mm);
  CHECK(same.out == o.out);
  CHECK(same.mass_g == o.mass_g);
  CHECK(same.rigid);
  CHECK(materials::to_toml(shot::projectile_metals_of(same).front(), "") == materials::to_toml(steel, ""));
}

TEST_CASE("a bilinear metal of a file reads back as the same") {
  const auto steel = ogive::library::apm2_core_steel<double>();
  const std::string text = materials::to_toml(steel, "");
  CHECK(materials::to_toml(materials::parse(text, "steel.toml"), "") == text);
  CHECK(materials::model_of(materials::parse(text, "steel.toml")) == materials::Model::bilinear);
  CHECK_THAT(message_of([&] { materials::parse("model = \"bilinear\"\nA_MPa = 3\n", "f"); }),
             StartsWith("f: model \"bilinear\" lacks name, "));
}

TEST_CASE("bad projectiles are refused with option, value and what is allowed") {
  struct Bad {
    std::vector<const char *> arguments;
    std::string message;
  };
  const std::vector<Bad> all{
      {{"--projectile", "bullet"},
       "--projectile = bullet: must be one of blunt, conical, ogival, hemispherical, sphere, apm2_762, apm2_762_core, "
       "fsp_20mm, fsp_127mm, or a file that ends in .toml"},
      {{"--projectile", "fsp_20"}, "--projectile = fsp_20: must be one of "},
      {{"--projectile", "gone.toml"}, "--projectile = gone.toml: must be a TOML file that can be read"},
      {{"--projectile-metal", "leed"}, "--projectile-metal = leed: must be one of arne_tool_steel, apm2_core_steel, "},
      {{"--projectile-metal", "gone.toml"}, "--projectile-metal = gone.toml: must be a TOML file that can be read"},
      {{"--profile", "gone.csv"}, "--profile = gone.csv: must be a CSV file that can be read"},
      {{"--nose", "profile"}, "--nose = profile: needs --profile FILE.csv"},
      {{"--tip-diameter-mm", "2"}, "--tip-diameter-mm = 2: needs --nose conical, ogival or chisel"},
      {{"--nose", "conical", "--tip-diameter-mm", "0"},
       "--tip-diameter-mm = 0: must lie between 0.02 diameters, 0.4 mm"},
      {{"--nose", "chisel", "--nose-length-mm", "10"}, "--nose-length-mm = 10: must be at most 9.63 mm"},
      {{"--nose", "sphere", "--length-mm", "30"}, "--length-mm = 30: must be the diameter of a sphere"},
      {{"--tail-diameter-mm", "15"}, "--tail-diameter-mm = 15: needs --tail-length-mm"},
      {{"--tail-length-mm", "10"}, "--tail-diameter-mm = 0: must lie between 5 mm, a quarter of the diameter, and the"},
      {{"--tail-length-mm", "90", "--tail-diameter-mm", "15"},
       "--tail-length-mm = 90: must be less than the length of the shank, 80 mm"},
      {{"--pitch-deg", "3"}, "--pitch-deg = 3: needs --extent half or --extent full"},
      {{"--yaw-deg", "3", "--extent", "half"}, "--yaw-deg = 3: needs --extent full"},
      {{"--pitch-deg", "20", "--extent", "half"}, "--sph-radius-mm = 24: must lie between 24.880806 mm, what the"},
  };
  for (const Bad &bad : all) CHECK_THAT(refusal(bad.arguments), StartsWith(bad.message));

  const TemporaryFolder folder;
  const std::string profile = (folder.path / "nose.csv").string(), file = (folder.path / "p.toml").string();
  write(profile, "z_mm,r_mm\n0,2\n8,6\n30,6\n");
  const char *csv = profile.c_str();
  CHECK_THAT(refusal({"--profile", csv, "--nose", "blunt"}), StartsWith("--nose = blunt: contradicts profile"));
  CHECK_THAT(refusal({"--profile", csv, "--diameter-mm", "10"}),
             StartsWith("--diameter-mm = 10: contradicts profile, which gives 12 mm"));
  CHECK_THAT(refusal({"--profile", csv, "--edge-radius-mm", "1"}),
             StartsWith("--edge-radius-mm = 1: contradicts profile"));
  write(profile, "z_mm,r_mm\n0,2\n8,600\n");
  CHECK_THAT(refusal({"--profile", csv}), StartsWith(profile + ": radius of point 1"));
  write(profile, "z_mm,r_mm\n0,200\n8,300\n");
  CHECK_THAT(refusal({"--profile", csv}),
             StartsWith("--profile = 600 mm as its diameter_mm: must lie between 1 and 200"));
  write(file, "velocity_mps = 300\n");
  CHECK_THAT(refusal({"--projectile", file.c_str()}),
             StartsWith(file + ":1: velocity_mps = 300: unknown key; allowed are nose, diameter_mm, "));
}
