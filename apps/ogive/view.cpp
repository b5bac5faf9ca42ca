// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"
#include "options/text.hpp"
#include "results.hpp"
#include "view/page.hpp"

#include "ogive/io/atomic_file.hpp"

#include <iostream>

namespace commands {

namespace {

namespace fs = std::filesystem;

/// One page.
struct ViewOptions {
  std::vector<fs::path> result; ///< a folder with a .pvd file, or that file; exactly one
  fs::path out;
  std::string title;
  std::string fields; ///< names with commas between them; empty: the default ones
  int frames = 20;
  std::optional<ogive::Extent> extent;
  fs::path three_js = "/usr/share/javascript/three";
};

// clang-format off
options::Table table_of(ViewOptions &o) {
  options::Table t;
  add(t, o.result, {.key = "result", .meaning = "result of ogive shoot or mesh", .brief = "result of ogive shoot or mesh",
      .allowed = "a folder with a .pvd file, or a .pvd file", .in_file = false}).placeholder = "FOLDER|FILE.pvd";
  add(t, o.out, {.key = "out", .meaning = "file of the page", .source = "view.html beside the result: ours",
      .brief = "file of the page"}).placeholder = "FILE.html";
  add(t, o.title, {.key = "title", .meaning = "title above the page", .source = "the case, or the folder's name: ours",
      .brief = "title above the page"});
  add(t, o.frames, {.key = "frames",
      .meaning = "largest number of frames; of a longer series evenly spaced ones are taken",
      .source = "ours", .brief = "largest number of frames in the page", .limits = {1, 1000}});
  add(t, o.fields, {.key = "fields", .meaning = "fields to choose from; speed_m_per_s is the magnitude of the velocity",
      .source = "plastic_strain, temperature_K, von_mises_MPa, pressure_MPa, damage, speed_m_per_s: ours",
      .brief = "fields to choose from"}).placeholder = "NAME,NAME,...";
  add_extent(t, o.extent);
  add(t, o.three_js, {.key = "three_js",
      .meaning = "folder of three.js with three.min.js and examples/js/controls/OrbitControls.js",
      .source = "/usr/share/javascript/three: Debian's libjs-three"}).placeholder = "FOLDER";
  return t;
}
// clang-format on

} // namespace

options::Table view_table() { return unbound(table_of); }

int view(const options::Arguments &arguments) {
  ViewOptions o;
  const options::Table table = table_of(o);
  const options::Command command{
      .name = "ogive view",
      .purpose = "Writes a result as one interactive HTML file that any browser opens from disk: the model in three\n"
                 "dimensions with its fields, cut and time, and the velocity. It needs no network.\n",
      .usage = "RESULT [--out FILE.html] [options]",
      .examples = "  ogive view vtk_out/my_case\n"
                  "  ogive view vtk_out/my_case --fields plastic_strain,temperature_K --frames 40 --out strain.html\n",
      .more = "Exit status: 0 done; 2 wrong input; 3 the page could not be written; 1 anything else.\n",
      .positional = "result"};
  if (!read_values(command, table, arguments, std::cout)) return options::only_printed;
  if (o.result.size() != 1)
    throw ogive::SetupError("RESULT: one is required: a folder with a .pvd file, or a .pvd file");
  const auto pvd = find_pvd(o.result.front(), "RESULT");
  const auto folder = pvd.parent_path();
  if (o.out.empty()) o.out = folder / "view.html";
  if (o.out.extension() != ".html") options::refuse("--out", o.out.string(), "must be the name of a .html file");
  ::view::Result result{.title = o.title.empty() ? case_title(folder) : o.title,
                        .series = ogive::read_series(pvd),
                        .symmetry = symmetry_of(o.extent),
                        .fields = o.fields.empty() ? std::vector<std::string>{} : options::split(o.fields, ','),
                        .most_frames = o.frames,
                        .velocity = {}};
  std::error_code ignored;
  if (fs::exists(folder / "history.csv", ignored)) result.velocity = ::view::read_velocity(folder / "history.csv");
  const std::string html = ::view::page(result, o.three_js);
  ogive::write_atomically(o.out, html);
  std::printf("%s: %.1f MB\n", o.out.c_str(), static_cast<double>(html.size()) * 1e-6);
  return options::success;
}

} // namespace commands
