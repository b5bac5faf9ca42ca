// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "options_table.hpp"
#include "shared/toml_file.hpp"

#include "ogive/version.hpp"

#include <map>
#include <ostream>
#include <set>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

namespace calibrate {

namespace {

using input::Given;
using input::refuse;
using input::shortest;

/// Where each value comes from: the flag, or file, line and key.
using Origins = std::map<std::string, std::string>;

std::string origin_of(const Origins &origins, const std::string &key) {
  const auto found = origins.find(key);
  return found == origins.end() ? input::flag_of(key) : found->second;
}

/// What a value of this option may be, to complete "must be" or "needs a value:".
std::string allowed_text(const Entry &entry, double) { return "a number between " + text_of(entry.limits); }
std::string allowed_text(const Entry &entry, const std::optional<double> &) { return allowed_text(entry, 0.0); }
std::string allowed_text(const Entry &entry, const std::vector<double> &) {
  return "numbers between " + text_of(entry.limits) + ", separated by blanks or commas";
}
std::string allowed_text(const Entry &, const std::filesystem::path &) { return "the name of a folder"; }
std::string allowed_text(const Entry &, const std::vector<std::filesystem::path> &) { return "the names of CSV files"; }
std::string allowed_text(const Entry &, const std::string &) { return "a name of letters, digits, _ - . and blanks"; }
std::string allowed_text(const Entry &, bool) { return "true or false"; }
template <class E> std::string allowed_text(const Entry &, E kind) {
  return "one of " + input::names_in(choices(kind));
}

void assign(const Entry &entry, double &value, const Given &given) { value = number_within(given, entry.limits); }
void assign(const Entry &entry, std::optional<double> &value, const Given &given) {
  value = number_within(given, entry.limits);
}
void assign(const Entry &entry, std::vector<double> &values, const Given &given) {
  for (std::size_t begin = 0; begin <= given.value.size();) {
    const std::size_t end = std::min(given.value.find(',', begin), given.value.size());
    Given one = given;
    one.value = given.value.substr(begin, end - begin);
    values.push_back(number_within(one, entry.limits));
    begin = end + 1;
  }
}
void assign(const Entry &, bool &value, const Given &given) { value = input::truth_given(given); }
void assign(const Entry &entry, std::filesystem::path &value, const Given &given) {
  value = line_given(given, allowed_text(entry, value));
}
void assign(const Entry &entry, std::vector<std::filesystem::path> &values, const Given &given) {
  values.emplace_back(line_given(given, allowed_text(entry, values)));
}

/// Whether a name makes a folder of that name and reads well everywhere.
bool is_plain(const std::string &name) {
  return name.size() <= 60 && name.front() != '.' && name.front() != ' ' &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c == '.' || c == ' '; });
}
void assign(const Entry &entry, std::string &value, const Given &given) {
  value = line_given(given, allowed_text(entry, value));
  if (!is_plain(value))
    refuse(given, "must be " + allowed_text(entry, value) + ", at most 60, not a dot or blank first");
}
template <class E> void assign(const Entry &, E &value, const Given &given) {
  value = choice_given(given, choices(value));
}

template <class V> constexpr input::Flag::Values values_of(const V &) { return input::Flag::one; }
constexpr input::Flag::Values values_of(const bool &) { return input::Flag::none; }
template <class V> constexpr input::Flag::Values values_of(const std::vector<V> &) { return input::Flag::several; }

/// The items of an array as entries of their own, anything else as it is.
void add_items(const toml::node *node, const Given &given, std::vector<Given> &entries) {
  const toml::array *array = node != nullptr ? node->as_array() : nullptr;
  if (array == nullptr || array->empty()) return entries.push_back(given);
  for (const toml::node &item : *array) {
    Given one = given;
    if (const auto *text = item.as_string())
      one.value = text->get(), one.kind = Given::text;
    else if (const auto number = item.value<double>(); number && item.is_number())
      one.value = shortest(*number), one.kind = Given::number;
    else
      one.value = "something else in an array";
    entries.push_back(one);
  }
}

