// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"

#include <algorithm>

namespace ogive {

/// Pressure from density and energy.
enum class PressureLaw {
  linear,       ///< p = K (rho/rho0 - 1)
  mie_gruneisen ///< shock Hugoniot Us = c0 + s up as the reference curve
};

/// Equation of state. `gruneisen` and `hugoniot_slope` are used by Mie-Grueneisen only.
template <class T> struct EquationOfState {
  PressureLaw law = PressureLaw::linear; ///< which of the two
  T hugoniot_slope{};                    ///< s of Us = c0 + s up
  T gruneisen{};                         ///< Gamma0, with rho Gamma = rho0 Gamma0
};

/// Pressure in Pa for the compression mu = rho/rho0 - 1 and the internal energy `energy` in J per reference m3.
/// Mie-Grueneisen: Hugoniot in compression, linear in tension, the bulk sound speed from `bulk_modulus` (Pa).
/// `N` is T or a pack of T.
template <class T, class N> N pressure(const EquationOfState<T> &eos, T bulk_modulus, N mu, N energy) {
  if (eos.law == PressureLaw::linear) return bulk_modulus * mu;
  using std::max;
  const N compression = max(mu, N(0)), eta = compression / (T(1) + compression);
  const N stiffening = T(1) - eos.hugoniot_slope * eta;
  const N hugoniot = bulk_modulus * eta * (T(1) - T(0.5) * eos.gruneisen * eta) / (stiffening * stiffening);
  return select(mu > N(0), hugoniot, bulk_modulus * mu) + eos.gruneisen * energy;
}

/// Bulk modulus of the present state, rho dp/drho at constant entropy, Pa: what sound feels. K rho/rho0 with the linear
/// law, more with Mie-Grueneisen. `mu` as in pressure(), `present` the pressure (Pa). No less than `bulk_modulus` (Pa),
/// so that it bounds the sound speed. `N` is T or a pack of T.
template <class T, class N> N tangent_bulk_modulus(const EquationOfState<T> &eos, T bulk_modulus, N mu, N present) {
  using std::max;
  const N ratio = T(1) + mu;
  if (eos.law == PressureLaw::linear) return bulk_modulus * max(ratio, N(1));
  const N eta = max(mu, N(0)) / max(ratio, N(1)), half = T(0.5) * eos.gruneisen * eta;
  const N stiffening = T(1) - eos.hugoniot_slope * eta;
  const N slope = ((T(1) - T(2) * half) * stiffening + T(2) * eos.hugoniot_slope * eta * (T(1) - half)) /
                  (stiffening * stiffening * stiffening);
  return bulk_modulus * max((T(1) - eta) * slope, N(1)) + eos.gruneisen * max(present, N(0)) / max(ratio, N(1));
}

} // namespace ogive
