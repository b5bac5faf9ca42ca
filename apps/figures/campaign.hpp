// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"
#include "run_shots.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file
/// The one program behind the figures of the paper: which shots, how to run them, what to draw.

namespace figures {

/// What a user can choose.
struct Options {
  std::optional<int> figure;  ///< this one alone
  bool quick = false;         ///< coarse: particles 1.5 mm apart
  std::string method = "sfm"; ///< that of the shots that are run; curves of all that are known are drawn
  std::string model = "both"; ///< mjc, jc or both; other methods than the paper's have mjc only
  double spacing_mm = 0.6;
  int jobs = 1;  ///< shots at a time
  int shard = 1; ///< this part of `shards`
  int shards = 1;
  bool run = true;      ///< run what is missing
  bool limits = true;   ///< bisection of the ballistic limits
  bool pictures = true; ///< shots that are for pictures alone, and frames
  std::filesystem::path out = "vtk_out/figures";
  std::filesystem::path perforate; ///< the program; next to this one unless given
};

/// A figure that plots curves: residual against initial velocity, or limit against thickness.
struct Plot {
  enum Kind { residual_velocity, ballistic_limit };
  int figure = 0;
  Kind kind = residual_velocity;
  std::string title;
};

/// One of the programs.
struct Campaign {
  std::string name;         ///< as in the column `app` of figure_shots.csv
  std::string purpose;      ///< one line for --help
  std::vector<int> figures; ///< all that --figure may name
  std::vector<Plot> plots;
};

/// A shot of the list that belongs to this campaign.
struct ListedShot {
  int figure = 0;
  bool picture = false; ///< not a point of a curve
  Task task;
};

/// The methods of perforate that the figures know, the paper's first.
inline constexpr std::array<const char *, 3> methods{"sfm", "stabilised", "adaptive"};

/// The shots of figure_shots.csv that the options choose, in the order of the file, the modified law first; a shot that
/// several figures need stands there once for each. Throws SetupError.
std::vector<ListedShot> listed_shots(const Campaign &campaign, const Options &options,
                                     const std::filesystem::path &data);

/// Those of the shots that belong to the options' shard. A series stays in one shard: its bisection then needs no other
/// and asks for the same velocities as in a run without shards.
std::vector<ListedShot> share_of(const std::vector<ListedShot> &shots, const Options &options);

/// The tasks of a list, each once, with the most frequent frames that are asked for.
std::vector<Task> tasks_of(const std::vector<ListedShot> &shots);

/// The series that the curves of a list belong to, in its order.
std::vector<SeriesKey> series_in(const std::vector<ListedShot> &shots);

/// Runs, resumes and draws; the program's main. Returns its exit status: 0, 1 failure, 2 wrong input, 3 a shot or file
/// failed. SIGINT, SIGTERM and SIGHUP end the process once the shots on their way are ended.
int run_campaign(const Campaign &campaign, int argc, const char *const *argv);

} // namespace figures
