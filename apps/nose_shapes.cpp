// SPDX-License-Identifier: BSD-3-Clause
#include "options/exit_status.hpp"
#include "study/figures.hpp"

/// Fig. 11: blunt, conical and ogival projectiles on 12 mm Weldox 460 E.
int main(int argc, char **argv) {
  options::limit_spinning(argv);
  using study::FigurePlot;
  const study::Figures figures{
      .name = "nose_shapes",
      .purpose = "blunt, conical and ogival projectiles on 12 mm Weldox 460 E, Fig. 11 of Liu et al. 2012",
      .figures = {11},
      .plots = {{11, FigurePlot::residual_velocity, "Fig. 11: residual velocity, three noses on 12 mm Weldox 460 E"}}};
  return study::run_figures(figures, {argv + 1, argv + argc});
}
