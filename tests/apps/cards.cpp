// SPDX-License-Identifier: BSD-3-Clause
#include "cards/import.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "materials/material_keys.hpp"

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

using Metal = ogive::Metal<double, ogive::JohnsonCook<double>>;

/// Columns of 10, as in cards of LS-DYNA; of 20 in those of OpenRadioss.
std::string columns(const std::vector<std::string> &fields, std::size_t width = 10) {
  std::string line;
  for (const std::string &field : fields) line += std::string(width - std::min(width, field.size()), ' ') + field;
  return line + "\n";
}

/// Steel 4340 in mm, tonne and s; `D3` as the card has it.
std::string ls_dyna(const std::string &D3 = "-2.12") {
  return "*KEYWORD\n*MAT_JOHNSON_COOK_TITLE\nSteel 4340\n$ mid, ro, ...\n" +
         columns({"1", "7.830E-9", "77519.", "200000.", "0.29", "0.0", "1.0", "0"}) +
         columns({"792.", "510.", "0.26", "0.014", "1.03", "1793.", "293.", "1.0"}) +
         columns({"4.77E+8", "-5000.", "2.0", "0", "0.05", "3.44", D3, "0.002"}) +
         columns({"0.61", "0", "0", "1.-6", "0"}) + "*EOS_GRUNEISEN\n" + columns({"1", "4578000"}) + "*END\n";
}

std::string abaqus() {
  return "** mm, tonne, s\n*Material, name=Steel-4340\n*Density\n 7.83e-09,\n*Elastic, type=ISOTROPIC\n200000., 0.29\n"
         "*Plastic, hardening=JOHNSON COOK\n 792., 510., 0.26, 1.03, 1793., 293.\n"
         "*Rate Dependent, type=JOHNSON COOK\n 0.014, 1.\n*Damage Initiation,\n criterion=JOHNSON COOK\n"
         " 0.05, 3.44, 2.12, 0.002, 0.61, 1793., 293., 1.\n*Damage Evolution, type=DISPLACEMENT\n 0.1,\n"
         "*Specific Heat\n 4.77e+08,\n*Material, name=rubber\n*Hyperelastic\n1.,\n";
}

std::string radioss() {
  return "#RADIOSS STARTER\n/UNIT/1\nunit for mat\n Mg   mm   s\n/MAT/PLAS_JOHNS/1/1\nSteel 4340\n" +
         columns({"7.83E-9"}, 20) + columns({"200000", "0.29"}, 20) + columns({"792", "510", "0.26", "0", "2500"}, 20) +
         columns({"0.014", "1"}, 20) + columns({"1.03", "1793", "3.73491", "293"}, 20) + "/FAIL/JOHNSON/1\n" +
         columns({"0.05", "3.44", "-2.12", "0.002", "0.61"}, 20) + columns({"1"}, 20);
}

cards::Imported imported(const std::string &text, std::optional<cards::Units> units = {}) {
  return cards::import_card(text, "my.card", units);
}

Metal metal_in(const std::string &text, std::optional<cards::Units> units = {}) {
  return std::get<Metal>(imported(text, units).metal);
}

std::string refusal_of(const std::string &text, std::optional<cards::Units> units = {}) {
  return message_of([&] { imported(text, units); });
}

std::string replaced(std::string text, const std::string &old, const std::string &by) {
  REQUIRE(text.find(old) != std::string::npos);
  return text.replace(text.find(old), old.size(), by);
}

/// Whether one of the lines has this part.
bool has_line(const std::vector<std::string> &lines, const std::string &part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto &line) { return line.find(part) != std::string::npos; });
}

/// The constants of steel 4340 by Johnson & Cook 1983 and 1985, in SI units.
void check_steel_4340(const Metal &m) {
  CHECK(m.density == 7830);
  CHECK(m.elasticity.young == 200e9);
  CHECK(m.elasticity.poisson == 0.29);
  CHECK(m.flow.A == 792e6);
  CHECK(m.flow.B == 510e6);
  CHECK(m.flow.n == 0.26);
  CHECK(m.flow.C == 0.014);
  CHECK(m.flow.m == 1.03);
  CHECK(m.flow.reference_rate == 1);
  CHECK(m.flow.rate_factor == ogive::RateFactor::logarithmic);
  CHECK(m.room_temperature == 293);
  CHECK(m.melting_temperature == 1793);
  CHECK(m.specific_heat == Approx(477).epsilon(1e-12));
  const auto &f = m.damage.failure_strain;
  CHECK(f.D1 == 0.05);
  CHECK(f.D2 == 3.44);
  CHECK(f.D3 == -2.12);
  CHECK(f.D4 == 0.002);
  CHECK(f.D5 == 0.61);
  CHECK(f.reference_rate == 1);
  CHECK(f.rate_term == ogive::FailureRateTerm::logarithmic);
}

} // namespace

