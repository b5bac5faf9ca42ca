// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// Perforation of metal plates with coupled SPH and 8-node hexes: materials, bodies, contact, runs, shots, checkpoints.
/// Not here: fits (fit/), the search for ballistic limits, other files than checkpoints (io/).

#include "ogive/io/checkpoint.hpp"
#include "ogive/material/doubts.hpp"
#include "ogive/material/library.hpp"
#include "ogive/perforation/flight.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/perforation/motion.hpp"
#include "ogive/perforation/projectile_library.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/perforation/shape.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/hash.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/version.hpp"
