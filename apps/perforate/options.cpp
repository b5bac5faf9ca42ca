#include "options.hpp"

#include "ogive/version.hpp"
#include "options_table.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <ostream>

namespace perforate {

namespace {

/// Where each value comes from: the flag, or file, line and key.
using Origins = std::map<std::string, std::string>;

std::string origin_of(const Origins &origins, const std::string &key) {
  const auto found = origins.find(key);
  return found == origins.end() ? flag_of(key) : found->second;
}

[[noreturn]] void refuse_given(const Given &given, const std::string &allowed) {
  const bool quoted = given.kind == Given::text;
  refuse(given.where, quoted ? '"' + given.value + '"' : given.value, allowed);
}

/// What a value of this option may be, to complete "must be" or "needs a value:".
std::string allowed_text(const Entry &entry, double) { return "a number between " + text_of(entry.limits); }
std::string allowed_text(const Entry &entry, const std::optional<int> &) {
  return "a whole number between " + text_of(entry.limits);
}
std::string allowed_text(const Entry &, const std::filesystem::path &) { return "the name of a folder"; }
std::string allowed_text(const Entry &, bool) { return "true or false"; }
template <class E> std::string allowed_text(const Entry &, E kind) { return "one of " + choice_names(kind); }

/// A number from all of `text`; infinity where it is too large for one.
std::optional<double> number_from(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  if (error != std::errc{}) return std::nullopt;
  return number;
}

bool within(const Limits &limits, double number) { return number >= limits.low && number <= limits.high; }

bool is_number(const Given &given) {
  return given.kind == Given::untyped || given.kind == Given::number || given.kind == Given::integer;
}

void assign(const Entry &entry, double &value, const Given &given) {
  const auto number = is_number(given) ? number_from(given.value) : std::nullopt;
  if (!number) {
    const std::string hint = *entry.limits.unit == 0 ? "" : ", written without the unit";
    refuse_given(given, "must be " + allowed_text(entry, value) + hint);
  }
  if (!within(entry.limits, *number)) refuse_given(given, "must lie between " + text_of(entry.limits));
  value = *number;
}

void assign(const Entry &entry, std::optional<int> &value, const Given &given) {
  const auto number = is_number(given) ? number_from(given.value) : std::nullopt;
  if (!number || *number != std::floor(*number) || !within(entry.limits, *number))
    refuse_given(given, "must be " + allowed_text(entry, value));
  value = static_cast<int>(*number);
}

void assign(const Entry &entry, bool &value, const Given &given) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::boolean;
  if (!may_be || (given.value != "true" && given.value != "false"))
    refuse_given(given, "must be " + allowed_text(entry, value));
  value = given.value == "true";
}

void assign(const Entry &entry, std::filesystem::path &value, const Given &given) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::text;
  const bool one_line =
      std::none_of(given.value.begin(), given.value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (!may_be || given.value.empty() || !one_line)
    refuse_given(given, "must be " + allowed_text(entry, value) + ", on one line");
  value = given.value;
}

template <class E> void assign(const Entry &entry, E &value, const Given &given) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::text;
  for (const auto &choice : choices(value)) {
    if (!may_be || given.value != choice.name) continue;
    value = choice.value;
    return;
  }
  refuse_given(given, "must be " + allowed_text(entry, value));
}

/// Puts one given value into the options.
void apply(Options &options, Origins &origins, const Given &given) {
  for_each_option(options, [&](const Entry &entry, auto &value) {
    if (given.key == entry.key) assign(entry, value, given);
  });
  origins[given.key] = given.where;
}

/// What the command line says, the last one of each flag.
struct CommandLine {
  bool help = false;
  bool version = false;
  std::optional<std::string> config;
  std::vector<Given> given;
};

/// Throws the error for a flag without a value.
[[noreturn]] void refuse_missing(const std::string &flag, const std::string &allowed) {
  throw ogive::SetupError(printable(flag) + ": needs a value: " + allowed);
}

