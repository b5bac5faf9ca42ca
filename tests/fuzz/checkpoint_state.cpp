// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/memory_file.hpp"
#include "fuzz/must.hpp"
#include "fuzz/sound_checkpoint.hpp"
#include "fuzz/struck_brick.hpp"
#include "fuzz/targets.hpp"

#include <algorithm>
#include <string>

namespace {

/// The state of the struck brick while it touches.
std::string good_state() {
  auto model = fuzz::struck_brick();
  ogive::RunState<double> run;
  fuzz::run_to(model, run, 13);
  fuzz::must(model.contacts[0].state.near.forces.at(0).facet >= 0, "the block touches the brick");
  model.times = {}; // would make an input mean another state in each run
  ogive::checkpoint_detail::StateWriter writer;
  const std::uint64_t print = fingerprint(model);
  writer.plain(print);
  for_each_state_field(model, run, writer);
  std::string state;
  for (const std::string_view piece : writer.pieces) state += piece;
  return state;
}

/// The state with edits: each two bytes for the place, one for the kind and up to eight that are put there. The place
/// counts from the first byte behind the fingerprint, so that inputs keep their meaning when that changes.
std::string edited(std::string state, std::string_view edits) {
  constexpr std::size_t print = sizeof(std::uint64_t);
  while (edits.size() > 3) {
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(edits[i])); };
    const std::size_t at = print + (256 * byte(0) + byte(1)) % (state.size() - print + 1), kind = byte(2);
    edits.remove_prefix(3);
    const std::string_view bytes = edits.substr(0, std::min<std::size_t>(edits.size(), 8));
    edits.remove_prefix(bytes.size());
    if (kind < 240)
      state.replace(at, std::min(bytes.size(), state.size() - at), bytes.substr(0, state.size() - at));
    else if (kind < 248)
      state.insert(at, bytes);
    else
      state.resize(at);
  }
  return state;
}

} // namespace

/// A checkpoint with a state that was edited and checksums that fit it: only the reader of the state can refuse it. One
/// that is taken is stepped on.
void fuzz::try_checkpoint_state(std::string_view bytes) {
  static MemoryFile file;
  static const auto reference = struck_brick();
  static const std::string good = good_state();
  file.write(sound_checkpoint("", edited(good, bytes)));
  auto model = reference;
  ogive::RunState<double> state;
  try {
    restore(ogive::read_checkpoint(file.path), model, state);
  } catch (const ogive::SetupError &) {
    must(model.steps == 0, "a state that is refused changes nothing");
    return;
  }
  run_to(model, state, model.steps + 1);
}
