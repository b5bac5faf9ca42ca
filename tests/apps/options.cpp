// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "shot/projectile.hpp"

#include "ogive/version.hpp"
#include "options/text.hpp"
#include "shot/defaults.hpp"
#include "shot/run.hpp"
#include "shot/table.hpp"

#include <set>
#include <unistd.h>

using shot::Options;

namespace {

std::string refusal_of_out(const Options &options) {
  return message_of([&] { shot::prepare_out(options); });
}

} // namespace

TEST_CASE("without arguments the options are the main job") {
  const Options o = options_of({});
  CHECK(o == Options{});
  CHECK(o.out == "vtk_out/weldox_460e_mjc_blunt_12mm_303.5mps");
  CHECK(shot::default_out(o) == o.out);
  CHECK(shot::settled({}) == o);
}

TEST_CASE("friction, end and folder follow from the case unless given") {
  const Options steel = options_of({"--nose", "conical"});
  CHECK(steel.friction == 0.02);
  CHECK(steel.end_us == 2180); // six passages of 110 mm at 303.5 m/s
  const Options aluminium = options_of({"--nose", "conical", "--material=aa5083_h116", "--thickness-mm", "15"});
  CHECK(aluminium.friction == 0.02);
  CHECK(options_of({"--nose", "conical", "--method", "paper"}).friction == 0.08);
  CHECK(options_of({"--nose", "conical", "--method", "paper", "--material", "aa5083_h116"}).friction == 0.02);
  CHECK(options_of({"--method", "paper"}).friction == 0);
  CHECK(aluminium.out == "vtk_out/aa5083_h116_mjc_conical_15mm_303.5mps");
  const Options given = options_of({"--friction", "0.1", "--nose", "ogival", "--end-us", "50", "--out", "here"});
  CHECK(given.friction == 0.1);
  CHECK(given.end_us == 50);
  CHECK(given.out == "here");
}

TEST_CASE("cases that differ have folders of their own") {
  const std::string usual = Options{}.out.string();
  using Arguments = std::vector<const char *>;
  const auto suffix = [&](const Arguments &arguments) {
    const std::string out = options_of(arguments).out.string();
    return out.starts_with(usual) ? out.substr(usual.size()) : out;
  };
  CHECK(suffix({"--spacing-mm", "1"}) == "_spacing_mm=1");
  CHECK(suffix({"--damage", "none"}) == "_damage=none");
  CHECK(suffix({"--damage", "cockcroft_latham", "--failure", "removal"}) == "_damage=cockcroft_latham_failure=removal");
  CHECK(suffix({"--method", "paper"}) == "_paper");
  CHECK(suffix({"--method", "paper", "--lattice", "ring", "--seed", "3"}) == "_paper_lattice=ring_seed=3");
  CHECK(suffix({"--obliquity-deg", "30", "--extent", "half"}) == "_30deg_extent=half");
  CHECK(suffix({"--spacing-mm", "0.6", "--friction", "0", "--threads", "1", "--quiet", "--end-us", "300"}).empty());
  CHECK(options_of({"--nose", "conical", "--nose-length-mm", "40"}).out ==
        "vtk_out/weldox_460e_mjc_conical_12mm_303.5mps_nose_length_mm=40");
}

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

TEST_CASE("the command line overrides the file, and the last of a flag counts") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string();
  write(file, "thickness_mm = 8\nvelocity_mps = 250.5\nnose = \"ogival\"\nvtk = false\npicture = false\n");
  const Options o = options_of({"--velocity-mps", "1", "--config", file.c_str(), "--velocity-mps", "260", "--vtk"});
  CHECK(o.thickness_mm == 8);
  CHECK(o.velocity_mps == 260);
  CHECK(o.nose == shot::Nose::ogival);
  CHECK(o.friction == 0.02);
  CHECK(o.vtk);
  CHECK_FALSE(o.picture);
  CHECK_FALSE(options_of({"--no-vtk"}).vtk);
}

