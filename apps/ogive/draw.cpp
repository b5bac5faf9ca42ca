// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "draw/model.hpp"
#include "draw/plot.hpp"
#include "draw/projectiles.hpp"
#include "draw/section.hpp"
#include "options/exit_status.hpp"
#include "shot/table.hpp"

#include "ogive/fem/hex8.hpp"
#include "ogive/io/read_frame.hpp"
#include "ogive/io/text.hpp"

#include <iostream>

namespace commands {

namespace {

namespace fs = std::filesystem;
using ogive::Frame;
using options::Entry;
using options::Given;
using options::refuse;
using options::Table;

/// The time of a series' last frame, whenever that is.
constexpr double last_time = std::numeric_limits<double>::infinity();

enum class Colour { plastic_strain, temperature };
auto choices(Colour) {
  return options::named<Colour>({{Colour::plastic_strain, "plastic_strain"}, {Colour::temperature, "temperature"}});
}

/// One picture, in the units of the names. What is unset follows from the results that are drawn.
struct Options {
  std::vector<fs::path> series; ///< .pvd files, or the folders that they lie in
  std::vector<double> times_us{last_time};
  std::optional<int> columns;
  Colour colour = Colour::plastic_strain;
  std::optional<std::array<double, 2>> range;   ///< values of the first and of the last colour
  std::optional<std::array<double, 3>> view_mm; ///< lowest and highest z, radius
  bool mesh_edges = false;
  std::optional<ogive::Extent> extent; ///< of results whose files do not hold it

  std::vector<fs::path> velocity; ///< history.csv files, or the folders that they lie in
  std::optional<double> measured_mps;

  bool projectiles = false;

  fs::path mesh; ///< as series; its first frame

