#include "catch.hpp"
#include "sim/small_shot.hpp"

#include "ogive/sim/step.hpp"

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

TEST_CASE("the hash sees the last bit of the state", "[sim]") {
  auto model = small_shot(small_case(Nose::blunt, Extent::quarter));
  const auto hash = state_hash(model);
  CHECK(state_hash(small_shot(small_case(Nose::blunt, Extent::quarter))) == hash);
  double &x = model.nodes.position[17][1], before = x;
  x = std::nextafter(x, 1.0);
  CHECK(state_hash(model) != hash);
  x = before;
  CHECK(state_hash(model) == hash);
  disc(model).points.temperature[3] += 1e-12 * 293;
  CHECK(state_hash(model) != hash);
}
