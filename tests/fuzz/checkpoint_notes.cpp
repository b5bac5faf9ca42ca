// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/memory_file.hpp"
#include "fuzz/sound_checkpoint.hpp"
#include "fuzz/targets.hpp"
#include "options/toml_file.hpp"
#include "shot/plates.hpp"
#include "shot/resume.hpp"
#include "shot/saved_case.hpp"
#include "shot/table.hpp"

/// The notes of a checkpoint, from which a run that resumes has its case and its metal.
void fuzz::try_checkpoint_notes(std::string_view bytes) {
  static MemoryFile file;
  file.write(sound_checkpoint(bytes, ""));
  try {
    // What is no case with a metal ends here, before the slow table.
    const shot::SavedCase saved = shot::read_saved_case(file.path);
    options::toml_entries(saved.case_toml, "case", shot::toml_example);
    materials::parse(saved.metal_toml, "metal");
    shot::plates_of(shot::restarted(file.path, {}));
  } catch (const ogive::SetupError &) {
  }
}
