// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

/// \file
/// Runs that resume from a checkpoint.

namespace shot {

/// The options in a checkpoint with what a command line changes: the folder of the results is that of the file; only
/// options that leave the physics as they are may be given. Throws SetupError.
Options restarted(const std::string &file, const std::vector<options::Given> &given);

/// The options of a run that may resume, and the obstacle if it cannot.
struct Resumed {
  Options options;
  std::string obstacle{}; ///< error of the checkpoint in the folder; empty if it can be resumed or there is none
};

/// The options of a run that continues what an earlier one left in the folder `options.out`: they resume from the
/// checkpoint there if it is of the same case, metal and version of ogive and the folder has no summary, the sign of an
/// end, or that of a shot which had no verdict at the end of its time and may have more now. Else those given. Threads,
/// picture and terminal may differ; frames may not, the earlier ones would be missing.
Resumed resumed(const Options &options);

/// Key and value of each option that results depend on, but names of metals and files: what they name counts.
std::vector<std::pair<std::string, std::string>> case_values(const Options &options);

/// The metals of the plates and of the projectile, as text of files.
std::string all_metals_text(const Options &options);

/// The first key in which the case in `options.out` differs from these options: "thickness_mm", "material"; empty if
/// they agree, nothing if there is no case that can be read. The end of the time is not compared: the verdict does not
/// depend on it.
std::optional<std::string> other_case(const Options &options);

} // namespace shot
