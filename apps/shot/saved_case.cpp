// SPDX-License-Identifier: BSD-3-Clause
#include "saved_case.hpp"

#include "ogive/io/archive.hpp"
#include "ogive/io/checkpoint_file.hpp"

#include <cmath>

namespace shot {

SavedCase read_saved_case(const std::filesystem::path &file) {
  const std::string notes = ogive::read_checkpoint_notes(file),
                    name = "checkpoint = " + ogive::printable(file.string());
  const auto foreign = [&]() { return ogive::SetupError(name + ": was not written by ogive shoot"); };
  SavedCase saved;
  try {
    ogive::ArchiveReader{notes, name}(saved);
  } catch (const ogive::SetupError &) {
    throw foreign();
  }
  if (saved.program != "ogive shoot" || !std::isfinite(saved.time_us)) throw foreign();
  return saved;
}

} // namespace shot
