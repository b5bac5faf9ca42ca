// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/checkpoint.hpp"

#include "io/temporary_folder.hpp"
#include "sim/blocks.hpp"

#include "ogive/mesh/facets.hpp"

#include "catch.hpp"

#include <random>

using namespace ogive;
using sim_test::brick_at;
using sim_test::lattice;
using sim_test::V;

namespace {

constexpr double spacing = 1e-3;

/// A few particles that strike a brick, after `steps` steps.
template <class T = double> auto small_model(double friction = 0.1, T young = T(200e9)) {
  Nodes<T> nodes;
  auto steel = fem_test::steel<T>();
  steel.elasticity.young = young;
  HexMesh<T> mesh;
  for (const V &x : brick_at(3, 3, 2, V(3e-3, 3e-3, 2e-3), V(-1.5e-3, -1.5e-3, -2e-3)).positions)
    mesh.positions.push_back(x.template cast<T>());
  mesh.hexes = brick_at(3, 3, 2, V(3e-3, 3e-3, 2e-3), V(-1.5e-3, -1.5e-3, -2e-3)).hexes;
  auto target = add_hex_body(nodes, mesh, steel, "target");
  ParticleLayout<T> layout{T(spacing), {}, {}};
  for (const V &x : lattice(3, 3, 2, spacing, V(-1.5e-3, -1.5e-3, 0.05e-3)).positions) {
    layout.positions.push_back(x.template cast<T>());
    layout.volumes.push_back(T(1e-9));
  }
  auto block = add_sph_body(nodes, layout, steel, "block");
  set_velocity<T>(nodes, block.nodes, Vec3<T>(T(20), T(0), T(-100)));
  std::vector<Index> slaves;
  for (Index n = block.nodes.begin; n < block.nodes.end; ++n) slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<T>(slaves.size(), T(0.5 * spacing)), boundary_facets(mesh),
                              "contact", ContactOptions<T>{.friction = T(friction)});
  Model model{std::move(nodes), std::tuple(std::move(target), std::move(block)), SymmetryPlanes{}};
  model.contacts.push_back(std::move(contact));
  return model;
}

template <class M, class T> void run_steps(M &model, RunState<T> &state, std::int64_t steps) {
  run(
      model, RunOptions<T>{.end_time = T(1)}, state, [](const auto &, const auto &) { return true; },
      [&](const auto &m, const auto &) { return m.steps == steps; });
}

/// All bytes of the state.
template <class M, class R> std::string state_of(const M &model, const R &run) {
  checkpoint_detail::StateWriter writer;
  for_each_state_field(model, run, writer);
  std::string bytes;
  for (const auto piece : writer.pieces) bytes += piece;
  return bytes;
}

/// The line that `f()` is refused with; empty if it is not.
template <class F> std::string refusal(F &&f) {
  try {
    f();
  } catch (const SetupError &error) {
    std::string line = error.what();
    CHECK(line.starts_with("checkpoint = "));
    CHECK(line.find('\n') == std::string::npos);
    return line;
  }
  return "";
}

struct Saved {
  TemporaryFolder folder;
  std::filesystem::path path = folder.path / "checkpoint.bin";
  std::string bytes;

  explicit Saved(std::int64_t steps = 13) {
    auto model = small_model();
    RunState<double> state;
    run_steps(model, state, steps);
    write_checkpoint(path, model, state, "notes of a program");
    bytes = read_text(path);
  }
  std::string refusal_of(const std::string &other) const {
    write_atomically(path, other);
    return refusal([&] { read_checkpoint(path); });
  }
};

} // namespace

TEST_CASE("a checkpoint with a contact on a facet that is not there is refused") {
  const TemporaryFolder folder;
  auto model = small_model();
  auto &contact = model.contacts[0];
  RunState<double> state;
  run_steps(model, state, 5);
  contact.state.near.forces.at(0).facet = static_cast<Index>(contact.facets.size());
  write_checkpoint(folder.path / "checkpoint.bin", model, state);
  auto other = small_model();
  CHECK(refusal([&] {
          restore(read_checkpoint(folder.path / "checkpoint.bin"), other, state);
        }).find("is damaged: contact facet has impossible values") != std::string::npos);
}

