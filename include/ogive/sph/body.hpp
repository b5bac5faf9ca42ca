// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/choice.hpp"
#include "ogive/core/extremes.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/core/types.hpp"
#include "ogive/material/shear_band.hpp"
#include "ogive/search/build_neighbours.hpp"
#include "ogive/sph/bonds.hpp"
#include "ogive/sph/kernel.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// A body of particles. It has two numberings:
///
///     particle i   0 ... n-1, never changes; node nodes.begin + i, material point i, end of a bond
///     place k      order in memory of what neighbours read, made anew with the lists:
///
///                  | cluster 0  | cluster 1  | ...      | mirror images of clusters    |
///                  | four places each, near ones together | order.size() + 4 g           |
///                    order[k] is the particle at place k  images[g] has their cluster
///
/// The way of the data through a step; by particle on the left, by place on the right:
///
///     nodes: x, v; points: density, ...   -- prepare() -->              pair_data: x, v, volume, ...; lists
///     points: velocity_gradient           <-- velocity_gradient() --    pair_data, lists
///                                                                       writes B to pair_data.flux, lists.within
///     points: stress, ...                 -- update_stress(), each particle alone
///     points: stress                      -- add_internal_force() -->   pair_data.flux, in the place of B
///     nodes: force                        <-- add_internal_force() --   pair_data, lists.within

