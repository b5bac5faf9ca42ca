// SPDX-License-Identifier: BSD-3-Clause
#include "own_mesh.hpp"

#include "options/toml_file.hpp"

#include "ogive/io/vtk_mesh.hpp"
#include "ogive/mesh_io/read_abaqus.hpp"
#include "ogive/mesh_io/read_ls_dyna.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace shot {

namespace {

constexpr std::array<std::string_view, 5> endings{".k", ".key", ".dyn", ".inp", ".vtu"};

/// Largest file of a mesh, MiB: some million hexes.
constexpr std::size_t largest_file = 512;

bool is_same(const ogive::OwnProjectile &a, const ogive::OwnProjectile &b) {
  return a.body.mesh.hexes == b.body.mesh.hexes && a.body.mesh.positions == b.body.mesh.positions &&
         a.body.part_of == b.body.part_of && a.body.parts == b.body.parts;
}

} // namespace

double metres(MeshUnit unit) {
  switch (unit) {
  case MeshUnit::cm:
    return 1e-2;
  case MeshUnit::m:
    return 1;
  case MeshUnit::inch:
    return 25.4e-3;
  case MeshUnit::mm:
    break;
  }
  return 1e-3;
}

bool OwnMesh::operator==(const OwnMesh &other) const {
  if (read == other.read) return true;
  return read && other.read && is_same(read->projectile, other.read->projectile);
}

std::string allowed_mesh_files() { return "a file that ends in .k, .key, .dyn, .inp or .vtu"; }

bool is_mesh_file(const std::string &name) {
  const std::string ending = std::filesystem::path(name).extension().string();
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

OwnMesh read_own_mesh(const std::filesystem::path &file, MeshUnit unit, ogive::Extent extent, ogive::Parts parts,
                      const std::string &origin) {
  const std::string name = file.string(), ending = file.extension().string();
  auto read = std::make_shared<MeshOfFile>();
  read->bytes = options::text_of_file(file, origin, "mesh", largest_file);
  read->mesh = ending == ".vtu"   ? ogive::read_vtu_mesh(file, metres(unit))
               : ending == ".inp" ? ogive::read_abaqus_mesh(read->bytes, name, metres(unit))
                                  : ogive::read_ls_dyna_mesh(read->bytes, name, metres(unit));
  read->projectile = ogive::own_projectile(read->mesh, extent, parts);
  return {read};
}

std::string mesh_copy_name(const std::string &file) {
  return "projectile_mesh" + std::filesystem::path(file).extension().string();
}

} // namespace shot
