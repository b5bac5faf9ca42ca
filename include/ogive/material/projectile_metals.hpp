// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/bilinear.hpp"
#include "ogive/material/metal.hpp"

/// \file
/// Steels of bullets' cores and of fragment simulators. That of the paper's projectiles is in library.hpp.

namespace ogive::library {

/// A steel of a projectile: elastic and thermal constants of steel, bilinear. Young's modulus is a textbook value.
template <class T>
Metal<T, Bilinear<T>> projectile_steel(std::string name, std::string source, std::string confidence, Bilinear<T> flow) {
  Metal<T, Bilinear<T>> m;
  m.name = std::move(name);
  m.source = std::move(source);
  m.confidence = std::move(confidence);
  m.density = T(7850);
  m.elasticity = {T(207e9), T(0.3)};
  m.eos = {PressureLaw::linear, T(1.49), T(1.93)};
  m.flow = flow;
  m.specific_heat = T(452);
  m.melting_temperature = T(1800);
  return m;
}

/// Hard core of the 7.62 mm APM2, 63 HRC: yield 1200 MPa and a plastic modulus of 50 GPa, as quoted; the source gives
/// them up to a strain of 0.15.
template <class T> Metal<T, Bilinear<T>> apm2_core_steel() {
  return projectile_steel<T>("apm2_core_steel", "quoted: 63 HRC, for strains up to 0.15; Young's modulus assumed",
                             "medium: quoted, not checked against the original", {T(1200e6), T(50e9)});
}

/// Steel of fragment simulators, 30 HRC or 260 HV: yield 800 MPa from the hardness. The plastic modulus is an
/// assumption: 1 GPa, a tensile strength some 10 % above the yield stress.
template <class T> Metal<T, Bilinear<T>> fsp_steel() {
  return projectile_steel<T>("fsp_steel", "from memory: 260 HV; Young's modulus and hardening assumed",
                             "low: from memory, not checked against the original", {T(800e6), T(1e9)});
}

} // namespace ogive::library
