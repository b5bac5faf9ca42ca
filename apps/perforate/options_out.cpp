#include "options.hpp"
#include "options_material.hpp"
#include "shared/input.hpp"
#include "shared/out_folder.hpp"

namespace perforate {

namespace {

/// Bytes that a run will write at most, by a generous guess for each particle and each hex of the projectile.
double estimated_bytes(const Options &o) {
  constexpr double fixed = 4e6, per_particle_and_frame = 120;
  const double frames = o.vtk ? o.end_us / o.output_every_us + 2 : 1;
  return fixed + frames * per_particle_and_frame * estimated_particles(o);
}

} // namespace

void prepare_out(const Options &options) {
  std::error_code missing;
  if (is_material_file(options.material) &&
      std::filesystem::equivalent(options.out / "case.toml", options.material, missing))
    input::refuse("--material", options.material,
                  "must not be case.toml in the folder for the results: that is overwritten");
  input::prepare_out(options.out, estimated_bytes(options), "; a longer --output-every-us or --no-vtk needs less");
}

} // namespace perforate
