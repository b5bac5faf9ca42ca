// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"
#include "options_material.hpp"
#include "shared/input.hpp"
#include "shared/out_folder.hpp"

#include <algorithm>

namespace perforate {

namespace {

/// Bytes that a run will write at most, by a generous guess for each particle and each hex of the projectile. Two
/// checkpoints are there while the new one is written.
double estimated_bytes(const Options &o) {
  constexpr double fixed = 4e6, per_particle_and_frame = 120, per_particle_of_checkpoint = 600;
  const double time_us = std::max(0.0, o.end_us + o.settle_us - (o.restart ? o.restart->time_us : 0));
  const double frames = o.vtk ? time_us / o.output_every_us + 2 : 1;
  return fixed + (frames * per_particle_and_frame + 2 * per_particle_of_checkpoint) * estimated_particles(o);
}

} // namespace

void prepare_out(const Options &options) {
  std::error_code missing;
  for (const std::string &material : materials_of(options))
    if (!options.restart && is_material_file(material) &&
        std::filesystem::equivalent(options.out / "case.toml", material, missing))
      input::refuse(options.layer_materials.empty() ? "--material" : "--layer-materials", material,
                    "must not be case.toml in the folder for the results: that is overwritten");
  input::prepare_out(options.out, estimated_bytes(options), "; a longer --output-every-us or --no-vtk needs less");
}

} // namespace perforate
