// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/mesh_io/own_projectile.hpp"
#include "ogive/mesh_io/read_abaqus.hpp"

#include "fuzz/must.hpp"
#include "fuzz/targets.hpp"

/// A mesh of a projectile; one that is taken is a body with a volume, its tip at zero.
void fuzz::try_mesh_inp(std::string_view bytes) {
  for (const ogive::Extent extent : {ogive::Extent::quarter, ogive::Extent::full}) {
    ogive::OwnProjectile own;
    try {
      own = ogive::own_projectile(ogive::read_abaqus_mesh(bytes, "mesh.inp", 1e-3), extent);
    } catch (const ogive::SetupError &) {
      continue;
    }
    check(own.shape);
    must(ogive::volume(own.body.mesh) > 0, "the body has a volume");
    must(own.body.part_of.size() == own.body.mesh.hexes.size(), "each hex is of a part");
    for (const std::size_t part : own.body.part_of) must(part < own.body.parts.size(), "of one that is there");
    double tip = 1;
    for (const auto &x : own.body.mesh.positions) tip = std::min(tip, x[2]);
    must(tip == 0, "the tip is at zero");
  }
}
