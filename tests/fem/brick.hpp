// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex_force.hpp"
#include "ogive/fem/hex_time_step.hpp"
#include "ogive/material/bilinear.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace fem_test {

using namespace ogive;
using V = Vec3<double>;
using M = Mat3<double>;

/// Deterministic numbers in [-1, 1].
struct Noise {
  std::uint32_t state = 12345;
  double operator()() {
    state = state * 1664525u + 1013904223u;
    return 2.0 * (state >> 8) / double(1u << 24) - 1.0;
  }
  V vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }
};

/// nx x ny x nz hexes that fill the box from 0 to `size`.
template <class T> HexMesh<T> brick(Index nx, Index ny, Index nz, const Vec3<T> &size) {
  HexMesh<T> mesh;
  for (Index k = 0; k <= nz; ++k)
    for (Index j = 0; j <= ny; ++j)
      for (Index i = 0; i <= nx; ++i)
        mesh.positions.push_back({size[0] * T(i) / T(nx), size[1] * T(j) / T(ny), size[2] * T(k) / T(nz)});
  const auto node = [&](Index i, Index j, Index k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (Index k = 0; k < nz; ++k)
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i)
        mesh.hexes.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                              node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                              node(i, j + 1, k + 1)});
  return mesh;
}

/// A brick of n^3 hexes of about `edge` whose nodes are moved at random by up to `distortion` edges.
inline HexMesh<double> distorted_brick(Index n, double edge, double distortion, std::uint32_t seed = 12345) {
  auto mesh = brick<double>(n, n, n, V::Constant(n * edge));
  Noise noise{seed};
  for (auto &p : mesh.positions) p += distortion * edge * noise.vector();
  return mesh;
}

/// Steel that never yields unless told to.
template <class T> Metal<T, Bilinear<T>> steel(T yield = T(1e15)) {
  Metal<T, Bilinear<T>> m;
  m.name = "steel";
  m.density = T(7850);
  m.elasticity = {T(200e9), T(0.33)};
  m.flow = {yield, T(2e9)};
  return m;
}

/// Hexes without any viscosity.
template <class T> HexOptions<T> inviscid() { return {T(0.1), T(0), T(0), T(0)}; }

/// A body and its nodes.
template <class Rule> struct Solid {
  Nodes<double> nodes;
  HexBody<double, Bilinear<double>, Rule> body;
};

template <class Rule>
Solid<Rule> solid(const HexMesh<double> &mesh, const HexOptions<double> &options = {},
                  const Metal<double, Bilinear<double>> &metal = steel<double>()) {
  Solid<Rule> s;
  s.body = add_hex_body<Rule>(s.nodes, mesh, metal, "brick", options);
  return s;
}

/// Forces at the present positions and velocities, after the stress has moved through `dt`.
template <class S> void compute_forces(S &s, double dt) {
  for (auto &f : s.nodes.force) f.setZero();
  velocity_gradient(s.body, s.nodes);
  update_stress(s.body, dt);
  add_internal_force(s.body, s.nodes, dt);
}

/// One step of central differences.
template <class S> void step(S &s, double dt) {
  compute_forces(s, dt);
  for (Index n = 0; n < s.nodes.size(); ++n) {
    s.nodes.velocity[n] += dt / s.nodes.mass[n] * s.nodes.force[n];
    for (int i = 0; i < 3; ++i)
      if (s.nodes.held[n] & (1 << i)) s.nodes.velocity[n][i] = 0;
    s.nodes.position[n] += dt * s.nodes.velocity[n];
  }
}

template <class S> double kinetic_energy(const S &s) {
  double sum = 0;
  for (Index n = 0; n < s.nodes.size(); ++n) sum += 0.5 * s.nodes.mass[n] * s.nodes.velocity[n].squaredNorm();
  return sum;
}

/// The message of the SetupError that `f()` throws; empty if it throws none.
template <class F> std::string setup_error_of(F &&f) {
  try {
    f();
  } catch (const SetupError &error) {
    return error.what();
  }
  return {};
}

inline bool contains(const std::string &text, const std::string &part) { return text.find(part) != std::string::npos; }

/// Rotation about `axis` (not unit) by `angle`.
inline M rotation(const V &axis, double angle) {
  const V a = axis / axis.norm();
  M K;
  K << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return M::Identity() + std::sin(angle) * K + (1 - std::cos(angle)) * K * K;
}

} // namespace fem_test