TEST_CASE("the same steel on three cards is the same metal") {
  for (const std::string &text : {ls_dyna(), abaqus(), radioss()}) {
    INFO(text);
    const auto metal = metal_in(text);
    check_steel_4340(metal);
    CHECK_THAT(metal.source, StartsWith("imported from my.card, "));
    CHECK(materials::doubts_of_flow(metal).empty());
    CHECK(materials::doubts_of_damage(metal).empty());
  }
  CHECK(metal_in(ls_dyna()).name == "Steel 4340");
  CHECK(metal_in(abaqus()).name == "STEEL-4340");
}

TEST_CASE("units, signs and what was dropped are said") {
  const auto dyna = imported(ls_dyna());
  CHECK(has_line(dyna.notes, "units: mm-tonne-s, guessed from density 7.830e-9 and modulus 200000."));
  CHECK(has_line(dyna.notes, "D3: -2.12 as on the card, of exp(D3 triaxiality)"));
  CHECK(has_line(dyna.notes, "D4: that of 1 + D4 ln(rate/reference)"));
  for (const char *part : {"VP = 1.0 (line 5)", "PC = -5000. (line 7): cut-off of the pressure", "SPALL = 2.0",
                           "EFMIN = 1.e-6 (line 8)", "*EOS_GRUNEISEN (line 9)"})
    CHECK(has_line(dyna.dropped, part));
  CHECK(dyna.dropped.size() == 5);
  const auto inp = imported(abaqus());
  CHECK(has_line(inp.notes, "D3: -2.12, the card's d3 = 2.12 is that of exp(-d3 triaxiality)"));
  CHECK(inp.dropped == std::vector<std::string>{"*DAMAGEEVOLUTION, TYPE=DISPLACEMENT (line 14)"});
  const auto rad = imported(radioss());
  CHECK(has_line(rad.notes, "units: mm-tonne-s, stated on the card"));
  CHECK(rad.dropped == std::vector<std::string>{"SIG_max0 = 2500 (line 9): largest flow stress"});
  // A sign that makes the metal more ductile in tension is kept, and a doubt.
  CHECK(materials::doubts_of_damage(imported(ls_dyna("2.12")).metal).size() == 1);
}

TEST_CASE("a card may be written in every way and unit") {
  // mm, g and ms with commas; the exponent without its letter is Fortran's.
  check_steel_4340(metal_in("*MAT_015\n7,7.83-3,,200000,.29\n792,510,.26,.014,1.03,1793,293,1-3\n"
                            "477,,,,0.05,3.44,-2.12,2.D-3\n.61\n"));
  // mm, kg and ms, the shear modulus in place of Young's: 2 * 77.51938 GPa * 1.29 is 200.
  const auto shear = metal_in("*MAT_JOHNSON_COOK\n" + columns({"7", "7.83E-6", "77.519380", "0", "0.29"}) +
                              columns({"0.792", "0.51", "0.26", "0.014", "1.03", "1793", "293", "1E-3"}) +
                              columns({"477"}) + columns({}));
  CHECK(shear.elasticity.young == Approx(200e9).epsilon(1e-6));
  CHECK(shear.flow.A == 792e6);
  CHECK(shear.flow.reference_rate == 1);
  CHECK_FALSE(materials::has(shear, materials::Group::strain));
  // SI in columns of 20.
  check_steel_4340(metal_in("*MAT_JOHNSON_COOK+\n" + columns({"7", "7830", "0", "200.E9", "0.29"}, 20) +
                            columns({"792.E6", "510.E6", "0.26", "0.014", "1.03", "1793", "293", "1"}, 20) +
                            columns({"477", "0", "0", "0", "0.05", "3.44", "-2.12", "0.002"}, 20) +
                            columns({"0.61"}, 20)));
  // Degrees Celsius: a room temperature of 20.
  const auto celsius = metal_in(replaced(replaced(ls_dyna(), "1793.", "1520."), "293.", " 20."));
  CHECK(celsius.room_temperature == Approx(293.15));
  CHECK(celsius.melting_temperature == Approx(1793.15));
  // Temperatures that are left out, by two zeros.
  const auto cold = metal_in(replaced(abaqus(), "1.03, 1793., 293.", "1.03, 0., 0."));
  CHECK(cold.room_temperature == 293);
  CHECK(cold.melting_temperature == 1e4);
  // Without heat and rate: neutral.
  const auto plain = metal_in("*MAT_15\n1,7830,,2e11,.3\n5e8,0,0,0,0,0,0,0\n");
  CHECK(plain.flow.C == 0);
  CHECK(plain.specific_heat == 0);
  CHECK(plain.melting_temperature == 1e4);
}

