// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/material/damage.hpp"
#include "ogive/material/equation_of_state.hpp"
#include "ogive/mesh/projectile_shape.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/perforation/method.hpp"
#include "shared/material_file.hpp"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

/// \file
/// What a user can choose for a run of `perforate`, from the command line and from a TOML file.

namespace perforate {

using FlowModel = material_file::Model;
using ogive::DamageLaw;
using ogive::DamagePressure;
using ogive::Extent;
using ogive::FailureEffect;
using ogive::Lattice;
using ogive::LengthScope;
using ogive::Method;
using ogive::Nose;
using ogive::PressureLaw;

enum class ProjectileKind { deformable, rigid };
enum class SphForm { renormalised, standard };
enum class SphKernel { cubic_spline, wendland_c2 };
enum class Smoothing { constant, variable };
enum class ElementRule { one_point, selective_reduced };

/// What a run that goes on from a checkpoint has from there, besides the options of its case.
struct Restart {
  std::filesystem::path file;
  std::string metal_toml; ///< the metal of the plate, or those of the plates
  double time_us = 0;     ///< of the checkpoint

  bool operator==(const Restart &) const = default;
};

/// One run, in the units that the names say. The defaults are the main job: Weldox 460 E, MJC, 12 mm, blunt.
struct Options {
  Method method = Method::sfm;
  std::string material = "weldox_460e";        ///< a name of the library, or a file that ends in .toml
  FlowModel model = FlowModel::mjc;            ///< parse() takes the file's where the material is one
  DamageLaw damage = DamageLaw::none;          ///< parse() takes default_damage() where none is given
  FailureEffect failure = FailureEffect::none; ///< parse() takes default_failure() where none is given
  double damage_softening = 0;                 ///< Dc; parse() takes default_softening() where none is given
  std::optional<double> damage_length_mm = 0;  ///< unset: shear_length_mm of each plate; parse() takes the default
  double damage_length_exponent = 1;           ///< parse() takes default_length_exponent() where none is given
  LengthScope damage_length_scope{};           ///< parse() takes default_length_scope() where none is given
  DamagePressure damage_pressure{};            ///< parse() takes default_damage_pressure() where none is given
  double thickness_mm = 12;                    ///< of several plates the sum
  std::vector<double> layers_mm;               ///< thicknesses of several plates from front to rear; empty: one plate
  std::vector<double> gaps_mm;                 ///< between them; parse() makes it one for each two plates
  std::vector<std::string> layer_materials; ///< one for each plate, the first one's is `material` too; empty: all that
  double clamp_radius_mm = 250;

  Nose nose = Nose::blunt;
  double diameter_mm = 20;
  double length_mm = 80;          ///< tip to tail; parse() takes that of the paper's nose, scaled with the diameter
  double nose_length_mm = 0;      ///< of a conical or ogival nose; parse() takes that of the paper's, scaled likewise
  double calibre_radius_head = 0; ///< of an ogive, instead of its nose length; 0: not given
  double edge_radius_mm = 0;      ///< of the edge between face and shank of a blunt nose; 0: sharp
  double mass_g = 0;              ///< of the projectile; 0: by the density of its steel
  double obliquity_deg = 0;       ///< between the line of flight and the plate's axis
  ProjectileKind projectile = ProjectileKind::deformable;
  double velocity_mps = 303.5;
  double friction = 0;  ///< Coulomb; parse() takes default_friction() where none is given
  double settle_us = 0; ///< after the shot is decided
  double end_us = 500;  ///< parse() takes default_end_us() where none is given

  double spacing_mm = 0.6;
  double sph_radius_mm = 24;
  Extent extent = Extent::quarter;
  Lattice lattice = Lattice::ring;
  SphForm form = SphForm::renormalised;
  SphKernel kernel = SphKernel::cubic_spline;
  Smoothing smoothing = Smoothing::constant;
  ElementRule element = ElementRule::one_point;
  PressureLaw pressure = PressureLaw::linear;
  double control_stiffness = 0; ///< parse() takes default_control_stiffness() where none is given
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

