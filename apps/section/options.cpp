// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "options_table.hpp"

#include "ogive/version.hpp"

#include <cmath>
#include <ostream>
#include <set>

namespace section {

namespace {

using input::flag_of;
using input::Given;
using input::refuse;

/// The items of a list separated by commas, each as if it had been given alone.
std::vector<Given> items_given(const Given &given) {
  std::vector<Given> items;
  for (std::size_t begin = 0; begin <= given.value.size();) {
    const std::size_t end = std::min(given.value.find(',', begin), given.value.size());
    items.push_back(given);
    items.back().value = given.value.substr(begin, end - begin);
    begin = end + 1;
  }
  return items;
}

/// A list of `count` numbers separated by commas, each within the limits.
std::vector<double> numbers_given(const Entry &entry, const Given &given, std::size_t count) {
  std::vector<double> numbers;
  for (const Given &item : items_given(given)) {
    if (!number_given(item)) break;
    numbers.push_back(number_within(item, entry.limits));
  }
  if (numbers.size() != count || items_given(given).size() != count)
    refuse(given, std::string("must be ") + entry.allowed);
  return numbers;
}

void assign(const Entry &entry, double &value, const Given &given) { value = number_within(given, entry.limits); }
void assign(const Entry &entry, std::optional<int> &value, const Given &given) {
  const double number = number_within(given, entry.limits);
  if (number != std::floor(number)) refuse(given, std::string("must be ") + entry.allowed);
  value = static_cast<int>(number);
}
void assign(const Entry &entry, std::vector<double> &values, const Given &given) {
  values.clear();
  for (const Given &item : items_given(given)) {
    if (item.value != "last" && !number_given(item)) refuse(given, std::string("must be ") + entry.allowed);
    values.push_back(item.value == "last" ? last_time : number_within(item, entry.limits));
  }
}
void assign(const Entry &entry, std::optional<Range> &value, const Given &given) {
  const auto numbers = numbers_given(entry, given, 2);
  value = Range{numbers[0], numbers[1]};
  if (!(value->low < value->high)) refuse(given, std::string("must be ") + entry.allowed);
}
void assign(const Entry &entry, std::optional<View> &value, const Given &given) {
  const auto numbers = numbers_given(entry, given, 3);
  value = View{numbers[0], numbers[1], numbers[2]};
  if (value->high_mm - value->low_mm < 1) refuse(given, std::string("must be ") + entry.allowed + " by 1 mm or more");
  if (value->radius_mm < 1) refuse(given, "must have a radius of 1 mm or more");
}
void assign(const Entry &, bool &value, const Given &given) { value = input::truth_given(given); }
void assign(const Entry &, Colour &value, const Given &given) { value = choice_given(given, colours); }
void assign(const Entry &, std::optional<ogive::Extent> &value, const Given &given) {
  value = choice_given(given, extents);
}
void assign(const Entry &, ogive::Nose &value, const Given &given) { value = choice_given(given, noses()); }
void assign(const Entry &entry, std::string &value, const Given &given) { value = line_given(given, entry.allowed); }
void assign(const Entry &entry, std::vector<std::string> &values, const Given &given) {
  values.push_back(line_given(given, entry.allowed));
}
void assign(const Entry &entry, std::filesystem::path &value, const Given &given) {
  value = line_given(given, entry.allowed);
  if (value.extension() != ".png" || value.stem().empty()) refuse(given, std::string("must be ") + entry.allowed);
}
void assign(const Entry &entry, std::vector<std::filesystem::path> &values, const Given &given) {
  values.emplace_back(line_given(given, entry.allowed));
}

template <class V> constexpr input::Flag::Values values_of(const V &) { return input::Flag::one; }
constexpr input::Flag::Values values_of(const bool &) { return input::Flag::none; }
constexpr input::Flag::Values values_of(const std::vector<std::string> &) { return input::Flag::several; }
constexpr input::Flag::Values values_of(const std::vector<std::filesystem::path> &) { return input::Flag::several; }

/// What a value may be, to complete "needs a value:".
std::string allowed_text(const Entry &entry) {
  if (*entry.allowed != 0) return entry.allowed;
  return entry.limits.high > 0 ? "a number between " + text_of(entry.limits) : "one of those that --help names";
}

const char *flag_of_figure(Figure figure) {
  return figure == Figure::projectiles ? "--projectiles" : figure == Figure::mesh ? "--mesh" : "--series";
}

/// Finds out which figure is meant, and refuses options of others.
void choose_figure(Options &o, const std::vector<Given> &all) {
  std::set<Figure> asked;
  if (!o.series.empty()) asked.insert(Figure::panel);
  if (o.projectiles) asked.insert(Figure::projectiles);
  if (o.mesh) asked.insert(Figure::mesh);
  if (asked.size() != 1) {
    const std::string problem = asked.empty() ? "one is required" : "only one may be given";
    throw ogive::SetupError("--series, --projectiles, --mesh: " + problem + ": each draws another picture");
  }
  o.figure = *asked.begin();
  for_each_option(o, [&](const Entry &entry, auto &) {
    for (const Given &given : all)
      if (given.key == entry.key && entry.figure != Figure::any && entry.figure != o.figure)
        throw ogive::SetupError(given.where + ": belongs to " + flag_of_figure(entry.figure) + ", not to " +
                                flag_of_figure(o.figure));
  });
}

void check(const Options &o) {
  if (o.out.empty()) throw ogive::SetupError("--out: is required: the name of a .png file");
  if (o.figure == Figure::mesh && o.spacing_mm > o.thickness_mm / 2)
    refuse("--spacing-mm", input::shortest(o.spacing_mm), "must be at most half the thickness");
  const std::size_t sections = o.series.size() * o.times_us.size();
  if (!o.label.empty() && o.label.size() != sections)
    refuse("--label", std::to_string(o.label.size()) + " texts",
           "must be one for each section, " + std::to_string(sections));
}

std::string help() {
  std::string text =
      "section --series FOLDER|FILE.pvd... --out FILE.png [options]\n"
      "section --projectiles --out FILE.png\n"
      "section --mesh --out FILE.png [options]\n\n"
      "Draws sections through plate and projectile from results of perforate on one page, all at the\n"
      "same scale and with the same colours; or the projectiles; or the mesh. In brackets: the default.\n";
  Options defaults;
  auto figure = Figure::any;
  bool first = true;
  for_each_option(defaults, [&](const Entry &entry, auto &) {
    if (first || figure != entry.figure)
      text += entry.figure == Figure::panel         ? "\nSections:\n"
              : entry.figure == Figure::projectiles ? "\nProjectiles:\n"
              : entry.figure == Figure::mesh        ? "\nMesh:\n"
                                                    : "\nPicture:\n";
    figure = entry.figure;
    first = false;
    const std::string value = *entry.value == 0 ? "" : std::string(" ") + entry.value;
    text += input::help_item(flag_of(entry.key) + value, std::string(entry.meaning) + " [" + entry.fallback + "]");
  });
  text += "\nGeneral:\n";
  text += input::help_item("--version", "print the version");
  text += input::help_item("--help", "print this text");
  text += "\nExamples:\n"
          "  section --series vtk_out/my_case --times-us 0,20,40,last --out sequence.png\n"
          "  section --series vtk_out/blunt vtk_out/conical --label \"(a) blunt\" \"(b) conical\" --out gallery.png\n"
          "  section --series vtk_out/my_case --colour temperature --range 300,700 --out hot.png\n"
          "  section --mesh --nose ogival --spacing-mm 1 --out mesh.png\n"
          "\nExit status: 0 done; 2 wrong input; 3 the picture could not be drawn or written; 1 anything else.\n";
  return text;
}

} // namespace

std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text) {
  Options options;
  std::vector<input::Flag> flags;
  for_each_option(options, [&](const Entry &entry, auto &value) {
    flags.push_back({entry.key, allowed_text(entry), values_of(value)});
  });
  const auto line = input::read_command_line("section", flags, argc, argv);
  if (line.help)
    text << help();
  else if (line.version)
    text << "section " << ogive::version << "\n";
  if (line.help || line.version) return std::nullopt;
  if (line.config) refuse("--config", *line.config, "section reads no options from files");
  for (const Given &given : line.given)
    for_each_option(options, [&](const Entry &entry, auto &value) {
      if (given.key == entry.key) assign(entry, value, given);
    });
  choose_figure(options, line.given);
  check(options);
  return options;
}

} // namespace section
