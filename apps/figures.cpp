// SPDX-License-Identifier: BSD-3-Clause
#include "study/figures.hpp"

#include "ogive/core/spinning.hpp"
#include "options/exit_status.hpp"

/// The programs of the figures of Liu et al. 2012; OGIVE_FIGURES names the one that is built.
int main(int argc, char **argv) {
  ogive::limit_spinning(argv);
  using enum study::FigurePlot::Kind;
  const std::vector<study::Figures> programs{
      {"steel_blunt",
       "blunt projectiles on Weldox 460 E plates of 6 to 20 mm, Figs. 6 to 10 of Liu et al. 2012",
       {6, 7, 8, 9, 10},
       {{6, residual_velocity, "Fig. 6: residual velocity, blunt projectiles on Weldox 460 E"},
        {9, ballistic_limit, "Fig. 9: ballistic limit, blunt projectiles on Weldox 460 E"}}},
      {"nose_shapes",
       "blunt, conical and ogival projectiles on 12 mm Weldox 460 E, Fig. 11 of Liu et al. 2012",
       {11},
       {{11, residual_velocity, "Fig. 11: residual velocity, three noses on 12 mm Weldox 460 E"}}},
      {"aluminium_conical",
       "conical projectiles on AA5083-H116 plates of 15 to 30 mm, Figs. 12 to 14 of Liu et al. 2012",
       {12, 13, 14},
       {{12, residual_velocity, "Fig. 12: residual velocity, conical projectiles on AA5083-H116"},
        {13, ballistic_limit, "Fig. 13: ballistic limit, conical projectiles on AA5083-H116"}}}};
  for (const study::Figures &figures : programs)
    if (figures.name == OGIVE_FIGURES) return study::run_figures(figures, {argv + 1, argv + argc});
  return options::failure;
}
