// SPDX-License-Identifier: BSD-3-Clause
#include "materials/library.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/shear_band.hpp"
#include "options/data_folder.hpp"
#include "shot/run.hpp"

#include <set>

using Catch::Matchers::StartsWith;
using shot::Options;

namespace {

namespace library = ogive::library;

/// A folder with steel.toml (mjc) and plain.toml (jc, without constants of damage and Mie-Grueneisen).
struct Materials {
  TemporaryFolder folder;
  std::filesystem::path steel = folder.path / "steel.toml", plain = folder.path / "plain.toml";

  Materials() {
    auto metal = library::weldox_460e_jc<double>();
    metal.damage = {};
    metal.eos = {};
    write(plain, materials::to_toml(metal, ""));
    write(steel, materials::to_toml(library::weldox_460e_mjc<double>(), ""));
  }
};

} // namespace

TEST_CASE("a material file decides the model, and names the folder") {
  const Materials m;
  const Options steel = options_of({"--material", m.steel.c_str(), "--nose", "conical"});
  CHECK(steel.material == m.steel);
  CHECK(steel.model == shot::FlowModel::mjc);
  CHECK(steel.friction == 0.02);
  CHECK(options_of({"--material", m.steel.c_str(), "--nose", "conical", "--method", "paper"}).friction == 0.08);
  CHECK(steel.out == "vtk_out/steel_mjc_conical_12mm_303.5mps");
  const Options plain = options_of({"--material", m.plain.c_str(), "--model", "jc"});
  CHECK(plain.model == shot::FlowModel::jc);
  CHECK(plain.out == "vtk_out/plain_jc_blunt_12mm_303.5mps");
  CHECK(refusal({"--material", m.plain.c_str(), "--model", "mjc"}) ==
        "--model = mjc: contradicts " + m.plain.string() + ", which has model = jc");
}

TEST_CASE("errors in a material file end the reading of options") {
  const Materials m;
  write(m.steel, "model = \"mjc\"\n");
  CHECK_THAT(refusal({"--material", m.steel.c_str()}), StartsWith(m.steel.string() + ": model \"mjc\" lacks name, "));
}

TEST_CASE("what the options need must be in the material file") {
  const Materials m;
  const std::string file = m.plain.string();
  CHECK(refusal({"--material", file.c_str(), "--damage", "jc"}) ==
        "--damage = jc: needs D1, D2, D3, D4, D5 in " + file);
  CHECK(refusal({"--material", file.c_str(), "--damage", "cockcroft_latham"}) ==
        "--damage = cockcroft_latham: needs critical_work_MPa in " + file);
  CHECK(refusal({"--material", file.c_str(), "--pressure", "mie_gruneisen"}) ==
        "--pressure = mie_gruneisen: needs hugoniot_slope, gruneisen in " + file);
  CHECK(refusal({"--material", m.steel.c_str(), "--damage", "jc", "--pressure", "mie_gruneisen"}).empty());
}

