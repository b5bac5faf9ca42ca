// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace verification {

/// A clamped-free prismatic beam of rectangular section; SI units.
struct BeamSection {
  double length, height;        ///< m, the height in the direction of bending
  double young, shear, density; ///< Pa, Pa, kg/m3
};

/// First angular frequency by Timoshenko's theory with the shear factor 5/6, 1/s.
double timoshenko_frequency(const BeamSection &beam);

} // namespace verification
