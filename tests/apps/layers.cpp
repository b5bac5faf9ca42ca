// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "shot/plates.hpp"
#include "shot/to_case.hpp"

using shot::Options;

namespace {

using Numbers = std::vector<double>;
using Names = std::vector<std::string>;

} // namespace

TEST_CASE("several plates come from lists") {
  const Options o =
      options_of({"--layers-mm", "4,8", "--gaps-mm", "10", "--layer-materials", "weldox_460e,aa5083_h116"});
  CHECK(o.layers_mm == Numbers{4, 8});
  CHECK(o.gaps_mm == Numbers{10});
  CHECK(o.layer_materials == Names{"weldox_460e", "aa5083_h116"});
  CHECK(o.material == "weldox_460e");
  CHECK(o.thickness_mm == 12);
  CHECK(shot::target_depth_mm(o) == 22);
  CHECK(o.out == "vtk_out/weldox_460e+aa5083_h116_mjc_blunt_4+8mm_10mm_apart_303.5mps");
  const auto c = shot::to_case(o);
  CHECK(c.thickness == 4e-3);
  REQUIRE(c.behind.size() == 1);
  CHECK(c.behind[0].gap == 10e-3);
  CHECK(c.behind[0].thickness == 8e-3);
  const auto plates = shot::plates_of(o);
  REQUIRE(plates.size() == 2);
  CHECK(materials::name_of(plates[1]) == "aa5083_h116");

  CHECK(options_of({"--layers-mm", "6,6"}).gaps_mm == Numbers{0});
  CHECK(options_of({"--layers-mm", "6,6"}).out == "vtk_out/weldox_460e_mjc_blunt_6+6mm_303.5mps");
  CHECK(options_of({"--layers-mm", "3,3,3", "--gaps-mm", "2"}).gaps_mm == Numbers{2, 2});
  CHECK(options_of({"--layers-mm", "3,3,3", "--gaps-mm", "2,0"}).out ==
        "vtk_out/weldox_460e_mjc_blunt_3+3+3mm_2+0mm_apart_303.5mps");
  CHECK(shot::plates_of(options_of({"--layers-mm", "3,3,3"})).size() == 3);
}

TEST_CASE("a list of one plate, or of one material, is that plate and that material") {
  const Options one = options_of({"--layers-mm", "12"});
  CHECK(one == Options{});
  const Options same = options_of({"--layers-mm", "6,6", "--layer-materials", "aa5083_h116,aa5083_h116"});
  CHECK(same == options_of({"--layers-mm", "6,6", "--material", "aa5083_h116"}));
}

