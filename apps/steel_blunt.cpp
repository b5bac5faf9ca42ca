// SPDX-License-Identifier: BSD-3-Clause
#include "options/exit_status.hpp"
#include "study/figures.hpp"

/// Figs. 6 to 10: blunt projectiles on Weldox 460 E plates of 6 to 20 mm.
int main(int argc, char **argv) {
  options::limit_spinning(argv);
  using study::FigurePlot;
  const study::Figures figures{
      .name = "steel_blunt",
      .purpose = "blunt projectiles on Weldox 460 E plates of 6 to 20 mm, Figs. 6 to 10 of Liu et al. 2012",
      .figures = {6, 7, 8, 9, 10},
      .plots = {{6, FigurePlot::residual_velocity, "Fig. 6: residual velocity, blunt projectiles on Weldox 460 E"},
                {9, FigurePlot::ballistic_limit, "Fig. 9: ballistic limit, blunt projectiles on Weldox 460 E"}}};
  return study::run_figures(figures, {argv + 1, argv + argc});
}
