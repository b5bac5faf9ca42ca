// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/sim/hash.hpp"
#include "ogive/sim/state.hpp"

#include <bit>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ogive {

/// Collects what distinguishes one model from another.
struct Fingerprint {
  std::uint64_t hash = hash_start; ///< of all that has been added

  /// Adds a text with its length.
  void add(std::string_view text) { hash = hash_bytes(hash_word(text.size()), text); }
  /// Adds a whole number.
  void add(std::integral auto whole) { hash = hash_word(static_cast<std::uint64_t>(whole)); }
  /// Rounded, so that the last bits of another compiler or processor make no other model.
  void add(std::floating_point auto number) {
    const auto rounded = static_cast<float>(number);
    hash = hash_word(rounded == rounded ? std::bit_cast<std::uint32_t>(rounded) : 0xffffffffU);
  }
  /// Adds a choice.
  template <class E>
  requires std::is_enum_v<E>
  void add(E choice) { add(static_cast<int>(choice)); }
  /// Adds which mirror planes there are.
  void add(SymmetryPlanes planes) { add(planes.x), add(planes.y); }
  /// Adds a range of nodes.
  void add(NodeRange range) { add(range.begin), add(range.end); }
  /// Adds all values.
  template <class V, std::size_t n> void add(const std::array<V, n> &values) {
    for (const V &value : values) add(value);
  }
  /// Adds their number and all values.
  template <class V> void add(const std::vector<V> &values) {
    add(values.size());
    for (const V &value : values) add(value);
  }

private:
  std::uint64_t hash_word(std::uint64_t word) const {
    return hash_bytes(hash, {reinterpret_cast<const char *>(&word), sizeof word});
  }
};

/// Adds all constants of a metal; the flow law, of whatever kind, by stresses that it gives.
template <class T, class Law> void add_metal(Fingerprint &print, const Metal<T, Law> &m) {
  for (const T number : {m.density, m.elasticity.young, m.elasticity.poisson, m.eos.hugoniot_slope, m.eos.gruneisen,
                         m.specific_heat, m.taylor_quinney, m.room_temperature, m.melting_temperature, m.rate_floor,
                         m.damage.critical_work, m.damage.softening, m.shear_band.spacing})
    print.add(number);
  if (has_bands(m.shear_band)) print.add(m.shear_band.onset), print.add(m.shear_band.diffusivity);
  const FailureStrain<T> &f = m.damage.failure_strain;
  for (const T number : {f.D1, f.D2, f.D3, f.D4, f.D5, f.reference_rate}) print.add(number);
  if (f.rate_term != FailureRateTerm::power) print.add(f.rate_term);
  print.add(m.eos.law), print.add(m.damage.law), print.add(m.damage.effect);
  for (const T strain : {T(0), T(0.01), T(0.3)})
    for (const T rate : {m.rate_floor, T(1e3) * m.rate_floor})
      for (const T heat : {T(0), T(0.3)})
        print.add(flow_stress(m, strain, rate, m.room_temperature + heat * (m.melting_temperature - m.room_temperature))
                      .value);
}

/// Adds what every body has.
template <class Body> void add_name_and_metal(Fingerprint &print, const Body &body) {
  print.add(body.name), print.add(body.nodes), print.add(body.point_mass);
  add_metal(print, body.metal);
}

/// Adds what a body of hexes is made of.
template <class T, class Law, class Rule> void add_body(Fingerprint &print, const HexBody<T, Law, Rule> &body) {
  add_name_and_metal(print, body);
  print.add(body.hexes), print.add(body.points.size()), print.add(body.erodes);
  const HexOptions<T> &o = body.options;
  for (const T number :
       {o.hourglass_stiffness, o.hourglass_viscosity, o.linear_bulk_viscosity, o.quadratic_bulk_viscosity})
    print.add(number);
}

/// Adds what a body of particles is made of.
template <class T, class Law, class Kernel, class Form>
void add_body(Fingerprint &print, const SphBody<T, Law, Kernel, Form> &body) {
  add_name_and_metal(print, body);
  const SphOptions<T> &o = body.options;
  print.add(body.symmetry), print.add(body.spacing), print.add(o.variable_smoothing), print.add(o.damage_pressure),
      print.add(is_corrected(body));
  for (const T number :
       {o.smoothing_ratio, o.linear_viscosity, o.quadratic_viscosity, o.skin_ratio, o.courant, o.largest_strain,
        o.control.stiffness, o.control.strength, o.control.while_flowing, o.control.reach})
    print.add(number);
  with_choice(body.kernel, [&](auto kernel) {
    for (const double u : {0.3, 0.9, 1.6}) print.add(kernel.norm * kernel.shape(u));
  });
}

/// Adds slaves, masters and options of a contact.
template <class T> void add_contact(Fingerprint &print, const NodeToSurface<T> &contact) {
  print.add(contact.name), print.add(contact.symmetry), print.add(contact.slaves), print.add(contact.offset);
  print.add(contact.search_margin), print.add(contact.eroding);
  // Where hexes may be removed the facets are a part of the state, and follow from the hexes.
  if (contact.eroding.empty()) {
    print.add(contact.master_mass), print.add(contact.facets.size());
    for (const Facet &facet : contact.facets) print.add(facet.nodes);
  }
  const ContactOptions<T> &o = contact.options;
  print.add(o.friction), print.add(o.stiffness), print.add(o.sticking), print.add(o.rigid_masters),
      print.add(o.reentrant);
}

/// Adds bodies and stiffness of a contact of particles.
template <class T> void add_contact(Fingerprint &print, const ParticleContact<T> &contact) {
  print.add(contact.name), print.add(contact.symmetry), print.add(contact.nodes), print.add(contact.body);
  print.add(contact.smoothing_length), print.add(contact.stiffness), print.add(contact.search_margin);
}

/// Hash of all that a run does not change, and of the list of what it does: equal for models that one checkpoint
/// fits. The state, such as positions and velocities, does not enter.
template <class T, class Bodies> std::uint64_t fingerprint(const Model<T, Bodies> &model) {
  Fingerprint print;
  print.add(model.nodes.size()), print.add(model.nodes.held), print.add(model.symmetry);
  for_each_body(model, [&](const auto &body) { add_body(print, body); });
  for (const auto &contact : model.contacts) add_contact(print, contact);
  for (const auto &contact : model.particle_contacts) add_contact(print, contact);
  for (const auto &tie : model.ties)
    for (const auto &t : tie.nodes) {
      print.add(t.slave), print.add(t.masters);
      // Beside 1, so that the round-off of a weight of zero does not count.
      for (const T weight : t.weights) print.add(T(1) + weight);
    }
  for (const RigidPart<T> &part : model.rigid_parts) print.add(part.nodes);
  const RunState<T> run;
  for_each_state_field(model, run, [&](const std::string &name, const auto &) { print.add(name); });
  return print.hash;
}

} // namespace ogive
