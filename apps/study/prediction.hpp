// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"

/// \file
/// A ballistic limit on record: what was computed, from what, by which version, under one hash. Filed before a test it
/// shows later that the prediction came first and can be repeated.

namespace study {

/// A record as text, in JSON, with its hash.
struct Prediction {
  std::string text;
  std::string file{}; ///< that it was read from
};

/// The record of a limit that was searched with all `series`, which differ in their seed, to `width_mps`.
Prediction predicted(const shot::Options &o, double width_mps, const std::vector<Series> &series,
                     const std::vector<Row> &rows);

/// Reads a record. Throws SetupError, which names `origin`, if it cannot be read or its hash is not that of its text.
Prediction read_prediction(const std::filesystem::path &file, const std::string &origin);

/// Throws SetupError, which names `origin` and the first difference, unless the record is of this case and width.
void require_same_case(const Prediction &prediction, const shot::Options &o, double width_mps,
                       const std::string &origin);

/// What came of the search beside the record.
struct Comparison {
  std::string text;      ///< one line
  bool confirmed = true; ///< each limit lies within the widths of both brackets
};

/// Compares two records of one case.
Comparison compared(const Prediction &now, const Prediction &earlier);

} // namespace study