TEST_CASE("the method brings its damage along, unless the user says otherwise") {
  const Options stabilised = options_of({"--method", "stabilised"});
  CHECK(stabilised.damage == shot::DamageLaw::johnson_cook);
  CHECK(stabilised.failure == shot::FailureEffect::no_tension);
  CHECK(stabilised.damage_softening == 0.3);
  CHECK(stabilised.band_onset == 0.5);
  CHECK(stabilised.damage_pressure == shot::DamagePressure::neighbours);
  CHECK(stabilised == options_of({}));
  CHECK(stabilised.lattice == shot::Lattice::ring);
  CHECK(stabilised.control_stiffness == 0.3);
  CHECK(stabilised.out == "vtk_out/weldox_460e_mjc_blunt_12mm_303.5mps");
  std::visit(
      [](const auto &metal) {
        CHECK(metal.damage.softening == 0.3);
        CHECK(metal.shear_band.onset_ratio == 0.5);
      },
      plate_of(stabilised));
  const Options undamaged = options_of({"--method", "stabilised", "--damage", "none"});
  CHECK(undamaged.failure == shot::FailureEffect::none);
  CHECK(undamaged.damage_softening == 0);
  CHECK(undamaged.band_onset == 0.5); // bands need no damage
  CHECK(undamaged.damage_pressure == shot::DamagePressure::own);
  const Options paper = options_of({"--method", "paper"});
  CHECK(paper.damage == shot::DamageLaw::none);
  CHECK(paper.lattice == shot::Lattice::cubic);
  CHECK(paper.control_stiffness == 0);
  CHECK(options_of({"--method", "paper", "--damage", "jc"}).damage_softening == 0);
  CHECK(paper.band_onset == 0);
  CHECK(refusal({"--method", "paper", "--damage-pressure", "neighbours"}) ==
        "--damage-pressure = neighbours: needs --damage jc or --damage cockcroft_latham");
  CHECK(options_of({"--damage-softening", "0.1"}).damage_softening == 0.1);
}

TEST_CASE("a metal without failure strains has no damage unless it is asked for, and that is said") {
  const Options o = options_of({"--material", "aa6061_t651"});
  CHECK(o.damage == shot::DamageLaw::none);
  CHECK(o.failure == shot::FailureEffect::none);
  CHECK(o.control_stiffness == 0.3);
  const auto doubts = doubts_of(o, plates_of(o));
  CHECK(std::count(doubts.begin(), doubts.end(),
                   "aa6061_t651: has no D1 to D5, so that no damage grows and plugs are held too long") == 1);
  CHECK(options_of({"--layers-mm", "6,6", "--layer-materials", "weldox_460e,weldox_460e"}).damage ==
        shot::DamageLaw::johnson_cook);
  CHECK(refusal({"--material", "aa6061_t651", "--damage", "jc"}) ==
        "--damage = jc: needs D1, D2, D3, D4, D5 in aa6061_t651");
}

TEST_CASE("bands of shear widen as the conductivity of each plate lets them") {
  // Widths after 50 us; 0 where no bands form.
  const auto widths_mm = [](std::vector<const char *> arguments) {
    std::vector<double> all;
    for (const auto &plate : plates_of(options_of(arguments)))
      std::visit(
          [&](const auto &metal) {
            const auto band = with_shear_bands(metal, 0.6e-3).shear_band;
            all.push_back(has_bands(band) ? 1e3 * ogive::band_width(band.diffusivity, 50e-6) : 0);
          },
          plate);
    return all;
  };
  // 2 sqrt(k t/(rho c_p)) with k 45 and 117 W/(m K).
  const auto both = widths_mm({"--layers-mm", "4,8", "--layer-materials", "weldox_460e,aa5083_h116"});
  REQUIRE(both.size() == 2);
  CHECK(both[0] == Approx(0.05036).epsilon(1e-3));
  CHECK(both[1] == Approx(0.09759).epsilon(1e-3));
  CHECK(widths_mm({"--band-onset", "0"})[0] == 0);
  CHECK(widths_mm({"--method", "paper"})[0] == 0);

  const Materials m;
  auto metal = library::weldox_460e_mjc<double>();
  metal.thermal_conductivity = 20;
  write(m.steel, materials::to_toml(metal, ""));
  CHECK(widths_mm({"--material", m.steel.c_str()})[0] == Approx(0.03358).epsilon(1e-3));
  metal.thermal_conductivity = 0;
  write(m.steel, materials::to_toml(metal, ""));
  const std::string doubt =
      ": has no specific heat or no thermal_conductivity_W_per_mK, so that no bands of shear form "
      "and plugs are held too long";
  const auto says_so = [&](const Options &o) {
    const auto doubts = doubts_of(o, plates_of(o));
    return std::any_of(doubts.begin(), doubts.end(), [&](const auto &text) { return text.ends_with(doubt); });
  };
  CHECK(says_so(options_of({"--material", m.steel.c_str()})));
  CHECK_FALSE(says_so(options_of({"--material", m.steel.c_str(), "--band-onset", "0"})));
  CHECK_FALSE(says_so(options_of({})));
}

