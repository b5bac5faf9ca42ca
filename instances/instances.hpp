// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/checkpoint.hpp"
#include "ogive/io/frame.hpp"
#include "ogive/ogive.hpp"

/// \file
/// Lists of templates that many files use in the same types. Compiled once in a library and declared here, they are not
/// compiled again in each of those files; where this header is not included, they are. In each list `extern_` is
/// `extern` for the declarations and empty where they are compiled.

/// The functions of a type of particles.
#define OGIVE_PARTICLES(extern_, ...)                                                                                  \
  extern_ template void update_stress(__VA_ARGS__ &, double);                                                          \
  extern_ template void add_internal_force(__VA_ARGS__ &, Nodes<double> &, double);                                    \
  extern_ template void update_body(__VA_ARGS__ &, Nodes<double> &, double, Lap &);                                    \
  extern_ template double stable_time_step(const __VA_ARGS__ &, const Nodes<double> &);                                \
  extern_ template Index shortest_step_at(const __VA_ARGS__ &, const Nodes<double> &);                                 \
  extern_ template double elastic_energy<double>(const __VA_ARGS__ &);                                                 \
  extern_ template double internal_energy(const __VA_ARGS__ &);                                                        \
  extern_ template double viscous_energy(const __VA_ARGS__ &);                                                         \
  extern_ template double hourglass_energy(const __VA_ARGS__ &);                                                       \
  extern_ template void add_body(Fingerprint &, const __VA_ARGS__ &);                                                  \
  extern_ template void release_removed(NodeToSurface<double> &, const __VA_ARGS__ &);                                 \
  extern_ template void release_removed(ParticleContact<double> &, const __VA_ARGS__ &);                               \
  extern_ template void prepare(__VA_ARGS__ &, const Nodes<double> &);                                                 \
  extern_ template void velocity_gradient(__VA_ARGS__ &);                                                              \
  extern_ template void build_lists(__VA_ARGS__ &, std::span<const Vec3<double>>, double);                             \
  extern_ template void gather_body(Frame &, const Nodes<double> &, const __VA_ARGS__ &, int);

/// The functions of a type of hexes.
#define OGIVE_HEXES(extern_, ...)                                                                                      \
  extern_ template void update_stress(__VA_ARGS__ &, double);                                                          \
  extern_ template void add_internal_force(__VA_ARGS__ &, Nodes<double> &, double);                                    \
  extern_ template void update_body(__VA_ARGS__ &, Nodes<double> &, double, Lap &);                                    \
  extern_ template double stable_time_step(const __VA_ARGS__ &, const Nodes<double> &);                                \
  extern_ template Index shortest_step_at(const __VA_ARGS__ &, const Nodes<double> &);                                 \
  extern_ template double elastic_energy<double>(const __VA_ARGS__ &);                                                 \
  extern_ template double internal_energy(const __VA_ARGS__ &);                                                        \
  extern_ template double viscous_energy(const __VA_ARGS__ &);                                                         \
  extern_ template double hourglass_energy(const __VA_ARGS__ &);                                                       \
  extern_ template void add_body(Fingerprint &, const __VA_ARGS__ &);                                                  \
  extern_ template void release_removed(NodeToSurface<double> &, const __VA_ARGS__ &);                                 \
  extern_ template void release_removed(ParticleContact<double> &, const __VA_ARGS__ &);                               \
  extern_ template void velocity_gradient(__VA_ARGS__ &, const Nodes<double> &);                                       \
  extern_ template double raise_time_step(__VA_ARGS__ &, Nodes<double> &, double);                                     \
  extern_ template Index first_inverted(const __VA_ARGS__ &, const Nodes<double> &);                                   \
  extern_ template Fault inverted_fault(const __VA_ARGS__ &, const Nodes<double> &, Index);                            \
  extern_ template Index erode(__VA_ARGS__ &, const Nodes<double> &, SymmetryPlanes, double, double, Index);           \
  extern_ template void gather_body(Frame &, const Nodes<double> &, const __VA_ARGS__ &, int);

/// The functions of a type of perforation model, with the flow laws of its plates and its projectile and its
/// Discretisation.
#define OGIVE_PERFORATION(extern_, Model_, Law_, ShotLaw_, Parts_)                                                     \
  extern_ template Model_ make_perforation(const PerforationCase<double> &, const std::vector<Metal<double, Law_>> &,  \
                                           const std::vector<Metal<double, ShotLaw_>> &, PerforationOptions<double>,   \
                                           const Parts_ &);                                                            \
  extern_ template void step(Model_ &, double);                                                                        \
  extern_ template Energy<double> energy(const Model_ &);                                                              \
  extern_ template double stable_time_step(const Model_ &);                                                            \
  extern_ template RunState<double> begin_run(const Model_ &, const RunOptions<double> &);                             \
  extern_ template std::optional<Fault> find_not_finite(const Model_ &);                                               \
  extern_ template std::optional<Fault> find_inverted(const Model_ &, Index);                                          \
  extern_ template std::optional<Fault> find_turned(const Model_ &);                                                   \
  extern_ template void erode(Model_ &, double, Index);                                                                \
  extern_ template std::optional<Fault> find_fault(const Model_ &, const RunOptions<double> &,                         \
                                                   const RunState<double> &);                                          \
  extern_ template std::optional<Fault> find_small_step(const Model_ &, const RunOptions<double> &,                    \
                                                        const RunState<double> &);                                     \
  extern_ template std::optional<Fault> find_energy_error(const Model_ &, const RunOptions<double> &,                  \
                                                          const RunState<double> &, const Energy<double> &);           \
  extern_ template std::uint64_t fingerprint(const Model_ &);                                                          \
  extern_ template std::uint64_t state_hash(const Model_ &);                                                           \
  extern_ template void write_checkpoint(const std::filesystem::path &, const Model_ &, const RunState<double> &,      \
                                         std::string_view);                                                            \
  extern_ template void restore(const Checkpoint &, Model_ &, RunState<double> &);                                     \
  extern_ template Frame gather_frame(const Model_ &);                                                                 \
  extern_ template Way<double> find_way(const Model_ &, const Vec3<double> &, double, double);                         \
  extern_ template FlightSample<double> observe_flight(const Model_ &, const ProjectileShape<double> &,                \
                                                       const Flight<double> &);                                        \
  extern_ template PlateShape<double> plate_shape(const Model_ &, const std::vector<Vec3<double>> &, double,           \
                                                  const Layer<double> &, std::size_t);

