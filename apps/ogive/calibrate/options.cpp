// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include <cctype>

namespace calibrate {

namespace {

using options::Given;
using options::Limits;
using options::Origins;
using options::refuse;
using options::shortest;
using options::Table;

/// Whether a name makes a folder of that name and reads well everywhere.
bool is_plain(const std::string &name) {
  return name.size() <= 60 && name.front() != '.' && name.front() != ' ' &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '.' || c == ' '; });
}

/// Checks what must be there and what belongs together.
void check(const Table &table, const Options &o, const Origins &origins) {
  const auto need = [&](bool there, const char *key, const std::string &why) {
    if (!there)
      throw ogive::SetupError(options::flag_of(key) + ": is required" + why + ": " + find(table, key)->allowed_text);
  };
  const auto need_above = [&](const char *key, const std::optional<double> &value, const char *low_key,
                              const std::optional<double> &low, const char *unit) {
    if (value && low && *value <= *low)
      refuse(options::origin_of(origins, key), shortest(*value),
             "must be above " + options::flag_of(low_key) + ", " + shortest(*low) + unit);
  };
  const bool heats = !o.isothermal;
  need(!o.data.empty(), "data", "");
  need(o.melting_K.has_value(), "melting_K", "");
  need(!heats || o.density_kg_per_m3, "density_kg_per_m3", " unless --isothermal");
  need(!heats || o.specific_heat_J_per_kgK, "specific_heat_J_per_kgK", " unless --isothermal");
  need(!o.engineering || o.young_GPa, "young_GPa", " with --engineering");
  need(!o.leave_out_from_K || o.leave_out_to_K, "leave_out_to_K", " with --leave-out-from-K");
  need(!o.leave_out_to_K || o.leave_out_from_K, "leave_out_from_K", " with --leave-out-to-K");
  need_above("melting_K", o.melting_K, "room_K", o.room_K, " K");
  need_above("rate_window_to", o.rate_window_to, "rate_window_from", o.rate_window_from, "");
  need_above("thermal_window_to", o.thermal_window_to, "thermal_window_from", o.thermal_window_from, "");
  need_above("leave_out_to_K", o.leave_out_to_K, "leave_out_from_K", o.leave_out_from_K, " K");
}

const options::Command command{
    .name = "ogive calibrate",
    .purpose = "Fits the modified and the classical Johnson-Cook law to tensile curves, with uncertainty, after\n"
               "Liu, Swaddiwudhipong & Islam, Nucl. Eng. Des. 250 (2012) 108-115, section 2.1. A table has the\n"
               "columns strain_rate_per_s, temperature_K, plastic_strain, stress_MPa (true values), and\n"
               "optionally specimen and plate.\n",
    .usage = "--data FILE... --melting-K X --density X --specific-heat X [options]",
    .examples = "  ogive calibrate --data apps/data/synthetic_weldox_460e.csv --melting-K 1800 --density 7850 \\\n"
                "    --specific-heat 452 --young-GPa 200 --poisson 0.33\n"
                "  ogive calibrate --config steel.toml --model jc --rate-factor power --out calibration_out/steel_jc\n",
    .more = "Exit status: 0 done; 2 wrong input, nothing was overwritten; 3 a file could not be written;\n"
            "1 anything else.\n",
    .config = true};

} // namespace

