// Wave in a bar: a flying bar is caught at one end. The wave brings its particles to rest one after another, so that
// its momentum falls linearly and changes sign after L/c, c being the longitudinal sound speed (the bar is held
// laterally). Run: 03_wave. It prints the mean velocity and the time of the change of sign, within 1 % of L/c.
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  const auto metal = library::arne_tool_steel<double>();
  const double length = 60e-3, speed = 1; // m, m/s

  Nodes<double> nodes;
  const DiscShape<double> shape{.radius = 3e-3, .thickness = length, .spacing = 1e-3};
  auto bar = add_sph_body(nodes, ring_disc(shape, Extent::full), metal, "bar");
  set_velocity(nodes, bar.nodes, Vec3<double>(0, 0, -speed));
  for (Index n = 0; n < nodes.size(); ++n) {
    nodes.held[n] = held_x | held_y;
    if (nodes.position[n][2] < shape.spacing - length) nodes.held[n] = held_all;
  }
  Model model{std::move(nodes), std::tuple{std::move(bar)}, SymmetryPlanes{}};

  double turned_at = 0, time_before = 0, velocity_before = speed;
  const RunOptions<double> until{.end_time = 15e-6, .observe_every = 0.5e-6};
  const auto result = run(model, until, [&](const auto &now, const auto &) {
    const double velocity = -mean_velocity(now.nodes, std::get<0>(now.bodies).nodes)[2];
    const double time = now.time - 0.5 * now.last_step; // velocities are half a step older than positions
    if (velocity_before > 0 && velocity <= 0)
      turned_at = time_before + (time - time_before) * velocity_before / (velocity_before - velocity);
    std::printf("%5.2f us  %6.3f m/s\n", time * 1e6, velocity);
    time_before = time, velocity_before = velocity;
    return velocity > -0.2 * speed;
  });
  const double free_length = length - shape.spacing; // one layer is held
  const double theory = free_length / sound_speed(metal);
  std::printf("turned after %.3f us, L/c is %.3f us\n", turned_at * 1e6, theory * 1e6);
  return !result.fault && std::abs(turned_at / theory - 1) < 0.01 ? 0 : 1;
}
