// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/choice.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/pack.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/fem/hex8.hpp"
#include "ogive/fem/hourglass.hpp"
#include "ogive/material/metal.hpp"
#include "ogive/material/points.hpp"
#include "ogive/mesh/hex_mesh.hpp"
#include "ogive/mesh/mesh_check.hpp"

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ogive {

/// One material point in the middle, hourglass control (Flanagan & Belytschko 1981).
struct OnePoint {
  static constexpr int points = 1; ///< in a hex
};

/// 2x2x2 material points, dilatation averaged over the element (B-bar, Hughes 1980). It needs no hourglass control.
struct SelectiveReduced {
  static constexpr int points = 8; ///< in a hex
};

/// A rule that is chosen when the program runs.
using AnyRule = std::variant<OnePoint, SelectiveReduced>;

/// Numerical resistance of hexes.
template <class T> struct HexOptions {
  T hourglass_stiffness = T(0.1);      ///< fraction of the element's own stiffness, see hourglass.hpp
  T hourglass_viscosity = T(0);        ///< fraction of the element's acoustic impedance
  T linear_bulk_viscosity = T(0.06);   ///< in compression only
  T quadratic_bulk_viscosity = T(1.5); ///< in compression only
};

/// For each node of a body, the element corners that meet there: `corners[begin[n]]` to `corners[begin[n + 1]]` of the
/// n-th node of the body, each 8 * hex + corner.
struct CornersOfNodes {
  std::vector<Index> begin;   ///< number of nodes + 1
  std::vector<Index> corners; ///< grouped by node
};

/// A body of eight-node hexes. `Rule` is OnePoint, SelectiveReduced or AnyRule. Point p of hex e is material point
/// e * points_of_hex() + p. Energies are those of the computed part of the model.
template <class T, class Law, class Rule = OnePoint, class Width = SimdWidth> struct HexBody {
  std::string name;                        ///< for messages and files
  Metal<T, Law> metal;                     ///< the same in all hexes
  Rule rule{};                             ///< of integration
  HexOptions<T> options{};                 ///< numerical resistance
  NodeRange nodes{};                       ///< of the body
  std::vector<std::array<Index, 8>> hexes; ///< corners, indices into Nodes
  MaterialPoints<T> points;                ///< state of the metal
  std::vector<T> point_mass;               ///< kg, constant, of each point
  bool erodes = false;                     ///< hexes that are too distorted are removed, see fem/erosion.hpp

  // History, one for each hex.
  std::vector<HourglassModes<T>> hourglass_force; ///< N, generalised; empty with SelectiveReduced
  std::vector<T> hourglass_energy;                ///< J
  std::vector<T> viscous_pressure;                ///< Pa, bulk viscosity
  std::vector<T> viscous_energy;                  ///< J, work of bulk viscosity
  std::vector<std::array<T, 8>> corner_mass;      ///< kg, the hex's share of its nodes' masses, mass scaling included

  // Made anew in each step by velocity_gradient and add_internal_force; `lanes<T>` hexes make a pack.
  std::vector<MeanGradient<Pack<T>>> mean_gradient;       ///< one for each pack of hexes
  std::vector<HourglassMotion<Pack<T>>> hourglass_motion; ///< empty with SelectiveReduced
  std::vector<Vec3<T>> corner_force;                      ///< N, entry 8 * hex + corner
  CornersOfNodes corners_of_nodes;                        ///< from which nodes gather their forces; constant
};

/// Whether a type is a HexBody.
template <class Body> inline constexpr bool is_hex_body = false;
/// True for HexBody.
template <class T, class Law, class Rule> inline constexpr bool is_hex_body<HexBody<T, Law, Rule>> = true;

/// A body of hexes, constant or not.
template <class Body>
concept BodyOfHexes = is_hex_body<std::remove_const_t<Body>>;

/// Calls `f(name, unit, values)` for each field of the state of a body of hexes that is not a material point's.
template <class Body, class F> void for_each_hex_field(Body &&body, F &&f) {
  f("hourglass_force", "N", body.hourglass_force);
  f("hourglass_energy", "J", body.hourglass_energy);
  f("viscous_pressure", "Pa", body.viscous_pressure);
  f("viscous_energy", "J", body.viscous_energy);
  f("corner_mass", "kg", body.corner_mass);
}

/// Values of a node field at the corners of a hex.
template <class T> Corners<T> gather_corners(const std::vector<Vec3<T>> &field, const std::array<Index, 8> &hex) {
  Corners<T> values;
  for (int a = 0; a < 8; ++a) {
    const Vec3<T> &value = field[hex[a]];
    values(a, 0) = value[0], values(a, 1) = value[1], values(a, 2) = value[2];
  }
  return values;
}

/// Number of material points in each hex.
template <class T, class Law, class Rule> Index points_of_hex(const HexBody<T, Law, Rule> &body) {
  return with_choice(body.rule, [](auto rule) -> Index { return rule.points; });
}

/// Number of packs that hold all hexes of a body; the last one may repeat the last hex.
template <class T, class Law, class Rule> Index packs(const HexBody<T, Law, Rule> &body) {
  return (static_cast<Index>(body.hexes.size()) + lanes<T> - 1) / lanes<T>;
}

/// The hex in a lane of a pack.
template <class T, class Law, class Rule> Index hex_in(const HexBody<T, Law, Rule> &body, Index pack, Index lane) {
  return std::min(pack * lanes<T> + lane, static_cast<Index>(body.hexes.size()) - 1);
}

/// The list of corners that meet at each node of the range.
inline CornersOfNodes corners_of_nodes(const std::vector<std::array<Index, 8>> &hexes, NodeRange nodes) {
  CornersOfNodes list;
  list.begin.assign(nodes.size() + 1, 0);
  list.corners.resize(8 * hexes.size());
  for (const auto &hex : hexes)
    for (Index n : hex) ++list.begin[n - nodes.begin + 1];
  for (Index n = 0; n < nodes.size(); ++n) list.begin[n + 1] += list.begin[n];
  std::vector<Index> next(list.begin.begin(), list.begin.end() - 1);
  for (Index e = 0; e < static_cast<Index>(hexes.size()); ++e)
    for (Index a = 0; a < 8; ++a) list.corners[next[hexes[e][a] - nodes.begin]++] = 8 * e + a;
  return list;
}

/// Adds a mesh (m) to the nodes, at rest, as a body of `metal`. Masses are lumped by row sums: they add up to density
/// times the exact volume and keep its centre. Throws SetupError if a constant of the metal or an option is out of
/// range or a hex is inverted.
template <class Rule = OnePoint, class T, class Law>
HexBody<T, Law, Rule> add_hex_body(Nodes<T> &nodes, const HexMesh<T> &mesh, const Metal<T, Law> &metal,
                                   std::string name, const HexOptions<T> &options = {}, Rule rule = {}) {
  check(metal);
  check_mesh(mesh, name);
  const auto not_negative = [&](T value, const char *thing) {
    require(value >= T(0) && std::isfinite(value), name + " " + thing, value, "must not be negative");
  };
  not_negative(options.hourglass_stiffness, "hourglass stiffness");
  not_negative(options.hourglass_viscosity, "hourglass viscosity");
  not_negative(options.linear_bulk_viscosity, "linear bulk viscosity");
  not_negative(options.quadratic_bulk_viscosity, "quadratic bulk viscosity");

  HexBody<T, Law, Rule> body;
  body.name = std::move(name);
  body.metal = metal;
  body.rule = rule;
  body.options = options;
  body.nodes = add_nodes(nodes, mesh.positions);
  body.hexes = mesh.hexes;
  for (auto &hex : body.hexes)
    for (Index &n : hex) n += body.nodes.begin;

  const Index count = static_cast<Index>(body.hexes.size()), points = points_of_hex(body);
  fill(body.points, count * points, initial_point(metal));
  body.point_mass.resize(body.points.size());
  body.hourglass_energy.assign(count, T(0));
  body.viscous_pressure.assign(count, T(0));
  body.viscous_energy.assign(count, T(0));
  body.corner_mass.resize(count);
  body.mean_gradient.resize(packs(body));
  body.corner_force.assign(8 * count, Vec3<T>::Zero());
  body.corners_of_nodes = corners_of_nodes(body.hexes, body.nodes);
  if (points == 1) {
    body.hourglass_force.assign(count, HourglassModes<T>::Zero());
    body.hourglass_motion.resize(packs(body));
  }

  for (Index e = 0; e < count; ++e) {
    const Corners<T> x = gather_corners(nodes.position, body.hexes[e]);
    const T hex_volume = mean_gradient<T>(x).volume;
    const CornerWeights<T> share = metal.density * lumped_volumes<T>(x);
    for (int a = 0; a < 8; ++a) {
      body.corner_mass[e][a] = share[a];
      nodes.mass[body.hexes[e][a]] += share[a];
    }
    for (int p = 0; p < points; ++p) {
      const T volume = points == 1 ? hex_volume : point_gradient<T>(x, p).volume;
      body.point_mass[e * points + p] = metal.density * volume;
    }
  }
  return body;
}

/// True if all material points of hex e have failed: it has no shear stiffness left.
template <class T, class Law, class Rule> bool is_failed(const HexBody<T, Law, Rule> &body, Index e) {
  const Index points = points_of_hex(body);
  for (Index i = e * points; i < (e + 1) * points; ++i)
    if (!is_failed(body.metal.damage, body.points.damage[i])) return false;
  return true;
}

/// True if all material points of hex e have failed and have been removed: it acts on its nodes no more.
template <class T, class Law, class Rule> bool is_removed(const HexBody<T, Law, Rule> &body, Index e) {
  return body.metal.damage.effect == FailureEffect::removal && is_failed(body, e);
}

/// True if the `n`-th node of the body belongs to removed hexes of it and to no other.
template <class T, class Law, class Rule> bool is_node_removed(const HexBody<T, Law, Rule> &body, Index n) {
  const CornersOfNodes &list = body.corners_of_nodes;
  if (body.metal.damage.effect != FailureEffect::removal || list.begin[n] == list.begin[n + 1]) return false;
  for (Index k = list.begin[n]; k < list.begin[n + 1]; ++k)
    if (!is_removed(body, list.corners[k] / 8)) return false;
  return true;
}

/// Energy that the stress has taken up, J: elastic, plastic and heat.
template <class T, class Law, class Rule> T internal_energy(const HexBody<T, Law, Rule> &body) {
  return ordered_sum(body.points.size(), T(0),
                     [&](Index i) { return body.point_mass[i] * body.points.internal_energy[i]; });
}

/// Work of the hourglass forces, J.
template <class T, class Law, class Rule> T hourglass_energy(const HexBody<T, Law, Rule> &body) {
  return ordered_sum(static_cast<Index>(body.hexes.size()), T(0), [&](Index e) { return body.hourglass_energy[e]; });
}

/// Work of the bulk viscosity, J.
template <class T, class Law, class Rule> T viscous_energy(const HexBody<T, Law, Rule> &body) {
  return ordered_sum(static_cast<Index>(body.hexes.size()), T(0), [&](Index e) { return body.viscous_energy[e]; });
}

/// Volume that belongs to material point p of a hex with the corners `x`, m3; those of all points add up to the hex's.
template <class Rule, class T> T point_volume(const Corners<T> &x, int p) {
  if constexpr (Rule::points == 1)
    return hex_volume<T>(x);
  else
    return determinant<T>(jacobian<T>(x, gauss_point<T>(p)));
}

/// A material point of a hex and its volume.
template <class T> struct PointVolume {
  int point = 0; ///< from 0 on
  T volume{};    ///< m3
};

/// The material point of a hex with the corners `x` that has the least volume; one whose volume is not a number counts
/// as the least.
template <class Rule, class T> PointVolume<T> smallest_point(const Corners<T> &x) {
  PointVolume<T> smallest{0, point_volume<Rule>(x, 0)};
  for (int p = 1; p < Rule::points; ++p)
    if (const T volume = point_volume<Rule>(x, p); !(volume >= smallest.volume)) smallest = {p, volume};
  return smallest;
}

/// A hex that has a material point whose volume is not positive: the first one, or -1. Removed hexes may have any
/// shape.
template <class T, class Law, class Rule>
Index first_inverted(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes) {
  const Index count = static_cast<Index>(body.hexes.size());
  const Index first = with_choice(body.rule, [&]<class Chosen>(Chosen) {
    return parallel_min(count, count, [&](Index e) {
      if (is_removed(body, e)) return count;
      return smallest_point<Chosen>(gather_corners(nodes.position, body.hexes[e])).volume > T(0) ? count : e;
    });
  });
  return first == count ? -1 : first;
}

} // namespace ogive