TEST_CASE("damage is off, and where it is on failure takes the tension") {
  CHECK(options_of({"--method", "paper"}).failure == shot::FailureEffect::none);
  CHECK(options_of({"--damage", "jc"}).failure == shot::FailureEffect::no_tension);
  CHECK(options_of({"--damage", "jc", "--failure", "none"}).failure == shot::FailureEffect::none);
  const Options o = options_of({"--damage", "cockcroft_latham", "--failure", "removal", "--pressure", "mie_gruneisen"});
  std::visit(
      [](const auto &metal) {
        CHECK(metal.damage.law == ogive::DamageLaw::cockcroft_latham);
        CHECK(metal.damage.effect == ogive::FailureEffect::removal);
        CHECK(metal.eos.law == ogive::PressureLaw::mie_gruneisen);
      },
      plate_of(o));
}

TEST_CASE("the library's metals bear the names that the user gives") {
  for (const char *name : {"weldox_460e", "aa5083_h116", "aa5083_h116_25mm"})
    for (const char *model : {"mjc", "jc"}) {
      const auto plate = plate_of(options_of({"--material", name, "--model", model}));
      CHECK(materials::name_of(plate) == name);
      CHECK(materials::name_of(materials::model_of(plate)) == model);
    }
  const auto weak = plate_of(options_of({"--material", "aa5083_h116_25mm"}));
  CHECK(std::get<0>(weak).flow.A == library::aa5083_h116_mjc<double>(0.85).flow.A);
}

TEST_CASE("a material in a TOML file counts from the folder of that file") {
  const Materials m;
  const auto config = m.folder.path / "case.toml";
  write(config, "material = \"steel.toml\"\n");
  CHECK(options_of({"--config", config.c_str()}).material == m.steel);
  CHECK_THAT(refusal({"--config", config.c_str(), "--material", "steel.toml"}),
             StartsWith("--material = steel.toml: must be a TOML file that can be read: No such file"));
  write(config, "material = \"below/../steel.toml\"\n");
  std::filesystem::create_directory(m.folder.path / "below");
  CHECK(options_of({"--config", config.c_str()}).model == shot::FlowModel::mjc);
  write(config, "material = " + ('"' + m.plain.string() + '"') + "\nmodel = \"mjc\"\n");
  CHECK(refusal({"--config", config.c_str()}) ==
        config.string() + ":2: model = mjc: contradicts " + m.plain.string() + ", which has model = jc");
}

TEST_CASE("case.toml runs a case with a material file again") {
  const Materials m;
  const auto config = m.folder.path / "again.toml";
  for (const auto &o : {options_of({"--material", m.plain.c_str()}),
                        options_of({"--material", m.steel.c_str(), "--damage", "jc", "--nose", "ogival"}),
                        options_of({"--material", m.steel.c_str(), "--damage", "jc", "--failure", "none"})}) {
    write(config, shot::to_toml(o));
    CHECK(options_of({"--config", config.c_str()}) == o);
  }
}

TEST_CASE("a material that the results would overwrite is refused") {
  const Materials m;
  const auto file = m.folder.path / "case.toml";
  std::filesystem::rename(m.steel, file);
  Options o = options_of({"--material", file.c_str()});
  o.out = m.folder.path;
  CHECK(message_of([&] { shot::prepare_out(o); }) ==
        "--material = " + file.string() + ": must not be case.toml in the folder for the results: that is overwritten");
}

