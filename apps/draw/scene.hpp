// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/io/frame.hpp"

#include <string>
#include <vector>
#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

/// \file
/// Parts of a frame as VTK actors, cut open at the plane y = 0, where the half with y >= 0 stays, or whole. Lengths in
/// mm.

namespace draw {

/// The name of the projectile among the parts of a frame; those of its parts begin with it.
inline constexpr char projectile_name[] = "projectile";

/// Whether a part of a frame is the projectile or one of its parts.
inline bool is_of_projectile(const std::string &part) { return part.starts_with(projectile_name); }

/// Colours, grey parts, mesh and spheres of a section.
struct SectionStyle {
  std::string field = "plastic_strain";                 ///< a scalar field of particles and cells that gives the colour
  double smallest = 0;                                  ///< value of the first colour
  double largest = 1.5;                                 ///< value of the last colour
  std::vector<std::string> grey_parts{projectile_name}; ///< drawn in one grey instead
  bool mesh_edges = true;                               ///< thin lines between hexes
  /// Radius of the spheres in particle distances; at half a lattice's diagonal, 0.7, neighbours close the face.
  double particle_radius = 0.7;
  double particle_ambient = 0.5; ///< light on spheres that does not shade them, 0 to 1
  bool whole = false;            ///< with the half that a section leaves out
};

/// The colours: light grey for the undeformed metal, through yellow and red to almost black. Throws ogive::SetupError
/// unless the largest value is above the smallest.
vtkSmartPointer<vtkColorTransferFunction> section_colours(const SectionStyle &style);

/// The particles of the half y >= 0, or all, as spheres, the hexes as a closed surface, mirrored at the symmetry
/// planes. Throws ogive::SetupError if they lack the field of the style, or it is not one number for each.
vtkSmartPointer<vtkActor> section_actor(const ogive::PointCloud &cloud, ogive::SymmetryPlanes planes,
                                        const SectionStyle &style, vtkColorTransferFunction *colours);
vtkSmartPointer<vtkActor> section_actor(const ogive::HexGrid &hexes, ogive::SymmetryPlanes planes,
                                        const SectionStyle &style, vtkColorTransferFunction *colours);

/// An empty scene: white, with one light that moves with the camera.
vtkSmartPointer<vtkRenderer> white_scene();

/// Directions of view, in parallel projection.
enum class Seen {
  section, ///< the half behind the plane y = 0, seen along y with z upwards
  oblique, ///< the same half from the front, the left and above
  behind   ///< all of the plate from behind, along z, without the projectile, which would hide hole and petals
};

/// Visible part of a scene, mm, and the direction of view. The rear view is centred on the axis z instead.
struct SectionView {
  double centre_x_mm = 0;     ///< in the middle of the view
  double centre_z_mm = -8;    ///< in the middle of the view; the plate's front face is z = 0
  double half_height_mm = 30; ///< half of what is seen from bottom to top
  Seen from = Seen::section;
};

/// Points a scene's camera at a section or the plate.
void aim(vtkRenderer *scene, const SectionView &view);

/// A frame as a scene, with the symmetry of the frame. The computed part of a model lies where the
/// coordinates of its symmetry planes are positive. Throws ogive::SetupError if a part lacks the field of the style.
vtkSmartPointer<vtkRenderer> section_scene(const ogive::Frame &frame, const SectionStyle &style,
                                           vtkColorTransferFunction *colours, const SectionView &view);

} // namespace draw
