// A plate perforated in a dozen lines: 12 mm of Weldox 460 E, a blunt projectile at 303.5 m/s, particles 1.2 mm apart.
// Run: 01_perforate. It prints time, projectile velocity and total energy every 5 us; the energy stays what it was.
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  const PerforationCase<double> shot{.thickness = 12e-3,
                                     .spacing = 1.2e-3,
                                     .projectile = paper_projectile<double>(Nose::blunt),
                                     .initial_velocity = 303.5};
  auto model = make_perforation(Method::stabilised, shot, library::weldox_460e_mjc<double>(),
                                library::arne_tool_steel<double>());
  const RunOptions<double> until{.end_time = 100e-6, .observe_every = 5e-6};
  const RunResult result = run(model, until, [](const auto &now, const Energy<double> &energy) {
    std::printf("%5.1f us  %6.1f m/s  %8.2f J\n", now.time * 1e6, -mean_velocity(now.nodes, projectile(now).nodes)[2],
                total(energy));
    return true;
  });
  return result.fault ? 1 : 0;
}