/// The entries of the file, an array of an option that takes several values taken apart.
std::vector<Given> read_config(const std::string &file) {
  const std::string text = input::text_of_file(file, "--config");
  const auto all = input::toml_entries(text, file, "melting_K = 1800.0");
  const toml::table table = toml::parse(text, file);
  Options any;
  std::string keys;
  for_each_option(any,
                  [&](const Entry &entry, auto &) { keys += (keys.empty() ? "" : ", ") + std::string(entry.key); });
  std::vector<Given> entries;
  for (const Given &given : all) {
    const bool known = with_option(any, given.key, [&](const Entry &, auto &value) {
      const bool several = values_of(value) == input::Flag::several;
      add_items(several ? table.get(given.key) : nullptr, given, entries);
    });
    if (!known) refuse(given.where, given.value, "unknown key; allowed are " + keys);
  }
  return entries;
}

/// Puts given values into the options; lists begin anew.
void apply(Options &options, Origins &origins, const std::vector<Given> &all) {
  std::set<std::string> begun;
  for (const Given &given : all) {
    with_option(options, given.key, [&]<class V>(const Entry &entry, V &value) {
      if constexpr (requires { value.push_back({}); } && !std::is_same_v<V, std::string>)
        if (begun.insert(given.key).second) value.clear();
      assign(entry, value, given);
    });
    origins[given.key] = given.where;
  }
}

/// Checks what must be there and what belongs together.
void check(const Options &o, const Origins &origins) {
  const auto needed = [&](const char *key, const std::string &why) {
    with_option(o, key, [&](const Entry &entry, const auto &value) {
      throw ogive::SetupError(input::flag_of(key) + ": is required" + why + ": " + allowed_text(entry, value));
    });
  };
  const auto refuse_value = [&](const char *key, double value, const std::string &allowed) {
    refuse(origin_of(origins, key), shortest(value), allowed);
  };
  if (o.data.empty()) needed("data", "");
  if (!o.melting_K) needed("melting_K", "");
  if (!o.isothermal && !o.density_kg_per_m3) needed("density_kg_per_m3", " unless --isothermal");
  if (!o.isothermal && !o.specific_heat_J_per_kgK) needed("specific_heat_J_per_kgK", " unless --isothermal");
  if (o.engineering && !o.young_GPa) needed("young_GPa", " with --engineering");
  if (*o.melting_K <= o.room_K)
    refuse_value("melting_K", *o.melting_K, "must lie above room temperature, " + shortest(o.room_K) + " K");
  if (o.rate_window_to && *o.rate_window_to <= o.rate_window_from)
    refuse_value("rate_window_to", *o.rate_window_to,
                 "must be above --rate-window-from, " + shortest(o.rate_window_from));
  if (o.thermal_window_to <= o.thermal_window_from)
    refuse_value("thermal_window_to", o.thermal_window_to,
                 "must be above --thermal-window-from, " + shortest(o.thermal_window_from));
  if (o.leave_out_from_K && !o.leave_out_to_K) needed("leave_out_to_K", " with --leave-out-from-K");
  if (o.leave_out_to_K && !o.leave_out_from_K) needed("leave_out_from_K", " with --leave-out-to-K");
  if (o.leave_out_to_K && *o.leave_out_to_K <= *o.leave_out_from_K)
    refuse_value("leave_out_to_K", *o.leave_out_to_K,
                 "must be above --leave-out-from-K, " + shortest(*o.leave_out_from_K) + " K");
}

/// The first table's name as a name of a metal.
std::string name_from(const std::filesystem::path &table) {
  std::string name = table.stem().string().substr(0, 60);
  for (char &c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  return name.empty() || name.front() == '.' ? "metal" : name;
}

} // namespace

std::filesystem::path default_out(const Options &o) { return std::filesystem::path("calibration_out") / o.name; }

