// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "ogive/version.hpp"
#include "options_layers.hpp"
#include "options_material.hpp"
#include "options_projectile.hpp"
#include "options_table.hpp"
#include "saved_case.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>
#include <utility>

namespace perforate {

namespace {

/// What a value of this option may be, to complete "must be" or "needs a value:".
std::string allowed_text(const Entry &entry, double) { return "a number between " + text_of(entry.limits); }
std::string allowed_text(const Entry &entry, const std::optional<double> &) { return allowed_text(entry, 0.0); }
std::string allowed_text(const Entry &entry, const std::optional<int> &) {
  return "a whole number between " + text_of(entry.limits);
}
std::string allowed_text(const Entry &, const std::filesystem::path &) { return "the name of a folder"; }
std::string allowed_text(const Entry &, const std::string &) { return allowed_materials(); }
std::string allowed_text(const Entry &, bool) { return "true or false"; }
std::string allowed_text(const Entry &entry, const std::vector<double> &) {
  return "numbers between " + text_of(entry.limits) + " with commas between them";
}
std::string allowed_text(const Entry &, const std::vector<std::string> &) {
  return "materials with commas between them, each " + allowed_materials();
}
template <class E> std::string allowed_text(const Entry &, E kind) { return "one of " + choice_names(kind); }

void assign(const Entry &entry, double &value, const Given &given) {
  value = input::number_within(given, entry.limits);
}

void assign(const Entry &entry, std::optional<double> &value, const Given &given) {
  value = input::number_within(given, entry.limits);
}

void assign(const Entry &entry, std::optional<int> &value, const Given &given) {
  const auto number = input::number_given(given);
  if (!number || *number != std::floor(*number) || !input::within(entry.limits, *number))
    refuse(given, "must be " + allowed_text(entry, value));
  value = static_cast<int>(*number);
}

void assign(const Entry &, bool &value, const Given &given) { value = input::truth_given(given); }

void assign(const Entry &entry, std::filesystem::path &value, const Given &given) {
  value = input::line_given(given, allowed_text(entry, value));
}

/// The options that are texts are materials.
void assign(const Entry &entry, std::string &value, const Given &given) {
  const std::string material = input::line_given(given, allowed_text(entry, value));
  if (!is_material_file(material) && find_library_metal(material) == nullptr)
    refuse(given, "must be " + allowed_text(entry, value));
  value = material;
}

template <class V> void assign(const Entry &entry, std::vector<V> &values, const Given &given) {
  values.clear();
  for (const Given &one : input::entries_given(given)) assign(entry, values.emplace_back(), one);
}

template <class E> void assign(const Entry &, E &value, const Given &given) {
  value = input::choice_given(given, choices(value));
}

/// Puts one given value into the options.
void apply(Options &options, Origins &origins, const Given &given) {
  for_each_option(options, [&](const Entry &entry, auto &value) {
    if (given.key == entry.key) assign(entry, value, given);
  });
  origins[given.key] = given.where;
}

/// The flags of all options.
std::vector<input::Flag> flags() {
  std::vector<input::Flag> all;
  Options defaults;
  for_each_option(defaults, [&]<class V>(const Entry &entry, V &value) {
    all.push_back(
        {entry.key, allowed_text(entry, value), std::is_same_v<V, bool> ? input::Flag::none : input::Flag::one});
  });
  all.push_back({"restart", "the name of a checkpoint file"});
  all.push_back({"resume", "", input::Flag::none});
  return all;
}

/// Takes the model of a material file and checks that it has the constants that the options need. Throws SetupError.
void settle_material(Options &o, const std::string &material, bool is_model_fixed, const Origins &origins) {
  const std::string origin = origin_of(origins, o.layer_materials.empty() ? "material" : "layer_materials");
  const auto plate = read_metal(o, material, origin);
  const FlowModel model = material_file::model_of(plate);
  if (o.model != model && origins.contains("model"))
    refuse(origin_of(origins, "model"), choice_name(o.model),
           "contradicts " + printable(material) + ", which has model = " + choice_name(model));
  if (o.model != model && is_model_fixed)
    refuse(origin, printable(material),
           "has model = " + choice_name(model) + ", the other plates " + choice_name(o.model) +
               ": all plates must have the same");
  o.model = model;

  using material_file::Group;
  const auto need = [&](const char *key, auto choice, Group group) {
    if (!has(plate, group))
      refuse(origin_of(origins, key), choice_name(choice), "needs " + keys_of(group) + " in " + printable(material));
  };
  if (o.pressure == PressureLaw::mie_gruneisen) need("pressure", o.pressure, Group::shock);
  if (o.damage == DamageLaw::johnson_cook) need("damage", o.damage, Group::strain);
  if (o.damage == DamageLaw::cockcroft_latham) need("damage", o.damage, Group::work);
}

/// The same for the materials of all plates: files first, they say which model those of the library get.
void settle_materials(Options &o, const Origins &origins) {
  bool is_model_fixed = false;
  for (const bool files : {true, false})
    for (const std::string &material : materials_of(o))
      if (is_material_file(material) == files)
        settle_material(o, material, std::exchange(is_model_fixed, true), origins);
}

/// Checks what belongs together.
void check(const Options &o, const Origins &origins) {
  const auto refuse_value = [&](const char *key, double value, const std::string &allowed) {
    refuse(origin_of(origins, key), shortest(value), allowed);
  };
  if (o.damage == DamageLaw::none && o.failure != FailureEffect::none)
    refuse(origin_of(origins, "failure"), choice_name(o.failure), "needs --damage jc or --damage cockcroft_latham");
  if (o.damage == DamageLaw::none && o.damage_softening > 0)
    refuse_value("damage_softening", o.damage_softening, "needs --damage jc or --damage cockcroft_latham");
  if (o.damage == DamageLaw::none && o.damage_length_mm.value_or(0) > 0)
    refuse_value("damage_length_mm", *o.damage_length_mm, "needs --damage jc or --damage cockcroft_latham");
  if (o.damage == DamageLaw::none && o.damage_length_scope != LengthScope::everywhere)
    refuse(origin_of(origins, "damage_length_scope"), choice_name(o.damage_length_scope),
           "needs --damage jc or --damage cockcroft_latham");
  if (o.damage == DamageLaw::none && o.damage_pressure != DamagePressure::own)
    refuse(origin_of(origins, "damage_pressure"), choice_name(o.damage_pressure),
           "needs --damage jc or --damage cockcroft_latham");
  if (o.method == Method::adaptive && o.damage != DamageLaw::none && o.failure != FailureEffect::no_tension)
    refuse(origin_of(origins, "failure"), choice_name(o.failure),
           "must be no_tension with --method adaptive: so do the particles that hexes turn into");
  if (o.method == Method::adaptive && o.damage_pressure != DamagePressure::own)
    refuse(origin_of(origins, "damage_pressure"), choice_name(o.damage_pressure),
           "must be own with --method adaptive: hexes have no neighbours");
  if (o.method == Method::adaptive && o.control_stiffness > 0)
    refuse_value("control_stiffness", o.control_stiffness, "must be 0 with --method adaptive: hexes have no bonds");
  if (o.method == Method::adaptive && o.layers_mm.size() > 1)
    refuse_value("layers_mm", static_cast<double>(o.layers_mm.size()), "must be one plate with --method adaptive");
  const double thinnest =
      o.layers_mm.empty() ? o.thickness_mm : *std::min_element(o.layers_mm.begin(), o.layers_mm.end());
  if (o.spacing_mm > thinnest / 2)
    refuse_value("spacing_mm", o.spacing_mm,
                 std::string("must be at most half the thickness of the ") + (o.layers_mm.empty() ? "" : "thinnest ") +
                     "plate, " + shortest(thinnest / 2) + " mm");
  const double turn = o.obliquity_deg * std::numbers::pi / 180;
  const double smallest_disc =
      std::round(1e6 * (o.diameter_mm / 2 / std::cos(turn) + target_depth_mm(o) * std::tan(turn) + 2 * o.spacing_mm)) /
      1e6;
  if (o.sph_radius_mm < smallest_disc || o.sph_radius_mm >= o.clamp_radius_mm)
    refuse_value("sph_radius_mm", o.sph_radius_mm,
                 "must lie between " + shortest(smallest_disc) + " mm, " +
                     (o.obliquity_deg > 0 ? "what the oblique projectile needs" : "the projectile's radius") +
                     " and two spacings, and " + "less than the clamp radius, " + shortest(o.clamp_radius_mm) + " mm");
  if (o.obliquity_deg > 0 && o.extent == Extent::quarter)
    refuse_value("obliquity_deg", o.obliquity_deg, "needs --extent half or --extent full");
  const double particles = estimated_particles(o);
  if (particles > most_particles)
    refuse_value("spacing_mm", o.spacing_mm,
                 "gives about " + shortest(std::round(particles / 1e6)) + " million particles, at most " +
                     shortest(most_particles / 1e6) + " million are allowed");
}

/// The options that a run may change when it goes on: nothing in the physics depends on them.
constexpr std::array<std::string_view, 8> changeable{"end_us", "out",     "output_every_us", "checkpoint_every_us",
                                                     "vtk",    "picture", "quiet",           "threads"};

/// The options of the checkpoint with what the command line changes.
Options parse_restart(const input::CommandLine &line, const Given &restart) {
  std::string flags;
  for (const auto key : changeable) flags += (flags.empty() ? "" : ", ") + flag_of(key);
  if (line.config) refuse("--config", *line.config, "the case is that of --restart; what may be given is " + flags);
  for (const Given &given : line.given)
    if (given.key != "restart" && std::find(changeable.begin(), changeable.end(), given.key) == changeable.end())
      refuse(given, "the case is that of --restart; what may be given is " + flags);

  const std::filesystem::path file = input::line_given(restart, "the name of a checkpoint file");
  const SavedCase saved = read_saved_case(file);
  Options options;
  options.damage_length_mm.reset(); // the case has all that is set
  Origins origins;
  for (const Given &given : entries_of(saved.case_toml, "case in " + file.string())) apply(options, origins, given);
  options.out = file.has_parent_path() ? file.parent_path() : ".";
  for (const Given &given : line.given) apply(options, origins, given);
  if (!options.layers_mm.empty())
    options.thickness_mm = std::accumulate(options.layers_mm.begin(), options.layers_mm.end(), 0.0);
  check(options, origins);
  options.restart = {file, saved.metal_toml, saved.time_us};
  const bool end_given =
      std::any_of(line.given.begin(), line.given.end(), [](const Given &given) { return given.key == "end_us"; });
  if (end_given && options.end_us < saved.time_us)
    refuse("--end-us", shortest(options.end_us),
           "must not lie before the time of the checkpoint, " + shortest(saved.time_us) + " us");
  return options;
}

} // namespace

DamageLaw default_damage(Method method) { return method == Method::sfm ? DamageLaw::none : DamageLaw::johnson_cook; }

double default_softening(Method method) { return method == Method::sfm ? 0 : ogive::softening_of_damage(method); }

double default_control_stiffness(Method method) { return ogive::options_of<double>(method).sph.control.stiffness; }

std::optional<double> default_damage_length_mm(Method method, DamageLaw damage) {
  if (damage == DamageLaw::none || method == Method::sfm) return 0;
  if (method == Method::stabilised) return std::nullopt;
  return std::round(ogive::length_of_hex_damage * 1e6) / 1e3;
}

double default_length_exponent(Method method) { return ogive::length_exponent_of_damage(method); }

LengthScope default_length_scope(Method method) { return ogive::length_scope_of_damage(method); }

DamagePressure default_damage_pressure(Method method) { return ogive::options_of<double>(method).sph.damage_pressure; }

FailureEffect default_failure(DamageLaw damage) {
  return damage == DamageLaw::none ? FailureEffect::none : FailureEffect::no_tension;
}

double default_end_us(Nose nose) { return nose == Nose::blunt ? 500 : 1500; }

double target_depth_mm(const Options &o) { return std::accumulate(o.gaps_mm.begin(), o.gaps_mm.end(), o.thickness_mm); }

double estimated_particles(const Options &o) {
  constexpr double pi = 3.14159265358979323846;
  const double part = o.extent == Extent::quarter ? 0.25 : o.extent == Extent::half ? 0.5 : 1.0;
  return part * pi * o.sph_radius_mm * o.sph_radius_mm * o.thickness_mm / std::pow(o.spacing_mm, 3);
}

void take_defaults(Options &o, const Origins &origins) {
  const auto is_open = [&](const char *key) { return !origins.contains(key); };
  if (is_open("damage")) o.damage = default_damage(o.method);
  if (is_open("damage_length_mm")) o.damage_length_mm = default_damage_length_mm(o.method, o.damage);
  if (o.damage != DamageLaw::none) {
    if (is_open("damage_softening")) o.damage_softening = default_softening(o.method);
    if (is_open("damage_length_exponent")) o.damage_length_exponent = default_length_exponent(o.method);
    if (is_open("damage_length_scope")) o.damage_length_scope = default_length_scope(o.method);
    if (is_open("damage_pressure")) o.damage_pressure = default_damage_pressure(o.method);
  }
  if (is_open("control_stiffness")) o.control_stiffness = default_control_stiffness(o.method);
  if (is_open("failure")) o.failure = default_failure(o.damage);
  if (is_open("friction")) o.friction = default_friction(o.nose, o.material);
  if (is_open("end_us")) o.end_us = default_end_us(o.nose);
}

std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text) {
  const auto line = input::read_command_line("perforate", flags(), argc, argv);
  const bool list = std::any_of(line.given.begin(), line.given.end(),
                                [](const Given &given) { return given.key == "material" && given.value == "list"; });
  if (line.help)
    text << help();
  else if (line.version)
    text << "perforate " << ogive::version << "\n";
  else if (list)
    text << library_list();
  if (line.help || line.version || list) return std::nullopt;

  for (const Given &given : line.given)
    if (given.key == "restart") return parse_restart(line, given);
  const auto is_resume = [](const Given &given) { return given.key == "resume"; };
  const bool resume = std::any_of(line.given.begin(), line.given.end(), is_resume);

  Options options;
  Origins origins;
  if (line.config) {
    for (const Given &given : read_toml(*line.config)) apply(options, origins, given);
    const auto from_there = [&](std::string &material) {
      if (is_material_file(material))
        material = (std::filesystem::path(*line.config).parent_path() / material).string();
    };
    from_there(options.material);
    for (std::string &material : options.layer_materials) from_there(material);
  }
  for (const Given &given : line.given) override_layers(options, origins, given.key);
  for (const Given &given : line.given) apply(options, origins, given);

  settle_layers(options, origins);
  take_defaults(options, origins);
  settle_materials(options, origins);
  settle_projectile(options, origins);
  if (!origins.contains("out")) options.out = default_out(options);
  check(options, origins);
  return resume ? resumed(options) : options;
}

} // namespace perforate
