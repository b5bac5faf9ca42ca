// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"

#include "options/command_line.hpp"

/// \file
/// The programs of the paper's figures: studies with lists that are in apps/data/figure_shots.csv.

namespace study {

/// A figure that plots curves.
struct FigurePlot {
  enum Kind { residual_velocity, ballistic_limit };
  int figure = 0;
  Kind kind = residual_velocity;
  std::string title{};
};

/// One of the programs.
struct Figures {
  std::string name;         ///< as in the column `app` of the list
  std::string purpose;      ///< one line for --help
  std::vector<int> figures; ///< all that --figure may name
  std::vector<FigurePlot> plots;
};

/// Options of the programs of the figures.
struct FigureOptions {
  int figure = 0; ///< this one alone; 0: all
  bool quick = false;
  std::string method = "paper"; ///< of the shots that are run; curves of all methods that are known are drawn
  std::string model = "both";   ///< mjc, jc or both; other methods than the paper's have mjc only
  double spacing_mm = 0;        ///< of all shots; 0: that of each in the list
  bool limits = true;           ///< bisection of the ballistic limits
  bool pictures = true;         ///< shots that are for pictures alone, and frames
  std::filesystem::path out = "vtk_out/figures";
};

/// A shot of the list.
struct FigureShot {
  int figure = 0;
  bool picture = false; ///< not a point of a curve
  Case shot;
};

/// The shots that the options choose, in the order of the list, the modified law first; a shot that several figures
/// need is there once for each. Throws SetupError.
std::vector<FigureShot> listed_shots(const Figures &figures, const FigureOptions &options);

/// The cases of a list, each once, with the most frequent frames of those that it is listed with.
std::vector<Case> cases_in(const std::vector<FigureShot> &shots);

/// The part of a list that belongs to the study's shard. A series stays in one shard: its bisection then needs no other
/// and takes the same velocities as without shards.
std::vector<Case> share_of_series(const std::vector<Case> &all, const Study &study);

/// The main function of a program of the figures: runs, resumes and draws. Returns its exit status.
int run_figures(const Figures &figures, const options::Arguments &arguments);

} // namespace study