ogive::FlowForm form_of(const Options &o) {
  if (o.model == FlowModel::mjc) return ogive::FlowForm::modified;
  return o.rate_factor == RateTerm::power ? ogive::FlowForm::power : ogive::FlowForm::logarithmic;
}

std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text) {
  std::vector<input::Flag> flags;
  Options options;
  for_each_option(options, [&](const Entry &entry, auto &value) {
    flags.push_back({entry.key, allowed_text(entry, value), values_of(value), entry.alias});
  });
  const auto line = input::read_command_line("calibrate", flags, argc, argv);
  if (line.help)
    text << help();
  else if (line.version)
    text << "calibrate " << ogive::version << "\n";
  if (line.help || line.version) return std::nullopt;

  Origins origins;
  if (line.config) apply(options, origins, read_config(*line.config));
  apply(options, origins, line.given);
  check(options, origins);
  if (!origins.contains("name")) options.name = name_from(options.data.front());
  if (!origins.contains("out")) options.out = default_out(options);
  return options;
}

std::string help() {
  std::string text = "calibrate --data FILE... --melting-K X --density X --specific-heat X [options]\n\n"
                     "Fits the modified and the classical Johnson-Cook law to tensile curves, with uncertainty, after\n"
                     "Liu, Swaddiwudhipong & Islam, Nucl. Eng. Des. 250 (2012) 108-115, section 2.1. A table has the\n"
                     "columns strain_rate_per_s, temperature_K, plastic_strain, stress_MPa (true values), and where\n"
                     "wanted specimen and plate. In brackets: the default.\n";
  Options defaults;
  const char *group = "";
  const auto placeholder = []<class V>(const V &) -> std::string {
    if constexpr (std::is_same_v<V, bool>) return "";
    if constexpr (std::is_same_v<V, std::vector<double>>) return " X...";
    if constexpr (std::is_same_v<V, std::vector<std::filesystem::path>>) return " FILE...";
    if constexpr (std::is_same_v<V, std::filesystem::path>) return " FOLDER";
    return std::is_same_v<V, double> || std::is_same_v<V, std::optional<double>> ? " X" : " NAME";
  };
  for_each_option(defaults, [&]<class V>(const Entry &entry, const V &value) {
    if (group != entry.group) text += std::string("\n") + entry.group + ":\n";
    group = entry.group;
    std::string meaning = entry.meaning;
    if (*entry.alias != 0) meaning += std::string("; also --") + entry.alias;
    if (entry.limits.high > 0) meaning += "; " + text_of(entry.limits, " to ");
    std::string shown = entry.fallback == nullptr ? "required" : entry.fallback;
    if constexpr (std::is_same_v<V, double>) shown = shortest(value);
    if constexpr (std::is_same_v<V, bool>) shown = value ? "yes; --no-plots for not" : "no";
    if constexpr (requires { choices(value); }) {
      shown = input::name_in(choices(value), value);
      meaning += ": " + input::names_in(choices(value));
    }
    text += input::help_item(input::flag_of(entry.key) + placeholder(value), meaning + " [" + shown + "]");
  });
  text += "\nGeneral:\n";
  text += input::help_item("--config FILE.toml", "read options from FILE.toml, under the names of the flags with "
                                                 "underscores (melting_K = 1800.0); the command line overrides them");
  text += input::help_item("--version", "print the version");
  text += input::help_item("--help", "print this text");
  text += "\nExamples:\n"
          "  calibrate --data apps/data/synthetic_weldox_460e.csv --melting-K 1800 --density 7850 \\\n"
          "    --specific-heat 452 --young-GPa 200 --poisson 0.33\n"
          "  calibrate --config steel.toml --model jc --rate-factor power --out calibration_out/steel_jc\n"
          "\nExit status: 0 done; 2 wrong input, nothing was overwritten; 3 a file could not be written;\n"
          "1 anything else.\n";
  return text;
}

} // namespace calibrate