TEST_CASE("case.toml runs the same case again") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string();
  Options all;
  all.material = "aa5083_h116_25mm";
  all.model = shot::FlowModel::jc;
  all.method = shot::Method::stabilised;
  all.damage = shot::DamageLaw::cockcroft_latham;
  all.damage_softening = 0.25;
  all.band_onset = 0.7;
  all.damage_pressure = shot::DamagePressure::own;
  all.failure = shot::FailureEffect::removal;
  all.thickness_mm = 25.1;
  all.clamp_radius_mm = 100.0 + 1.0 / 3;
  all.nose = shot::Nose::hemispherical;
  all.rigid = true;
  all.projectile_metal = "fsp_steel";
  all.tail_length_mm = 12.5;
  all.tail_diameter_mm = 15;
  all.velocity_mps = 1000.0 / 7;
  all.friction = 1.0 / 30;
  all.end_us = 100000;
  all.settle_us = 2500.5;
  all.spacing_mm = 2.0 / 3;
  all.sph_radius_mm = 30;
  all.extent = shot::Extent::half;
  all.lattice = shot::Lattice::cubic;
  all.seed = 12;
  all.form = shot::SphForm::standard;
  all.kernel = shot::SphKernel::wendland_c2;
  all.smoothing = shot::Smoothing::variable;
  all.element = shot::ElementRule::selective_reduced;
  all.pressure = shot::PressureLaw::mie_gruneisen;
  all.control_stiffness = 0.2;
  all.contact_stiffness = 0.05;
  all.linear_viscosity = 0.1;
  all.quadratic_viscosity = 2;
  all.out = "a \"quoted\" \\ folder";
  all.output_every_us = 0.5;
  all.checkpoint_every_us = 20;
  all.vtk = false;
  all.picture = false;
  all.quiet = true;
  all.threads = 3;
  for (const Options &o : {all, Options{}, options_of({"--nose", "conical", "--velocity-mps", "214.1"})}) {
    write(file, shot::to_toml(o));
    CHECK(options_of({"--config", file.c_str()}) == o);
  }
}

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

namespace {

/// The flags that a help lists, in its order.
std::vector<std::string> flags_in(const std::string &help) {
  std::vector<std::string> flags;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  --")) flags.push_back(line.substr(2, line.find_first_of(" \n", 2) - 2));
  return flags;
}

bool fits_a_terminal(const std::string &text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 100) return false;
  return true;
}

} // namespace

TEST_CASE("asked for its version, the program prints it and ends") {
  std::ostringstream version;
  CHECK_FALSE(parse({"--version"}, version));
  CHECK(version.str() == std::string("ogive shoot ") + ogive::version + "\n");
}

TEST_CASE("the short help has one line for each of the options that most users need") {
  std::ostringstream text, same;
  CHECK_FALSE(parse({"--quiet", "--help"}, text));
  CHECK_FALSE(parse({"-h"}, same));
  CHECK(text.str() == same.str());
  std::vector<std::string> expected;
  for (const options::Option &option : commands::shoot_table().options)
    if (*option.brief != 0) expected.push_back(options::flag_of(option.key));
  CHECK(expected.size() >= 10);
  CHECK(expected.size() <= 16);
  expected.emplace_back("--help-all");
  CHECK(flags_in(text.str()) == expected);
  CHECK_THAT(text.str(), Catch::Matchers::StartsWith("ogive shoot [options]\n"));
  CHECK(fits_a_terminal(text.str()));

  // Every flag has its text on the same line, and nothing is continued on the next.
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line) && line != "Examples:";) {
    if (line.starts_with("  --")) CHECK(line.find_first_not_of(' ', line.find("  ", 4)) < line.size());
    CHECK_FALSE(line.starts_with("   "));
  }
}

TEST_CASE("the long help has every option, with its source, and fits a terminal") {
  std::ostringstream text;
  CHECK_FALSE(parse({"--help-all", "--quiet"}, text));
  std::vector<std::string> expected;
  for (const options::Option &option : commands::shoot_table().options) {
    expected.push_back(options::flag_of(option.key));
    CHECK(*option.meaning != 0);
    CHECK(*option.source != 0);
  }
  CHECK(expected.size() >= 50);
  expected.insert(expected.end(), {"--config", "--version", "--help", "--help-all"});
  auto found = flags_in(text.str());
  CHECK(std::set(found.begin(), found.end()) == std::set(expected.begin(), expected.end()));
  CHECK(found.size() == expected.size());
  CHECK(fits_a_terminal(text.str()));
  CHECK(text.str().find("\nGeneral:\n") == text.str().rfind("\nGeneral:\n"));
  for (const char *part :
       {"; 0.05 to 500 mm", "conical, ogival,", "--no-vtk", "paper, Fig. 11", "Exit status: 0 done", "\nProjectile:\n"})
    CHECK_THAT(text.str(), Catch::Matchers::Contains(part));
}

