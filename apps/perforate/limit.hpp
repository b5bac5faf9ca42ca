// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// perforate limit: the ballistic limit of a case, and the curve of its residual velocities.

namespace perforate {

/// Finds the ballistic limit of the case of a command line whose first argument is "limit": bisection to the width that
/// is asked for, some shots above the limit, a fit, a table, a CSV file and a picture. Shots that have results in the
/// folder are not run again. Returns the exit status. Throws ogive::SetupError, ogive::WriteError.
int find_limit(int argc, const char *const *argv);

} // namespace perforate
