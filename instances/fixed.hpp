// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "instances.hpp"

/// \file
/// What tests, examples and benchmarks run: types that are chosen when they are compiled.

namespace ogive {

namespace instances {

using SteelParticles = SphBody<double, Bilinear<double>>;
using SteelHexes = HexBody<double, Bilinear<double>>;
using SteelHexesOfPoints = HexBody<double, Bilinear<double>, SelectiveReduced>;
using PlateParticles = SphBody<double, ModifiedJohnsonCook<double>>;
using PlateHexes = HexBody<double, ModifiedJohnsonCook<double>>;
using PlateHexesOfPoints = HexBody<double, ModifiedJohnsonCook<double>, SelectiveReduced>;
using FixedShot = PerforationModel<double, ModifiedJohnsonCook<double>, CubicSpline, RenormalisedForm, OnePoint>;

} // namespace instances

OGIVE_PARTICLES(extern, instances::SteelParticles)
OGIVE_HEXES(extern, instances::SteelHexes)
OGIVE_HEXES(extern, instances::SteelHexesOfPoints)
OGIVE_PARTICLES(extern, instances::PlateParticles)
OGIVE_HEXES(extern, instances::PlateHexes)
OGIVE_HEXES(extern, instances::PlateHexesOfPoints)
OGIVE_PERFORATION(extern, instances::FixedShot, ModifiedJohnsonCook<double>, Bilinear<double>, Discretisation<>)

} // namespace ogive
