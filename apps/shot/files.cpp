// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include "materials/library.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"
#include "parts.hpp"
#include "saved_case.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sys/types.h>
#include <system_error>

namespace shot {

namespace {

namespace fs = std::filesystem;

/// Name of the file of the metal of a projectile of one part, and of parts without one of their own.
constexpr char projectile_metal_name[] = "projectile_metal.toml";

/// Names of the files of the metals: one, or one for each plate.
std::vector<std::string> material_names(const Options &o) {
  std::vector<std::string> names;
  for (std::size_t k = 1; k <= o.layer_materials.size(); ++k)
    names.push_back("material_" + std::to_string(k) + ".toml");
  return names.empty() ? std::vector<std::string>{"material.toml"} : names;
}

const std::vector<std::string> history_columns{
    "time_us",      "velocity_m_per_s",    "nose_depth_mm", "tail_depth_mm",  "kinetic_J",  "elastic_J",
    "plastic_J",    "hourglass_J",         "viscous_J",     "contact_J",      "friction_J", "total_J",
    "momentum_N_s", "support_impulse_N_s", "speed_m_per_s", "deflection_deg", "turn_deg",   "spin_rad_per_s"};

/// Removes the halves of files that a run left when it was killed while it wrote them: those with the number of a
/// process that is no more.
void remove_leftovers(const fs::path &folder) {
  std::error_code ignored;
  std::vector<fs::path> leftovers;
  for (const auto &entry : fs::directory_iterator(folder, ignored)) {
    const fs::path name = entry.path().filename();
    // <name>.<process>.part
    const std::string process = name.stem().extension().string();
    if (name.extension() != ".part" || process.size() < 2 || process.size() > 10 ||
        process.find_first_not_of("0123456789", 1) != std::string::npos)
      continue;
    if (::kill(static_cast<pid_t>(std::stol(process.substr(1))), 0) != 0 && errno == ESRCH)
      leftovers.push_back(entry.path());
  }
  for (const fs::path &path : leftovers) fs::remove(path, ignored);
}

/// Writes a metal of a run into its folder, unless it is read from there.
void write_metal(const fs::path &copy, const materials::AnyMetal &metal, const std::string &material,
                 const std::string &of, const std::string &option) {
  std::error_code missing;
  if (materials::is_material_file(material) && fs::equivalent(copy, material, missing)) return;
  ogive::write_atomically(copy,
                          materials::to_toml(metal, "The metal of the " + of + " in a run of ogive " +
                                                        std::string(ogive::version) + ", from " + material +
                                                        ".\nA copy with other numbers is a metal for " + option + "."));
}

} // namespace

bool is_in_place(const Options &o) {
  if (!o.restart) return false;
  std::error_code ignored;
  const fs::path folder = o.restart->file.parent_path();
  return fs::equivalent(o.out, folder.empty() ? "." : folder, ignored);
}

std::string case_text(const Options &options) {
  Options o = options;
  // All that the file of a projectile or a profile gives is written; its name counts from elsewhere.
  if (materials::is_material_file(o.projectile)) o.projectile.clear();
  o.profile = std::filesystem::path(o.profile).filename().string();
  const auto parts = parts_of(o), part_files = part_metal_files(o);
  for (std::string &entry : o.part_metals) {
    const PartMetal part = part_metal_of(entry);
    const auto k = static_cast<std::size_t>(std::find(parts.begin(), parts.end(), part.part) - parts.begin());
    if (materials::is_material_file(part.metal) && k < parts.size()) entry = entry_of({part.part, part_files[k]});
  }
  if (!o.projectile_mesh.empty()) o.projectile_mesh = mesh_copy_name(o.projectile_mesh);
  if (materials::is_material_file(o.projectile_metal)) o.projectile_metal = projectile_metal_name;
  // Counts from the folder of case.toml, so that the folder may move.
  const auto names = material_names(o);
  if (materials::is_material_file(o.material)) o.material = names.front();
  for (std::size_t k = 0; k < o.layer_materials.size(); ++k)
    if (materials::is_material_file(o.layer_materials[k])) o.layer_materials[k] = names[k];
  return to_toml(o);
}

void start_results(const Options &o, const Plates &plates) {
  std::error_code ignored;
  remove_leftovers(o.out), remove_leftovers(o.out / "frames");
  for (const char *name : {"summary.json", "section.png", "velocity.svg"}) fs::remove(o.out / name, ignored);
  if (!o.restart) fs::remove(o.out / "history.csv", ignored);
  if (!is_in_place(o) && fs::exists(o.out / checkpoint_name, ignored))
    fs::rename(o.out / checkpoint_name, o.out / earlier_checkpoint_name, ignored);
  const auto names = material_names(o);
  for (std::size_t k = 0; k < names.size(); ++k)
    write_metal(o.out / names[k], plates[k], materials_of(o)[k], "plate", "--material");
  const auto names_of_parts = parts_of(o), part_names = part_materials(o), part_files = part_metal_files(o);
  const Plates part_metals = projectile_metals_of(o);
  for (std::size_t k = 0; k < part_names.size(); ++k) {
    if (!materials::is_material_file(part_names[k])) continue;
    const bool has_own = std::any_of(o.part_metals.begin(), o.part_metals.end(), [&](const std::string &entry) {
      return part_metal_of(entry).part == names_of_parts[k];
    });
    write_metal(o.out / (has_own ? part_files[k] : projectile_metal_name), part_metals[k], part_names[k], "projectile",
                "--projectile-metal");
  }
  if (o.own_mesh.read) ogive::write_atomically(o.out / mesh_copy_name(o.projectile_mesh), o.own_mesh.read->bytes);
  ogive::write_atomically(o.out / "case.toml", case_text(o));
}

Files open_files(const Options &o, const Course &course) {
  constexpr char name[] = "perforation";
  Files files{ogive::continue_csv(o.out / "history.csv", history_columns, course.history), {}};
  if (!is_in_place(o)) {
    files.series = ogive::open_series(o.out, name);
  } else if (o.vtk) {
    std::vector<ogive::VtkSeriesEntry> entries;
    for (const FrameFile &f : course.frame_files) entries.push_back({f.time, f.part, f.part_name, f.file});
    files.series = ogive::resume_series(o.out, name, course.frames, entries);
  }
  return files;
}

void add_frame(Files &files, Course &course, const ogive::Frame &frame) {
  ogive::add_frame(files.series, frame);
  course.frames = files.series.frames;
  course.frame_files.clear();
  for (const auto &e : files.series.entries) course.frame_files.push_back({e.time, e.part, e.part_name, e.file});
}

void read_notes(const ogive::Checkpoint &checkpoint, Result &shot, Course &course) {
  ogive::ArchiveReader reader{checkpoint.notes, "checkpoint = " + ogive::printable(checkpoint.file)};
  SavedCase saved;
  reader(saved), reader(shot), reader(course);
  const bool possible = reader.rest.empty() && course.history.size() % history_columns.size() == 0 &&
                        !shot.flight.samples.empty() && course.frames >= 0 &&
                        shot.flight.state <= ogive::FlightState::stopped &&
                        shot.flight.state >= ogive::FlightState::in_progress && std::isfinite(course.next_frame_us);
  if (!possible) ogive::refuse_checkpoint(checkpoint.file, "is damaged: its notes have impossible values");
}

std::string notes_of(const Options &o, const Plates &plates, Result &shot, Course &course, double time_us) {
  ogive::ArchiveWriter notes;
  notes(SavedCase{"ogive shoot", ogive::version, to_complete_toml(o), metals_text(o, plates), time_us});
  notes(shot), notes(course);
  return notes.bytes;
}

} // namespace shot