// clang-format off
Table table_of(Options &o) {
  constexpr Limits rate{1e-9, 1e9, "1/s"}, strain{0, 10, ""}, kelvin{1, 10000, "K"};
  const char *const no_material = "no material.toml";
  Table table;
  table.group = "Tests";
  add(table, o.data, {.key = "data", .meaning = "tables of tensile curves in CSV, see docs/calibration.md",
      .source = "required", .brief = "tables of tensile curves in CSV, required",
      .allowed = "the names of CSV files"});
  add(table, o.engineering, {.key = "engineering",
      .meaning = "the tables have engineering stress and strain; curves are cut at necking, needs --young-GPa"});
  add(table, o.unusual, {.key = "unusual", .meaning = "accept tests below 150 K, or with a yield stress outside 10 MPa to "
      "5 GPa, which otherwise count as wrong units"});
  auto &name = add(table, o.name, {.key = "name", .meaning = "name of the metal", .source = "that of the first table",
      .brief = "name of the metal", .allowed = "a name of letters, digits, _ - . and blanks"});
  name.assign = [&o, allowed = name.allowed_text](const Given &given) {
    o.name = line_given(given, allowed);
    if (!is_plain(o.name)) refuse(given, "must be " + allowed + ", at most 60, not a dot or blank first");
  };

  table.group = "Law";
  add(table, o.model, {.key = "model",
      .meaning = "law of material.toml, modified or classical Johnson-Cook; all laws are fitted",
      .brief = "modified or classical Johnson-Cook law: mjc, jc"});
  add(table, o.rate_factor, {.key = "rate_factor",
      .meaning = "rate factor of the classical law: 1 + C ln(rate/reference) or (1 + rate/reference)^C"});
  add(table, o.reference_rate_per_s, {.key = "reference_rate_per_s", .meaning = "reference rate of the classical law",
      .source = "rate of the quasi-static curve", .limits = rate});
  add(table, o.C, {.key = "C", .meaning = "value of C that is known", .source = "fitted", .limits = {-1, 1}});
  add(table, o.b, {.key = "b", .meaning = "value of b, or of m of the classical law, that is known", .source = "fitted",
      .limits = {0.01, 20}});

  table.group = "Metal";
  add(table, o.melting_K, {.key = "melting_K", .meaning = "melting temperature", .source = "required",
      .brief = "melting temperature, required", .limits = kelvin});
  add(table, o.density_kg_per_m3, {.key = "density_kg_per_m3", .meaning = "density, for the heating of fast tests",
      .source = "required unless --isothermal", .brief = "density, also --density; for fast tests",
      .limits = {100, 30000, "kg/m3"}, .alias = "density"});
  add(table, o.specific_heat_J_per_kgK, {.key = "specific_heat_J_per_kgK",
      .meaning = "specific heat, for the heating of fast tests",
      .source = "required unless --isothermal", .brief = "specific heat, also --specific-heat; for fast tests",
      .limits = {1, 20000, "J/(kg K)"}, .alias = "specific-heat"});
  add(table, o.thermal_conductivity_W_per_mK, {.key = "thermal_conductivity_W_per_mK",
      .meaning = "thermal conductivity, which material.toml needs for adiabatic shear bands", .source = "0: not known",
      .limits = {0, 3000, "W/(m K)"}});
  add(table, o.room_K, {.key = "room_K", .meaning = "room temperature; tests within 10 K count as at that temperature",
      .limits = kelvin});
  add(table, o.beta, {.key = "beta", .meaning = "fraction of the plastic work that becomes heat", .limits = {0, 1}});
  add(table, o.young_GPa, {.key = "young_GPa", .meaning = "Young's modulus", .source = no_material,
      .brief = "Young's modulus, for material.toml", .limits = {0.1, 2000, "GPa"}});
  add(table, o.poisson, {.key = "poisson", .meaning = "Poisson's ratio", .source = no_material,
      .brief = "Poisson's ratio, for material.toml", .limits = {0, 0.495}});

  table.group = "Fit";
  add(table, o.isothermal, {.key = "isothermal", .meaning = "all tests are isothermal", .brief = "all tests are isothermal"});
  add(table, o.adiabatic_above_per_s, {.key = "adiabatic_above_per_s",
      .meaning = "strain rate above which tests are treated as adiabatic", .limits = rate});
  add(table, o.rate_window_from, {.key = "rate_window_from",
      .meaning = "smallest plastic strain of the points that give C",
      .limits = strain});
  add(table, o.rate_window_to, {.key = "rate_window_to", .meaning = "largest plastic strain of the points that give C",
      .limits = strain});
  add(table, o.thermal_window_from, {.key = "thermal_window_from",
      .meaning = "smallest plastic strain of the points that give b",
      .limits = strain});
  add(table, o.thermal_window_to, {.key = "thermal_window_to",
      .meaning = "largest plastic strain of the points that give b",
      .limits = strain});
  add(table, o.leave_out_from_K, {.key = "leave_out_from_K",
      .meaning = "lower end of a range of temperatures whose tests are left out, as for blue brittleness",
      .limits = kelvin});
  add(table, o.leave_out_to_K, {.key = "leave_out_to_K", .meaning = "upper end of that range", .limits = kelvin});
  add(table, o.simultaneous, {.key = "simultaneous",
      .meaning = "afterwards fit all parameters at once to all tests, robustly"});

  table.group = "Output";
  add(table, o.predict_rates_per_s, {.key = "predict_rates_per_s",
      .meaning = "strain rates of the curves in prediction.svg, at room temperature", .source = "those of the tests",
      .limits = rate});
  add(table, o.out, {.key = "out", .meaning = "folder for the results", .source = "calibration_out/NAME",
      .brief = "folder for the results"});
  add(table, o.plots, {.key = "plots", .meaning = "draw the pictures"});
  return table;
}
// clang-format on

std::string file_part(std::string name) {
  for (char &c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  return name;
}

ogive::FlowForm form_of(const Options &o) {
  if (o.model == FlowModel::mjc) return ogive::FlowForm::modified;
  return o.rate_factor == RateTerm::power ? ogive::FlowForm::power : ogive::FlowForm::logarithmic;
}

std::optional<Options> parse(const options::Arguments &arguments, std::ostream &text) {
  Options o;
  const Table table = table_of(o);
  const auto line = read_command_line(command, table, arguments, text);
  if (!line) return std::nullopt;
  Origins origins;
  if (line->config)
    for (const Given &given :
         entries_of(table, options::text_of_file(*line->config, "--config"), *line->config, "melting_K = 1800.0"))
      apply(table, origins, given);
  if (line->find("data") != nullptr) o.data.clear();
  for (const Given &given : line->given) apply(table, origins, given);
  check(table, o, origins);
  if (o.name.empty()) o.name = file_part(o.data.front().stem().string().substr(0, 60));
  if (o.name.empty() || o.name.front() == '.') o.name = "metal";
  if (o.out.empty()) o.out = std::filesystem::path("calibration_out") / o.name;
  return o;
}

} // namespace calibrate
