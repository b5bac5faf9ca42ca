// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/fem/hex_force.hpp"
#include "ogive/search/box.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sph/body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace ogive {

/// Kinds of faults in the loop.
enum class FaultKind {
  not_finite, ///< a position or velocity that is no number
  inverted,   ///< a hex without volume
  lost,       ///< a node or particle that went through a surface
  astray,     ///< a node far outside the model
  small_step, ///< the stable time step collapsed
  energy      ///< the energy is not conserved
};

/// A fault in the loop: its kind, place and time.
struct Fault {
  FaultKind kind = FaultKind::not_finite; ///< its kind
  std::string what;                       ///< one line, with the values
  std::string body;                       ///< its name
  Index id = -1;                          ///< node, particle or hex of the body; -1: none in particular
  double time_us = 0;                     ///< of the model, µs
};

/// "(1, 2, 3) mm"
template <class T> std::string in_mm(const Vec3<T> &x) {
  auto text = text_stream();
  text << "(" << 1e3 * double(x[0]) << ", " << 1e3 * double(x[1]) << ", " << 1e3 * double(x[2]) << ") mm";
  return text.str();
}

/// The fault of a node, with its body and its number there.
template <class T, class Bodies>
Fault node_fault(const Model<T, Bodies> &model, FaultKind kind, Index node, const std::string &what) {
  Fault fault{kind, what, "nodes", node, double(model.time) * 1e6};
  for_each_body(model, [&](const auto &body) {
    if (node >= body.nodes.begin && node < body.nodes.end) fault.body = body.name, fault.id = node - body.nodes.begin;
  });
  return fault;
}

/// The first node for which `is_bad(n)`, or -1.
template <class T, class F> Index first_node(const Nodes<T> &nodes, F &&is_bad) {
  const Index count = nodes.size();
  const Index first = parallel_min(count, count, [&](Index n) { return is_bad(n) ? n : count; });
  return first == count ? -1 : first;
}

/// The first node with a velocity or position that is not a finite number, if any.
template <class T, class Bodies> std::optional<Fault> find_not_finite(const Model<T, Bodies> &model) {
  const Nodes<T> &nodes = model.nodes;
  const Index n =
      first_node(nodes, [&](Index i) { return !nodes.position[i].allFinite() || !nodes.velocity[i].allFinite(); });
  if (n < 0) return std::nullopt;
  auto what = text_stream();
  what << "position or velocity is not a finite number: " << in_mm(nodes.position[n]) << ", ("
       << nodes.velocity[n].transpose() << ") m/s";
  return node_fault(model, FaultKind::not_finite, n, what.str());
}

/// The fault of a hex that has no volume left, as a whole or at one of several material points.
template <class T, class Law, class Rule>
Fault inverted_fault(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index hex) {
  const Corners<T> x = gather_corners(nodes.position, body.hexes[hex]);
  const PointVolume<T> smallest =
      with_choice(body.rule, [&]<class Chosen>(Chosen) { return smallest_point<Chosen>(x); });
  Vec3<T> at = x.colwise().mean().transpose();
  auto what = text_stream();
  what << "a hex has no volume left";
  if (const Index points = points_of_hex(body); points > 1) {
    what << " at its point " << smallest.point << " of " << points;
    at = x.transpose() * shape_functions<T>(gauss_point<T>(smallest.point));
  }
  what << ": " << 1e9 * double(smallest.volume) << " mm3 at " << in_mm<T>(at);
  return {FaultKind::inverted, what.str(), body.name, hex, 0};
}

/// A hex of a body without volume, as a whole or at one of several material points, if any, where hexes have at least
/// `least_points` of them.
template <class T, class Law, class Rule>
std::optional<Fault> find_inverted(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index least_points) {
  if (points_of_hex(body) < least_points) return std::nullopt;
  const Index hex = first_inverted(body, nodes);
  return hex < 0 ? std::nullopt : std::optional(inverted_fault(body, nodes, hex));
}

/// None: particles cannot invert.
template <class T, class Law, class K, class F>
std::optional<Fault> find_inverted(const SphBody<T, Law, K, F> &, const Nodes<T> &, Index) {
  return std::nullopt;
}

/// A hex of the model without volume, if any; of bodies whose hexes have at least `least_points` material points.
template <class T, class Bodies>
std::optional<Fault> find_inverted(const Model<T, Bodies> &model, Index least_points = 1) {
  std::optional<Fault> fault;
  for_each_body(model, [&](const auto &body) {
    if (!fault) fault = find_inverted(body, model.nodes, least_points);
  });
  if (fault) fault->time_us = double(model.time) * 1e6;
  return fault;
}