TEST_CASE("units that the user gives must fit the card") {
  constexpr cards::Units mm_tonne_s{3, -3, 0}, si{};
  check_steel_4340(metal_in(ls_dyna(), mm_tonne_s));
  CHECK_THAT(refusal_of(ls_dyna(), si),
             StartsWith("my.card:5: units given as SI do not fit: density 7.830e-9 and modulus "
                        "200000. are ") &&
                 Contains(" GPa with them; --units must be one of SI"));
  // The density is that of a metal in mm, tonne and s; the modulus is in Pa.
  CHECK_THAT(refusal_of(replaced(ls_dyna(), "200000.", " 200.E9")),
             StartsWith("my.card:5: units guessed as mm-tonne-s do not fit: "));
  CHECK_THAT(refusal_of(replaced(ls_dyna(), "7.830E-9", "7.830E+9")), StartsWith("my.card:5: units cannot be guessed"));
}

TEST_CASE("what is wrong on a card is refused with its line") {
  const auto starts = [](const std::string &text, const std::string &message) {
    const std::string refusal = refusal_of(text);
    CHECK_THAT(refusal, StartsWith(message));
    CHECK(refusal.find('\n') == std::string::npos);
  };
  starts("", "my.card: must have a material *MAT_JOHNSON_COOK (LS-DYNA), ");
  starts("*MAT_SIMPLIFIED_JOHNSON_COOK\n1\n",
         "my.card:1: *MAT_SIMPLIFIED_JOHNSON_COOK cannot be imported; must have a mat");
  starts(replaced(ls_dyna(), "510.", "51O."), "my.card:6: B = 51O.: must be a number");
  starts(replaced(ls_dyna(), "510.", "&B  "), "my.card:6: B = &B: is a parameter; put its number in its place");
  starts(replaced(ls_dyna(), "     510.", "  510 0.2"),
         "my.card:6: B = 510 0.2: must be one number: the columns do not fit");
  starts(replaced(ls_dyna(), "     510.", "\t510."), "my.card:6: has a tab, with which columns cannot be counted");
  starts(replaced(ls_dyna(), "792.", "   0"), "my.card:2: LS-DYNA *MAT_JOHNSON_COOK lacks the yield stress A");
  starts(replaced(ls_dyna(), "0.26", "    "),
         "my.card:2: LS-DYNA *MAT_JOHNSON_COOK lacks the exponent n of the hardening B");
  starts(replaced(ls_dyna(), "1793.", " 200."), "my.card:2: LS-DYNA *MAT_JOHNSON_COOK: ");
  starts("*MAT_JOHNSON_COOK\n1,7.83e-9\n", "my.card:1: has 1 of its cards, at least 2 are needed");
  starts(ls_dyna() + ls_dyna(),
         "my.card:13: is a second material of this kind, the first is in line 2; keep one of them");
  starts(replaced(ls_dyna(), "1.0         0\n", "1.0         3\n"),
         "my.card:5: RATEOP = 3: must be 0, other rate factors cannot be imported");
  starts(replaced(abaqus(), "type=JOHNSON COOK\n 0.014", "type=POWER LAW\n 0.014"),
         "my.card:9: *RATE DEPENDENT: must have TYPE=JOHNSON COOK, others cannot be imported");
  starts(replaced(abaqus(), " 7.83e-09,\n", ""), "my.card:3: *DENSITY: has no data");
  starts(replaced(abaqus(), "*Density\n 7.83e-09,\n", ""),
         "my.card:5: Abaqus *PLASTIC, HARDENING=JOHNSON COOK lacks a den");
  starts(replaced(radioss(), columns({"200000", "0.29"}, 20),
                  columns({"200000", "0.29"}, 20).substr(0, 40) + "         1\n"),
         "my.card:8: Iflag = 1: must be 0; for yield stress and strength there is \"ogive materials from-tensile\"");
  starts("/MAT/LAW2/1\nx\n" + columns({"7.83E-9"}, 20), "my.card:1: /MAT/LAW2/1: ends before the line of E, Nu, Iflag");
}

TEST_CASE("a card in a file gives the metal its name where it has none") {
  const TemporaryFolder folder;
  const auto file = folder.path / "hard.k";
  write(file, replaced(ls_dyna(), "_TITLE\nSteel 4340", ""));
  CHECK(materials::name_of(cards::import_card(file, {}).metal) == "hard");
  CHECK(materials::name_of(cards::import_card(file, {}, "mine").metal) == "mine");
  CHECK_THAT(message_of([&] { cards::import_card(folder.path / "gone.k", {}); }),
             Contains("gone.k: must be a text file that can be read: No such file"));
}
