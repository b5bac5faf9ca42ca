// SPDX-License-Identifier: BSD-3-Clause
#include "materials/material_file.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "materials/material_keys.hpp"

#include "ogive/material/library.hpp"

#include <bit>
#include <cstdint>

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using materials::AnyMetal;

namespace {

namespace library = ogive::library;

/// Every constant and text of a metal, numbers to the last bit.
std::vector<std::string> bits_of(const AnyMetal &any) {
  std::vector<std::string> all;
  std::visit(
      [&](const auto &metal) {
        materials::for_each_key(metal, [&]<class V>(const materials::Key &key, const V &value) {
          if constexpr (std::is_same_v<V, double>)
            all.push_back(std::to_string(std::bit_cast<std::uint64_t>(value)));
          else
            all.push_back(materials::text_of(key, value));
        });
      },
      any);
  return all;
}

/// A file without anything optional.
const std::string mjc = "name = \"my steel\"\n"
                        "model = \"mjc\"\n"
                        "density_kg_per_m3 = 7850\n"
                        "young_modulus_GPa = 210.0\n"
                        "poisson_ratio = 0.3\n"
                        "specific_heat_J_per_kgK = 452\n"
                        "room_temperature_K = 293\n"
                        "melting_temperature_K = 1_800.0\n"
                        "A_MPa = 5.03e+2 # yield\n"
                        "B_MPa = 581\n"
                        "a = 0.481\n"
                        "C = 0.01\n"
                        "b = 0.94\n";

/// The file with a line put in place of the line of a key, or at the end if there is none.
std::string with(const std::string &key, const std::string &line) {
  const std::size_t begin = ("\n" + mjc).find("\n" + key + " =");
  if (begin == std::string::npos) return mjc + line + "\n";
  const std::size_t end = mjc.find('\n', begin);
  return mjc.substr(0, begin) + line + mjc.substr(end);
}

std::string refusal_of(const std::string &text) {
  return message_of([&] { materials::parse(text, "my.toml"); });
}

} // namespace

TEST_CASE("every metal of the library reads back from its file to the last bit") {
  auto odd = library::weldox_460e_mjc<double>();
  odd.name = "\"odd\" \\ \xc3\xa4";
  odd.density = 7850.0 / 7 * 3;
  odd.elasticity.young = std::nextafter(200e9, 1e12);
  odd.flow.A = 1e9 / 3;
  odd.flow.B = std::nextafter(0x1p29, 0);
  odd.damage.critical_work = std::nextafter(1e9, 0);
  odd.taylor_quinney = 0;
  auto bare = library::aa5083_h116_jc<double>();
  bare.flow.rate_factor = ogive::RateFactor::logarithmic;
  bare.source = "";
  bare.eos = {};
  bare.damage = {};
  bare.flow.reference_rate = 1e-10;
  auto damaged = library::aa5083_h116<double>(ogive::Voce<double>{1e8, 2e8, 20, -1e7, 3, {.C = -0.01, .m = 1}}, "");
  damaged.confidence = "low";
  damaged.damage.failure_strain.rate_term = ogive::FailureRateTerm::logarithmic;
  const auto power = library::aa5083_h116<double>(ogive::PowerLaw<double>{276e6, 70e9, 0.07, {.C = 0.001, .m = 1}}, "");
  for (const AnyMetal &metal :
       {AnyMetal(damaged), AnyMetal(power), AnyMetal(library::weldox_460e_mjc<double>()),
        AnyMetal(library::weldox_460e_jc<double>()), AnyMetal(library::aa5083_h116_mjc<double>()),
        AnyMetal(library::aa5083_h116_mjc<double>(0.85)), AnyMetal(library::aa5083_h116_jc<double>()), AnyMetal(odd),
        AnyMetal(bare)}) {
    const std::string text = materials::to_toml(metal, "two\nlines");
    CHECK_THAT(text, StartsWith("# two\n# lines\nname = "));
    const AnyMetal read = materials::parse(text, "my.toml");
    CHECK(bits_of(read) == bits_of(metal));
    CHECK(materials::to_toml(read, "two\nlines") == text);
  }
  CHECK(materials::to_toml(bare, "").find("D1") == std::string::npos);
  CHECK(materials::to_toml(bare, "").find("gruneisen") == std::string::npos);
}

TEST_CASE("a unit moves the point of a number, without rounding") {
  CHECK(options::shortest(503e6, -6) == "503");
  CHECK(options::shortest(-0.5, -3) == "-0.0005");
  CHECK(options::shortest(1234.5, 2) == "123450");
  CHECK(options::shortest(1.25e-20, -6) == "1.25e-26");
  CHECK(options::number_from("1.5e-3", 6) == 1500.0);
  CHECK(options::number_from("-2E+2", -3) == -0.2);
  CHECK_FALSE(options::number_from("5e", 6));
  CHECK_FALSE(options::number_from("", 6));
}