TEST_CASE("every metal of the library loads, with its source and how far to trust it") {
  std::set<std::string> files;
  for (const std::string &name : materials::library_names()) {
    INFO(name);
    const materials::LibraryMetal &entry = *materials::find_library_metal(name);
    if (entry.make == nullptr) files.insert(materials::file_of(entry).filename().string());
    const auto metal = materials::find_metal(name, shot::FlowModel::mjc, "test");
    CHECK(materials::name_of(metal) == name);
    std::visit(
        [](const auto &m) {
          CHECK(m.source.size() > 20);
          CHECK((m.confidence.starts_with("high") || m.confidence.starts_with("medium") ||
                 m.confidence.starts_with("low: from memory")));
        },
        metal);
    // At 10000 1/s the power of lead multiplies its flow stress by (2e7)^0.1 = 5.4, and its heat with it.
    CHECK(materials::doubts_of_flow(metal).size() == (name == "lead" ? 1 : 0));
    // -0.77 + 1.45 exp(-0.47 s) and -2.2 + 5.43 exp(-0.47 s) are below zero from 1.35 and 1.92 on, and 1 - 0.0528
    // ln(1e8) is 0.03.
    const bool doubtful = name == "aa6061_t6" || name == "armco_iron" || name == "mild_steel";
    CHECK(materials::doubts_of_damage(metal).size() == (doubtful ? 1 : 0));
  }
  std::set<std::string> found;
  for (const auto &file : std::filesystem::directory_iterator(options::data_folder() / "metals"))
    found.insert(file.path().filename().string());
  CHECK(found == files);
  CHECK(files.size() >= 15);
}

TEST_CASE("a metal of the library in a file has a flow law of its own") {
  const Options o = options_of({"--material", "steel_4340"});
  CHECK(o.model == shot::FlowModel::jc);
  CHECK(o.out == "vtk_out/steel_4340_jc_blunt_12mm_303.5mps");
  CHECK(options_of({"--material", "aa6061_t651", "--nose", "conical"}).friction == 0.02);
  CHECK(refusal({"--material", "steel_4340", "--model", "mjc"}) ==
        "--model = mjc: contradicts steel_4340, which has model = jc");
  CHECK(refusal({"--material", "weldox_460e", "--model", "voce"}) ==
        "--model = voce: contradicts weldox_460e, which has model = mjc");
  CHECK(refusal({"--material", "hardox_400", "--damage", "jc"}) ==
        "--damage = jc: needs D1, D2, D3, D4, D5 in hardox_400");
  // The other plate gets the law of the one that has no choice.
  const Options both = options_of({"--layers-mm", "4,8", "--layer-materials", "weldox_460e,steel_4340"});
  for (const auto &plate : plates_of(both)) CHECK(materials::model_of(plate) == shot::FlowModel::jc);
}

TEST_CASE("a run warns of its metals' flow stress, and of damage that it uses") {
  const Materials m;
  auto metal = library::weldox_460e_jc<double>();
  metal.flow.C = -0.01;
  metal.damage.failure_strain.D3 = 2.9;
  write(m.steel, materials::to_toml(metal, ""));
  const auto doubts = [&](std::vector<const char *> arguments) {
    arguments.insert(arguments.end(), {"--material", m.steel.c_str()});
    const Options o = options_of(arguments);
    return shot::doubts_of(o, shot::plates_of(o));
  };
  const auto without = doubts({"--damage", "none"});
  REQUIRE(without.size() == 2);
  CHECK(without[1] == "outside of what was compared with tests: metal steel");
  CHECK_THAT(without[0], StartsWith("weldox_460e: the flow stress falls with the rate"));
  const auto with_damage = doubts({});
  REQUIRE(with_damage.size() == 3);
  CHECK_THAT(with_damage[1], StartsWith("weldox_460e: the failure strain rises with tension"));
}

TEST_CASE("the list has a line for every metal, and fits a terminal") {
  const std::string text = materials::library_list();
  for (const std::string &name : materials::library_names()) CHECK(text.find("\n" + name + " ") != std::string::npos);
  for (const char *part :
       {"mjc, jc    D1-D5, W_cr  high", "power_law  -            medium", "jc         W_cr         low"})
    CHECK(text.find(part) != std::string::npos);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
}