namespace ogive {

/// Positions, velocities and volumes of the four places of a cluster. In single precision: sums over neighbours are
/// exact to about 1e-6 of their largest term, and pairs are equal and opposite.
struct alignas(64) ClusterMotion {
  /// One number for each place.
  template <class N> using Places = std::array<N, cluster_size>;
  std::array<Places<std::int32_t>, 3> x; ///< position in quanta of the neighbour lists
  std::array<Places<float>, 3> v;        ///< m/s
  Places<float> volume;                  ///< m3; 0 for fillers
  Places<float> density;                 ///< kg/m3
};

/// Corrected stress G = sigma B times the volume at the four places of a cluster, row first, N m; until the stress of
/// the step is known, the correction B alone.
using ClusterFlux = std::array<std::array<float, cluster_size>, 9>;

/// The data of particles and their mirror images that their neighbours read.
struct PairData {
  std::vector<ClusterMotion> motion; ///< by clusters
  std::vector<ClusterFlux> flux;     ///< by clusters
  std::vector<float> pressure;       ///< Pa, by places; used where damage follows that of the neighbours only
  std::vector<float> smoothing;      ///< in quanta, by places; used with variable smoothing length only
};

/// The renormalised symmetric form: gradients corrected so that linear fields are exact, forces their transpose
/// (Randles & Libersky 1996; Bonet & Lok 1999).
struct RenormalisedForm {
  static constexpr bool corrected = true; ///< B = M^-1
};

/// The standard symmetric form without correction.
struct StandardForm {
  static constexpr bool corrected = false; ///< B = I
};

/// A form that is chosen when the program runs.
using AnyForm = std::variant<RenormalisedForm, StandardForm>;

/// Whose pressure the damage of a particle follows.
enum class DamagePressure {
  own,       ///< its own, which alternates from neighbour to neighbour where particles flow
  neighbours ///< the mean over its neighbours and itself, in which that cancels; failed ones count with what they bear
};

/// Numerical parameters of particles; the defaults are frozen for all cases.
template <class T> struct SphOptions {
  T smoothing_ratio = T(1.2);       ///< h over the particle distance
  T linear_viscosity = T(0.06);     ///< Monaghan's alpha
  T quadratic_viscosity = T(1.5);   ///< Monaghan's beta
  bool variable_smoothing = false;  ///< h follows the density: h = h0 (rho0/rho)^(1/3), at most 1.3 h0
  T skin_ratio = T(0.25);           ///< reach of the neighbour lists beyond the support, over the particle distance
  ZeroEnergyControl<T> control{};   ///< off
  DamagePressure damage_pressure{}; ///< whose pressure damage follows: its own
  T largest_strain = T(0.05);       ///< of a particle in a step
  T courant = T(0.5);               ///< time step = courant * particle distance / longitudinal sound speed
};

/// A body of SPH particles: node `nodes.begin + i` is particle i and its own material point i.
template <class T, class Law, class Kernel_ = CubicSpline, class Form_ = RenormalisedForm, class Width = SimdWidth>
struct SphBody {
  /// Number type.
  using Scalar = T;
  /// Smoothing kernel, or a variant of them.
  using Kernel = Kernel_;
  /// RenormalisedForm, StandardForm or AnyForm.
  using Form = Form_;
  std::string name;              ///< for messages and files
  Metal<T, Law> metal;           ///< the same in all particles
  Kernel kernel{};               ///< the same for all particles
  Form form{};                   ///< of gradients and forces
  SphOptions<T> options{};       ///< numerical parameters
  SymmetryPlanes symmetry{};     ///< mirror planes
  T spacing{};                   ///< particle distance, m
  NodeRange nodes{};             ///< one for each particle
  MaterialPoints<T> points;      ///< state of the metal
  std::vector<T> point_mass;     ///< kg, constant
  std::vector<T> viscous_energy; ///< J, work of artificial viscosity: each particle's half of its pairs
  Neighbours<T> neighbours;      ///< lists, made anew when particles have moved
  PairData pair_data;            ///< that neighbours read, made anew in each step
  Bonds<T> bonds;                ///< against zero-energy modes; none unless the options have a stiffness for them
};

/// Whether a type is an SphBody.
template <class Body> inline constexpr bool is_sph_body = false;
/// True for SphBody.
template <class T, class Law, class K, class F> inline constexpr bool is_sph_body<SphBody<T, Law, K, F>> = true;

/// A body of particles, constant or not.
template <class Body>
concept BodyOfParticles = is_sph_body<std::remove_const_t<Body>>;

/// Particles that fill a shape: positions in m, and the volume of each in m3.
template <class T> struct ParticleLayout {
  T spacing{};                    ///< m
  std::vector<Vec3<T>> positions; ///< m
  std::vector<T> volumes;         ///< m3
};

/// Adds the particles of `layout` as nodes of mass density * volume. Throws SetupError if there are none, or if
/// spacing, volumes or the metal's constants are not positive.
template <class Kernel = CubicSpline, class Form = RenormalisedForm, class T, class Law>
SphBody<T, Law, Kernel, Form> add_sph_body(Nodes<T> &nodes, const ParticleLayout<T> &layout, const Metal<T, Law> &metal,
                                           std::string name, SymmetryPlanes symmetry = {}, SphOptions<T> options = {},
                                           Kernel kernel = {}, Form form = {}) {
  check(metal);
  require(!layout.positions.empty(), name + " particles", 0, "there must be at least one");
  require(layout.spacing > T(0), name + " spacing (m)", layout.spacing, "must be positive");
  require(layout.volumes.size() == layout.positions.size(), name + " volumes", layout.volumes.size(),
          "there must be one for each particle");
  SphBody<T, Law, Kernel, Form> body;
  body.name = std::move(name);
  body.metal = with_shear_bands(metal, layout.spacing);
  body.kernel = kernel;
  body.form = form;
  body.options = options;
  body.symmetry = symmetry;
  body.spacing = layout.spacing;
  body.nodes = add_nodes(nodes, layout.positions);
  body.point_mass.reserve(layout.volumes.size());
  for (Index i = 0; i < body.nodes.size(); ++i) {
    require(layout.volumes[i] > T(0), body.name + " particle volume (m3)", layout.volumes[i], "must be positive");
    body.point_mass.push_back(metal.density * layout.volumes[i]);
    nodes.mass[body.nodes.begin + i] = body.point_mass[i];
  }
  fill(body.points, body.nodes.size(), initial_point(metal));
  if (options.damage_pressure == DamagePressure::neighbours)
    body.points.neighbour_pressure.assign(body.nodes.size(), T(0));
  if (has_bands(body.metal.shear_band)) {
    body.points.shear_strain.assign(body.nodes.size(), T(0));
    body.points.band_age.assign(body.nodes.size(), T(0));
  }
  body.viscous_energy.assign(body.nodes.size(), T(0));
  if (const ZeroEnergyControl<T> &control = options.control; control.stiffness > T(0))
    body.bonds = make_bonds<T>(layout.positions, symmetry, control.reach * layout.spacing);
  return body;
}

/// True if the gradients of the body are corrected.
template <class T, class Law, class K, class F> bool is_corrected(const SphBody<T, Law, K, F> &body) {
  return with_choice(body.form, [](auto form) { return form.corrected; });
}

/// Smoothing length of the undeformed body, m.
template <class Body> auto reference_smoothing_length(const Body &body) {
  return body.options.smoothing_ratio * body.spacing;
}

/// True if particle i has failed and has been removed. It has no neighbours.
template <class T, class Law, class K, class F> bool is_removed(const SphBody<T, Law, K, F> &body, Index i) {
  return is_removed(body.metal.damage, body.points.damage[i]);
}

/// True if the `n`-th node of the body belongs to nothing but removed material.
template <class T, class Law, class K, class F> bool is_node_removed(const SphBody<T, Law, K, F> &body, Index n) {
  return is_removed(body, n);
}

/// Volume of particle i in sums over neighbours, m3: mass over density. A removed particle has none; a failed one at
/// most that of its undeformed metal, because what opens around it is void.
template <class T, class Law, class K, class F> T kernel_volume(const SphBody<T, Law, K, F> &body, Index i) {
  const Damage<T> &damage = body.metal.damage;
  const T D = body.points.damage[i], density = body.points.density[i];
  if (is_removed(damage, D)) return T(0);
  return body.point_mass[i] / (is_failed(damage, D) ? std::max(density, body.metal.density) : density);
}

/// Square of how fast particle i strains, 1/s2; 0 for a removed one.
template <class T, class Law, class K, class F> T squared_strain_rate(const SphBody<T, Law, K, F> &body, Index i) {
  return is_removed(body, i) ? T(0) : full(symmetric_part(body.points.velocity_gradient[i])).squaredNorm();
}

/// Stable time step, s: courant * spacing / sound speed, or what strains no particle by more than `largest_strain` if
/// that is shorter; a variable smoothing length shortens the former with its smallest value.
template <class T, class Law, class K, class F>
T stable_time_step(const SphBody<T, Law, K, F> &body, const Nodes<T> &) {
  T shortest = T(1);
  if (body.options.variable_smoothing)
    shortest = parallel_min(body.points.size(), T(1),
                            [&](Index i) { return std::cbrt(body.metal.density / body.points.density[i]); });
  // Debris that flies past each other at high speed would otherwise change its density by half in a step.
  const T fastest = parallel_max(body.points.size(), T(0), [&](Index i) { return squared_strain_rate(body, i); });
  const T of_waves = body.options.courant * shortest * body.spacing / sound_speed(body.metal);
  return least(of_waves, body.options.largest_strain / std::sqrt(std::max(fastest, std::numeric_limits<T>::min())));
}

/// The first of the particles that strain fastest: all else that the stable step depends on hardly changes.
template <class T, class Law, class K, class F>
Index shortest_step_at(const SphBody<T, Law, K, F> &body, const Nodes<T> &) {
  const Index count = body.points.size();
  const T fastest = parallel_max(count, T(0), [&](Index i) { return squared_strain_rate(body, i); });
  return parallel_min(count, count, [&](Index i) {
    const T squared = squared_strain_rate(body, i);
    return squared >= fastest || is_nan(squared) ? i : count;
  });
}

/// Work of the stresses since the start, J.
template <class T, class Law, class K, class F> T internal_energy(const SphBody<T, Law, K, F> &body) {
  return ordered_sum(body.points.size(), T(0),
                     [&](Index i) { return body.point_mass[i] * body.points.internal_energy[i]; });
}

/// Work of artificial viscosity since the start, J.
template <class T, class Law, class K, class F> T viscous_energy(const SphBody<T, Law, K, F> &body) {
  return ordered_sum(body.points.size(), T(0), [&](Index i) { return body.viscous_energy[i]; });
}

/// Work taken by the control of zero-energy modes since the start, J.
template <class T, class Law, class K, class F> T hourglass_energy(const SphBody<T, Law, K, F> &body) {
  return ordered_sum(static_cast<Index>(body.bonds.energy.size()), T(0), [&](Index i) { return body.bonds.energy[i]; });
}

} // namespace ogive
