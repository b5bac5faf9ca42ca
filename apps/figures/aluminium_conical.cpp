// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.hpp"

/// Figs. 12 to 14: conical projectiles on AA5083-H116 plates of 15 to 30 mm.
int main(int argc, char **argv) {
  using figures::Plot;
  const figures::Campaign campaign{
      .name = "aluminium_conical",
      .purpose = "conical projectiles on AA5083-H116 plates of 15 to 30 mm, Figs. 12 to 14 of Liu et al. 2012",
      .figures = {12, 13, 14},
      .plots = {{12, Plot::residual_velocity, "Fig. 12: residual velocity, conical projectiles on AA5083-H116"},
                {13, Plot::ballistic_limit, "Fig. 13: ballistic limit, conical projectiles on AA5083-H116"}}};
  return figures::run_campaign(campaign, argc, argv);
}