TEST_CASE("an option that stands twice in the table would hide one") {
  for (const auto table : {commands::shoot_table, commands::limit_table, commands::sweep_table, commands::mesh_table,
                           commands::draw_table, commands::calibrate_table, commands::materials_table}) {
    std::set<std::string> keys;
    for (const options::Option &option : table().options) CHECK(keys.insert(option.key).second);
  }
}

TEST_CASE("the nearest name is found for letters that are swapped, missing, superfluous or wrong, and for units") {
  const std::vector<std::string> known{"--thickness-mm", "--nose", "--nose-length-mm", "--velocity-mps", "--vtk"};
  const auto nearest = [&](const char *name) { return options::nearest(name, known); };
  CHECK(nearest("--thickness-mm") == "--thickness-mm");
  CHECK(nearest("--thikcness-mm") == "--thickness-mm");
  CHECK(nearest("--thicknes-mm") == "--thickness-mm");
  CHECK(nearest("--thicknesss-mm") == "--thickness-mm");
  CHECK(nearest("--thickmess-mm") == "--thickness-mm");
  CHECK(nearest("--thickness") == "--thickness-mm");
  CHECK(nearest("--velocity") == "--velocity-mps");
  CHECK(nearest("--velocity-ms") == "--velocity-mps");
  CHECK(nearest("--nsoe") == "--nose");
  CHECK(nearest("--nose-length") == "--nose-length-mm");
  CHECK(nearest("--vkt") == "--vtk");
  CHECK(nearest("--bullets").empty());
  CHECK(nearest("").empty());
  CHECK(nearest("--").empty());
  CHECK(options::nearest("--nose", {}).empty());
  CHECK(nearest(std::string(5000, 'n').c_str()).empty());
  CHECK(options::nearest_text("--nsoe", known) == ", the nearest is --nose");
  CHECK(options::nearest_text("--bullets", known).empty());
}

TEST_CASE("the output folder is created, and what is in it stays") {
  const TemporaryFolder folder;
  Options o;
  o.out = folder.path / "new" / "results";
  CHECK(refusal_of_out(o).empty());
  CHECK(std::filesystem::is_empty(o.out));
  write(o.out / "history.csv", "old");
  CHECK(refusal_of_out(o).empty());
  CHECK(std::filesystem::file_size(o.out / "history.csv") == 3);
}

TEST_CASE("an output folder that cannot be used is refused, and nothing is left behind") {
  const TemporaryFolder folder;
  Options o;
  const auto refused_with = [&](const std::filesystem::path &out, const std::string &reason) {
    o.out = out;
    CHECK_THAT(refusal_of_out(o), Catch::Matchers::StartsWith("--out = " + out.string() + ": " + reason));
  };
  write(folder.path / "file", "old");
  refused_with(folder.path / "file", "must be a folder, but a file of that name is there");
  refused_with(folder.path / "file" / "below", "must be a folder that can be created: Not a directory");
  CHECK(std::filesystem::file_size(folder.path / "file") == 3);
  {
    const FullDisk disk(0);
    refused_with(folder.path / "new" / "results", "must be a folder that can be written to: File too large");
  }
  CHECK_FALSE(std::filesystem::exists(folder.path / "new"));
  o.output_every_us = 0.5;
  o.end_us = 100000;
  o.spacing_mm = 0.1;
  refused_with(folder.path / "new" / "results", "needs up to ");
  CHECK_FALSE(std::filesystem::exists(folder.path / "new"));
}

TEST_CASE("a folder without permission to write is refused") {
  const TemporaryFolder folder;
  Options o;
  o.out = folder.path / "locked";
  std::filesystem::create_directory(o.out);
  std::filesystem::permissions(o.out, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  // The superuser may write anywhere.
  if (::access(o.out.c_str(), W_OK) == 0) return;
  const auto refused_with = [&](const std::string &reason) {
    CHECK_THAT(refusal_of_out(o), Catch::Matchers::StartsWith("--out = " + o.out.string() + ": " + reason));
  };
  refused_with("must be a folder that can be written to: Permission denied");
  o.out /= "below";
  refused_with("must be a folder that can be created: Permission denied");
}
