// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "result.hpp"

#include "experiment.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace shot {

/// The test that this case can be compared with, if there is one.
std::optional<experiment::Residual> find_test(const Options &options);

/// The result in numbers, as summary.json has it.
nlohmann::ordered_json summary_of(const Options &options, const Result &shot,
                                  const std::optional<experiment::Residual> &test = {});

/// Writes summary.json. Throws WriteError.
void write_summary(const Options &options, const Result &shot, const std::optional<experiment::Residual> &test);

/// Draws section.png and velocity.svg. Returns a line for each picture that cannot be drawn, with the reason.
std::string draw(const Options &options, const Result &shot, const std::optional<experiment::Residual> &test);

/// Prints the closing table.
void print_table(const Options &options, const Result &shot, const std::optional<experiment::Residual> &test);

} // namespace shot
