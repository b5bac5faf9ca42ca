#pragma once

#include "progress.hpp"
#include "shot.hpp"

#include "ogive/io/csv.hpp"
#include "ogive/io/vtk.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/sim/hash.hpp"

#include <chrono>
#include <cmath>

namespace perforate {

/// The case of the options in SI units.
inline ogive::PerforationCase<double> to_case(const Options &o) {
  ogive::PerforationCase<double> c;
  c.thickness = o.thickness_mm * 1e-3;
  c.clamp_radius = o.clamp_radius_mm * 1e-3;
  c.sph_radius = o.sph_radius_mm * 1e-3;
  c.spacing = o.spacing_mm * 1e-3;
  c.lattice = o.lattice;
  c.nose = o.nose;
  c.initial_velocity = o.velocity_mps;
  c.friction = o.friction;
  c.rigid_projectile = o.projectile == ProjectileKind::rigid;
  c.extent = o.extent;
  return c;
}

/// What the projectile's mesh and the plate's particles amount to.
template <class M> Sizes sizes_of(const M &model) {
  Sizes s;
  const auto &particles = ogive::disc(model);
  const auto &shot = ogive::projectile(model);
  s.particles = particles.points.size();
  s.hexes = static_cast<long>(ogive::rim(model).hexes.size() + shot.hexes.size());
  s.spacing_mm = particles.spacing * 1e3;
  s.plate_disc_mass_g = ogive::whole_mass(particles.point_mass, model.symmetry) * 1e3;
  s.projectile_mass_g = ogive::whole_mass(shot.point_mass, model.symmetry) * 1e3;
  double nodal = 0;
  for (ogive::Index n = shot.nodes.begin; n < shot.nodes.end; ++n) nodal += model.nodes.mass[n];
  s.added_mass_g = nodal * model.symmetry.copies() * 1e3 - s.projectile_mass_g;
  s.time_step_us = ogive::stable_time_step(model) * 1e6;
  return s;
}

/// Writes material.toml and case.toml and removes the results of an earlier run from the folder. A material file that
/// the user has there under that name is left as it is. Throws WriteError.
void start_results(const Options &options, const material_file::AnyMetal &plate);

/// Prints what is about to be computed.
void announce(const Options &options, const Shot &shot);

/// Runs a case with the kernel, form and hexes chosen at compile time.
template <class Kernel, class Form, class Rule, class Law>
Shot shoot_with(const Options &options, const ogive::Metal<double, Law> &plate) {
  ogive::PerforationOptions<double> numerics;
  numerics.sph.variable_smoothing = options.smoothing == Smoothing::variable;
  const auto c = to_case(options);
  auto model =
      ogive::make_perforation<Kernel, Form, Rule>(c, plate, ogive::library::arne_tool_steel<double>(), numerics);
  const auto shape = ogive::paper_projectile<double>(options.nose);
  const auto undeformed = ogive::disc_positions(model);

  Shot shot;
  shot.material = plate.name;
  shot.sizes = sizes_of(model);
  shot.flight = ogive::start_flight(c);
  shot.symmetry = model.symmetry;
  announce(options, shot);
  start_results(options, plate);

  auto history = ogive::open_csv(options.out / "history.csv",
                                 {"time_us", "velocity_m_per_s", "nose_depth_mm", "tail_depth_mm", "kinetic_J",
                                  "elastic_J", "plastic_J", "hourglass_J", "viscous_J", "contact_J", "friction_J",
                                  "external_J", "total_J", "momentum_N_s", "support_impulse_N_s"});
  auto series = ogive::open_series(options.out, "perforation");
  Progress progress{.quiet = options.quiet};
  double first_energy = 0, first_momentum = 0, next_frame_us = 0, writing_s = 0;
  const auto write_frame = [&] {
    if (!options.vtk) return;
    const double before = elapsed_s(progress);
    ogive::add_frame(series, ogive::gather_frame(model));
    writing_s += elapsed_s(progress) - before;
  };

  ogive::RunOptions<double> run_options;
  run_options.end_time = options.end_us * 1e-6;
  double last_frame_us = -1;
  const auto result = ogive::run(model, run_options, [&](const auto &now, const ogive::Energy<double> &e) {
    const auto sample = ogive::observe_flight(now, shape);
    ogive::record(shot.flight, sample, [&] { return ogive::is_plug_loose(now); });
    const double momentum = -ogive::momentum(now)[2], time_us = now.time * 1e6;
    const double impulse = -now.support_impulse[2] * now.symmetry.copies();
    if (shot.flight.samples.size() == 1) first_energy = total(e), first_momentum = momentum;
    shot.hourglass_fraction = e.hourglass / first_energy;
    const double error = std::abs(total(e) / first_energy - 1);
    if (!(error <= shot.energy_error)) shot.energy_error = error;
    shot.momentum_error = std::max(shot.momentum_error, std::abs(momentum - first_momentum - impulse) / first_momentum);
    ogive::add_row(history,
                   {time_us, sample.velocity, sample.nose * 1e3, sample.tail * 1e3, e.kinetic, e.elastic, e.plastic,
                    e.hourglass, e.viscous, e.contact, e.friction, e.external, total(e), momentum, impulse});
    if (time_us >= next_frame_us) {
      write_frame();
      shot.intrusion_mm = std::max(shot.intrusion_mm, ogive::largest_intrusion(now) * 1e3);
      last_frame_us = time_us;
      next_frame_us += options.output_every_us;
    }
    show(progress, time_us, options.end_us, sample.velocity, now.steps);
    return shot.flight.state == ogive::FlightState::in_progress;
  });
  shot.loop_s = elapsed_s(progress) - writing_s;
  if (last_frame_us < model.time * 1e6) write_frame();
  show(progress, model.time * 1e6, options.end_us, shot.flight.samples.back().velocity, model.steps, true);

  shot.reason = result.reason;
  shot.fault = result.fault;
  shot.wall_s = elapsed_s(progress);
  shot.steps = model.steps;
  shot.simulated_us = model.time * 1e6;
  shot.fragments = ogive::find_fragments(model);
  shot.shape = ogive::plate_shape(model, undeformed, shape.diameter / 2, c.thickness);
  shot.state_hash = ogive::state_hash(model);
  shot.times = model.times;
  shot.last_frame = ogive::gather_frame(model);
  return shot;
}

/// Runs a case: the choices of kernel, form and hexes become types here.
template <class Law> Shot shoot_metal(const Options &o, const ogive::Metal<double, Law> &plate) {
  const auto with_rule = [&]<class Kernel, class Form>() {
    return o.element == ElementRule::one_point ? shoot_with<Kernel, Form, ogive::OnePoint>(o, plate)
                                               : shoot_with<Kernel, Form, ogive::SelectiveReduced>(o, plate);
  };
  const auto with_form = [&]<class Kernel>() {
    return o.form == SphForm::renormalised ? with_rule.template operator()<Kernel, ogive::RenormalisedForm>()
                                           : with_rule.template operator()<Kernel, ogive::StandardForm>();
  };
  return o.kernel == SphKernel::cubic_spline ? with_form.template operator()<ogive::CubicSpline>()
                                             : with_form.template operator()<ogive::WendlandC2>();
}

} // namespace perforate
