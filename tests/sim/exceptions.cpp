// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "sim/blocks.hpp"

#include "ogive/io/csv.hpp"

#include <algorithm>
#include <new>
#include <omp.h>
#include <stdexcept>
#include <string>

using namespace sim_test;

namespace faulty {

struct Broken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A law that throws where the metal has flowed.
template <class T> struct Law {
  T yield{};
  bool out_of_memory = false;
};

template <class T> FlowStress<T> flow_stress(const Law<T> &law, T plastic_strain, T, T) {
  if (plastic_strain > T(1e-3) && law.out_of_memory) throw std::bad_alloc();
  if (plastic_strain > T(1e-3)) throw Broken("this law ends at a plastic strain of 0.001");
  return {law.yield, T(0), T(0), T(0)};
}

/// A kernel that throws between near particles.
struct Kernel : CubicSpline {
  template <class N> static N slope_over_u(N u, N inverse_u) {
    if (armed) throw Broken("this kernel is not for near particles");
    return CubicSpline::slope_over_u(u, inverse_u);
  }
  static inline bool armed = false;
};

} // namespace faulty

namespace {

/// A block of many more particles than a thread takes at a time, and of hexes, squeezed to both of its sides.
template <class K = CubicSpline> auto squeezed(const faulty::Law<double> &law) {
  Metal<double, faulty::Law<double>> metal;
  metal.name = "faulty";
  metal.density = 7850;
  metal.elasticity = {200e9, 0.33};
  metal.flow = law;
  Nodes<double> nodes;
  auto particles = add_sph_body(nodes, lattice(14, 14, 14, 1e-3), metal, "particles", {}, SphOptions<double>{}, K{});
  auto hexes = add_hex_body(nodes, brick_at(8, 8, 8, V::Constant(8e-3), V(0, 0, 30e-3)), metal, "hexes");
  for (Index n = 0; n < nodes.size(); ++n) nodes.velocity[n][0] = -2e4 * (nodes.position[n][0] - 7e-3);
  return model_of(std::move(nodes), std::move(particles), std::move(hexes));
}

/// Calls `f()` with 1, 2 and 4 threads.
template <class F> void with_threads(F &&f) {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    INFO(threads << " threads");
    f();
  }
  omp_set_num_threads(before);
}

const RunOptions<double> until{.end_time = 5e-6, .observe_every = 1e-7};
const auto go_on = [](const auto &, const auto &) { return true; };

} // namespace

TEST_CASE("an exception of a flow law reaches the caller of run()", "[sim]") {
  with_threads([] {
    auto model = squeezed({.yield = 300e6});
    CHECK_THROWS_WITH(run(model, until, go_on), "this law ends at a plastic strain of 0.001");
    CHECK(model.steps > 0);
  });
}

TEST_CASE("the lack of memory reaches the caller of run()", "[sim]") {
  with_threads([] {
    auto model = squeezed({.yield = 300e6, .out_of_memory = true});
    CHECK_THROWS_AS(run(model, until, go_on), std::bad_alloc);
  });
}

TEST_CASE("an exception of a kernel reaches the caller of run()", "[sim]") {
  with_threads([] {
    faulty::Kernel::armed = false;
    auto model = squeezed<faulty::Kernel>({.yield = 1e15});
    faulty::Kernel::armed = true;
    CHECK_THROWS_AS(run(model, until, go_on), faulty::Broken);
  });
}

TEST_CASE("an exception of an observer reaches the caller of run(), and files are whole up to there", "[sim]") {
  with_threads([] {
    const TemporaryFolder folder;
    auto csv = continue_csv(folder.path / "history.csv", {"time_us"});
    auto model = squeezed({.yield = 1e15});
    int calls = 0;
    const auto observer = [&](const auto &now, const auto &) {
      if (++calls > 3) throw faulty::Broken("the observer has seen enough");
      add_row(csv, {now.time * 1e6});
      return true;
    };
    CHECK_THROWS_WITH(run(model, until, observer), "the observer has seen enough");
    const std::string text = read_text(folder.path / "history.csv");
    CHECK(text.back() == '\n');
    CHECK(std::count(text.begin(), text.end(), '\n') == 4);
    // Another model runs in the same process.
    auto other = squeezed({.yield = 1e15});
    CHECK(run(other, RunOptions<double>{.end_time = 5e-7}, go_on).reason == StopReason::end_time);
  });
}
