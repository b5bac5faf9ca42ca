// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/memory_file.hpp"
#include "fuzz/struck_brick.hpp"
#include "fuzz/targets.hpp"
#include "shot/saved_case.hpp"

/// A checkpoint file as it is: almost all damage ends at its checksums.
void fuzz::try_checkpoint_file(std::string_view bytes) {
  static MemoryFile file;
  static const auto reference = struck_brick();
  file.write(bytes);
  try {
    shot::read_saved_case(file.path);
  } catch (const ogive::SetupError &) {
  }
  try {
    const ogive::Checkpoint checkpoint = ogive::read_checkpoint(file.path);
    auto model = reference;
    ogive::RunState<double> state;
    restore(checkpoint, model, state);
  } catch (const ogive::SetupError &) {
  }
}
