// An observer that stops the run: here as soon as the plate has taken 10 % of the projectile's velocity.
// Run: 09_stopping_observer. It prints time and velocity every microsecond, and why the run ended.
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  const PerforationCase<double> shot{.thickness = 6e-3, .spacing = 1.5e-3, .initial_velocity = 200};
  auto model = make_perforation(shot, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());

  double velocity = 0;
  const RunOptions<double> until{.end_time = 100e-6, .observe_every = 1e-6};
  const RunResult result = run(model, until, [&](const auto &now, const Energy<double> &) {
    velocity = -mean_velocity(now.nodes, projectile(now).nodes)[2];
    std::printf("%5.1f us  %6.1f m/s\n", now.time * 1e6, velocity);
    return velocity > 0.9 * shot.initial_velocity; // false: enough
  });
  const bool stopped = result.reason == StopReason::observer;
  std::printf("stopped by the observer: %s\n", stopped ? "yes" : "no");
  return stopped && velocity <= 0.9 * shot.initial_velocity && model.time < until.end_time ? 0 : 1;
}
