// SPDX-License-Identifier: BSD-3-Clause
#include "../commands.hpp"

#include "../results.hpp"
#include "compare.hpp"
#include "draw/model.hpp"
#include "draw/plot.hpp"
#include "draw/projectiles.hpp"
#include "options/exit_status.hpp"
#include "sections.hpp"

#include "ogive/io/read_frame.hpp"

#include <iostream>

namespace commands {

namespace {

using namespace drawing;
using options::Given;
using options::Table;

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
    {"Sections", "series", [](const Options &o) { o.animate.empty() ? draw_sections(o) : draw_film(o); }},
    {"Velocity", "velocity", plot_velocities},
    {"Comparison", "compare", compare},
    {"Projectiles", "projectiles", [](const Options &o) { draw::render_projectiles(o.title, o.out); }},
    {"Mesh", "mesh", [](const Options &o) {
       draw::render_model(read_frame(ogive::read_series(find_pvd(o.mesh, "--mesh")), 0, symmetry_of(o.extent)), o.title,
                          o.out);
     }}};

/// The picture that is meant; refuses options of others.
const Figure &figure_of(const Table &table, const Options &o, const options::CommandLine &line) {
  const std::array chosen{!o.series.empty(), !o.velocity.empty(), !o.compare.empty(), o.projectiles, !o.mesh.empty()};
  const auto count = std::count(chosen.begin(), chosen.end(), true);
  if (count != 1)
    throw ogive::SetupError("--series, --velocity, --compare, --projectiles, --mesh: " +
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
               "or velocities against time; or two results beside each other; or the paper's projectiles; or "
               "the\nmodel before the shot.\n",
    .usage = "--series|--velocity|--compare|--mesh FOLDER... --out FILE.png [options]",
    .examples =
        "  ogive draw --series vtk_out/my_case --times-us 0,20,40,last --out sequence.png\n"
        "  ogive draw --series vtk_out/blunt vtk_out/conical --label \"(a) blunt\" \"(b) conical\" --out two.png\n"
        "  ogive draw --series vtk_out/my_case --animate my_case.mp4\n"
        "  ogive draw --compare vtk_out/coarse vtk_out/fine --out coarse_or_fine\n"
        "  ogive draw --velocity vtk_out/blunt vtk_out/conical --out velocities.svg\n",
    .more = "Exit status: 0 done; 2 wrong input; 3 the picture could not be drawn or written; 1 anything else.\n"};

} // namespace

options::Table draw_table() { return unbound(drawing::table_of); }

int draw(const options::Arguments &arguments) {
  Options o;
  const Table table = table_of(o);
  const auto line = read_values(command, table, arguments, std::cout);
  if (!line) return options::only_printed;
  const Figure &figure = figure_of(table, o, *line);
  check(o);
  figure.draw(o);
  return options::success;
}

} // namespace commands
