// SPDX-License-Identifier: BSD-3-Clause
#include "table.hpp"

#include "materials/library.hpp"
#include "materials/material_keys.hpp"
#include "named_projectile.hpp"
#include "options/text.hpp"
#include "parts.hpp"

#include <thread>

namespace shot {

namespace {

using options::add;
using options::Given;
using options::Option;
using options::Table;

/// Most threads that a run may have.
double most_threads() { return std::max(64.0, 4.0 * std::thread::hardware_concurrency()); }

std::string material_given(const Given &given) {
  const std::string material = line_given(given, materials::allowed_materials());
  if (!materials::is_material_file(material) && materials::find_library_metal(material) == nullptr)
    refuse(given,
           "must be " + materials::allowed_materials() + options::nearest_text(material, materials::library_names()));
  return material;
}

// clang-format off
void add_plate(Table &t, Options &o) {
  t.group = "Plate";
  Option &material = add(t, o.material, {.key = "material", .meaning = "metal of the plate", .source = "paper",
      .brief = "metal of the plate: a name, or your FILE.toml"});
  material.placeholder = "NAME|FILE.toml";
  material.allowed_text = materials::allowed_materials();
  material.range = ": " + material.allowed_text;
  material.assign = [&o](const Given &given) { o.material = material_given(given); };
  material.names = materials::library_names();
  add(t, o.model, {.key = "model",
      .meaning = "flow law, of metals with the modified and the classical Johnson-Cook law (mjc and jc); other metals "
      "have one law", .source = "paper"});
  add(t, o.method, {.key = "method", .meaning = "numerical method: stabilised has damage and bonds between the "
      "particles; paper, the method of the paper, has neither, and particles separate by themselves", .source = "ours",
      .brief = "method: stabilised, or paper, that of the paper"});
  add(t, o.damage, {.key = "damage",
      .meaning = "damage law: jc with D1 to D5 of the material, cockcroft_latham with its critical_work_MPa",
      .source = "jc, none with --method paper: ours, paper"});
  add(t, o.failure, {.key = "failure",
      .meaning = "effect of full damage (D = 1): no_tension leaves pressure only, removal leaves no force",
      .source = "none without --damage, else no_tension: ours"});
  add(t, o.damage_softening, {.key = "damage_softening",
      .meaning = "share of the flow stress that is lost at full damage",
      .source = "0.3, 0 with --method paper: Boervik et al. 2001",
      .limits = {0, 1, ""}});
  add(t, o.damage_pressure, {.key = "damage_pressure",
      .meaning = "pressure in the damage law: each particle's own, or the mean of its neighbours",
      .source = "neighbours, own with --method paper: ours"});
  add(t, o.band_onset, {.key = "band_onset",
      .meaning = "adiabatic shear bands form at this share of the strain of instability; 0: none form",
      .source = "0.5, 0 with --method paper: ours",
      .limits = {0, 1, ""}});
  add(t, o.thickness_mm, {.key = "thickness_mm", .meaning = "thickness of the plate", .source = "paper, Fig. 11",
      .brief = "thickness of the plate", .limits = {0.05, 500, "mm"}});
  add(t, o.layers_mm, {.key = "layers_mm", .meaning = "thicknesses of several plates behind each other, from front "
      "to rear, instead of --thickness-mm", .source = "none: one plate",
      .brief = "several plates instead, from front to rear", .limits = {0.05, 500, "mm"}});
  add(t, o.gaps_mm, {.key = "gaps_mm",
      .meaning = "gaps between the plates of --layers-mm: one for all, or one for each pair of neighbours",
      .source = "0: they touch", .limits = {0, 1000, "mm"}});
  Option &layers = options::add_option(t, {.key = "layer_materials",
      .meaning = "metals of the plates of --layers-mm, one for each",
      .source = "that of --material: one for all"}, options::Kind::texts, "NAME,NAME,...");
  layers.range = "; separated by commas, each as for --material";
  layers.allowed_text = "materials with commas between them, each " + materials::allowed_materials();
  layers.assign = [&o](const Given &given) {
    o.layer_materials.clear();
    for (const Given &one : entries_given(given)) o.layer_materials.push_back(material_given(one));
  };
  layers.toml = [&o] {
    std::vector<std::string> names;
    for (const auto &name : o.layer_materials) names.push_back(options::toml_string(name));
    return names.empty() ? "" : "[" + options::joined(names) + "]";
  };
  add(t, o.clamp_radius_mm, {.key = "clamp_radius_mm", .meaning = "radius at which the plate is clamped",
      .source = "tests", .limits = {1, 5000, "mm"}});
}

void add_projectile_choice(Table &t, Options &o) {
  Option &named = options::add_option(t, {.key = "projectile", .meaning = "a projectile of the library, or a file with "
      "the options of this group from --nose to --rigid; options given with it override single values. case.toml has "
      "deformable or rigid for one without a name", .source = "deformable: that of --nose and the sizes, of tool steel, paper",
      .brief = "a projectile by name, or your FILE.toml"}, options::Kind::other, "NAME|FILE.toml");
  named.allowed_text = allowed_projectiles();
  named.range = ": " + named.allowed_text;
  named.names = projectile_names();
  named.assign = [&o](const Given &given) {
    const std::string name = projectile_given(given);
    if (!names_projectile(name)) o.rigid = name == "rigid";
    // A nose is no more than the option --nose.
    o.projectile = is_library_projectile(name) || materials::is_material_file(name) ? name : "";
  };
  named.toml = [&o] {
    return options::toml_string(!o.projectile.empty() ? o.projectile : o.rigid ? "rigid" : "deformable");
  };
}

void add_projectile_metal(Table &t, Options &o) {
  Option &metal = options::add_option(t, {.key = "projectile_metal", .meaning = "metal of the projectile, without "
      "damage", .source = "arne_tool_steel: paper"}, options::Kind::text, "NAME|FILE.toml");
  metal.allowed_text = materials::allowed_projectile_metals();
  metal.range = ": " + metal.allowed_text;
  for (const auto &names : {materials::projectile_metal_names(), materials::library_names()})
    metal.names.insert(metal.names.end(), names.begin(), names.end());
  metal.assign = [&o, names = metal.names](const Given &given) {
    const std::string material = line_given(given, materials::allowed_projectile_metals());
    if (!materials::is_material_file(material) && std::find(names.begin(), names.end(), material) == names.end())
      refuse(given, "must be " + materials::allowed_projectile_metals() + options::nearest_text(material, names));
    o.projectile_metal = material;
  };
  metal.toml = [&o] { return options::toml_string(o.projectile_metal); };
}

void add_projectile(Table &t, Options &o) {
  t.group = "Projectile";
  add_projectile_choice(t, o);
  add(t, o.nose, {.key = "nose",
      .meaning = "shape of the nose; 20 mm in diameter and 197 g unless other sizes are given",
      .source = "paper, Fig. 11", .brief = "blunt, conical, ogival, hemispherical, chisel or sphere"});
  add(t, o.diameter_mm, {.key = "diameter_mm", .meaning = "diameter of the shank", .source = "paper",
      .brief = "diameter of the projectile", .limits = {1, 200, "mm"}});
  add(t, o.length_mm, {.key = "length_mm", .meaning = "length from tip to tail",
      .source = "80 blunt, 98 conical, 94.2 ogival, 83.2 hemispherical, 22.6 chisel, 20 sphere, times diameter/20 mm: "
      "paper, ours",
      .limits = {1, 2000, "mm"}});
  add(t, o.nose_length_mm, {.key = "nose_length_mm", .meaning = "length of a conical or ogival nose; depth of a "
      "chisel's inclined flats", .source = "30 conical, 33 ogival, 3.7 chisel, times diameter/20 mm: paper, ours",
      .limits = {0, 1000, "mm"}});
  add(t, o.tip_diameter_mm, {.key = "tip_diameter_mm", .meaning = "diameter of the flat at the tip of a conical or "
      "ogival nose; width of the flat of a chisel",
      .source = "2 conical, 1 ogival, 9.3 chisel, times diameter/20 mm: paper, ours",
      .limits = {0, 200, "mm"}});
  add(t, o.calibre_radius_head, {.key = "calibre_radius_head",
      .meaning = "radius of an ogive over the diameter, in place of --nose-length-mm",
      .source = "none: by the length", .limits = {0, 50, ""}});
  add(t, o.edge_radius_mm, {.key = "edge_radius_mm",
      .meaning = "radius of the edge of a blunt nose, at most twice the particle distance", .source = "0: sharp",
      .limits = {0, 25, "mm"}});
  add(t, o.tail_length_mm, {.key = "tail_length_mm",
      .meaning = "length of a boat tail at the end of the shank; 0: none",
      .source = "ours", .limits = {0, 1000, "mm"}});
  add(t, o.tail_diameter_mm, {.key = "tail_diameter_mm", .meaning = "diameter of the rear end of the boat tail",
      .source = "none", .limits = {0, 200, "mm"}});
  Option &profile = options::add_option(t, {.key = "profile", .meaning = "a projectile that is a body of revolution: "
      "FILE.csv with the columns z_mm,r_mm, distance from the front and radius, from the front to the rear",
      .source = "none", .brief = "a body of revolution: FILE.csv with the columns z_mm,r_mm"},
      options::Kind::other, "FILE.csv");
  profile.allowed_text = "the name of a CSV file";
  profile.range = "";
  profile.assign = [&o](const Given &given) { o.profile = line_given(given, "the name of a CSV file"); };
  profile.toml = [&o] { return o.profile.empty() ? "" : options::toml_string(o.profile); };
  add(t, o.profile_mm, {.key = "profile_mm", .meaning = "z and r in turn of the points of a profile, as case.toml has "
      "them; --profile reads them from a file", .source = "none", .limits = {0, 2000, "mm"}});
  Option &mesh = options::add_option(t, {.key = "projectile_mesh", .meaning = "a projectile that is a mesh of hexes: "
      "nodes and solids of LS-DYNA (.k), Abaqus (.inp) or VTK (.vtu); its axis is z, its tip the end with the smallest "
      "z", .source = "none", .brief = "your own mesh: FILE.k, FILE.inp or FILE.vtu"},
      options::Kind::other, "FILE");
  mesh.allowed_text = allowed_mesh_files();
  mesh.range = "";
  mesh.assign = [&o](const Given &given) {
    const std::string file = line_given(given, allowed_mesh_files());
    if (!is_mesh_file(file)) refuse(given, "must be " + allowed_mesh_files());
    o.projectile_mesh = file;
  };
  mesh.toml = [&o] { return o.projectile_mesh.empty() ? "" : options::toml_string(o.projectile_mesh); };
  add(t, o.mesh_unit, {.key = "mesh_unit", .meaning = "unit of length of the mesh", .source = "ours"});
  add_parts(t, o);
  add(t, o.mass_g, {.key = "mass_g",
      .meaning = "mass of the projectile, set by its density; 0: by the density of its metal",
      .source = "paper", .brief = "mass of the projectile; 0: by the density of its metal", .limits = {0, 1e6, "g"}});
  add_projectile_metal(t, o);
  add(t, o.rigid, {.key = "rigid", .meaning = "the projectile moves and turns as a rigid body",
      .source = "no: paper", .brief = "the projectile does not deform"});
  add(t, o.projectile_erosion, {.key = "projectile_erosion", .meaning = "remove hexes of the projectile that "
      "are too distorted; their mass stays at their nodes. Without it they stop the run",
      .source = "yes: ours"});
  add(t, o.obliquity_deg, {.key = "obliquity_deg",
      .meaning = "angle between the line of flight and the plate's axis; needs --extent half or full",
      .source = "tests", .limits = {0, 60, "deg"}});
  add(t, o.pitch_deg, {.key = "pitch_deg", .meaning = "angle between the projectile's axis and the line of "
      "flight, in the plane of the line of flight and the plate's axis, positive in the sense of the obliquity; needs "
      "--extent half or full",
      .source = "none", .limits = {-45, 45, "deg"}});
  add(t, o.yaw_deg, {.key = "yaw_deg",
      .meaning = "angle of the projectile's axis out of that plane; needs --extent full",
      .source = "none", .limits = {-45, 45, "deg"}});
  add(t, o.velocity_mps, {.key = "velocity_mps", .meaning = "initial velocity", .source = "tests",
      .brief = "initial velocity", .limits = {1, largest_velocity_mps, "m/s"}});
  add(t, o.friction, {.key = "friction", .meaning = "Coulomb friction between plate and projectile",
      .source = "0 blunt and chisel; else 0.02; with paper 0.08 on steel and FILE.toml, 0.02 on aluminium",
      .limits = {0, 2, ""}});
}

void add_discretisation(Table &t, Options &o) {
  t.group = "Discretisation";
  add(t, o.spacing_mm, {.key = "spacing_mm",
      .meaning = "particle distance, at most half the thickness",
      .source = "paper", .brief = "particle distance; time grows with its fourth power",
      .limits = {0.01, 25, "mm"}});
  add(t, o.sph_radius_mm, {.key = "sph_radius_mm",
      .meaning = "radius of the disc of particles in the plate: at least the "
      "projectile's radius and two spacings, less than the clamp radius",
      .source = "paper", .limits = {0.6, 5000, "mm"}});
  add(t, o.extent, {.key = "extent", .meaning = "computed part of the round model", .source = "paper"});
  add(t, o.lattice, {.key = "lattice", .meaning = "arrangement of the particles", .source = "ring, cubic with "
      "--method paper: ours, paper"});
  add(t, o.seed, {.key = "seed", .meaning = "number of a random arrangement: particles are moved by up to 5 % of the "
      "particle distance; 0: the undisturbed lattice", .source = "ours", .limits = {0, largest_seed, ""}});
  add(t, o.form, {.key = "form", .meaning = "gradients of SPH: corrected (renormalised), or as in textbooks (standard)",
      .source = "ours"});
  add(t, o.kernel, {.key = "kernel", .meaning = "kernel of SPH", .source = "ours"});
  add(t, o.smoothing, {.key = "smoothing", .meaning = "smoothing length, constant or following the density",
      .source = "ours"});
  add(t, o.element, {.key = "element", .meaning = "integration of the hexes", .source = "ours"});
  add(t, o.pressure, {.key = "pressure", .meaning = "pressure law", .source = "ours"});
  add(t, o.control_stiffness, {.key = "control_stiffness",
      .meaning = "stiffness of the bonds against zero-energy modes, over the shear modulus; 0: no bonds",
      .source = "0.3, 0 with --method paper: ours, paper", .limits = {0, 2, ""}});
  add(t, o.contact_stiffness, {.key = "contact_stiffness",
      .meaning = "penalty stiffness of the contact, over mass/(time step)^2", .source = "ours",
      .limits = {0.001, 0.5, ""}});
  add(t, o.linear_viscosity, {.key = "linear_viscosity", .meaning = "alpha of the artificial viscosity of SPH",
      .source = "ours", .limits = {0, 2, ""}});
  add(t, o.quadratic_viscosity, {.key = "quadratic_viscosity", .meaning = "beta of the artificial viscosity of SPH",
      .source = "ours", .limits = {0, 5, ""}});
}

void add_run(Table &t, Options &o) {
  t.group = run_group;
  add(t, o.end_us, {.key = "end_us", .meaning = "time at which the run ends",
      .source = "three passages of the projectile at its "
      "initial velocity, six unless blunt, at least 500 or 1500 us times diameter/20 mm; most runs end by themselves: ours", .limits = {1, longest_us, "us"}});
  add(t, o.settle_us, {.key = "settle_us", .meaning = "time for which a run continues after the shot is "
      "decided; dishing_at_rest_mm is the mean over it, as the plate swings", .source = "0: none",
      .limits = {0, longest_us, "us"}});
  add(t, o.out, {.key = "out", .meaning = "folder for the results",
      .source = "vtk_out/MATERIAL_MODEL_NOSE_THICKNESSmm_VELOCITYmps and every option that differs from its "
      "default: ours", .brief = "folder for the results"});
  add(t, o.output_every_us, {.key = "output_every_us", .meaning = "time between two frames", .source = "ours",
      .limits = {0.5, longest_us, "us"}});
  add(t, o.checkpoint_every_us, {.key = "checkpoint_every_us",
      .meaning = "time between two checkpoints, from which --restart resumes; 0: one every 15 minutes of work. "
      "Ctrl-C (SIGINT), SIGTERM and SIGHUP write one in any case", .source = "ours", .limits = {0, longest_us, "us"}});
  add(t, o.vtk, {.key = "vtk", .meaning = "write VTK files", .source = "ours"});
  add(t, o.picture, {.key = "picture", .meaning = "draw the section picture", .source = "ours"});
  add(t, o.quiet, {.key = "quiet", .meaning = "no progress on the terminal", .source = "ours"});
  add(t, o.threads, {.key = "threads", .meaning = "OpenMP threads",
      .source = "all: OMP_NUM_THREADS or the number of cores", .brief = "threads",
      .limits = {1, most_threads(), ""}});
}
// clang-format on

} // namespace

options::Table table_of(Options &o) {
  Table t;
  add_plate(t, o);
  add_projectile(t, o);
  add_discretisation(t, o);
  add_run(t, o);
  return t;
}

} // namespace shot
