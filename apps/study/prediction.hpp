// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"

/// \file
/// A ballistic limit on record: what was computed, from what, by which version, under one hash. Filed before a test it
/// can be repeated afterwards. The hash guards against accidents; that a record is the older one follows from where it
/// was filed.

namespace study {

/// A record as text, in JSON, with its hash.
struct Prediction {
  std::string text;
  std::string file{}; ///< that it was read from
};

/// The record of a limit that was searched with all `series`, which differ in their seed, to `width_mps`. Throws
/// SetupError if a limit is not known to that width, or if a row of its shots has no results of this case beside it.
Prediction predicted(const Study &study, const shot::Options &o, double width_mps, const std::vector<Series> &series);

/// Reads a record. Throws SetupError, which names `origin`, if it cannot be read or its hash is not that of its text.
Prediction read_prediction(const std::filesystem::path &file, const std::string &origin);

/// Throws SetupError, which names `origin` and the first difference, unless the record is of this case and width.
void require_same_case(const Prediction &prediction, const shot::Options &o, double width_mps,
                       const std::string &origin);

/// Comparison of a search with an earlier record.
struct Comparison {
  std::string text;      ///< one line
  bool confirmed = true; ///< the bracket of each recorded limit overlaps with the one found now
};

/// Compares two records of one case.
Comparison compared(const Prediction &now, const Prediction &earlier);

} // namespace study
