// SPDX-License-Identifier: BSD-3-Clause
#include "options/exit_status.hpp"
#include "study/figures.hpp"

/// Figs. 12 to 14: conical projectiles on AA5083-H116 plates of 15 to 30 mm.
int main(int argc, char **argv) {
  options::limit_spinning(argv);
  using study::FigurePlot;
  const study::Figures figures{
      .name = "aluminium_conical",
      .purpose = "conical projectiles on AA5083-H116 plates of 15 to 30 mm, Figs. 12 to 14 of Liu et al. 2012",
      .figures = {12, 13, 14},
      .plots = {{12, FigurePlot::residual_velocity, "Fig. 12: residual velocity, conical projectiles on AA5083-H116"},
                {13, FigurePlot::ballistic_limit, "Fig. 13: ballistic limit, conical projectiles on AA5083-H116"}}};
  return study::run_figures(figures, {argv + 1, argv + argc});
}