  std::vector<std::string> label;
  std::string title;
  fs::path out;
};

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

// clang-format off
Table table_of(Options &o) {
  Table table;
  table.group = "Sections";
  add(table, o.series, {.key = "series", .meaning = "results of ogive shoot; all times of the first, then of the next",
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
  add(table, o.columns, {.key = "columns", .meaning = "of sections", .source = "up to 4: even rows",
      .limits = {1, 20}});
  add(table, o.colour, {.key = "colour", .meaning = "what gives the colour", .brief = "what gives the colour"});
  add_numbers(table, o.range, "LOW,HIGH", {.key = "range", .meaning = "values of the first and of the last colour",
      .source = "0,1.5 or 300,900 K: strain or temperature", .limits = {-1e6, 1e6},
      .allowed = "two numbers separated by a comma, the lower first"}, [](const auto &v) { return v[0] < v[1]; });
  add_numbers(table, o.view_mm, "ZMIN,ZMAX,RADIUS", {.key = "view_mm",
      .meaning = "what is seen; z = 0 is the plate's front face, the projectile flies towards -z",
      .source = "22 mm in front of the plate, down to the plug, 28 mm on either side", .limits = {-5000, 5000, "mm"},
      .allowed = "three numbers separated by commas, the second 1 mm or more above the first, the third 1 mm or more"},
      [](const auto &v) { return v[1] - v[0] >= 1 && v[2] >= 1; });
  add(table, o.mesh_edges, {.key = "mesh_edges", .meaning = "thin lines between the hexes"});

  table.group = "Velocity";
  add(table, o.velocity, {.key = "velocity",
      .meaning = "results of ogive shoot: the projectile's velocity against time, all in one plot",
      .brief = "plot velocity against time", .allowed = "folders with a history.csv, or such files"})
      .placeholder = "FOLDER|FILE.csv...";
  add(table, o.measured_mps, {.key = "measured_mps", .meaning = "residual velocity of a test, as a line",
      .limits = {0, 1e5, "m/s"}});

  table.group = "Projectiles";
  add(table, o.projectiles, {.key = "projectiles", .meaning = "draw the paper's projectiles with their dimensions",
      .brief = "draw the paper's projectiles with their dimensions"});

  table.group = "Mesh";
  add(table, o.mesh, {.key = "mesh", .meaning = "results of ogive mesh or shoot: the model before the shot",
      .brief = "draw the model before the shot", .allowed = "a folder with a .pvd file, or a .pvd file"})
      .placeholder = "FOLDER|FILE.pvd";

  table.group = "Picture";
  const Entry extent{.key = "extent", .meaning = "of results whose files do not hold it: quarter, half or full",
      .allowed = "one of quarter, half, full"};
  add_option(table, extent, options::Kind::choice, "NAME").assign = [&o](const Given &given) {
    o.extent = choice_given(given, choices(ogive::Extent{}));
  };
  add(table, o.label, {.key = "label", .meaning = "below the sections or of the curves, one for each",
      .source = "(a) time and velocity, or the folder: where there are several",
      .brief = "names of sections or curves"});
  add(table, o.title, {.key = "title", .meaning = "above the picture", .brief = "above the picture"});
  add(table, o.out, {.key = "out", .meaning = "the picture; .svg for plots and projectiles too",
      .brief = "the picture"}).placeholder = "FILE.png";
  return table;
}
// clang-format on

void check(const Options &o) {
  const bool plot = !o.velocity.empty() || o.projectiles;
  const std::string allowed = plot ? "the name of a .svg or .png file" : "the name of a .png file";
  if (o.out.empty()) throw ogive::SetupError("--out: is required: " + allowed);
  if (o.out.stem().empty() || !(o.out.extension() == ".png" || (plot && o.out.extension() == ".svg")))
    refuse("--out", o.out.string(), "must be " + allowed);
  const std::size_t labels = o.series.size() * o.times_us.size() + o.velocity.size();
  if (!o.label.empty() && o.label.size() != labels)
    refuse("--label", std::to_string(o.label.size()) + " texts",
           "must be one for each section or curve, " + std::to_string(labels));
}

/// The name of the folder that holds a file.
std::string folder_name(const fs::path &file) {
  return fs::absolute(file).lexically_normal().parent_path().filename().string();
}

/// The .pvd file that is meant: the one in a folder, or the file itself.
fs::path find_pvd(const fs::path &given, const char *flag) {
  std::error_code ignored;
  if (!fs::is_directory(given, ignored)) return given;
  std::vector<fs::path> found;
  for (const auto &entry : fs::directory_iterator(given, ignored))
    if (entry.path().extension() == ".pvd") found.push_back(entry.path());
  if (found.size() != 1)
    refuse(flag, given.string(),
           found.empty() ? "must be a folder with a .pvd file, or a .pvd file"
                         : "must be a folder with one .pvd file, or the one that is meant");
  return found.front();
}

/// The symmetry of results whose files do not hold it.
std::optional<ogive::SymmetryPlanes> symmetry_of(const Options &o) {
  return o.extent ? std::optional(ogive::symmetry_planes(*o.extent)) : std::nullopt;
}

/// The number of the frame nearest to a time; refuses times that are not in the series.
std::size_t frame_at(const ogive::StoredSeries &series, double time_us) {
  if (time_us == last_time) return series.frames.size() - 1;
  const double last_us = series.frames.back().time * 1e6;
  // The last frame may come a step after the time that somebody reads off a table.
  if (time_us > last_us + 0.5)
    refuse("--times-us", options::shortest(time_us),
           "must not be later than the last frame of " + series.pvd.string() + ", " +
               options::shortest(std::round(last_us * 100) / 100) + " us");
  return ogive::nearest_frame(series, time_us * 1e-6);
}

/// Mean velocity of the projectile in the direction of flight, weighted by mass, m/s. Nothing if the frame lacks what
/// it takes.
std::optional<double> projectile_velocity(const Frame &frame) {
  const auto named = [](const auto &all, const char *name) {
    return std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.name == name; });
  };
  const auto grid = named(frame.grids, "projectile");
  if (grid == frame.grids.end() || grid->hexes.empty()) return std::nullopt;
  const auto velocity = named(grid->point_fields, "velocity_m_per_s");
  const auto density = named(grid->cell_fields, "density_kg_per_m3");
  if (velocity == grid->point_fields.end() || density == grid->cell_fields.end() || velocity->components != 3)
    return std::nullopt;
  double mass = 0, momentum = 0;
  for (std::size_t e = 0; e < grid->hexes.size(); ++e) {
    ogive::Corners<double> corners;
    double mean = 0;
    int c = 0;
    for (const auto n : grid->hexes[e]) {
      corners.row(c++) = grid->positions[static_cast<std::size_t>(n)].cast<double>();
      mean -= velocity->values[3 * static_cast<std::size_t>(n) + 2] / 8.0;
    }
    const double m = density->values[e] * ogive::hex_volume(corners);
    mass += m;
    momentum += m * mean;
  }
  return momentum / mass;
}

/// "(a) 40 µs, 151 m/s".
std::string time_label(std::size_t number, const Frame &frame) {
  const auto velocity = projectile_velocity(frame);
  return options::printed("(%c) %.0f µs", static_cast<int>('a' + number % 26), frame.time * 1e6) +
         // A rebound is no "-0".
         (velocity ? options::printed(", %.0f m/s", std::round(*velocity) + 0.0) : "");
}

/// The z below which the share `below` of the positions within a radius of the axis lies, mm; 0 if there are none.
double low_mm(const std::vector<ogive::Vec3<float>> &positions, double radius_mm, double below) {
  std::vector<float> heights;
  for (const auto &x : positions)
    if (std::hypot(x[0], x[1]) <= 1e-3F * static_cast<float>(radius_mm)) heights.push_back(x[2]);
  if (heights.empty()) return 0;
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>(below * double(heights.size() - 1));
  std::nth_element(heights.begin(), place, heights.end());
  return 1e3 * double(*place);
}

/// From well above the front face down to below the projectile and the plug.
std::array<double, 3> usual_view(const std::vector<draw::PanelCell> &cells) {
  std::array<double, 3> view{-20, 22, 28};
  const auto extend = [&](const auto &parts, double below) {
    for (const auto &part : parts) view[0] = std::min(view[0], std::floor(low_mm(part.positions, view[2], below) - 4));
  };
  for (const auto &cell : cells) {
    extend(cell.frame.grids, 0);
    // A plug is a sixth of the disc; splinters are far less, and may have flown far ahead.
    extend(cell.frame.clouds, 0.01);
  }
  return view;
}

std::vector<draw::PanelCell> read_cells(const Options &o) {
  std::vector<draw::PanelCell> cells;
  for (const auto &given : o.series) {
    const auto series = ogive::read_series(find_pvd(given, "--series"));
    std::vector<std::size_t> numbers;
    for (const double time_us : o.times_us) numbers.push_back(frame_at(series, time_us));
    for (const std::size_t k : numbers) {
      const std::size_t n = cells.size();
      auto &cell = cells.emplace_back(draw::PanelCell{ogive::read_frame(series, k, symmetry_of(o)), ""});
      cell.label = o.label.empty() ? time_label(n, cell.frame) : o.label[n];
      if (o.label.empty() && o.series.size() > 1) cell.label.insert(4, folder_name(series.pvd) + ", ");
    }
  }
  return cells;
}

void draw_sections(const Options &o) {
  const auto cells = read_cells(o);
  const bool strain = o.colour == Colour::plastic_strain;
  const auto range = o.range.value_or(strain ? std::array{0.0, 1.5} : std::array{300.0, 900.0});
  const auto view = o.view_mm ? *o.view_mm : usual_view(cells);
  draw::SectionPanel panel{.title = o.title,
                           .bar_title = strain ? "plastic strain" : "temperature (K)",
                           .low_mm = view[0],
                           .high_mm = view[1],
                           .radius_mm = view[2],
                           .columns = o.columns.value_or(0)};
  panel.style.field = strain ? "plastic_strain" : "temperature_K";
  panel.style.smallest = range[0];
  panel.style.largest = range[1];
  panel.style.mesh_edges = o.mesh_edges;
  draw::render_panel(cells, o.out, panel);
}

void plot_velocities(const Options &o) {
  draw::VelocityPlot plot{o.title, {}, o.measured_mps};
  for (std::size_t k = 0; k < o.velocity.size(); ++k) {
    std::error_code ignored;
    const bool folder = fs::is_directory(o.velocity[k], ignored);
    const fs::path history = folder ? o.velocity[k] / "history.csv" : o.velocity[k];
    plot.curves.push_back({history, o.label.empty() ? folder_name(history) : o.label[k]});
  }
  draw::write_velocity_plot(plot, o.out);
}

/// A picture: the group of its options, the option that chooses it, and what draws it.
struct Figure {
  std::string group;
  const char *key;
  void (*draw)(const Options &o);
};
const std::vector<Figure> figures{
    {"Sections", "series", draw_sections},
    {"Velocity", "velocity", plot_velocities},
    {"Projectiles", "projectiles", [](const Options &o) { draw::render_projectiles(o.title, o.out); }},
    {"Mesh", "mesh", [](const Options &o) {
       draw::render_model(read_frame(ogive::read_series(find_pvd(o.mesh, "--mesh")), 0, symmetry_of(o)), o.title,
                          o.out);
     }}};

/// The picture that is meant; refuses options of others.
const Figure &figure_of(const Table &table, const Options &o, const options::CommandLine &line) {
  const std::array chosen{!o.series.empty(), !o.velocity.empty(), o.projectiles, !o.mesh.empty()};
  const auto count = std::count(chosen.begin(), chosen.end(), true);
  if (count != 1)
    throw ogive::SetupError("--series, --velocity, --projectiles, --mesh: " +
                            std::string(count == 0 ? "one is required" : "only one may be given") +
                            ": each draws another picture");
  const auto &figure =
      figures[static_cast<std::size_t>(std::find(chosen.begin(), chosen.end(), true) - chosen.begin())];
  for (const Given &given : line.given)
    for (const Figure &other : figures)
      if (find(table, given.key)->group == other.group && &other != &figure)
        throw ogive::SetupError(given.where + ": belongs to " + options::flag_of(other.key) + ", not to " +
                                options::flag_of(figure.key));
  return figure;
}

const options::Command command{
    .name = "ogive draw",
    .purpose = "Draws sections of results on one page, all at the same scale and with the same colours;\n"
               "or velocities against time; or the paper's projectiles; or the model before the shot.\n",
    .usage = "--series|--velocity|--mesh FOLDER... --out FILE.png [options]",
    .examples =
        "  ogive draw --series vtk_out/my_case --times-us 0,20,40,last --out sequence.png\n"
        "  ogive draw --series vtk_out/blunt vtk_out/conical --label \"(a) blunt\" \"(b) conical\" --out two.png\n"
        "  ogive draw --velocity vtk_out/blunt vtk_out/conical --out velocities.svg\n",
    .more = "Exit status: 0 done; 2 wrong input; 3 the picture could not be drawn or written; 1 anything else.\n"};

} // namespace

options::Table draw_table() { return unbound(table_of); }

int draw(const options::Arguments &arguments) {
  Options o;
  const Table table = table_of(o);
  const auto line = read_values(command, table, arguments, std::cout);
  if (!line) return options::success;
  const Figure &figure = figure_of(table, o, *line);
  check(o);
  figure.draw(o);
  return options::success;
}

} // namespace commands