TEST_CASE("a file needs no optional keys, and numbers may be written in every way") {
  const AnyMetal any = materials::parse(mjc, "my.toml");
  const auto &metal = std::get<0>(any);
  CHECK(metal.name == "my steel");
  CHECK(metal.source.empty());
  CHECK(metal.elasticity.young == 210e9);
  CHECK(metal.melting_temperature == 1800);
  CHECK(metal.room_temperature == 293);
  CHECK(metal.flow.A == 503e6);
  CHECK(metal.taylor_quinney == 0.9);
  CHECK(metal.rate_floor == 1);
  CHECK_FALSE(has(any, materials::Group::shock));
  CHECK_FALSE(has(any, materials::Group::strain));
  for (const char *written : {"503", "+503", "503.0", "0.503e3", "50_300.0e-2", "0x1f7", "503000.0E-0000003"})
    CHECK(std::get<0>(materials::parse(with("A_MPa", "A_MPa = " + std::string(written)), "")).flow.A == 503e6);
}

TEST_CASE("one error names all keys that are missing or superfluous") {
  const std::string jc = refusal_of(with("model", "model = \"jc\""));
  CHECK_THAT(jc,
             StartsWith("my.toml: model \"jc\" lacks n, m, reference_rate_per_s, rate_factor and does not know a, b; "
                        "its keys are name, density_kg_per_m3, "));
  CHECK_THAT(refusal_of(with("a", "n = 0.5") + "m = 1.0\n"),
             StartsWith("my.toml: model \"mjc\" lacks a and does not know m, n; its keys are name, "));
  CHECK_THAT(refusal_of(with("b", "")), StartsWith("my.toml: model \"mjc\" lacks b; its keys are"));
  CHECK_THAT(refusal_of(mjc + "D1 = 0.1\nD4 = 0.1\ngruneisen = 2\n"),
             StartsWith("my.toml: model \"mjc\" lacks hugoniot_slope, D2, D3, D5; its keys are"));
  CHECK_THAT(refusal_of(mjc + "damage_reference_rate_per_s = 1\n"),
             StartsWith("my.toml: model \"mjc\" lacks D1, D2, D3, D4, D5; its keys are"));
  CHECK_THAT(refusal_of(with("model", "yield = 3")),
             Contains("lacks model and does not know yield; model must be one of mjc, jc, voce, power_law, bilinear"));
  CHECK_THAT(refusal_of(""), StartsWith("my.toml: lacks name, ") && Contains("melting_temperature_K, model;"));
  CHECK_THAT(refusal_of(mjc + "\"x\\ny\" = 1\n"), Contains("does not know x?y; "));
  std::string many = mjc;
  for (int i = 0; i < 1000; ++i) many += "x" + std::to_string(i) + " = 1\n";
  CHECK_THAT(refusal_of(many), Contains("x10 and") || Contains(" and 960 more"));
}

