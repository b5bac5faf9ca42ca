// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"
#include "keeper.hpp"
#include "progress.hpp"
#include "result.hpp"
#include "signals.hpp"
#include "to_case.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/mesh/mesh_check.hpp"
#include "ogive/sim/hash.hpp"

#include <algorithm>
#include <cmath>

namespace shot {

namespace {

using AnyLaw = ogive::AnyFlowLaw<double>;
using Metals = std::vector<ogive::Metal<double, AnyLaw>>;

/// Samples of the flight between two searches for the particle deepest inside the projectile, which cost as much as
/// some steps: 10 us for 20 mm.
constexpr std::size_t samples_per_intrusion = 20;

template <class Law, class Rule>
BodySizes sizes_of(const ogive::HexBody<double, Law, Rule> &body, const ogive::Nodes<double> &nodes) {
  ogive::HexMesh<double> mesh;
  mesh.positions.assign(nodes.position.begin() + body.nodes.begin, nodes.position.begin() + body.nodes.end);
  mesh.hexes = body.hexes;
  for (auto &hex : mesh.hexes)
    for (ogive::Index &n : hex) n -= body.nodes.begin;
  const auto q = ogive::mesh_quality(mesh);
  return {.hexes = static_cast<long>(body.hexes.size()),
          .volume_mm3 = ogive::volume(mesh) * 1e9,
          .shortest_mm = q.shortest_edge * 1e3,
          .longest_mm = q.longest_edge * 1e3,
          .largest_aspect = q.largest_aspect,
          .smallest_scaled_jacobian = q.smallest_scaled_jacobian};
}

/// Numbers, sizes and masses of the projectile's mesh and the plate's particles.
template <class M> Sizes sizes_of(const M &model) {
  Sizes s;
  const ogive::NodeRange shot = ogive::projectile_nodes(model);
  for (const auto &rim : model.bodies.plate_hexes) s.hexes += static_cast<long>(rim.hexes.size());
  for (const auto &disc : model.bodies.plate_particles) s.particles += disc.points.size();
  s.spacing_mm = ogive::plate_particles(model).spacing * 1e3;
  s.projectile_mass_g = ogive::projectile_mass(model) * 1e3;
  s.projectile_jacobian = 1;
  for (const auto &part : model.bodies.projectile) {
    const BodySizes own = sizes_of(part, model.nodes);
    s.hexes += own.hexes;
    s.projectile_volume_mm3 += own.volume_mm3 * model.symmetry.copies();
    s.projectile_jacobian = std::min(s.projectile_jacobian, own.smallest_scaled_jacobian);
    if (model.bodies.projectile.size() > 1)
      s.part_masses_g.emplace_back(part.name, ogive::whole_mass(part.point_mass, model.symmetry) * 1e3);
  }
  double nodal = 0;
  for (ogive::Index n = shot.begin; n < shot.end; ++n) nodal += model.nodes.mass[n];
  s.added_mass_g = nodal * model.symmetry.copies() * 1e3 - s.projectile_mass_g;
  s.time_step_us = ogive::stable_time_step(model) * 1e6;
  return s;
}

/// The parts of a projectile whose parts touch, at the end; none if they are tied.
template <class M> std::vector<PartResult> parts_of(const M &model, const ogive::Flight<double> &flight) {
  std::vector<PartResult> all;
  if (!ogive::parts_touch(model)) return all;
  for (std::size_t k = 0; k < model.bodies.projectile.size(); ++k) {
    const auto &part = ogive::projectile(model, k);
    const ogive::Vec3<double> velocity = ogive::mean_velocity(model.nodes, ogive::nodes_of_part(model, k));
    all.push_back({part.name.substr(part.name.find('_') + 1), ogive::whole_mass(part.point_mass, model.symmetry) * 1e3,
                   velocity.dot(flight.direction), k == ogive::main_part(model)});
  }
  return all;
}

/// Restores model, run, shot and course from the checkpoint of the options. Throws SetupError.
template <class M>
void restore(const Options &options, M &model, ogive::RunState<double> &state, Result &shot, Course &course) {
  const auto checkpoint = ogive::read_checkpoint(options.restart->file);
  read_notes(checkpoint, shot, course);
  ogive::restore(checkpoint, model, state);
  // The plate's swing counts from the decision, or from the end of the time, which may be later now.
  if (shot.flight.state == ogive::FlightState::in_progress) shot.swing = {};
  course.next_frame_us += options.output_every_us - course.frame_interval_us;
  course.frame_interval_us = options.output_every_us;
}

/// Samples the model into shot, course and history.csv.
template <class M>
void take_sample(const M &now, const ogive::Energy<double> &e, const ogive::PerforationCase<double> &c,
                 const std::vector<double> &axial_places, Result &shot, Course &course, Files &files) {
  const auto sample = ogive::observe_flight(now, c.projectile, shot.flight);
  shot.motion = ogive::motion_of(now, c, axial_places);
  ogive::record(shot.flight, sample, [&] { return ogive::find_way(now, shot.flight); });
  const double momentum = -ogive::momentum(now)[2], impulse = -now.support_impulse[2] * now.symmetry.copies();
  if (shot.flight.samples.size() == 1) course.first_energy = total(e), course.first_momentum = momentum;
  shot.hourglass_fraction = e.hourglass / course.first_energy;
  const double error = std::abs(total(e) / course.first_energy - 1);
  if (!(error <= shot.energy_error)) shot.energy_error = error;
  shot.momentum_error =
      std::max(shot.momentum_error, std::abs(momentum - course.first_momentum - impulse) / course.first_momentum);
  const auto row = {now.time * 1e6,
                    sample.velocity,
                    sample.nose * 1e3,
                    sample.tail * 1e3,
                    e.kinetic,
                    e.elastic,
                    e.plastic,
                    e.hourglass,
                    e.viscous,
                    e.contact,
                    e.friction,
                    total(e),
                    momentum,
                    impulse,
                    shot.motion.speed,
                    in_degrees(shot.motion.deflection),
                    in_degrees(shot.motion.turn),
                    shot.motion.spin.norm()};
  ogive::add_row(files.history, row);
  course.history.insert(course.history.end(), row.begin(), row.end());
}

/// Adds a sample of the plate's dishing to its swing (trapezoidal rule).
void add_sample(Swing &swing, double time_us, double dishing_mm) {
  if (swing.begun_us < 0)
    swing.begun_us = time_us;
  else
    swing.integral_mm_us += 0.5 * (time_us - swing.until_us) * (swing.dishing_mm + dishing_mm);
  swing.until_us = time_us;
  swing.dishing_mm = dishing_mm;
}

/// "weldox_460e", or "weldox_460e + aa5083_h116".
std::string name_of(const Metals &plates) {
  std::string names = plates.front().name;
  const bool same = std::all_of(plates.begin(), plates.end(), [&](const auto &p) { return p.name == names; });
  for (std::size_t k = 1; k < plates.size() && !same; ++k) names += " + " + plates[k].name;
  return names;
}

/// Kernel, form and rule of the options.
ogive::AnyDiscretisation discretisation_of(const Options &o) {
  ogive::AnyDiscretisation parts;
  if (o.kernel == SphKernel::wendland_c2) parts.kernel = ogive::WendlandC2{};
  if (o.form == SphForm::standard) parts.form = ogive::StandardForm{};
  if (o.element == ElementRule::selective_reduced) parts.rule = ogive::SelectiveReduced{};
  return parts;
}

ogive::PerforationOptions<double> numerics_of(const Options &options) {
  auto numerics = ogive::choices_of<double>(options.method).numerics;
  numerics.sph.control.stiffness = options.control_stiffness;
  numerics.sph.damage_pressure = options.damage_pressure;
  numerics.contact_stiffness = options.contact_stiffness;
  numerics.sph.linear_viscosity = options.linear_viscosity;
  numerics.sph.quadratic_viscosity = options.quadratic_viscosity;
  numerics.sph.variable_smoothing = options.smoothing == Smoothing::variable;
  return numerics;
}

/// The metals with one type of law.
Metals metals_of(const Plates &plates) {
  Metals metals;
  for (const auto &any : plates)
    std::visit([&](const auto &metal) { metals.push_back(ogive::with_law<AnyLaw>(metal)); }, any);
  return metals;
}

/// The model of a case.
auto model_of(const Options &options, const ogive::PerforationCase<double> &c, const Metals &plates) {
  return ogive::make_perforation(c, plates, metals_of(projectile_metals_of(options)), numerics_of(options),
                                 discretisation_of(options));
}

/// Nodes of a body that it has something at.
template <class Law, class Rule> long nodes_of(const ogive::HexBody<double, Law, Rule> &body) {
  const auto &begin = body.corners_of_nodes.begin;
  long nodes = 0;
  for (std::size_t n = 0; n + 1 < begin.size(); ++n) nodes += begin[n] < begin[n + 1];
  return nodes;
}
template <class Law, class Kernel, class Form> long nodes_of(const ogive::SphBody<double, Law, Kernel, Form> &body) {
  return body.nodes.size();
}

template <class Law, class Kernel, class Form>
BodySizes sizes_of(const ogive::SphBody<double, Law, Kernel, Form> &body, const ogive::Nodes<double> &) {
  return {.shortest_mm = body.spacing * 1e3, .longest_mm = body.spacing * 1e3};
}

} // namespace

std::vector<BodySizes> write_model(const Options &options, const Plates &plates) {
  const auto model = model_of(options, to_case(options), metals_of(plates));
  auto series = ogive::open_series(options.out, "mesh");
  ogive::add_frame(series, ogive::gather_frame(model));
  std::vector<BodySizes> all;
  for_each_body(model, [&](const auto &body) {
    BodySizes sizes = sizes_of(body, model.nodes);
    sizes.name = body.name;
    sizes.nodes = nodes_of(body);
    sizes.mass_g = ogive::whole_mass(body.point_mass, model.symmetry) * 1e3;
    sizes.volume_mm3 *= model.symmetry.copies();
    sizes.time_step_us = ogive::stable_time_step(body, model.nodes) * 1e6;
    all.push_back(sizes);
  });
  return all;
}

Result run_model(const Options &options, const Plates &metals) {
  const Metals plates = metals_of(metals);
  const auto c = to_case(options);
  auto model = model_of(options, c, plates);
  const auto &shape = c.projectile;
  std::vector<std::vector<ogive::Vec3<double>>> undeformed;
  for (std::size_t k = 0; k < plates.size(); ++k) undeformed.push_back(ogive::plate_positions(model, k));

  const auto axial_places = ogive::axial_places(model, c);

  Result shot;
  shot.material = name_of(plates);
  shot.sizes = sizes_of(model);
  shot.flight = ogive::start_flight(c, model);
  shot.symmetry = model.symmetry;
  Course course;
  course.frame_interval_us = options.output_every_us;
  ogive::RunState<double> state;
  if (options.restart) restore(options, model, state, shot, course);
  announce(options, shot);
  start_results(options, metals);
  Files files = open_files(options, course);
  Progress progress{.quiet = options.quiet, .before_s = course.wall_s, .cpu_before_s = course.cpu_s};
  Keeper keeper = start_keeper(options, model.time * 1e6, course.wall_s);

  const auto writing = [&](auto &&write) {
    const double before = elapsed_s(progress);
    write();
    course.writing_s += elapsed_s(progress) - before;
  };
  const auto write_frame = [&] {
    if (options.vtk) writing([&] { add_frame(files, course, ogive::gather_frame(model)); });
    course.last_frame_us = model.time * 1e6;
  };
  const double last_us = options.end_us + options.settle_us;
  const auto observe = [&](const auto &now, const ogive::Energy<double> &e) {
    take_sample(now, e, c, axial_places, shot, course, files);
    if (shot.flight.samples.size() % samples_per_intrusion == 0)
      shot.intrusion_mm = std::max(shot.intrusion_mm, ogive::largest_intrusion(now) * 1e3);
    if (now.time * 1e6 >= course.next_frame_us) {
      write_frame();
      course.next_frame_us += options.output_every_us;
    }
    const double time_us = now.time * 1e6;
    show(progress, time_us, last_us, shot.flight.samples.back().velocity, now.steps);
    const bool in_progress = shot.flight.state == ogive::FlightState::in_progress;
    if (options.settle_us == 0 || (in_progress && time_us < options.end_us * (1 - 1e-12))) return in_progress;
    add_sample(shot.swing, time_us, ogive::dishing_of(now, undeformed.front(), shape.diameter / 2) * 1e3);
    return time_us - shot.swing.begun_us < options.settle_us;
  };
  ogive::RunOptions<double> run_options;
  run_options.end_time = last_us * 1e-6;
  // A small projectile is through in a few microseconds.
  run_options.observe_every *= std::min(1.0, shape.diameter / 20e-3);
  const auto pause = [&](const auto &now, const auto &run) {
    shot.interrupted_by = caught_signal();
    course.wall_s = elapsed_s(progress);
    // At the end of the time too, so that the run can resume with a later one.
    const bool undecided = shot.flight.state == ogive::FlightState::in_progress;
    const bool at_end =
        (options.checkpoint_every_us > 0 || undecided) && now.time >= run_options.end_time * (1 - 1e-12);
    if (is_due(keeper, now.time * 1e6, course.wall_s) || at_end || shot.interrupted_by != 0)
      writing([&] {
        course.cpu_s = cpu_s(progress);
        ogive::write_checkpoint(options.out / checkpoint_name, now, run,
                                notes_of(options, metals, shot, course, now.time * 1e6));
      });
    return shot.interrupted_by != 0;
  };
  const auto result = ogive::run(model, run_options, state, observe, pause);
  shot.loop_s = elapsed_s(progress) - course.writing_s;
  if (course.last_frame_us < model.time * 1e6) write_frame();
  show(progress, model.time * 1e6, last_us, shot.flight.samples.back().velocity, model.steps, true);

  shot.fault = result.fault;
  shot.wall_s = elapsed_s(progress);
  shot.cpu_s = cpu_s(progress);
  shot.steps = model.steps;
  shot.simulated_us = model.time * 1e6;
  shot.way = ogive::find_way(model, shot.flight);
  shot.intrusion_mm = std::max(shot.intrusion_mm, ogive::largest_intrusion(model) * 1e3);
  shot.fragments = ogive::find_fragments(model);
  shot.parts = parts_of(model, shot.flight);
  const auto removed = ogive::removed_hexes(model);
  shot.removed_hexes = removed.count;
  shot.removed_mass_g = removed.mass * model.symmetry.copies() * 1e3;
  for (std::size_t k = 0; k < plates.size(); ++k)
    shot.layers.push_back({plates[k].name, ogive::find_fragments_of(model, k),
                           ogive::plate_shape(model, undeformed[k], shape.diameter / 2, ogive::layers_of(c)[k], k)});
  shot.state_hash = ogive::state_hash(model);
  shot.times = model.times;
  shot.last_frame = ogive::gather_frame(model);
  return shot;
}

} // namespace shot
