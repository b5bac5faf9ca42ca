// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// \file
/// The lines of the verification record: theory, what was computed, and the most that the two may differ by.

namespace verification {

/// Round-off of gradients and forces of particles, relative: sums of single precision.
inline constexpr double round_off_of_pairs = 1e-5;
/// What is left of it in the momentum, relative to that: errors of many pairs, at random.
inline constexpr double round_off_of_momentum = 1e-7;

/// One line of a table and whether it is within its tolerance.
struct Line {
  std::vector<std::string> cells;
  bool ok = false;
};

/// A rung of the ladder: one table of the page.
struct Rung {
  std::string name; ///< of its place in the page
  std::vector<std::string> titles{"what", "theory", "computed", "error", "at most"};
  std::vector<Line> lines;
};

/// Six significant digits.
std::string number(double value);

/// Two significant digits, for errors and bounds.
std::string roughly(double value);

/// A line whose relative error |computed/theory - 1| may be at most `bound`. `what` names the unit too.
void compare(Rung &rung, const std::string &what, double theory, double computed, double bound);

/// A line for what vanishes in theory: at most `bound` in size.
void vanishes(Rung &rung, const std::string &what, double computed, double bound);

/// A line for a property that theory only bounds: `computed` must lie between `low` and `high`.
void lies_between(Rung &rung, const std::string &what, double computed, double low, double high);

/// A line for the order of convergence: errors of resolutions that double from one to the next. The last order must be
/// at least `least`; `theory` is the order of the method.
void converges(Rung &rung, const std::string &what, double theory, const std::vector<double> &errors, double least);

// The rungs.
Rung kernel_sums();
Rung gradients();
Rung one_point();
Rung waves();
Rung beams();
Rung patches();
Rung sliding();
Rung taylor_bars();
Rung balances();

/// Energies of small runs against `reference`, a file of final_energies.csv's form; writes that file instead if
/// `write`.
Rung final_energies(const std::string &reference, bool write);

/// The table in Markdown, between the lines that say where it belongs in the page.
std::string markdown(const Rung &rung);

} // namespace verification