TEST_CASE("a checkpoint puts a model where it was, and leaves no other file") {
  Saved saved;
  auto model = small_model(), restored = small_model();
  RunState<double> state, restored_state;
  run_steps(model, state, 13);
  restore(read_checkpoint(saved.path), restored, restored_state);
  CHECK(restored_state.observed_at == state.observed_at);
  restored.times = model.times;
  CHECK(state_of(restored, restored_state) == state_of(model, state));
  CHECK(read_checkpoint_notes(saved.path) == "notes of a program");
  CHECK(count_files(saved.folder.path) == 1);
  run_steps(model, state, 60), run_steps(restored, restored_state, 60);
  CHECK(state_hash(model) == state_hash(restored));
  CHECK(total(energy(model)) == total(energy(restored)));
  CHECK(energy(model).contact != 0);
}

TEST_CASE("a checkpoint of a model that has not begun, and one in single precision") {
  const TemporaryFolder folder;
  auto model = small_model<float>(0.1, 200e9F), restored = model;
  RunState<float> state, restored_state;
  write_checkpoint(folder.path / "c", model, state);
  restore(read_checkpoint(folder.path / "c"), restored, restored_state);
  run_steps(model, state, 25);
  write_checkpoint(folder.path / "c", model, state);
  restore(read_checkpoint(folder.path / "c"), restored, restored_state);
  run_steps(model, state, 50), run_steps(restored, restored_state, 50);
  CHECK(state_hash(model) == state_hash(restored));

  auto other = small_model();
  RunState<double> other_state;
  CHECK_THAT(refusal([&] { restore(read_checkpoint(folder.path / "c"), other, other_state); }),
             Catch::Contains("has numbers of 4 bytes, the model of 8"));
}

TEST_CASE("a damaged checkpoint is refused wherever the damage is") {
  const Saved saved;
  const std::string &whole = saved.bytes;
  const auto step = std::max<std::size_t>(1, whole.size() / 997);
  for (std::size_t at = 0; at < whole.size(); at += at < 300 ? 1 : step)
    for (const int bit : {0, 7}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      INFO("byte " << at);
      CHECK_FALSE(saved.refusal_of(damaged).empty());
    }
  std::string swapped = whole;
  std::swap_ranges(swapped.begin() + 1000, swapped.begin() + 1100, swapped.begin() + 2000);
  CHECK_THAT(saved.refusal_of(swapped), Catch::Contains("is damaged: its checksum is wrong"));
  CHECK_THAT(saved.refusal_of(std::string(whole.size(), '\0')), Catch::Contains("is not a checkpoint of ogive"));
}

TEST_CASE("a checkpoint that is cut short or too long is refused") {
  const Saved saved;
  const std::string &whole = saved.bytes;
  const auto step = std::max<std::size_t>(1, whole.size() / 97);
  for (std::size_t size = 0; size < whole.size(); size += size < 120 ? 1 : step) {
    INFO(size << " bytes");
    CHECK_FALSE(saved.refusal_of(whole.substr(0, size)).empty());
  }
  CHECK_THAT(saved.refusal_of(""), Catch::Contains("is not a checkpoint of ogive"));
  CHECK_THAT(saved.refusal_of(whole.substr(0, 5)), Catch::Contains("is cut short or damaged: it has 5 bytes"));
  CHECK_THAT(saved.refusal_of(whole.substr(0, whole.size() - 1)), Catch::Contains("is cut short or damaged"));
  CHECK_THAT(saved.refusal_of(whole + "x"), Catch::Contains("is cut short or damaged"));
  CHECK(saved.refusal_of(whole).empty());
}

TEST_CASE("foreign files and formats are refused with what is wrong") {
  const Saved saved;
  const auto with = [&](std::size_t at, const std::string &bytes) {
    std::string other = saved.bytes;
    return saved.refusal_of(other.replace(at, bytes.size(), bytes));
  };
  CHECK_THAT(saved.refusal_of("time_us,velocity_m_per_s\n0,303.5\n"), Catch::Contains("is not a checkpoint of ogive"));
  CHECK_THAT(with(8, "\x01\x02\x03\x04"), Catch::Contains("was written by a machine with another order of bytes"));
  CHECK_THAT(with(12, std::string("\x02\0\0\0", 4)), Catch::Contains("has the format 2, this program reads format 1"));
  // Sizes from nowhere: nothing of that size may be allocated.
  for (const std::size_t at : {24, 32}) {
    CHECK_THAT(with(at, std::string(8, '\xff')), Catch::Contains("is cut short or damaged"));
    CHECK_THAT(with(at, std::string("\0\0\0\0\0\0\0\x80", 8)), Catch::Contains("is cut short or damaged"));
  }
  CHECK_THAT(refusal([&] { read_checkpoint(saved.folder.path / "missing"); }),
             Catch::Contains("must be a file that can be read: No such file or directory"));
  CHECK_THAT(refusal([&] { read_checkpoint(saved.folder.path); }), Catch::Contains("must be a regular file"));
  CHECK_THAT(refusal([&] { read_checkpoint("/dev/zero"); }), Catch::Contains("must be a regular file"));
}

