// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/calibrate/results.hpp"

#include "catch.hpp"
#include "fit/law_curves.hpp"
#include "io/temporary_folder.hpp"
#include "materials/material_file.hpp"

#include <fstream>
#include <sstream>

using calibrate::Options;

namespace {

using Arguments = std::vector<std::string>;

Options options_of(const Arguments &arguments) {
  std::ostringstream text;
  return calibrate::parse(arguments, text).value();
}

std::string refusal(const Arguments &arguments) {
  std::ostringstream text;
  try {
    calibrate::parse(arguments, text);
  } catch (const ogive::SetupError &error) {
    return error.what();
  }
  return "";
}

/// Arguments of a complete calibration, and more.
Arguments complete(Arguments more = {}) {
  Arguments all{"--data", "a.csv", "--melting-K", "1800", "--density", "7850", "--specific-heat", "452"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

const ogive::ModifiedJohnsonCook<double> steel{503e6, 581e6, 0.481, 0.01, 0.94};

/// A table of the tests that the law would give.
std::string table(bool engineering) {
  LawCurves<ogive::ModifiedJohnsonCook<double>> tests{steel};
  tests.add_all();
  std::string text = engineering ? "strain_rate_per_s,temperature_K,engineering_strain,engineering_stress_MPa\n"
                                 : "strain_rate_per_s,temperature_K,plastic_strain,stress_MPa\n";
  for (const auto &c : tests.curves)
    for (std::size_t i = 0; i < c.strain.size(); ++i) {
      const double total = c.strain[i] + c.stress[i] / 200e9;
      text += options::shortest(c.rate) + "," + options::shortest(c.temperature) + "," +
              options::shortest(engineering ? std::expm1(total) : c.strain[i]) + "," +
              options::shortest(c.stress[i] * (engineering ? std::exp(-total) : 1) / 1e6) + "\n";
    }
  return text;
}

calibrate::Results fit(const Options &o) {
  std::vector<std::string> messages;
  auto curves = calibrate::read_tables(o, messages);
  return calibrate::fitted(o, std::move(curves), std::move(messages));
}

void check_steel(const ogive::Calibration &c, double epsilon) {
  CHECK(c.hardening[0].A == Approx(503e6).epsilon(epsilon));
  CHECK(c.hardening[0].B == Approx(581e6).epsilon(epsilon));
  CHECK(c.hardening[0].a == Approx(0.481).epsilon(epsilon));
  CHECK(c.C == Approx(0.01).epsilon(epsilon));
  CHECK(c.b == Approx(0.94).epsilon(epsilon));
}

} // namespace

TEST_CASE("calibrate: defaults, short flags and lists") {
  const Options o = options_of(complete({"--data", "b.csv", "c d.csv", "--predict-rates-per-s", "1,20,300"}));
  CHECK(o.data == std::vector<std::filesystem::path>{"a.csv", "b.csv", "c d.csv"});
  CHECK(o.predict_rates_per_s == std::vector<double>{1, 20, 300});
  CHECK(o.density_kg_per_m3 == 7850);
  CHECK(o.specific_heat_J_per_kgK == 452);
  CHECK(o.name == "a");
  CHECK(o.out == "calibration_out/a");
  CHECK(calibrate::form_of(o) == ogive::FlowForm::modified);
  CHECK(calibrate::form_of(options_of(complete({"--model", "jc"}))) == ogive::FlowForm::logarithmic);
  CHECK(calibrate::form_of(options_of(complete({"--model", "jc", "--rate-factor", "power"}))) ==
        ogive::FlowForm::power);
  CHECK_FALSE(options_of({"--data", "a.csv", "--melting-K", "1800", "--isothermal"}).density_kg_per_m3);
}

TEST_CASE("calibrate: each bad argument is refused with one line") {
  struct Bad {
    Arguments arguments;
    std::string message;
  };
  const std::vector<Bad> all{
      {{}, "--data: is required: the names of CSV files"},
      {{"--data", "a.csv"}, "--melting-K: is required: a number between 1 and 10000 K"},
      {{"--data", "a.csv", "--melting-K", "1800"}, "--density-kg-per-m3: is required unless --isothermal: a number"},
      {{"--data", "a.csv", "--melting-K", "1800", "--density", "7850"},
       "--specific-heat-J-per-kgK: is required unless --isothermal"},
      {complete({"--engineering"}), "--young-GPa: is required with --engineering"},
      {complete({"--melting-K", "200"}), "--melting-K = 200: must be above --room-K, 293 K"},
      {complete({"--model", "MJC"}), "--model = MJC: must be one of mjc, jc"},
      {complete({"--beta", "2"}), "--beta = 2: must lie between 0 and 1"},
      {complete({"--C", "x"}), "--C = x: must be a number between -1 and 1"},
      {complete({"--b", "nan"}), "--b = nan: must lie between 0.01 and 20"},
      {complete({"--b"}), "--b: needs a value: a number between 0.01 and 20"},
      {complete({"--density"}), "--density: needs a value: a number between 100 and 30000 kg/m3"},
      {complete({"--predict-rates-per-s", "1,,2"}), "--predict-rates-per-s = : must be a number"},
      {complete({"--rate-window-to", "0.01"}), "--rate-window-to = 0.01: must be above --rate-window-from, 0.05"},
      {complete({"--thermal-window-to", "0.01"}), "--thermal-window-to = 0.01: must be above --thermal-window-from"},
      {complete({"--leave-out-from-K", "400"}), "--leave-out-to-K: is required with --leave-out-from-K"},
      {complete({"--leave-out-from-K", "400", "--leave-out-to-K", "300"}), "--leave-out-to-K = 300: must be above"},
      {complete({"--meltingK", "1800"}), "--meltingK: unknown option, the nearest is --melting-K"},
      {complete({"--name", "../x"}), "--name = ../x: must be a name of letters, digits"},
      {complete({"--quiet"}), "--quiet: unknown option; ogive calibrate --help-all lists what is allowed"},
      {complete({"--config", "no.toml"}), "--config = no.toml: must be a TOML file that can be read: No such file"},
  };
  for (const Bad &bad : all) {
    const std::string message = refusal(bad.arguments);
    CHECK_THAT(message, Catch::StartsWith(bad.message));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("calibrate: a TOML file gives the same, with arrays, and the command line overrides it") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "c.toml").string();
  const auto write = [&](const std::string &text) { std::ofstream(file) << text; };
  write("data = [\"a.csv\", \"b.csv\"]\nmelting_K = 1800\nisothermal = true\nC = 0.01\n"
        "predict_rates_per_s = [1, 2.5]\nplots = false\n");
  const Options o = options_of({"--config", file, "--predict-rates-per-s", "7"});
  CHECK(o.data.size() == 2);
  CHECK(o.C == 0.01);
  CHECK(o.predict_rates_per_s == std::vector<double>{7});
  CHECK_FALSE(o.plots);
  CHECK(options_of({"--config", file}).predict_rates_per_s == std::vector<double>{1, 2.5});
  CHECK(options_of({"--config", file, "--data", "c.csv"}).data == std::vector<std::filesystem::path>{"c.csv"});
  write("melting_K = [1, 2]\n");
  CHECK_THAT(refusal({"--config", file}), Catch::StartsWith(file + ":1: melting_K = an array: must be"));
  write("\ndata = [1]\n");
  CHECK_THAT(refusal({"--config", file}), Catch::StartsWith(file + ":2: data = 1: must be the names of CSV"));
  write("melting = 1800\n");
  CHECK_THAT(refusal({"--config", file}),
             Catch::StartsWith(file + ":1: melting = 1800: unknown key, the nearest is melting_K; allowed"));
}

TEST_CASE("calibrate: help names every option and fits a terminal") {
  std::ostringstream text;
  CHECK_FALSE(calibrate::parse({"--help-all"}, text));
  for (const char *flag : {"--data", "--engineering", "--C", "--b", "--simultaneous", "--leave-out-to-K", "--config"})
    CHECK(text.str().find(std::string("\n  ") + flag) != std::string::npos);
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
}

TEST_CASE("calibrate: tables become fit.json, material.toml and tables for pictures") {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "steel.csv") << table(false);
  const std::string data = (folder.path / "steel.csv").string(), out = folder.path.string();
  auto o = options_of({"--data", data, "--melting-K", "1800", "--density", "7850", "--specific-heat", "452",
                       "--young-GPa", "200", "--poisson", "0.33", "--out", out, "--no-plots", "--simultaneous"});
  const auto results = fit(o);
  // As in tests/fit/calibration.cpp.
  check_steel(results.chosen.steps.law, 1e-3);
  CHECK(results.laws.size() == 3);
  calibrate::write_json(o, results);
  CHECK(calibrate::write_materials(o, results).empty());
  CHECK(calibrate::write_plots(o, results).empty());
  for (const char *name : {"fit.json", "material.toml", "material_simultaneous.toml", "points.csv", "hardening.csv",
                           "rate_exponent.csv", "thermal_exponent.csv", "prediction.csv"})
    CHECK(std::filesystem::file_size(folder.path / name) > 100);
  const auto metal = std::get<0>(materials::read(folder.path / "material.toml"));
  CHECK(metal.name == "steel");
  CHECK(metal.density == 7850);
  CHECK(metal.flow.A == Approx(results.chosen.steps.law.hardening[0].A).epsilon(1e-15));
  CHECK(metal.flow.a == results.chosen.steps.law.hardening[0].a);
  CHECK(metal.flow.C == results.chosen.steps.law.C);
  CHECK(metal.flow.b == results.chosen.steps.law.b);
  o.young_GPa.reset();
  CHECK(calibrate::write_materials(o, results) == "material.toml: it also needs --young-GPa");
}

TEST_CASE("calibrate: engineering curves give the same law up to necking") {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "steel.csv") << table(true);
  const std::string data = (folder.path / "steel.csv").string();
  const auto results = fit(options_of({"--data", data, "--melting-K", "1800", "--density", "7850", "--specific-heat",
                                       "452", "--young-GPa", "200", "--engineering"}));
  // The conversion is exact; the first point lies at plastic strain 0.002 and may be lost to round-off.
  check_steel(results.chosen.steps.law, 2e-3);
  CHECK_FALSE(results.messages.empty());
}
