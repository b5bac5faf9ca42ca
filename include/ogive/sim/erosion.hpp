// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/force.hpp"
#include "ogive/contact/new_facets.hpp"
#include "ogive/fem/erosion.hpp"
#include "ogive/mesh/facets.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sph/body.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

/// \file
/// Erosion of a model: hexes that are too distorted are removed, and contacts get the faces that this exposes.

namespace ogive {

/// None: particles cannot be too distorted.
template <class T, class Law, class K, class F>
Index erode(SphBody<T, Law, K, F> &, const Nodes<T> &, SymmetryPlanes, T, T, Index) {
  return 0;
}

/// None: particles are not removed by erosion.
template <class T, class Law, class K, class F> RemovedHexes<T> removed_hexes(const SphBody<T, Law, K, F> &) {
  return {};
}

/// Hexes of several bodies, with their numbers in their bodies.
struct NumberedHexes {
  std::vector<std::array<Index, 8>> hexes; ///< corners, indices into Nodes
  std::vector<Index> numbers;              ///< of each hex in its body
};

/// Adds the hexes of a body that have not been removed.
template <class T, class Law, class Rule> void add_present(NumberedHexes &all, const HexBody<T, Law, Rule> &body) {
  for (Index e = 0; e < static_cast<Index>(body.hexes.size()); ++e)
    if (!is_removed(body, e)) all.hexes.push_back(body.hexes[e]), all.numbers.push_back(e);
}

/// Nothing: particles are no hexes.
template <class T, class Law, class K, class F> void add_present(NumberedHexes &, const SphBody<T, Law, K, F> &) {}

/// The faces that are exposed on the hexes which are left of the bodies of a contact, in the order of the bodies and
/// their hexes; those in mirror planes, where all nodes are held, are left out.
template <class T, class Bodies>
std::vector<Facet> exposed_facets(const Model<T, Bodies> &model, const NodeToSurface<T> &contact) {
  NumberedHexes all;
  Index number = 0;
  for_each_body(model, [&](const auto &body) {
    if (std::find(contact.eroding.begin(), contact.eroding.end(), number++) != contact.eroding.end())
      add_present(all, body);
  });
  std::vector<Facet> facets;
  for (Facet facet : boundary_facets(HexMesh<T>{{}, all.hexes})) {
    const auto in_plane = [&](bool plane, Held held) {
      return plane && std::all_of(facet.nodes.begin(), facet.nodes.end(),
                                  [&](Index n) { return (model.nodes.held[n] & held) != 0; });
    };
    if (in_plane(model.symmetry.x, held_x) || in_plane(model.symmetry.y, held_y)) continue;
    facet.hex = all.numbers[facet.hex];
    facets.push_back(facet);
  }
  return facets;
}

/// The hexes that erosion has removed from all bodies.
template <class T, class Bodies> RemovedHexes<T> removed_hexes(const Model<T, Bodies> &model) {
  RemovedHexes<T> all;
  for_each_body(model, [&](const auto &body) {
    const RemovedHexes<T> own = removed_hexes(body);
    all.count += own.count, all.mass += own.mass;
  });
  return all;
}

/// Removes the hexes of bodies that erode which are too distorted or across a mirror plane, between two steps, if they
/// have at least `least_points` material points. Contacts lose their facets and get the faces behind them. Nodes that
/// belong to removed hexes alone fly on as points, and no longer touch anything.
template <class T, class Bodies> void erode(Model<T, Bodies> &model, T least_step, Index least_points = 1) {
  Index removed = 0;
  for_each_body(model, [&](auto &body) {
    removed += erode(body, model.nodes, model.symmetry, least_step, model.last_step, least_points);
  });
  if (removed == 0) return;
  for (auto &contact : model.contacts) {
    if (!contact.eroding.empty()) replace_facets(contact, model.nodes, exposed_facets(model, contact), model.last_step);
    for_each_body(model, [&](const auto &body) { deactivate_removed(contact, body); });
  }
}

/// Gives contacts the facets that they had when the state of the model was written.
template <class T, class Bodies> void renew_facets(Model<T, Bodies> &model) {
  if (removed_hexes(model).count == 0) return;
  for (auto &contact : model.contacts)
    if (!contact.eroding.empty()) set_facets(contact, model.nodes, exposed_facets(model, contact)), contact.torn = true;
}

} // namespace ogive
