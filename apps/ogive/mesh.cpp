// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"

#include "shot/defaults.hpp"
#include "shot/plates.hpp"
#include "shot/result.hpp"
#include "shot/run.hpp"
#include "shot/table.hpp"

#include <algorithm>
#include <iostream>

namespace commands {

options::Table mesh_table() { return unbound(shot::table_of); }

int mesh(const options::Arguments &arguments) {
  const options::Command command{
      .name = "ogive mesh",
      .purpose = "Writes the model of a shot for ParaView and prints its sizes and the quality of its hexes, without\n"
                 "running it. Options are those of ogive shoot.\n",
      .usage = "[options]",
      .examples = "  ogive mesh --nose conical --spacing-mm 1\n",
      .more = exit_statuses,
      .config = true};
  shot::Options defaults; // which the help reads
  const auto line = options::read_command_line(command, shot::table_of(defaults), arguments, std::cout);
  if (!line) return options::only_printed;
  shot::Options o = shot::settled(shot::levels_of(*line));
  if (o.out == shot::default_out(o)) o.out += "_mesh";
  shot::use_threads(o);
  shot::prepare_out(o);
  const auto bodies = shot::write_model(o, shot::plates_of(o));
  std::printf("Model of %s\n", o.out.c_str());
  std::printf("\n  %-17s %8s %8s %10s %12s %12s %8s %8s %9s\n", "body", "nodes", "hexes", "mass, g", "shortest, mm",
              "longest, mm", "aspect", "Jacobian", "step, us");
  for (const shot::BodySizes &b : bodies) {
    std::printf("  %-17s %8ld %8s %10.3f %12.4f %12.4f", b.name.c_str(), b.nodes,
                b.hexes > 0 ? std::to_string(b.hexes).c_str() : "-", b.mass_g, b.shortest_mm, b.longest_mm);
    if (b.hexes > 0)
      std::printf(" %8.2f %8.3f %9.4f\n", b.largest_aspect, b.smallest_scaled_jacobian, b.time_step_us);
    else
      std::printf(" %8s %8s %9.4f\n", "-", "-", b.time_step_us);
  }
  double mass_g = 0, volume_mm3 = 0, least = 1;
  for (const shot::BodySizes &b : bodies)
    if (b.name.starts_with("projectile"))
      mass_g += b.mass_g, volume_mm3 += b.volume_mm3, least = std::min(least, b.smallest_scaled_jacobian);
  std::printf("\n  projectile  %.3f g, %.2f mm3, least scaled Jacobian %.3f\n", mass_g, volume_mm3, least);
  std::printf("\n  Masses are those of the whole model. Jacobian: the smallest scaled one, 1 for a brick. The size of\n"
              "  a particle is the particle distance.\n"
              "  files %s\n",
              (o.out / "mesh.pvd").c_str());
  return options::success;
}

} // namespace commands