TEST_CASE("lists of plates that do not fit together are refused") {
  struct Bad {
    std::vector<const char *> arguments;
    std::string message;
  };
  const std::vector<Bad> all{
      {{"--layers-mm", "6,0.02"}, "--layers-mm = 0.02: must lie between 0.05 and 500 mm"},
      {{"--layers-mm", "6,thick"},
       "--layers-mm = thick: must be a number between 0.05 and 500 mm, written without the unit"},
      {{"--layers-mm", "6,"}, "--layers-mm = : must be a number between 0.05 and 500 mm"},
      {{"--layers-mm"}, "--layers-mm: needs a value: numbers between 0.05 and 500 mm with commas between them"},
      {{"--layers-mm", "1,1,1,1,1,1,1,1,1"}, "--layers-mm = 1,1,1,1,1,1,1,1,1: must be 1 to 8 thicknesses"},
      {{"--layers-mm", "6,6", "--thickness-mm", "12"}, "--layers-mm = 6,6: contradicts thickness_mm: give one of them"},
      {{"--layers-mm", "6,6", "--gaps-mm", "-1"}, "--gaps-mm = -1: must lie between 0 and 1000 mm"},
      {{"--layers-mm", "6,6", "--gaps-mm", "1,2"}, "--gaps-mm = 1,2: must be 1 number, or 1 between 2 plates"},
      {{"--layers-mm", "2,2,2,2", "--gaps-mm", "1,2"}, "--gaps-mm = 1,2: must be 1 number, or 3 between 4 plates"},
      {{"--layers-mm", "6", "--gaps-mm", "1"}, "--gaps-mm = 1: needs --layers-mm with at least 2 thicknesses"},
      {{"--gaps-mm", "1"}, "--gaps-mm = 1: needs --layers-mm"},
      {{"--layer-materials", "weldox_460e"}, "--layer-materials = weldox_460e: needs --layers-mm"},
      {{"--layers-mm", "6,6", "--layer-materials", "weldox_460e"},
       "--layer-materials = weldox_460e: must be 2, one for each plate of --layers-mm"},
      {{"--layers-mm", "6,6", "--layer-materials", "weldox_460e,wood"},
       "--layer-materials = wood: must be a metal that "},
      {{"--layers-mm", "6,6", "--layer-materials", "weldox_460e,aa5083_h116", "--material", "weldox_460e"},
       "--layer-materials = weldox_460e,aa5083_h116: contradicts material: give one of them"},
      {{"--layers-mm", "6,6", "--layer-materials", "weldox_460e,gone.toml"},
       "--layer-materials = gone.toml: must be a TOML file that can be read"},
      {{"--layers-mm", "6,2", "--spacing-mm", "1.5"},
       "--spacing-mm = 1.5: must be at most half the thickness of the thinnest plate, 1 mm"},
  };
  for (const Bad &bad : all) {
    const std::string message = refusal(bad.arguments);
    CHECK_THAT(message, Catch::Matchers::StartsWith(bad.message));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("plates in a file, and files of their metals beside it") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string(), steel = (folder.path / "steel.toml").string();
  const auto refused = [&](const std::string &text) {
    write(file, text);
    return refusal({"--config", file.c_str()});
  };
  write(steel, materials::to_toml(plate_of(options_of({"--model", "jc"})), ""));
  write(file, "layers_mm = [4, 8.5]\ngaps_mm = [10]\nlayer_materials = [\"steel.toml\", \"aa5083_h116\"]\n");
  const Options o = options_of({"--config", file.c_str()});
  CHECK(o.layers_mm == Numbers{4, 8.5});
  CHECK(o.layer_materials == Names{steel, "aa5083_h116"});
  CHECK(o.model == shot::FlowModel::jc); // the file's, and so the other plate's
  CHECK(shot::plates_of(o)[1].index() == shot::plates_of(o)[0].index());
  // What is written runs the same case again, and the command line overrides it.
  write(file, shot::to_toml(o));
  CHECK(options_of({"--config", file.c_str()}) == o);
  const Options thick = options_of({"--config", file.c_str(), "--thickness-mm", "10", "--material", "aa5083_h116"});
  CHECK(thick.layers_mm.empty());
  CHECK(thick.thickness_mm == 10);
  CHECK(thick.material == "aa5083_h116");
  write(file, shot::to_toml(options_of({"--thickness-mm", "8"})));
  CHECK(options_of({"--config", file.c_str(), "--layers-mm", "4,4"}).layers_mm == Numbers{4, 4});

  CHECK(refused("layers_mm = \"4,8\"\nout = \"a\"\n").empty());
  CHECK_THAT(refused("layers_mm = [4, \"8\"]\n"), Catch::Contains(":1: layers_mm = \"8\": must be a number"));
  CHECK_THAT(refused("layers_mm = [4, [8]]\n"), Catch::Contains(":1: layers_mm = an array: must be a number"));
  CHECK_THAT(refused("layers_mm = []\n"), Catch::Contains(":1: layers_mm = : must be 1 to 8 thicknesses"));
  CHECK_THAT(refused("layers_mm = true\n"), Catch::Contains(":1: layers_mm = true: must be a number"));
  CHECK_THAT(refused("layers_mm = [4, 8]\nmaterial = [\"weldox_460e\"]\n"), Catch::Contains("must be a metal"));
  write((folder.path / "other.toml").string(), materials::to_toml(plate_of(Options{}), ""));
  CHECK_THAT(refused("layers_mm = [4, 8]\nlayer_materials = [\"steel.toml\", \"other.toml\"]\n"),
             Catch::Contains("other.toml: has model = mjc, the other plates jc: all plates must have the same"));
}