TEST_CASE("wrong values in a material file are refused with file, line, key and what is allowed") {
  struct Bad {
    std::string key, line, message;
  };
  const std::vector<Bad> all{
      {"name", "name = 3", "my.toml:1: name = 3: must be text of at most 80 characters, on one line"},
      {"name", "name = \"\"", "my.toml:1: name = \"\": must be text of at most 80 characters, on one line"},
      {"name", "name = \"a\\nb\"", "my.toml:1: name = \"a?b\": must be text of at most 80 characters, on one line"},
      {"name", "name = \"" + std::string(81, 'x') + "\"", "my.toml:1: name = \"xxx"},
      {"source", "source = []", "my.toml:14: source = an array: must be text of at most 2000 characters, on one line"},
      {"model", "model = \"zerilli\"", "my.toml:2: model = \"zerilli\": must be one of mjc, jc, voce, power_law"},
      {"model", "model = 1", "my.toml:2: model = 1: must be one of mjc, jc, voce, power_law"},
      {"density_kg_per_m3", "density_kg_per_m3 = 7.85",
       "my.toml:3: density_kg_per_m3 = 7.85: must lie between 100 and 30000 kg/m3"},
      {"young_modulus_GPa", "young_modulus_GPa = 210e9",
       "my.toml:4: young_modulus_GPa = 210e9: must lie between 0.1 and 2000 GPa"},
      {"poisson_ratio", "poisson_ratio = 0.5", "my.toml:5: poisson_ratio = 0.5: must lie between 0 and 0.495"},
      {"poisson_ratio", "poisson_ratio = \"0.3\"",
       "my.toml:5: poisson_ratio = \"0.3\": must be a number between 0 and 0.495"},
      {"specific_heat_J_per_kgK", "specific_heat_J_per_kgK = -1",
       "my.toml:6: specific_heat_J_per_kgK = -1: must lie between 0 and 20000 J/(kg K)"},
      {"melting_temperature_K", "melting_temperature_K = 293",
       "my.toml:8: melting_temperature_K = 293: must lie above room_temperature_K"},
      {"A_MPa", "A_MPa = nan", "my.toml:9: A_MPa = nan: must lie between 0 and 100000 MPa"},
      {"A_MPa", "A_MPa = inf", "my.toml:9: A_MPa = inf: must lie between 0 and 100000 MPa"},
      {"A_MPa", "A_MPa = \"503 MPa\"",
       "my.toml:9: A_MPa = \"503 MPa\": must be a number between 0 and 100000 MPa, written without the unit"},
      {"A_MPa", "A_MPa = true", "my.toml:9: A_MPa = true: must be a number between 0 and 100000 MPa"},
      {"A_MPa", "A_MPa = 1979-05-27", "my.toml:9: A_MPa = a date or time: must be a number between 0 and 100000 MPa"},
      {"C", "C = -0.2", "my.toml:12: C = -0.2: must lie between -0.1 and 1"},
      {"a", "a = 0", "my.toml:11: a = 0: must lie between 0.001 and 10"},
      {"b", "[b]\nc = 3", "my.toml:13: b = a table: must be a number between 0.01 and 10"},
      {"A_MPa", "A_MPa =", "my.toml:9: "},
      {"A_MPa", "A_MPa = 3\nA_MPa = 4", "my.toml:10: "},
      {"name", "\xff\xfe", "my.toml:1: "},
  };
  for (const Bad &bad : all) {
    const std::string message = refusal_of(with(bad.key, bad.line));
    CHECK_THAT(message, StartsWith(bad.message));
    CHECK(message.find('\n') == std::string::npos);
  }
  const std::string voce = mjc.substr(0, mjc.find("B_MPa")) + "Q1_MPa = -600\nC1 = 10\nC = 0\nm = 1\n";
  CHECK(refusal_of(voce.substr(0, voce.find("mjc")) + "voce" + voce.substr(voce.find("mjc") + 3)) ==
        "my.toml:9: A_MPa = 5.03e+2: must be positive, with Q1_MPa and Q2_MPa where those are negative");
  std::string weak = with("A_MPa", "A_MPa = 0");
  weak.replace(weak.find("B_MPa = 581"), 11, "B_MPa = 0");
  CHECK(refusal_of(weak) == "my.toml:9: A_MPa = 0: A_MPa or B_MPa must be positive");
  CHECK(refusal_of(mjc + "D1 = 0\nD2 = 0\nD3 = 0\nD4 = 0\nD5 = 0\n") ==
        "my.toml:14: D1 = 0: D1 or D2 must be positive");
  CHECK_THAT(refusal_of(mjc + "critical_work_MPa = 0\n"),
             StartsWith("my.toml:14: critical_work_MPa = 0: must lie between 0.001 and 1000000 MPa"));
}

TEST_CASE("a material file that cannot be read is refused") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "my.toml").string();
  const auto refusal_of_file = [&] { return message_of([&] { materials::read(file); }); };
  CHECK(refusal_of_file() ==
        "material = " + file + ": must be a TOML file that can be read: No such file or directory");
  write(file, mjc + std::string(1 << 20, '#'));
  CHECK(refusal_of_file() == "material = " + file + ": must be a TOML file of at most 1 MiB");
  write(file, mjc + "x = \n");
  CHECK_THAT(refusal_of_file(), StartsWith(file + ":14: "));
}

TEST_CASE("the power law has the Young's modulus of its metal") {
  std::string text = mjc.substr(0, mjc.find("A_MPa")) + "yield_MPa = 276\nn = 0.07\nC = 0\nm = 1\n";
  text.replace(text.find("mjc"), 3, "power_law");
  const auto metal = std::get<ogive::Metal<double, ogive::PowerLaw<double>>>(materials::parse(text, "x"));
  CHECK(metal.flow.modulus == 210e9);
  // 276 (210000 * 0.1/276)^0.07 = 373.767 MPa at a total strain of 0.1, of which 373.767/210000 is elastic.
  CHECK(flow_stress(metal, 0.1 - 373.767 / 210000, 1.0, 293.0).value == Approx(373.767e6).epsilon(1e-5));
}

TEST_CASE("a flow stress without an effect of the rate needs no reference rate") {
  auto metal = ogive::library::weldox_460e_jc<double>();
  metal.flow.C = 0;
  std::string text = materials::to_toml(metal, "");
  const auto begin = text.find("reference_rate_per_s");
  REQUIRE(begin != std::string::npos);
  text.erase(begin, text.find('\n', begin) + 1 - begin);
  const auto read = std::get<ogive::Metal<double, ogive::JohnsonCook<double>>>(materials::parse(text, "x"));
  CHECK(read.flow.C == 0);
  CHECK(read.flow.reference_rate > 0);
  const auto C = text.find("\nC = 0");
  REQUIRE(C != std::string::npos);
  text.replace(C, 6, "\nC = 0.1");
  CHECK_THAT(message_of([&] { materials::parse(text, "x"); }), Catch::Matchers::Contains("lacks reference_rate_per_s"));
}
