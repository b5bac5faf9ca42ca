#include "ogive/io/atomic_file.hpp"
#include "options.hpp"
#include "options_table.hpp"

namespace perforate {

namespace {

namespace fs = std::filesystem;

/// The folders of `path` that do not exist yet, the outermost first.
std::vector<fs::path> missing_folders(const fs::path &path) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path folder = fs::absolute(path).lexically_normal(); !fs::exists(folder, ignored);) {
    if (folder.has_filename()) missing.insert(missing.begin(), folder);
    if (folder == folder.parent_path()) break;
    folder = folder.parent_path();
  }
  return missing;
}

/// Bytes that a run will write at most, by a generous guess for each particle and each hex of the projectile.
double estimated_bytes(const Options &o) {
  constexpr double fixed = 4e6, per_particle_and_frame = 120;
  const double frames = o.vtk ? o.end_us / o.output_every_us + 2 : 1;
  return fixed + frames * per_particle_and_frame * estimated_particles(o);
}

/// Why nothing can be written to the folder; empty if it can.
std::string obstacle(const Options &options) {
  const fs::path probe = ogive::temporary_name(options.out / ".perforate_probe");
  const int error = ogive::write_and_sync(probe, std::string(4096, ' '));
  std::error_code ignored;
  fs::remove(probe, ignored);
  if (error != 0) return "must be a folder that can be written to: " + std::generic_category().message(error);

  const double needed = estimated_bytes(options), free = static_cast<double>(fs::space(options.out, ignored).available);
  const auto megabytes = [](double bytes) { return shortest(std::ceil(bytes / 1e6)) + " MB"; };
  if (!ignored && free < needed)
    return "needs up to " + megabytes(needed) + " of free space and has " + megabytes(free) +
           "; a longer --output-every-us or --no-vtk needs less";
  return "";
}

} // namespace

void prepare_out(const Options &options) {
  const auto refuse_out = [&](const std::string &reason) { refuse("--out", options.out.string(), reason); };
  std::error_code error;
  const auto status = fs::status(options.out, error);
  if (fs::exists(status) && !fs::is_directory(status)) refuse_out("must be a folder, but a file of that name is there");

  const auto created = missing_folders(options.out);
  std::string reason;
  fs::create_directories(options.out, error);
  if (error)
    reason = "must be a folder that can be created: " + error.message();
  else
    reason = obstacle(options);
  if (reason.empty()) return;
  for (auto folder = created.rbegin(); folder != created.rend(); ++folder) fs::remove(*folder, error);
  refuse_out(reason);
}

} // namespace perforate
