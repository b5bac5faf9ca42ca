// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "options/text.hpp"
#include "shot/table.hpp"
#include "shot/title.hpp"
#include "study/row.hpp"

#include <nlohmann/json.hpp>

namespace commands {

namespace fs = std::filesystem;
using options::refuse;

std::string folder_name(const fs::path &file) {
  return fs::absolute(file).lexically_normal().parent_path().filename().string();
}

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

void add_extent(options::Table &table, std::optional<ogive::Extent> &extent) {
  const options::Entry entry{.key = "extent",
                             .meaning = "computed part of the model, for results whose files lack it: quarter, half "
                                        "or full",
                             .allowed = "one of quarter, half, full"};
  add_option(table, entry, options::Kind::choice, "NAME").assign = [&extent](const options::Given &given) {
    extent = choice_given(given, choices(ogive::Extent{}));
  };
}

std::optional<ogive::SymmetryPlanes> symmetry_of(const std::optional<ogive::Extent> &extent) {
  return extent ? std::optional(ogive::symmetry_planes(*extent)) : std::nullopt;
}

std::string case_title(const fs::path &folder) {
  try {
    return shot::title_of(study::read_summary(folder));
  } catch (const std::exception &) {
    return folder_name(folder / "file");
  }
}

draw::Motion motion_of(const fs::path &folder) {
  const auto file = folder / "history.csv";
  std::error_code none;
  draw::Motion motion;
  if (!fs::exists(file, none)) return motion;
  motion.history = draw::read_history(file);
  try {
    motion.part = study::read_summary(folder).value("followed_part", "");
  } catch (const std::exception &) {
    // A run that was interrupted has no summary.
  }
  return motion;
}

} // namespace commands
