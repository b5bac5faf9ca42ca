// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/memory_file.hpp"
#include "fuzz/sound_checkpoint.hpp"
#include "fuzz/target.hpp"
#include "perforate/options.hpp"
#include "perforate/options_material.hpp"
#include "perforate/options_table.hpp"
#include "perforate/saved_case.hpp"

#include <array>
#include <sstream>

/// The notes of a checkpoint, from which a run that goes on has its case and its metal.
void fuzz::try_input(std::string_view bytes) {
  static MemoryFile file;
  file.write(sound_checkpoint(bytes, ""));
  const std::array arguments{"perforate", "--restart", file.path.c_str()};
  try {
    // What is no case with a metal ends here, before the slow command line.
    const perforate::SavedCase saved = perforate::read_saved_case(file.path);
    perforate::entries_of(saved.case_toml, "case");
    material_file::parse(saved.metal_toml, "metal");
    std::ostringstream ignored;
    plate_of(perforate::parse(static_cast<int>(arguments.size()), arguments.data(), ignored).value());
  } catch (const ogive::SetupError &) {
  }
}
