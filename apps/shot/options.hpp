// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/material_file.hpp"
#include "ogive/core/error.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/material/damage.hpp"
#include "ogive/material/equation_of_state.hpp"
#include "ogive/mesh/projectile_shape.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/perforation/method.hpp"
#include "options/command_line.hpp"
#include "own_mesh.hpp"

/// \file
/// The options of a shot, from the command line, a TOML file or a row of a list of cases.

namespace shot {

using FlowModel = materials::Model;
using ogive::DamageLaw;
using ogive::DamagePressure;
using ogive::Extent;
using ogive::FailureEffect;
using ogive::Lattice;
using ogive::Method;
using ogive::Nose;
using ogive::Parts;
using ogive::PressureLaw;

enum class SphForm { renormalised, standard };
enum class SphKernel { cubic_spline, wendland_c2 };
enum class Smoothing { constant, variable };
enum class ElementRule { one_point, selective_reduced };

/// Data of a checkpoint that a run resumes from, besides the options of its case.
struct Restart {
  std::filesystem::path file;
  std::string metal_toml; ///< the metal of the plate, or those of the plates
  double time_us = 0;     ///< of the checkpoint

  bool operator==(const Restart &) const = default;
};

/// One run, in the units that the names have. The defaults are the main job: Weldox 460 E, MJC, 12 mm, blunt.
struct Options {
  Method method = Method::stabilised;
  std::string material = "weldox_460e"; ///< a name of the library, or a file that ends in .toml
  FlowModel model = FlowModel::mjc;     ///< parse() takes the file's where the material is one
  /// Of damage parse() takes the method's where nothing is given.
  DamageLaw damage = DamageLaw::johnson_cook;
  FailureEffect failure = FailureEffect::no_tension;
  double damage_softening = 0.3; ///< Dc
  double band_onset = 0.5;
  DamagePressure damage_pressure = DamagePressure::neighbours;
  double thickness_mm = 12;                 ///< of several plates the sum
  std::vector<double> layers_mm;            ///< thicknesses of several plates from front to rear; empty: one plate
  std::vector<double> gaps_mm;              ///< between them; parse() makes it one for each two plates
  std::vector<std::string> layer_materials; ///< one for each plate, the first one's is `material` too; empty: all that
  double clamp_radius_mm = 250;

  std::string projectile;                           ///< a name of the library, or a file; empty: by nose and sizes
  bool rigid = false;                               ///< it moves and turns as one, and does not deform
  std::string projectile_metal = "arne_tool_steel"; ///< a name of the library, or a file that ends in .toml
  Nose nose = Nose::blunt;
  double diameter_mm = 20;
  double length_mm = 80;          ///< tip to tail; parse() takes that of the paper's nose, scaled with the diameter
  double nose_length_mm = 0;      ///< unless blunt or round; parse() takes that of the paper's, scaled likewise
  double tip_diameter_mm = 0;     ///< flat at the tip, width of a chisel's; parse() takes the paper's, scaled likewise
  double calibre_radius_head = 0; ///< of an ogive, instead of its nose length; 0: not given
  double edge_radius_mm = 0;      ///< of the edge between face and shank of a blunt nose; 0: sharp
  double tail_length_mm = 0;      ///< of a boat tail; 0: none
  double tail_diameter_mm = 0;    ///< of its rear end; 0: none
  std::string profile;            ///< the CSV file that profile_mm comes from; empty: no file
  std::vector<double> profile_mm; ///< z and r of the points of a profile in turn; empty: no profile
  std::string projectile_mesh;    ///< a file of a mesh; empty: none
  MeshUnit mesh_unit = MeshUnit::mm;
  OwnMesh own_mesh;                      ///< contents of that file, as settled() or a checkpoint has read them
  std::vector<std::string> part_metals;  ///< "PART=METAL"; empty: projectile_metal for all
  Parts parts = Parts::tied;             ///< connection of the projectile's parts
  double part_friction = 0.1;            ///< Coulomb, between parts that touch
  bool projectile_erosion = true;        ///< its hexes that are too distorted are removed
  double bore_radius_mm = 0;             ///< of a bore from the rear; 0: none
  double bore_depth_mm = 0;              ///< of that bore
  std::vector<double> filler_profile_mm; ///< z and r of the surface within the jacket in turn; empty: no filler
  std::vector<double> core_profile_mm;   ///< likewise of the core; empty: no core
  double mass_g = 0;                     ///< of the projectile; 0: by the density of its metal
  double obliquity_deg = 0;              ///< between the line of flight and the plate's axis
  double pitch_deg = 0;                  ///< of the projectile's axis against the line of flight, in the plane of both
  double yaw_deg = 0;                    ///< likewise out of that plane
  double velocity_mps = 303.5;
  double friction = 0;  ///< Coulomb; parse() takes default_friction() where none is given
  double settle_us = 0; ///< after the shot is decided
  double end_us = 910;  ///< parse() takes default_end_us() where none is given