CommandLine read_command_line(int argc, const char *const *argv) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  const auto *help_flag = app.add_flag("--help,-h");
  const auto *version_flag = app.add_flag("--version");

  // CLI11 takes the command line apart; values are checked here, where the limits are known.
  struct Flag {
    std::string key, name, allowed;
    const CLI::Option *option;
  };
  std::vector<Flag> flags;
  const auto add_valued = [&](const std::string &key, const std::string &allowed) {
    const auto *option = app.add_option(flag_of(key))->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    flags.push_back({key, flag_of(key), allowed, option});
  };
  Options defaults;
  for_each_option(defaults, [&]<class V>(const Entry &entry, V &value) {
    const std::string name = flag_of(entry.key);
    if constexpr (std::is_same_v<V, bool>) {
      const auto *option = app.add_flag(name + ",!--no-" + name.substr(2));
      flags.push_back({entry.key, name, allowed_text(entry, value), option});
    } else {
      add_valued(entry.key, allowed_text(entry, value));
    }
  });
  add_valued("config", "the name of a TOML file");

  // CLI11 would take a following flag as the value.
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    for (const Flag &flag : flags)
      if (arguments[i] == flag.name + "=" ||
          (arguments[i] == flag.name && flag.option->get_items_expected_min() > 0 &&
           (i + 1 == arguments.size() || arguments[i + 1].empty() || arguments[i + 1].starts_with("--"))))
        refuse_missing(flag.name, flag.allowed);

  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError &error) {
    throw ogive::SetupError(printable(error.what()));
  }

  CommandLine line;
  line.help = help_flag->count() > 0;
  line.version = version_flag->count() > 0;
  if (line.help || line.version) return line;
  for (const auto &extra : app.remaining()) {
    const bool looks_like_flag = extra.starts_with("-");
    throw ogive::SetupError(printable(extra) + (looks_like_flag ? ": unknown option" : ": unexpected argument") +
                            ", perforate --help lists what is allowed");
  }
  for (const Flag &flag : flags) {
    if (flag.option->count() == 0) continue;
    const std::string value = flag.option->results().back();
    if (flag.key == "config")
      line.config = value;
    else
      line.given.push_back({flag.key, flag.name, value});
  }
  return line;
}

/// Checks what belongs together.
void check(const Options &o, const Origins &origins) {
  const auto refuse_value = [&](const char *key, double value, const std::string &allowed) {
    refuse(origin_of(origins, key), shortest(value), allowed);
  };
  if (o.spacing_mm > o.thickness_mm / 2)
    refuse_value("spacing_mm", o.spacing_mm,
                 "must be at most half the thickness of the plate, " + shortest(o.thickness_mm / 2) + " mm");
  const double smallest_disc = std::round(1e6 * (projectile_radius_mm + 2 * o.spacing_mm)) / 1e6;
  if (o.sph_radius_mm < smallest_disc || o.sph_radius_mm >= o.clamp_radius_mm)
    refuse_value("sph_radius_mm", o.sph_radius_mm,
                 "must lie between " + shortest(smallest_disc) + " mm, the projectile's radius and two spacings, and " +
                     "less than the clamp radius, " + shortest(o.clamp_radius_mm) + " mm");
  const double particles = estimated_particles(o);
  if (particles > most_particles)
    refuse_value("spacing_mm", o.spacing_mm,
                 "gives about " + shortest(std::round(particles / 1e6)) + " million particles, at most " +
                     shortest(most_particles / 1e6) + " million are allowed");
}

} // namespace

double default_friction(Nose nose, PlateMaterial material) {
  if (nose == Nose::blunt) return 0;
  return material == PlateMaterial::weldox_460e ? 0.08 : 0.02;
}

double default_end_us(Nose nose) { return nose == Nose::blunt ? 500 : 1500; }

std::filesystem::path default_out(const Options &o) {
  return std::filesystem::path("vtk_out") /
         (choice_name(o.material) + "_" + choice_name(o.model) + "_" + choice_name(o.nose) + "_" +
          shortest(o.thickness_mm) + "mm_" + shortest(o.velocity_mps) + "mps");
}

double estimated_particles(const Options &o) {
  constexpr double pi = 3.14159265358979323846;
  const double part = o.extent == Extent::quarter ? 0.25 : o.extent == Extent::half ? 0.5 : 1.0;
  return part * pi * o.sph_radius_mm * o.sph_radius_mm * o.thickness_mm / std::pow(o.spacing_mm, 3);
}

std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text) {
  const CommandLine line = read_command_line(argc, argv);
  if (line.help)
    text << help();
  else if (line.version)
    text << "perforate " << ogive::version << "\n";
  if (line.help || line.version) return std::nullopt;

  Options options;
  Origins origins;
  if (line.config)
    for (const Given &given : read_toml(*line.config)) apply(options, origins, given);
  for (const Given &given : line.given) apply(options, origins, given);

  if (!origins.contains("friction")) options.friction = default_friction(options.nose, options.material);
  if (!origins.contains("end_us")) options.end_us = default_end_us(options.nose);
  if (!origins.contains("out")) options.out = default_out(options);
  check(options, origins);
  return options;
}

std::string name_of(PlateMaterial material) { return choice_name(material); }
std::string name_of(FlowModel model) { return choice_name(model); }

} // namespace perforate