  std::optional<Restart> restart; ///< set: the run goes on from there

  bool operator==(const Options &) const = default;
};

/// Name of the checkpoint in the folder of the results.
inline constexpr char checkpoint_name[] = "checkpoint.bin";

/// Name that it gets when another run begins in the folder.
inline constexpr char earlier_checkpoint_name[] = "checkpoint_before.bin";

/// Wall time between two checkpoints of a run that has no interval for them.
inline constexpr double checkpoint_minutes = 15;

/// Most particles that a run may have.
inline constexpr double most_particles = 50e6;

/// Coulomb friction of the paper: 0 for blunt noses; for the others 0.08 on steel and 0.02 on aluminium. The paper
/// gives it for conical and ogival noses on Weldox 460 E and for conical ones on AA5083-H116; the rest follows the
/// plate, and the metal of a file is taken for steel.
double default_friction(Nose nose, const std::string &material);

/// How damage grows unless the user says so: not at all in the paper's method; else as Johnson & Cook have it.
DamageLaw default_damage(Method method);

/// By how much damage 1 lowers the flow stress unless the user says so.
double default_softening(Method method);

/// Stiffness of the bonds against zero-energy modes unless the user says so, over the shear modulus.
double default_control_stiffness(Method method);

/// Particle distance for which the constants of damage hold unless the user says so, mm; unset: that of each metal.
std::optional<double> default_damage_length_mm(Method method, DamageLaw damage);

/// With which exponent failure strains follow the particle distance unless the user says so.
double default_length_exponent(Method method);

/// Where failure strains follow the particle distance.
LengthScope default_length_scope(Method method);

/// Whose pressure damage follows.
DamagePressure default_damage_pressure(Method method);

/// What failure does unless the user says so: no tension where damage grows. Our choice.
FailureEffect default_failure(DamageLaw damage);

/// Time at which a run ends, us: sharp noses take longer to pass the plate. Our choice.
double default_end_us(Nose nose);

/// vtk_out/<material, or the stem of its file>_<model>_<nose>_<thickness>mm_<velocity>mps, with diameter, obliquity and
/// method where they are not those of the paper.
std::filesystem::path default_out(const Options &options);

/// Distance from the front face of the first plate to the rear face of the last one, mm.
double target_depth_mm(const Options &options);

/// The thicknesses of the plates and the gaps between them, for titles and folders: "12mm"; "6+6mm",
/// "4+8mm_10mm_apart".
std::string thickness_label(const Options &options);

/// Number of particles that a case will have, up to the edge of the disc.
double estimated_particles(const Options &options);

/// Reads the command line (argv[0] is skipped) and the TOML file that --config names; the command line wins. The name
/// of a material file counts from the folder of the TOML file, or on the command line from the current one. With
/// --restart the case is that of the checkpoint, and its folder that of the results; only options that leave the
/// physics as they are may be given. With --resume see resumed(). Returns nothing if --help, --version or --material
/// list was asked for and has been written to `text`. Throws ogive::SetupError, one line that names the option (or
/// file, line and key), the value and what is allowed. Reads the material file or the checkpoint to check it, and
/// touches no other.
std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text);

/// The options of a run that takes up what an earlier one left in the folder `options.out`: they go on from the
/// checkpoint there if it is of the same case, metal and version of ogive and the folder has no summary, the sign of an
/// end. Else those given. Threads, picture and terminal may differ; frames may not, those of before would be missing.
Options resumed(const Options &options);

/// A TOML file that runs the same case with --config.
std::string to_toml(const Options &options);

/// The same for checkpoints, with all that the file leaves to its reader.
std::string to_complete_toml(const Options &options);

/// The text of --help.
std::string help();

/// Creates the folder `options.out` and proves with a small file of its own, removed at once, that it can be written to
/// and has room for the run. Leaves what is there untouched. Throws ogive::SetupError, one line, and then leaves no new
/// folder behind.
void prepare_out(const Options &options);

/// The names of the choices, as the user writes them.
std::string name_of(Method method);
std::string name_of(DamageLaw damage);
std::string name_of(FailureEffect failure);

} // namespace perforate
