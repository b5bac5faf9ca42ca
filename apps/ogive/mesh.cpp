// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"

#include "shot/defaults.hpp"
#include "shot/plates.hpp"
#include "shot/run.hpp"
#include "shot/table.hpp"
#include "shot/to_case.hpp"

#include "ogive/io/vtk.hpp"
#include "ogive/material/library.hpp"
#include "ogive/mesh/mesh_check.hpp"

#include <cstdio>
#include <iostream>
#include <vector>

namespace commands {

namespace {

/// The hexes of a body as a mesh of their own.
template <class Body> ogive::HexMesh<double> mesh_of(const Body &body, const ogive::Nodes<double> &nodes) {
  ogive::HexMesh<double> mesh;
  mesh.positions.assign(nodes.position.begin() + body.nodes.begin, nodes.position.begin() + body.nodes.end);
  mesh.hexes = body.hexes;
  for (auto &hex : mesh.hexes)
    for (ogive::Index &n : hex) n -= body.nodes.begin;
  return mesh;
}

template <class M> void print_bodies(const M &model) {
  std::printf("\n  %-11s %8s %8s %12s %12s %12s %8s %8s %9s\n", "body", "nodes", "hexes", "mass, g", "shortest, mm",
              "longest, mm", "aspect", "Jacobian", "step, us");
  for_each_body(model, [&](const auto &body) {
    const double mass_g = ogive::whole_mass(body.point_mass, model.symmetry) * 1e3,
                 step_us = ogive::stable_time_step(body, model.nodes) * 1e6;
    if constexpr (requires { body.hexes; }) {
      const auto q = ogive::mesh_quality(mesh_of(body, model.nodes));
      std::printf("  %-11s %8d %8zu %12.3f %12.4f %12.4f %8.2f %8.3f %9.4f\n", body.name.c_str(), body.nodes.size(),
                  body.hexes.size(), mass_g, q.shortest_edge * 1e3, q.longest_edge * 1e3, q.largest_aspect,
                  q.smallest_scaled_jacobian, step_us);
    } else {
      std::printf("  %-11s %8d %8s %12.3f %12.4f %12.4f %8s %8s %9.4f\n", body.name.c_str(), body.nodes.size(), "-",
                  mass_g, body.spacing * 1e3, body.spacing * 1e3, "-", "-", step_us);
    }
  });
}

} // namespace

options::Table mesh_table() {
  shot::Options o;
  return shot::table_of(o);
}

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
  if (!line) return options::success;
  shot::Options o = shot::settled(shot::levels_of(*line));
  if (o.out == shot::default_out(o)) o.out += "_mesh";
  shot::prepare_out(o);
  // Of the metal only density and elastic constants matter here; any flow law, kernel and rule of the hexes will do.
  std::vector<ogive::Metal<double, ogive::ModifiedJohnsonCook<double>>> plates;
  for (const auto &any : shot::plates_of(o)) {
    auto &plate = plates.emplace_back(ogive::library::weldox_460e_mjc<double>());
    std::visit([&](const auto &metal) { plate.density = metal.density, plate.elasticity = metal.elasticity; }, any);
  }
  const auto model = ogive::make_perforation(shot::to_case(o), plates, ogive::library::arne_tool_steel<double>(),
                                             ogive::options_of<double>(o.method));
  auto series = ogive::open_series(o.out, "mesh");
  ogive::add_frame(series, ogive::gather_frame(model));
  std::printf("Model of %s\n", o.out.c_str());
  print_bodies(model);
  std::printf("\n  Masses are those of the whole model. Jacobian: the smallest scaled one, 1 for a brick. The size of\n"
              "  a particle is the particle distance.\n"
              "  files %s\n",
              (o.out / "mesh.pvd").c_str());
  return options::success;
}

} // namespace commands