/// Meshes, ties and motion of nodes.
#define OGIVE_MESHES(extern_)                                                                                          \
  extern_ template ParticleLayout<double> cubic_disc(const DiscShape<double> &, Extent);                               \
  extern_ template ParticleLayout<double> ring_disc(const DiscShape<double> &, Extent);                                \
  extern_ template HexMesh<double> rim_mesh(const RimShape<double> &, Extent);                                         \
  extern_ template HexMesh<double> projectile_mesh(const ProjectileShape<double> &, double, Extent);                   \
  extern_ template void check_mesh(const HexMesh<double> &, std::string_view);                                         \
  extern_ template std::vector<Facet> boundary_facets(const HexMesh<double> &);                                        \
  extern_ template std::vector<Facet> facets_off_planes(const std::vector<Facet> &, const std::vector<Vec3<double>> &, \
                                                        SymmetryPlanes, double);                                       \
  extern_ template Tie<double> make_tie(Nodes<double> &, NodeRange, const std::vector<Facet> &,                        \
                                        const std::vector<std::array<Index, 8>> &, double);                            \
  extern_ template void hand_over_forces(const Tie<double> &, Nodes<double> &);                                        \
  extern_ template void move_slaves(const Tie<double> &, Nodes<double> &);                                             \
  extern_ template RigidPart<double> make_rigid_part(const Nodes<double> &, NodeRange);                                \
  extern_ template void rigidify(RigidPart<double> &, Nodes<double> &, double, double);                                \
  extern_ template Inertia<double> inertia_of(const Nodes<double> &, NodeRange, SymmetryPlanes);                       \
  extern_ template Vec3<double> support_impulse(const Nodes<double> &, double);                                        \
  extern_ template void integrate(Nodes<double> &, double, double);                                                    \
  extern_ template double kinetic_energy(const Nodes<double> &, NodeRange, double);

/// Lists of neighbours and contacts.
#define OGIVE_CONTACTS(extern_)                                                                                        \
  extern_ template void build_neighbours(Neighbours<double> &, std::span<const Vec3<double>>, SymmetryPlanes, double,  \
                                         double);                                                                      \
  extern_ template bool are_stale(const Neighbours<double> &, std::span<const Vec3<double>>, SymmetryPlanes, double);  \
  extern_ template Bonds<double> make_bonds(std::span<const Vec3<double>>, SymmetryPlanes, double);                    \
  extern_ template NodeToSurface<double> make_contact(const Nodes<double> &, std::vector<Index>, std::vector<double>,  \
                                                      std::vector<Facet>, std::string, ContactOptions<double>,         \
                                                      SymmetryPlanes);                                                 \
  extern_ template void set_facets(NodeToSurface<double> &, const Nodes<double> &, std::vector<Facet>);                \
  extern_ template void search(NodeToSurface<double> &, const Nodes<double> &);                                        \
  extern_ template void add_contact_force(NodeToSurface<double> &, Nodes<double> &, double, double);                   \
  extern_ template void add_contact(Fingerprint &, const NodeToSurface<double> &);                                     \
  extern_ template ParticleContact<double> make_particle_contact(                                                      \
      const Nodes<double> &, const std::vector<ContactBody<double>> &, double, std::string, SymmetryPlanes);           \
  extern_ template void search(ParticleContact<double> &, std::span<const Vec3<double>>);                              \
  extern_ template void add_contact_force(ParticleContact<double> &, Nodes<double> &, double);                         \
  extern_ template void add_contact(Fingerprint &, const ParticleContact<double> &);                                   \
  extern_ template std::vector<Field> gather_state(const MaterialPoints<double> &, const std::vector<Index> &, Index);

namespace ogive {

OGIVE_MESHES(extern)
OGIVE_CONTACTS(extern)

namespace instances {

/// What programs run: law, kernel, form and rule are chosen when they run.
using AnyLaw = AnyFlowLaw<double>;
using AnyParticles = SphBody<double, AnyLaw, AnyKernel, AnyForm>;
using AnyHexes = HexBody<double, AnyLaw, AnyRule>;
using AnyShot = AnyPerforationModel<double>;

} // namespace instances

OGIVE_PARTICLES(extern, instances::AnyParticles)
OGIVE_HEXES(extern, instances::AnyHexes)
OGIVE_PERFORATION(extern, instances::AnyShot, instances::AnyLaw, instances::AnyLaw, AnyDiscretisation)

} // namespace ogive
