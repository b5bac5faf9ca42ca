// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh_io/own_projectile.hpp"

#include <filesystem>
#include <memory>
#include <string>

/// \file
/// The mesh of a projectile in a file of LS-DYNA, Abaqus or VTK.

namespace shot {

/// Length units that a mesh can have.
enum class MeshUnit { mm, cm, m, inch };

/// A unit in m.
double metres(MeshUnit unit);

/// Contents of a mesh file.
struct MeshOfFile {
  std::string bytes;               ///< of the file, to be copied
  ogive::FileMesh mesh;            ///< of the file, before it is cut or moved
  ogive::OwnProjectile projectile; ///< for the extent of the model
};

/// A mesh that has been read, which copies of the options share; none if there is no file.
struct OwnMesh {
  std::shared_ptr<const MeshOfFile> read{};

  /// Both have the same body, or none.
  bool operator==(const OwnMesh &other) const;
};

/// "a file that ends in .k, .key, .dyn, .inp or .vtu"
std::string allowed_mesh_files();

/// True if the name is one of those.
bool is_mesh_file(const std::string &name);

/// Reads a mesh for an extent of the model and for parts that are held like this. `origin` names the option in errors.
/// Throws SetupError.
OwnMesh read_own_mesh(const std::filesystem::path &file, MeshUnit unit, ogive::Extent extent, ogive::Parts parts,
                      const std::string &origin);

/// Name of the copy of a mesh in the folder of the results.
std::string mesh_copy_name(const std::string &file);

} // namespace shot
