// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/checkpoint_file.hpp"

#include <string>
#include <string_view>

namespace fuzz {

/// The bytes of a checkpoint file whose sizes and checksums are right, whatever its notes and state are.
inline std::string sound_checkpoint(std::string_view notes, std::string_view state) {
  using namespace ogive::checkpoint_detail;
  Header header;
  header.scalar_bytes = sizeof(double);
  header.notes_size = notes.size();
  header.state_size = state.size();
  std::string file;
  Checksum sum;
  const auto add = [&](std::string_view bytes) { file += bytes, sum.add(bytes); };
  const auto add_sum = [&] {
    const std::uint64_t value = sum.value();
    add(bytes_of_value(value));
  };
  add(bytes_of_value(header)), add(notes), add_sum(), add(state), add_sum();
  return file;
}

} // namespace fuzz
