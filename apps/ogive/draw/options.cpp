// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "../results.hpp"
#include "draw/film.hpp"

namespace commands::drawing {

using options::Entry;
using options::Given;
using options::refuse;
using options::Table;

namespace {

/// An option of `count` numbers with commas between them; `is_valid` is what they must fulfil together.
template <std::size_t count, class Valid>
void add_numbers(Table &table, std::optional<std::array<double, count>> &value, const char *placeholder,
                 const Entry &entry, Valid is_valid) {
  add_option(table, entry, options::Kind::other, placeholder).assign = [&value, entry, is_valid](const Given &given) {
    const auto items = entries_given(given);
    std::array<double, count> numbers{};
    bool valid = items.size() == count && std::all_of(items.begin(), items.end(), options::number_given);
    for (std::size_t k = 0; valid && k < count; ++k) numbers[k] = number_within(items[k], entry.limits);
    if (!valid || !is_valid(numbers)) refuse(given, std::string("must be ") + entry.allowed);
    value = numbers;
  };
}

} // namespace

// clang-format off
Table table_of(Options &o) {
  Table table;
  table.group = "Sections";
  add(table, o.series, {.key = "series",
      .meaning = "results of ogive shoot, drawn one after the other, each at all --times-us",
      .brief = "draw sections of results", .allowed = "folders with a .pvd file, or .pvd files"})
      .placeholder = "FOLDER|FILE.pvd...";
  const Entry times{.key = "times_us", .meaning = "times in us, or last; the frames nearest to them are drawn",
      .source = "last: the final state", .brief = "times in us, or last", .limits = {0, 1e6, "us"},
      .allowed = "times in us or last, separated by commas"};
  add_option(table, times, options::Kind::other, "T,T,...").assign = [&o, times](const Given &given) {
    o.times_us.clear();
    for (const Given &item : entries_given(given)) {
      if (item.value != "last" && !number_given(item)) refuse(given, std::string("must be ") + times.allowed);
      o.times_us.push_back(item.value == "last" ? last_time : number_within(item, times.limits));
    }
  };
  add(table, o.columns, {.key = "columns", .meaning = "number of sections in a row", .source = "up to 4: even rows",
      .limits = {1, 20}});
  add(table, o.colour, {.key = "colour", .meaning = "quantity that the colours show",
      .brief = "quantity that the colours show"});
  add_numbers(table, o.range, "LOW,HIGH", {.key = "range", .meaning = "values of the first and of the last colour",
      .source = "0,1.5 or 300,900 K: strain or temperature", .limits = {-1e6, 1e6},
      .allowed = "two numbers separated by a comma, the lower first"}, [](const auto &v) { return v[0] < v[1]; });
  add_numbers(table, o.view_mm, "ZMIN,ZMAX,RADIUS", {.key = "view_mm",
      .meaning = "extent of the picture; z = 0 is the plate's front face, the projectile flies towards -z",
      .source = "22 mm in front of the plate, down to the plug, 28 mm on either side", .limits = {-5000, 5000, "mm"},
      .allowed = "three numbers separated by commas, the second 1 mm or more above the first, the third 1 mm or more"},
      [](const auto &v) { return v[1] - v[0] >= 1 && v[2] >= 1; });
  add(table, o.mesh_edges, {.key = "mesh_edges", .meaning = "draw thin lines between the hexes"});
  add(table, o.from, {.key = "from",
      .meaning = "direction of view: the section from the front or obliquely, or the whole plate "
      "from behind, without the projectile", .brief = "view: section, oblique or behind"});
  add(table, o.pixels, {.key = "pixels", .meaning = "largest width of the page, pixels",
      .source = "1600, of a film 1000: ours",
      .limits = {200, 8000}});
  add(table, o.animate, {.key = "animate", .meaning = "draw a film of one series instead of a picture; needs ffmpeg",
      .brief = "draw a film of the series", .allowed = draw::film_names}).placeholder = "FILE.mp4|webm|gif|apng";
  add(table, o.frames, {.key = "frames",
      .meaning = "largest number of frames of a film; of a longer series evenly spaced ones are drawn",
      .source = "ours", .limits = {1, 10000}});
  add(table, o.frames_per_second, {.key = "frames_per_second", .meaning = "frames per second of a film", .source = "ours",
      .limits = {0.1, 60}});

  table.group = "Velocity";
  add(table, o.velocity, {.key = "velocity",
      .meaning = "results of ogive shoot: the projectile's velocity against time, all in one plot",
      .brief = "plot velocity against time", .allowed = "folders with a history.csv, or such files"})
      .placeholder = "FOLDER|FILE.csv...";
  add(table, o.measured_mps, {.key = "measured_mps", .meaning = "residual velocity of a test, drawn as a line",
      .limits = {0, 1e5, "m/s"}});

  table.group = "Comparison";
  add(table, o.compare, {.key = "compare",
      .meaning = "two results of ogive shoot: prints the differences; --out is a folder for differences.csv, velocity.svg and "
      "sections.png, the last frames", .brief = "compare two results",
      .allowed = "two folders with a summary.json"}).placeholder = "FOLDER FOLDER";

  table.group = "Projectiles";
  add(table, o.projectiles, {.key = "projectiles", .meaning = "draw the paper's projectiles with their dimensions",
      .brief = "draw the paper's projectiles with their dimensions"});

  table.group = "Mesh";
  add(table, o.mesh, {.key = "mesh", .meaning = "results of ogive mesh or shoot: the model before the shot",
      .brief = "draw the model before the shot", .allowed = "a folder with a .pvd file, or a .pvd file"})
      .placeholder = "FOLDER|FILE.pvd";

  table.group = "Picture";
  add_extent(table, o.extent);
  add(table, o.label, {.key = "label", .meaning = "labels of the sections or curves, one for each",
      .source = "(a) time and velocity, or the folder: if there are several",
      .brief = "labels of sections or curves"});
  add(table, o.title, {.key = "title", .meaning = "title above the picture", .brief = "title above the picture"});
  add(table, o.out, {.key = "out",
      .meaning = "file of the picture, for plots and projectiles .svg as well; for --compare a folder",
      .brief = "file of the picture, or folder of the comparison"}).placeholder = "FILE.png";
  return table;
}
// clang-format on

void check(const Options &o) {
  if (!o.compare.empty()) {
    if (o.compare.size() != 2)
      refuse("--compare", std::to_string(o.compare.size()) + " folders", "must be two folders with a summary.json");
    if (o.out.empty()) throw ogive::SetupError("--out: is required: a folder for table and pictures");
    if (!o.label.empty() && o.label.size() != 2)
      refuse("--label", std::to_string(o.label.size()) + " texts", "must be one for each result, 2");
    return;
  }
  const bool plot = !o.velocity.empty() || o.projectiles;
  const std::string allowed = plot ? "the name of a .svg or .png file" : "the name of a .png file";
  if (!o.animate.empty()) {
    if (!draw::is_film(o.animate)) refuse("--animate", o.animate.string(), std::string("must be ") + draw::film_names);
    if (!o.out.empty()) throw ogive::SetupError("--out: belongs to a picture, --animate names the film");
    if (o.columns || !o.label.empty() || o.times_us != std::vector{last_time})
      throw ogive::SetupError("--columns, --label, --times-us: belong to a picture, not to --animate");
    if (o.series.size() != 1) refuse("--series", std::to_string(o.series.size()) + " series", "must be one for a film");
    return;
  }
  if (o.out.empty()) throw ogive::SetupError("--out: is required: " + allowed);
  if (o.out.stem().empty() || !(o.out.extension() == ".png" || (plot && o.out.extension() == ".svg")))
    refuse("--out", o.out.string(), "must be " + allowed);
  const std::size_t labels = o.series.size() * o.times_us.size() + o.velocity.size();
  if (!o.label.empty() && o.label.size() != labels)
    refuse("--label", std::to_string(o.label.size()) + " texts",
           "must be one for each section or curve, " + std::to_string(labels));
}

} // namespace commands::drawing