  double spacing_mm = 0.6;
  double sph_radius_mm = 24;
  Extent extent = Extent::quarter;
  Lattice lattice = Lattice::ring; ///< parse() takes the method's where none is given
  int seed = 0;                    ///< of an arrangement that is disturbed at random; 0: the lattice
  SphForm form = SphForm::renormalised;
  SphKernel kernel = SphKernel::cubic_spline;
  Smoothing smoothing = Smoothing::constant;
  ElementRule element = ElementRule::one_point;
  PressureLaw pressure = PressureLaw::linear;
  double control_stiffness = 0.3; ///< parse() takes the method's where none is given
  double contact_stiffness = ogive::PerforationOptions<double>{}.contact_stiffness;
  double linear_viscosity = ogive::SphOptions<double>{}.linear_viscosity;
  double quadratic_viscosity = ogive::SphOptions<double>{}.quadratic_viscosity;

  std::filesystem::path out = "vtk_out/weldox_460e_mjc_blunt_12mm_303.5mps"; ///< default_out() where none is given
  double output_every_us = 5;
  double checkpoint_every_us = 0; ///< 0: by wall time, see checkpoint_minutes
  bool vtk = true;                ///< write VTK files
  bool picture = true;            ///< draw the section picture
  bool quiet = false;             ///< no progress on the terminal
  std::optional<int> threads;     ///< unset: as many as OpenMP offers

  std::optional<Restart> restart; ///< set: the run resumes from there

  bool operator==(const Options &) const = default;
};

/// Name of the checkpoint in the folder of the results.
inline constexpr char checkpoint_name[] = "checkpoint.bin";

/// Name of the checkpoint of an earlier run after another one has begun in the folder.
inline constexpr char earlier_checkpoint_name[] = "checkpoint_before.bin";

/// Wall time between two checkpoints of a run that has no interval for them.
inline constexpr double checkpoint_minutes = 15;

/// Highest initial velocity of a run, m/s: the equation of state holds below it.
inline constexpr double largest_velocity_mps = 3000;

/// Initial velocity above which a run warns that a deformable projectile may stop it, m/s.
inline constexpr double fastest_deformable_mps = 1500;

/// Largest number of an arrangement of the particles.
inline constexpr int largest_seed = 1000000;

/// Longest time of a run, us.
inline constexpr double longest_us = 100000;

/// Largest number of particles of a run.
inline constexpr double most_particles = 50e6;

/// Options of a case from one source: a file, a command line, a row of a list.
struct Level {
  std::vector<options::Given> given;
  std::filesystem::path folder{}; ///< that names of material files count from; empty: the current one
};

/// The levels of a command line that has been read: its --config file and the line itself, without the keys that are
/// not the case's. Throws SetupError.
std::vector<Level> levels_of(const options::CommandLine &line);

/// The case of what was given, later levels first, and defaults for the rest. Throws SetupError, one line that names
/// the option (of a file its line), the value and what is allowed.
Options settled(const std::vector<Level> &levels);

/// Checks the options that depend on each other. Throws SetupError.
void check(const Options &options, const options::Origins &origins);

/// A TOML file that parse() reads back as the same options.
std::string to_toml(const Options &options);

/// Every value of the case as TOML, defaults included, without the options that the reader of a checkpoint gives anew.
std::string to_complete_toml(const Options &options);

/// Number of particles that a case will have, up to the edge of the disc.
double estimated_particles(const Options &options);

/// Distance from the front face of the first plate to the rear face of the last one, mm.
double target_depth_mm(const Options &options);

} // namespace shot