/// The place of the first facet of a contact that has turned inside out in the list of its facets, or -1: its area
/// points into the hex of `body` that it is a face of. Facets of removed hexes may have any shape.
template <class T, class Law, class Rule>
Index first_turned(const NodeToSurface<T> &contact, const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes) {
  const Index count = static_cast<Index>(contact.facets.size());
  const Index first = parallel_min(count, count, [&](Index f) {
    const Facet &facet = contact.facets[f];
    if (facet.hex < 0 || facet.hex >= static_cast<Index>(body.hexes.size())) return count;
    // Parts of a projectile share their nodes: the hex of that number may be another part's.
    const auto &hex = body.hexes[facet.hex];
    const auto is_corner = [&](Index n) { return std::find(hex.begin(), hex.end(), n) != hex.end(); };
    if (!std::all_of(facet.nodes.begin(), facet.nodes.end(), is_corner) || is_removed(body, facet.hex)) return count;
    const auto at = [&](int k) -> const Vec3<T> & { return nodes.position[facet.nodes[k]]; };
    const Vec3<T> area = cross<T>(at(2) - at(0), at(3) - at(1));
    const Vec3<T> middle = T(0.25) * (at(0) + at(1) + at(2) + at(3));
    const Vec3<T> inside = gather_corners(nodes.position, body.hexes[facet.hex]).colwise().mean().transpose();
    return area.dot(middle - inside) > T(0) ? count : f;
  });
  return first == count ? -1 : first;
}

/// None: particles have no facets.
template <class T, class Law, class K, class F>
Index first_turned(const NodeToSurface<T> &, const SphBody<T, Law, K, F> &, const Nodes<T> &) {
  return -1;
}

/// A facet of a contact that has turned inside out, if any: the hex behind it has folded, and the surface has no
/// outside there.
template <class T, class Bodies> std::optional<Fault> find_turned(const Model<T, Bodies> &model) {
  std::optional<Fault> fault;
  for (const auto &contact : model.contacts) {
    for_each_body(model, [&](const auto &body) {
      const Index f = fault ? -1 : first_turned(contact, body, model.nodes);
      if (f < 0) return;
      const Facet &facet = contact.facets[f];
      Vec3<T> middle = Vec3<T>::Zero();
      for (const Index n : facet.nodes) middle += T(0.25) * model.nodes.position[n];
      fault = Fault{FaultKind::inverted,
                    "a facet of the contact \"" + contact.name + "\" has turned inside out, its hex has folded: at " +
                        in_mm(middle),
                    body.name, facet.hex, double(model.time) * 1e6};
    });
  }
  return fault;
}

/// A slave that contact has lost behind its surface, or a particle deep in another body, if any: one through the
/// projectile or from one plate into the next.
template <class T, class Bodies> std::optional<Fault> find_lost(const Model<T, Bodies> &model) {
  for (const auto &contact : model.contacts) {
    if (contact.state.lost < 0) continue;
    const Index node = contact.slaves[contact.state.lost];
    auto what = text_stream();
    what << "lies more than " << 1e3 * double(contact.search_margin) << " mm behind the surface of the contact \""
         << contact.name << "\", at " << in_mm(model.nodes.position[node]);
    return node_fault(model, FaultKind::lost, node, what.str());
  }
  for (const auto &contact : model.particle_contacts) {
    if (contact.lost < 0) continue;
    const Index node = contact.nodes.begin + contact.lost;
    return node_fault(model, FaultKind::lost, node,
                      "lies deep within another body of the contact \"" + contact.name + "\", at " +
                          in_mm(model.nodes.position[node]));
  }
  return std::nullopt;
}

/// Position and speed of a model at the start of a run.
template <class T> struct Start {
  Vec3<T> middle = Vec3<T>::Zero(); ///< m, of the box around all nodes
  T width{};                        ///< m, diagonal of that box
  T speed{};                        ///< m/s, of the fastest node
};

/// Position and speed of the model now.
template <class T, class Bodies> Start<T> start_of(const Model<T, Bodies> &model) {
  Box<T> box;
  T fastest{};
  for (const Vec3<T> &x : model.nodes.position) extend(box, x);
  for (const Vec3<T> &v : model.nodes.velocity) fastest = std::max(fastest, v.squaredNorm());
  return {T(0.5) * (box.low + box.high), (box.high - box.low).norm(), std::sqrt(fastest)};
}

/// A node out of the domain, if any: farther from the middle than `ratio` times the first width and the way that the
/// fastest node can have flown.
template <class T, class Bodies>
std::optional<Fault> find_astray(const Model<T, Bodies> &model, const Start<T> &start, T ratio) {
  const T reach = ratio * (start.width + start.speed * model.time);
  const Nodes<T> &nodes = model.nodes;
  const Index n =
      first_node(nodes, [&](Index i) { return (nodes.position[i] - start.middle).squaredNorm() > reach * reach; });
  if (n < 0) return std::nullopt;
  auto what = text_stream();
  what << "is out of the domain, farther than " << 1e3 * double(reach) << " mm from its middle: at "
       << in_mm(nodes.position[n]) << ", " << nodes.velocity[n].norm() << " m/s";
  return node_fault(model, FaultKind::astray, n, what.str());
}

} // namespace ogive
