// SPDX-License-Identifier: BSD-3-Clause
#include "out_folder.hpp"

#include "given.hpp"

#include "ogive/io/atomic_file.hpp"

namespace options {

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

/// The error that keeps `bytes` from being written to the folder; empty if there is room and permission.
std::string obstacle(const fs::path &out, double bytes, const char *hint) {
  const fs::path probe = ogive::temporary_name(out / ".probe");
  const int error = ogive::write_and_sync(probe, std::string(4096, ' '));
  std::error_code ignored;
  fs::remove(probe, ignored);
  if (error != 0) return "must be a folder that can be written to: " + std::generic_category().message(error);

  const double free = static_cast<double>(fs::space(out, ignored).available);
  const auto megabytes = [](double size) { return shortest(std::ceil(size / 1e6)) + " MB"; };
  if (!ignored && free < bytes)
    return "needs up to " + megabytes(bytes) + " of free space and has " + megabytes(free) + hint;
  return "";
}

} // namespace

std::vector<fs::path> prepare_out(const fs::path &out, double bytes, const char *hint) {
  std::error_code error;
  const auto status = fs::status(out, error);
  if (fs::exists(status) && !fs::is_directory(status))
    refuse("--out", out.string(), "must be a folder, but a file of that name is there");

  auto created = missing_folders(out);
  std::string reason;
  fs::create_directories(out, error);
  if (error)
    reason = "must be a folder that can be created: " + error.message();
  else
    reason = obstacle(out, bytes, hint);
  if (reason.empty()) return created;
  remove_empty(created);
  refuse("--out", out.string(), reason);
}

fs::path set_aside(const fs::path &out, const std::string &reason) {
  const fs::path folder = fs::absolute(out).lexically_normal();
  const fs::path whole = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  fs::path name;
  for (int k = 1; name.empty() || fs::exists(fs::symlink_status(name, error)); ++k)
    name = whole.string() + "_before_" + std::to_string(k);
  // Programs that work in the folder, this one among them, would go with it.
  const bool in_use = (fs::current_path(error).string() + "/").starts_with(whole.string() + "/");
  if (!in_use && !fs::is_symlink(whole, error)) {
    fs::rename(whole, name, error);
    if (!error) return name;
  }
  refuse("--out", out.string(), reason + "; give another --out, or remove them");
}

void remove_empty(const std::vector<fs::path> &folders) {
  std::error_code ignored;
  std::for_each(folders.rbegin(), folders.rend(), [&](const fs::path &folder) { fs::remove(folder, ignored); });
}

} // namespace options
