// SPDX-License-Identifier: BSD-3-Clause
#include "box.hpp"
#include "catch.hpp"

#include "ogive/mesh/facets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace contact_test;
using fem_test::Noise;

namespace {

/// How often a surface of facets, four triangles each, winds around `p`: 1 inside, 0 outside (solid angles of van
/// Oosterom & Strackee 1983).
double winding_number(const V &p, const Nodes<double> &nodes, const std::vector<Facet> &facets) {
  double sum = 0;
  for (const Facet &f : facets) {
    std::array<V, 4> to;
    V middle = V::Zero();
    for (int k = 0; k < 4; ++k) to[k] = nodes.position[f.nodes[k]] - p, middle += 0.25 * to[k];
    for (int k = 0; k < 4; ++k) {
      const V &a = to[k], &b = to[(k + 1) % 4], &c = middle;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      sum += 2 * std::atan2(a.dot(cross<double>(b, c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
  }
  return sum / (4 * std::numbers::pi);
}

/// What is left of a distorted block of hexes when about a third of them are gone, with many slaves in and around it.
struct Rubble {
  Nodes<double> nodes;
  NodeToSurface<double> contact;
};

Rubble rubble(std::uint32_t seed, SymmetryPlanes planes, bool half) {
  constexpr Index n = 4;
  const double edge = 1e-3;
  Rubble r;
  auto mesh = fem_test::distorted_brick(n, edge, 0.35, seed);
  if (half) // its middle plane is a mirror plane
    for (V &p : mesh.positions) p[0] = std::abs(p[0]) < 0.5 * edge ? 0.0 : p[0];
  Noise noise{seed + 1};
  std::vector<char> gone;
  for (std::size_t e = 0; e < mesh.hexes.size(); ++e) gone.push_back(noise() < -0.3);
  add_surface(r.nodes, mesh);
  for (Index i = 0; half && i < static_cast<Index>(mesh.positions.size()); ++i)
    if (mesh.positions[i][0] == 0.0) r.nodes.held[i] |= held_x;
  std::vector<V> points;
  for (int i = 0; i < 2000; ++i) {
    V p = 0.5 * n * edge * V::Ones() + 0.6 * n * edge * noise.vector();
    if (half) p[0] = std::abs(p[0]);
    points.push_back(p);
  }
  const NodeRange slaves = add_free(r.nodes, points, 1e-3);
  HexMesh<double> left{mesh.positions, {}};
  for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
    if (gone[e] == 0) left.hexes.push_back(mesh.hexes[e]);
  r.contact =
      contact_of(r.nodes, slaves, 0.5 * edge, facets_off_planes(boundary_facets(left), left.positions, planes, 1e-9),
                 ContactOptions<double>{.reentrant = true}, planes);
  add_contact_force(r.contact, r.nodes, 0.0, 1e-7);
  return r;
}

/// The facets, and their images behind the plane x = 0 with their corners in the other order.
std::vector<Facet> with_images(Nodes<double> &nodes, std::vector<Facet> facets) {
  const Index count = static_cast<Index>(nodes.position.size());
  for (Index i = 0; i < count; ++i)
    add_nodes(nodes, {V(-nodes.position[i][0], nodes.position[i][1], nodes.position[i][2])});
  for (std::size_t f = 0, own = facets.size(); f < own; ++f) {
    Facet image = facets[f];
    for (int k = 0; k < 4; ++k) image.nodes[k] = facets[f].nodes[3 - k] + count;
    facets.push_back(image);
  }
  return facets;
}

} // namespace

TEST_CASE("where hexes have gone, slaves know inside from outside at edges and corners of any kind", "[contact]") {
  const bool half = GENERATE(false, true);
  int corners = 0, inside = 0, looked_at = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    Rubble r = rubble(seed, {half, false}, half);
    Nodes<double> nodes = r.nodes;
    const auto closed = half ? with_images(nodes, r.contact.facets) : r.contact.facets;
    for (Index a = 0; a < static_cast<Index>(r.contact.candidates.active.size()); ++a) {
      const V p = r.nodes.position[r.contact.slaves[r.contact.candidates.active[a]]];
      const auto nearest = find_nearest(r.contact, r.nodes, a, p, 1e-3);
      if (nearest.facet < 0) continue;
      const double winding = winding_number(p, nodes, closed);
      // Hexes that distortion pushes through each other have no inside that all could agree on.
      if (std::abs(winding) > 1e-6 && std::abs(winding - 1) > 1e-6) continue;
      const auto &w = nearest.point.weights;
      corners += *std::max_element(w.begin(), w.end()) == 1.0;
      inside += winding > 0.5;
      ++looked_at;
      INFO("seed " << seed << ", slave at " << 1e3 * p.transpose() << " mm, distance "
                   << 1e3 * std::sqrt(nearest.point.distance_squared) << " mm");
      CHECK(nearest.outside == (winding < 0.5));
    }
  }
  CHECK(looked_at > 8000);
  CHECK(corners > 400);
  CHECK(inside > 2000);
}

TEST_CASE("a slave ahead of the warped corner of a blunt nose is outside", "[contact]") {
  // Two facets of a nose's face, slightly warped, and two of its side, as they were in a shot, mm. Ahead of the corner
  // the closest point lies on the fold of the one or on the edge of the other, a millionth nearer: the facet of the
  // side alone would say inside.
  const std::vector<V> corners = {
      {7.362402, 5.049161, -2.180556}, {6.557899, 6.557890, -2.169371}, {7.386805, 7.386755, -2.152890},
      {8.681677, 5.801349, -2.161710}, {7.370825, 7.370814, -0.788144}, {8.665183, 5.791163, -0.790968},
      {5.049135, 7.362401, -2.180576}, {5.801370, 8.681605, -2.161730}, {5.791120, 8.665209, -0.790929}};
  Nodes<double> nodes;
  for (const V &p : corners) add_nodes(nodes, {V(1e-3 * p)});
  for (double &m : nodes.mass) m = 1e-3;
  const std::vector<Facet> facets = {Facet{.nodes = {0, 1, 2, 3}}, Facet{.nodes = {3, 2, 4, 5}},
                                     Facet{.nodes = {6, 7, 2, 1}}, Facet{.nodes = {2, 7, 8, 4}}};
  std::vector<V> points;
  for (int i = -40; i <= 40; ++i)
    for (int j = -40; j <= 40; ++j) points.push_back(1e-3 * V(7.4004 + 5e-6 * i, 7.40044 + 5e-6 * j, -3.623313));
  const NodeRange slaves = add_free(nodes, points, 1e-6);
  auto contact = contact_of(nodes, slaves, 0.5e-3, facets);
  add_contact_force(contact, nodes, 0.0, 1e-7);
  REQUIRE(contact.candidates.active.size() == points.size());
  CHECK(contact.state.lost == -1);
  for (Index a = 0; a < static_cast<Index>(contact.candidates.active.size()); ++a) {
    const V p = nodes.position[contact.slaves[contact.candidates.active[a]]];
    const auto nearest = find_nearest(contact, nodes, a, p, 2e-3);
    INFO("slave at " << 1e3 * p.transpose() << " mm");
    REQUIRE(nearest.facet >= 0);
    CHECK(nearest.outside);
  }
}
