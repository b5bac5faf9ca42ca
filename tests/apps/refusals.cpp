// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"

TEST_CASE("each bad argument is refused with one line that names option, value and what is allowed") {
  struct Bad {
    std::vector<const char *> arguments;
    std::string message;
  };
  const std::vector<Bad> all{
      {{"--thickness-mm", "-3"}, "--thickness-mm = -3: must lie between 0.05 and 500 mm"},
      {{"--thickness-mm=-3"}, "--thickness-mm = -3: must lie between 0.05 and 500 mm"},
      {{"--thickness-mm", "0"}, "--thickness-mm = 0: must lie between 0.05 and 500 mm"},
      {{"--thickness-mm", "1e9"}, "--thickness-mm = 1e9: must lie between 0.05 and 500 mm"},
      {{"--thickness-mm", "nan"}, "--thickness-mm = nan: must lie between 0.05 and 500 mm"},
      {{"--velocity-mps", "inf"}, "--velocity-mps = inf: must lie between 1 and 3000 m/s"},
      {{"--velocity-mps", "1e999"}, "--velocity-mps = 1e999: must lie between 1 and 3000 m/s"},
      {{"--velocity-mps", "0"}, "--velocity-mps = 0: must lie between 1 and 3000 m/s"},
      {{"--thickness-mm", "12mm"},
       "--thickness-mm = 12mm: must be a number between 0.05 and 500 mm, written without the unit"},
      {{"--friction", "rough"}, "--friction = rough: must be a number between 0 and 2"},
      {{"--friction", "-0.1"}, "--friction = -0.1: must lie between 0 and 2"},
      {{"--friction", "2.5"}, "--friction = 2.5: must lie between 0 and 2"},
      {{"--end-us", "0"}, "--end-us = 0: must lie between 1 and 100000 us"},
      {{"--output-every-us", "0"}, "--output-every-us = 0: must lie between 0.5 and 100000 us"},
      {{"--clamp-radius-mm", "6000"}, "--clamp-radius-mm = 6000: must lie between 1 and 5000 mm"},
      {{"--spacing-mm", "-0.6"}, "--spacing-mm = -0.6: must lie between 0.01 and 25 mm"},
      {{"--spacing-mm", "70"}, "--spacing-mm = 70: must lie between 0.01 and 25 mm"},
      {{"--thickness-mm", "6", "--spacing-mm", "4"},
       "--spacing-mm = 4: must be at most half the thickness of the plate, 3 mm"},
      {{"--diameter-mm", "8", "--spacing-mm", "2.2"},
       "--spacing-mm = 2.2: must be at most a quarter of the projectile's diameter, 2 mm"},
      {{"--diameter-mm", "8", "--thickness-mm", "4.8", "--spacing-mm", "2"}, // two layers, 2.4 mm apart
       "--spacing-mm = 2: must be at most a quarter of the projectile's diameter, 2 mm, where whole layers of "
       "particles fill the plate, too"},
      {{"--sph-radius-mm", "11"},
       "--sph-radius-mm = 11: must lie between 11.2 mm, the projectile's radius and two spacings, and less than the "
       "clamp radius, 250 mm"},
      {{"--sph-radius-mm", "60", "--clamp-radius-mm", "50"},
       "--sph-radius-mm = 60: must lie between 11.2 mm, the projectile's radius and two spacings, and less than the "
       "clamp radius, 50 mm"},
      {{"--spacing-mm", "0.05", "--extent", "full"},
       "--spacing-mm = 0.05: gives about 174 million particles, at most 50 million are allowed"},
      {{"--threads", "1.5"}, "--threads = 1.5: must be a whole number between 1 and "},
      {{"--threads", "0"}, "--threads = 0: must be a whole number between 1 and "},
      {{"--threads", "1000000"}, "--threads = 1000000: must be a whole number between 1 and "},
      {{"--nose", "flat"}, "--nose = flat: must be one of blunt, conical, ogival, hemispherical"},
      {{"--nose", "a\nb"}, "--nose = a?b: must be one of blunt"},
      {{"--material", "steel"},
       "--material = steel: must be a metal that ogive materials lists, or a file that ends in .toml"},
      {{"--material", "weldox_460"},
       "--material = weldox_460: must be a metal that ogive materials lists, or a file that ends in "
       ".toml, "
       "the nearest is weldox_460e"},
      {{"--material", "list"}, "--material = list: must be a metal that "},
      {{"--material", "no_such.toml"}, "--material = no_such.toml: must be a TOML file that can be read: No such file"},
      {{"--damage", "yes"}, "--damage = yes: must be one of none, jc, cockcroft_latham"},
      {{"--damage", "jc", "--failure", "crack"}, "--failure = crack: must be one of none, no_tension, removal"},
      {{"--damage", "none", "--failure", "removal"},
       "--failure = removal: needs --damage jc or --damage cockcroft_latham"},
      {{"--method", "fem"}, "--method = fem: must be one of paper, stabilised"},
      {{"--method", "paper", "--damage-softening", "0.3"},
       "--damage-softening = 0.3: needs --damage jc or --damage cockcroft_latham"},
      {{"--method", "stabilised", "--damage", "none", "--damage-softening", "0.3"},
       "--damage-softening = 0.3: needs --damage jc or --damage cockcroft_latham"},
      {{"--contact-stiffness", "1"}, "--contact-stiffness = 1: must lie between 0.001 and 0.5"},
      {{"--nose-length-mm", "10"}, "--nose-length-mm = 10: needs --nose conical or --nose ogival"},
      {{"--nose", "ogival", "--nose-length-mm", "9"},
       "--nose-length-mm = 9: must exceed the radius of an ogive, 10 mm"},
      {{"--calibre-radius-head", "3"}, "--calibre-radius-head = 3: needs --nose ogival"},
      {{"--nose", "ogival", "--calibre-radius-head", "0.4"}, "--calibre-radius-head = 0.4: must exceed 0.5"},
      {{"--nose", "ogival", "--calibre-radius-head", "3", "--nose-length-mm", "33"},
       "--calibre-radius-head = 3: contradicts nose_length_mm"},
      {{"--nose", "conical", "--edge-radius-mm", "0.5"}, "--edge-radius-mm = 0.5: needs --nose blunt"},
      {{"--edge-radius-mm", "1.3"},
       "--edge-radius-mm = 1.3: must be at most an eighth of the diameter, 2.5 mm, and twice the particle distance, "
       "1.2 mm"},
      {{"--nose", "conical", "--length-mm", "31"}, "--length-mm = 31: must be 32 mm or more"},
      {{"--obliquity-deg", "30"}, "--obliquity-deg = 30: needs --extent half or --extent full"},
      {{"--obliquity-deg", "30", "--extent", "half", "--sph-radius-mm", "18"},
       "--sph-radius-mm = 18: must lie between 19.675209 mm, what the oblique projectile needs and two spacings"},
      {{"--diameter-mm", "46"}, "--sph-radius-mm = 24: must lie between 24.2 mm"},
      {{"--model", "MJC"}, "--model = MJC: must be one of mjc, jc, voce, power_law"},
      {{"--kernel", "gauss"}, "--kernel = gauss: must be one of cubic_spline, wendland_c2"},
      {{"--quiet=maybe"}, "--quiet = maybe: must be true or false"},
      {{"--no-quiet=maybe"}, "--quiet = maybe: must be true or false"},
      {{"--quiet="}, "--quiet: needs a value: true or false"},
      {{"--thickness-mm"}, "--thickness-mm: needs a value: a number between 0.05 and 500 mm"},
      {{"--thickness-mm", ""}, "--thickness-mm: needs a value: a number between 0.05 and 500 mm"},
      {{"--thickness-mm="}, "--thickness-mm: needs a value: a number between 0.05 and 500 mm"},
      {{"--thickness-mm", "--quiet"}, "--thickness-mm: needs a value: a number between 0.05 and 500 mm"},
      {{"--nose"}, "--nose: needs a value: one of blunt, conical, ogival, hemispherical"},
      {{"--restart"}, "--restart: needs a value: the name of a checkpoint file"},
      {{"--config"}, "--config: needs a value: the name of a TOML file"},
      {{"--thicknes-mm", "3"},
       "--thicknes-mm: unknown option, the nearest is --thickness-mm; ogive shoot --help-all lists what is allowed"},
      {{"--thickness", "3"},
       "--thickness: unknown option, the nearest is --thickness-mm; ogive shoot --help-all lists what is allowed"},
      {{"--qiuet=true"}, "--qiuet: unknown option, the nearest is --quiet; "},
      {{"--no-vkt"}, "--no-vkt: unknown option, the nearest is --no-vtk; "},
      {{"--bullets", "3"}, "--bullets: unknown option; ogive shoot --help-all lists what is allowed"},
      {{"-x"}, "-x: unknown option; ogive shoot --help-all lists what is allowed"},
      {{"12"}, "12: unexpected argument; ogive shoot --help-all lists what is allowed"},
      {{"--out", "a\nb"}, "--out = a?b: must be the name of a folder, on one line"},
      {{"--config", "no_such.toml"}, "--config = no_such.toml: must be a TOML file that can be read: No such file"},
      {{"--config", "."}, "--config = .: must be a TOML file that can be read: Is a directory"},
      {{"--config", "/dev/zero"}, "--config = /dev/zero: must be a TOML file of at most 1 MiB"},
  };
  for (const Bad &bad : all) {
    const std::string message = refusal(bad.arguments);
    CHECK_THAT(message, Catch::Matchers::StartsWith(bad.message));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("errors in a TOML file name file, line, key and what is allowed") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string();
  struct Bad {
    std::string text, message;
  };
  const std::vector<Bad> all{
      {"# case\nthickness_mm = \"12\"\n",
       ":2: thickness_mm = \"12\": must be a number between 0.05 and 500 mm, written without the unit"},
      {"thickness_mm = -3\n", ":1: thickness_mm = -3: must lie between 0.05 and 500 mm"},
      {"\n\nvelocity_mps = nan\n", ":3: velocity_mps = nan: must lie between 1 and 3000 m/s"},
      {"velocity_mps = inf\n", ":1: velocity_mps = inf: must lie between 1 and 3000 m/s"},
      {"velocity_mps = [1, 2]\n", ":1: velocity_mps = an array: must be a number between 1 and 3000 m/s"},
      {"threads = 1.5\n", ":1: threads = 1.5: must be a whole number between 1 and "},
      {"vtk = 1\n", ":1: vtk = 1: must be true or false"},
      {"out = 3\n", ":1: out = 3: must be the name of a folder"},
      {"nose = true\n", ":1: nose = true: must be one of blunt, conical, ogival, hemispherical"},
      {"nose = \"flat\"\n", ":1: nose = \"flat\": must be one of blunt, conical, ogival, hemispherical"},
      {"thickness = 3\n",
       ":1: thickness = 3: unknown key, the nearest is thickness_mm; allowed are material, model, method, damage, "},
      {"bullets = 3\n", ":1: bullets = 3: unknown key; allowed are material, model, method, damage, failure, "},
      {"material = \"weldox_460\"\n", ":1: material = \"weldox_460\": must be a metal that "},
      {"material = \"list\"\n", ":1: material = \"list\": must be a metal that "},
      {"material = 460\n", ":1: material = 460: must be a metal that "},
      {"material = \"/gone.toml\"\n", ":1: material = /gone.toml: must be a TOML file that can be read: No such file"},
      {"damage = \"none\"\nfailure = \"removal\"\n", ":2: failure = removal: needs --damage jc or "},
      {"config = \"b.toml\"\n", ":1: config = b.toml: unknown key; allowed are material"},
      {"restart = \"checkpoint.bin\"\n", ":1: restart = checkpoint.bin: unknown key; allowed are material"},
      {"resume = true\n", ":1: resume = true: unknown key; allowed are material"},
      {"[plate]\nthickness_mm = 3\n", ":1: plate = a table: unknown key; allowed are material"},
      {"spacing_mm = 4\nthickness_mm = 6\n",
       ":1: spacing_mm = 4: must be at most half the thickness of the plate, 3 mm"},
      {"nose = blunt\n", ":1: "},
      {"quiet = true\nthickness_mm = \n", ":2: "},
      {"thickness_mm = 3\nthickness_mm = 4\n", ":2: "},
      {"\xff\xfe", ":1: "},
  };
  for (const Bad &bad : all) {
    write(file, bad.text);
    const std::string message = refusal({"--config", file.c_str()});
    CHECK_THAT(message, Catch::Matchers::StartsWith(file + bad.message));
    CHECK(message.find('\n') == std::string::npos);
  }
}
