// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "materials/library.hpp"
#include "materials/material_keys.hpp"

#include <iostream>

namespace metals {

namespace {

using options::Given;
using options::Limits;
using options::refuse;
using options::Table;

constexpr auto actions = options::named<Action>({{Action::list, "list"},
                                                 {Action::show, "show"},
                                                 {Action::check, "check"},
                                                 {Action::import, "import"},
                                                 {Action::from_tensile, "from-tensile"}});

/// Whether an option is one of the action's.
bool belongs(const options::Option &option, Action action) {
  const std::string_view key = option.key;
  if (option.group == "Mill certificate") return action == Action::from_tensile;
  if (key == "model" || key == "plot") return action == Action::show;
  if (key == "units") return action == Action::import;
  return key == "action" || action == Action::import || action == Action::from_tensile;
}

void check(const Options &o) {
  const auto need = [](bool there, const char *key, const char *why) {
    if (!there) throw ogive::SetupError(options::flag_of(key) + ": is required" + why);
  };
  const std::string action = options::name_in(actions, o.action);
  const bool takes_names = o.action != Action::list && o.action != Action::from_tensile;
  if (takes_names && o.names.empty())
    throw ogive::SetupError(action + ": needs " +
                            (o.action == Action::import ? "the name of a card" : "the names of metals or files"));
  if (!takes_names && !o.names.empty()) throw ogive::SetupError(action + ": takes no names");
  if (o.names.size() > 1 && (o.action == Action::import || !o.plot.empty()))
    throw ogive::SetupError(action + (o.plot.empty() ? "" : " --plot") + ": takes one name");
  if (!o.out.empty() && o.out.extension() != ".toml") refuse("--out", o.out.string(), "must end in .toml");
  std::error_code none;
  if (!o.out.empty() && std::filesystem::exists(o.out, none))
    refuse("--out", o.out.string(), "exists; give another name, or remove it");
  if (o.action != Action::from_tensile) return;
  need(o.yield_mpa.has_value(), "yield_mpa", "");
  need(o.uts_mpa.has_value(), "uts_mpa", "");
  need(o.young_gpa.has_value(), "young_gpa", "");
  if (*o.uts_mpa <= *o.yield_mpa)
    refuse("--uts-mpa", options::shortest(*o.uts_mpa),
           "must be above --yield-mpa, " + options::shortest(*o.yield_mpa) + " MPa");
  if (const double most = 20 * *o.young_gpa; *o.yield_mpa >= most)
    refuse("--yield-mpa", options::shortest(*o.yield_mpa),
           "must be below 0.02 times --young-gpa, " + options::shortest(most) + " MPa");
  need(o.law != Hardening::voce || o.uniform_elongation_pct, "uniform_elongation_pct", " with --law voce");
}

} // namespace

// clang-format off
Table table_of(Options &o, std::vector<std::string> &words) {
  constexpr Limits stress{1, 10000, "MPa"}, percent{0.01, 99.9, "%"};
  Table t;
  add(t, words, {.key = "action", .meaning = "list, show NAME..., check FILE.toml..., import CARD or from-tensile",
      .source = "list: ours", .brief = "list, show NAME..., check FILE.toml..., import CARD or from-tensile",
      .allowed = "list, show, check, import or from-tensile", .in_file = false});
  add(t, o.model, {.key = "model", .meaning = "of show: flow law of a metal that has several, mjc and jc",
      .source = "paper", .brief = "of show: flow law of a metal that has several", .in_file = false});
  add(t, o.plot, {.key = "plot", .meaning = "of show: draw flow curves and failure strain into this SVG or PNG; their "
      "points are written to two tables beside it", .brief = "of show: draw flow curves and failure strain",
      .allowed = "the name of a picture", .in_file = false}).placeholder = "PICTURE";
  options::Option &units = add_option(t, {.key = "units", .meaning = "of import: units of the card",
      .source = "stated on the card, else guessed from its density: ours", .brief = "of import: units of the card",
      .in_file = false}, options::Kind::choice, "NAME");
  for (const auto &one : cards::all_units) units.names.emplace_back(one.name);
  units.range = ": " + options::names_in(cards::all_units);
  units.allowed_text = "one of " + options::names_in(cards::all_units);
  units.assign = [&o](const Given &given) { o.units = choice_given(given, cards::all_units); };
  units.toml = [] { return std::string(); };
  add(t, o.out, {.key = "out", .meaning = "of import and from-tensile: the material file to write, a new one",
      .source = "printed: ours", .brief = "of import and from-tensile: the material file to write",
      .allowed = "the name of a new file that ends in .toml", .in_file = false}).placeholder = "FILE.toml";
  add(t, o.name, {.key = "name", .meaning = "of import and from-tensile: name of the metal",
      .source = "that of the card, or my_metal: ours", .allowed = "text of at most 80 characters", .in_file = false});

  t.group = "Mill certificate";
  add(t, o.yield_mpa, {.key = "yield_mpa", .meaning = "yield stress, 0.2 % proof", .source = "required",
      .brief = "of from-tensile: yield stress, 0.2 % proof, required", .limits = stress, .alias = "yield_MPa",
      .in_file = false});
  add(t, o.uts_mpa, {.key = "uts_mpa", .meaning = "tensile strength", .source = "required",
      .brief = "of from-tensile: tensile strength, required", .limits = stress, .alias = "uts_MPa", .in_file = false});
  add(t, o.young_gpa, {.key = "young_gpa", .meaning = "Young's modulus", .source = "required",
      .brief = "of from-tensile: Young's modulus, required", .limits = {1, 1000, "GPa"}, .alias = "young_GPa",
      .in_file = false});
  add(t, o.elongation_pct, {.key = "elongation_pct", .meaning = "elongation at fracture; only compared with the law",
      .brief = "of from-tensile: elongation at fracture", .limits = {0.1, 200, "%"}, .in_file = false});
  add(t, o.uniform_elongation_pct, {.key = "uniform_elongation_pct",
      .meaning = "elongation at the largest force (Agt), for --law voce", .limits = percent,
      .in_file = false});
  add(t, o.reduction_of_area_pct, {.key = "reduction_of_area_pct",
      .meaning = "reduction of area at fracture (Z); gives critical_work_MPa for --damage cockcroft_latham",
      .brief = "of from-tensile: reduction of area, gives critical_work_MPa", .limits = percent, .in_file = false});
  add(t, o.law, {.key = "law", .meaning = "hardening law", .source = "ours", .in_file = false});
  add(t, o.like, {.key = "like", .meaning = "metal of the library, or FILE.toml, for values that a certificate "
      "lacks: density, Poisson's ratio, heat, effects of rate and temperature",
      .source = "aa6061_t651 at 60 to 85 GPa, weldox_460e at 180 to 225 GPa: ours",
      .brief = "of from-tensile: metal for values that a certificate lacks",
      .allowed = "a metal of the library, or a file",
      .in_file = false}).names = materials::library_names();
  return t;
}
// clang-format on

std::optional<Options> parse(const options::Arguments &arguments) {
  Options o;
  std::vector<std::string> words;
  const Table table = table_of(o, words);
  const options::Command command{
      .name = "ogive materials",
      .purpose = "Lists the metals of the library, prints one as a file to copy or draws its curves, checks files of\n"
                 "your own, and makes them: from a material card of LS-DYNA (*MAT_JOHNSON_COOK), Abaqus (*PLASTIC,\n"
                 "HARDENING=JOHNSON COOK) or OpenRadioss (/MAT/LAW2), or from the numbers of a mill certificate.\n",
      .usage = "[list | show NAME... | check FILE.toml... | import CARD | from-tensile]",
      .examples = "  ogive materials show weldox_460e\n"
                  "  ogive materials show steel_4340 --plot steel_4340.svg\n"
                  "  ogive materials check my_steel.toml\n"
                  "  ogive materials import my_steel.k --out my_steel.toml\n"
                  "  ogive materials from-tensile --yield-mpa 276 --uts-mpa 310 --young-gpa 68.9 --out my_alloy.toml\n",
      .positional = "action"};
  const auto line = options::read_values(command, table, arguments, std::cout);
  if (!line) return {};
  const std::string action = words.empty() ? "list" : words.front();
  const auto found = std::find_if(actions.begin(), actions.end(), [&](const auto &a) { return a.name == action; });
  if (found == actions.end()) {
    std::vector<std::string> known;
    for (const auto &a : actions) known.emplace_back(a.name);
    throw ogive::SetupError(options::printable(action) + ": must be list, show, check, import or from-tensile" +
                            options::nearest_text(action, known));
  }
  o.action = found->value;
  o.names.assign(words.begin() + (words.empty() ? 0 : 1), words.end());
  for (const Given &given : line->given)
    if (const options::Option *option = find(table, given.key); option != nullptr && !belongs(*option, o.action))
      throw ogive::SetupError(options::flag_of(option->key) + ": is not an option of ogive materials " + action);
  if (o.action == Action::show && line->find("model") != nullptr)
    for (const std::string &name : o.names)
      if (!materials::is_material_file(name) && materials::is_known(name)) {
        const auto own = materials::model_of(materials::find_metal(name, o.model, "show"));
        if (own != o.model)
          refuse("--model", materials::name_of(o.model),
                 "contradicts " + name + ", which has model = " + materials::name_of(own));
      }
  check(o);
  return o;
}

} // namespace metals
