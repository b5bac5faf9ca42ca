// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/perforation/plug.hpp"

#include <omp.h>

using namespace sim_test;

TEST_CASE("a shot has the same bits with any number of threads", "[sim]") {
  const auto hash_with = [](int threads) {
    omp_set_num_threads(threads);
    auto model = small_shot(small_case(Nose::conical, Extent::quarter));
    for (int i = 0; i < 80; ++i) {
      step(model, stable_time_step(model));
    }
    return std::pair(state_hash(model), total(energy(model)));
  };
  const int before = omp_get_max_threads();
  const auto one = hash_with(1), two = hash_with(2), three = hash_with(3);
  omp_set_num_threads(before);
  CHECK(one == two);
  CHECK(one == three);
}

TEST_CASE("a shot with all features has the same bits with any number of threads, again and across a restart",
          "[sim]") {
  const TemporaryFolder folder;
  const auto go_on = [](const auto &, const auto &) { return true; };
  const RunOptions<double> options{.end_time = 12e-6};
  const auto make = [] { return full_shot(FailureEffect::removal, false); };
  const auto hash_with = [&](int threads, bool restart) {
    omp_set_num_threads(threads);
    auto model = make();
    RunState<double> state;
    const auto saved = [&](const auto &m, const auto &s) {
      if (m.steps == 37) write_checkpoint(folder.path / "c", m, s);
      return restart && m.steps == 37;
    };
    run(model, options, state, go_on, saved);
    if (restart) {
      model = make();
      omp_set_num_threads(5 - threads);
      restore(read_checkpoint(folder.path / "c"), model, state);
      run(model, options, state, go_on, [](const auto &, const auto &) { return false; });
    }
    REQUIRE(model.time >= options.end_time);
    const auto f = find_fragments(model);
    REQUIRE(f.failed > 3);
    return std::tuple(state_hash(model), total(energy(model)), f.plug_mass, model.support_impulse[2], model.steps);
  };
  const int before = omp_get_max_threads();
  const auto one = hash_with(1, false);
  for (const int threads : {1, 2, 3, 4, 8}) CHECK(hash_with(threads, false) == one);
  for (const int threads : {1, 3}) CHECK(hash_with(threads, true) == one);
  omp_set_num_threads(before);
}

TEST_CASE("the hash sees the last bit of the state", "[sim]") {
  auto model = small_shot(small_case(Nose::blunt, Extent::quarter));
  const auto hash = state_hash(model);
  CHECK(state_hash(small_shot(small_case(Nose::blunt, Extent::quarter))) == hash);
  double &x = model.nodes.position[17][1], before = x;
  x = std::nextafter(x, 1.0);
  CHECK(state_hash(model) != hash);
  x = before;
  CHECK(state_hash(model) == hash);
  plate_particles(model).points.temperature[3] += 1e-12 * 293;
  CHECK(state_hash(model) != hash);
}