TEST_CASE("another model refuses a checkpoint and stays as it was") {
  const Saved saved;
  const auto refused = [&](auto model, const std::string &reason) {
    RunState<double> state;
    const std::string before = state_of(model, state);
    CHECK_THAT(refusal([&] { restore(read_checkpoint(saved.path), model, state); }), Catch::Contains(reason));
    CHECK(state_of(model, state) == before);
  };
  const std::string other = "is of another model";
  refused(small_model(0.2), other);
  refused(small_model(0.1, 210e9), other);
  const auto changed = [&](auto change) {
    auto model = small_model();
    change(model);
    refused(std::move(model), other);
  };
  changed([](auto &m) { m.nodes.held[3] = held_x; });
  changed([](auto &m) { std::get<0>(m.bodies).metal.flow.yield *= 1.001; });
  changed([](auto &m) { std::get<1>(m.bodies).metal.damage.effect = FailureEffect::removal; });
  changed([](auto &m) { std::get<1>(m.bodies).options.courant = 0.4; });
  changed([](auto &m) { std::get<1>(m.bodies).name = "other"; });
  changed([](auto &m) { std::swap(std::get<0>(m.bodies).hexes[0], std::get<0>(m.bodies).hexes[1]); });
  changed([](auto &m) { m.contacts[0].offset[2] *= 1.001; });
  changed([](auto &m) { m.contacts.clear(); });
  changed([](auto &m) { m.rigid_parts.push_back({std::get<0>(m.bodies).nodes}); });
  changed([](auto &m) { m.symmetry.x = true; });
}

TEST_CASE("the last bits of constants make no other model") {
  const Saved saved;
  auto model = small_model();
  RunState<double> state;
  auto &mass = std::get<0>(model.bodies).point_mass;
  for (double &m : mass) m *= 1 + 4e-16;
  CHECK(refusal([&] { restore(read_checkpoint(saved.path), model, state); }).empty());
}

TEST_CASE("whatever the state of a checkpoint says, it is refused or read, within its bounds") {
  const Saved saved;
  const Checkpoint good = read_checkpoint(saved.path);
  std::mt19937 random(7);
  const auto any = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto reference = small_model();
  int refused = 0, read = 0;
  for (int k = 0; k < 3000; ++k) {
    Checkpoint bad = good;
    if (k % 3 == 0) { // a size, a NaN, an infinity or an index, somewhere
      const std::array<std::uint64_t, 6> words{
          ~0ULL, 0, 1ULL << 40, 0x7ff8000000000000, 0x7ff0000000000000, 0x7fefffffffffffff};
      const std::size_t at = 8 + any((bad.state.size() - 16) / 4) * 4;
      std::memcpy(bad.state.data() + at, &words[any(words.size())], 8);
    } else if (k % 3 == 1) {
      for (int n = 0; n < 4; ++n) bad.state[8 + any(bad.state.size() - 8)] = static_cast<char>(random());
    } else {
      bad.state.resize(any(bad.state.size()));
    }
    auto model = reference;
    RunState<double> state;
    const bool is_refused = !refusal([&] { restore(bad, model, state); }).empty();
    ++(is_refused ? refused : read);
    if (is_refused) CHECK(model.steps == 0);
  }
  CHECK(refused > 1000);
  CHECK(read > 500);
  Checkpoint longer = good;
  longer.state += "12345678";
  auto model = reference;
  RunState<double> state;
  CHECK_THAT(refusal([&] { restore(longer, model, state); }), Catch::Contains("is damaged: it has bytes left over"));
}

TEST_CASE("a disk that is full leaves the old checkpoint") {
  Saved saved;
  auto model = small_model();
  RunState<double> state;
  run_steps(model, state, 30);
  {
    const FullDisk full(2000);
    CHECK_THROWS_WITH(write_checkpoint(saved.path, model, state),
                      "cannot write " + saved.path.string() + ": File too large");
  }
  CHECK(read_text(saved.path) == saved.bytes);
  CHECK(count_files(saved.folder.path) == 1);
}
