// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// Everything but VTK: perforation of metal plates with coupled SPH and 8-node hexes.

#include "ogive/io/checkpoint.hpp"
#include "ogive/material/library.hpp"
#include "ogive/perforation/flight.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/perforation/shape.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/hash.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/version.hpp"
