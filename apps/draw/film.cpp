// SPDX-License-Identifier: BSD-3-Clause
#include "film.hpp"

#include "options/text.hpp"
#include "process.hpp"

#include "ogive/io/atomic_file.hpp"

#include <algorithm>
#include <cstdlib>

namespace draw {

namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

constexpr double most_seconds = 600;

/// A folder for the single pictures, gone when the film is done.
struct PictureFolder {
  fs::path path;

  explicit PictureFolder(const fs::path &film) {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    std::string name = (folder / "ogive_film_XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr)
      throw ogive::write_error(film, "there is no temporary folder for its pictures");
    path = name;
  }
  ~PictureFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  PictureFolder(const PictureFolder &) = delete;
  PictureFolder &operator=(const PictureFolder &) = delete;
};

/// The options of ffmpeg for the filter and the encoder of a film.
Texts encoder(const std::string &ending) {
  // Most players take an even number of pixels and this form of colours only.
  const std::string hold = "tpad=stop_mode=clone:stop_duration=1", even = ",pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white";
  if (ending == ".mp4")
    return {"-vf",      hold + even, "-c:v",      "libx264",    "-crf", "20",
            "-pix_fmt", "yuv420p",   "-movflags", "+faststart", "-f",   "mp4"};
  if (ending == ".webm")
    return {"-vf", hold + even, "-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p", "-f", "webm"};
  if (ending == ".gif")
    return {"-vf",   hold + ",split[a][b];[a]palettegen=stats_mode=full[colours];[b][colours]paletteuse=dither=none",
            "-loop", "0",
            "-f",    "gif"};
  return {"-vf", hold, "-plays", "0", "-f", "apng"};
}

void encode(const fs::path &pictures, double frames_per_second, const fs::path &film) {
  ogive::require_replaceable(film);
  const auto temporary = ogive::temporary_name(film);
  Texts arguments{"-v",         "error",
                  "-nostdin",   "-y",
                  "-framerate", options::shortest(frames_per_second),
                  "-i",         (pictures / "%05d.png").string()};
  for (auto &argument : encoder(film.extension().string())) arguments.push_back(argument);
  // With a protocol in front no name can be taken for another one.
  arguments.push_back("file:" + fs::absolute(temporary).string());
  const int status = run_program("ffmpeg", arguments, most_seconds);
  std::error_code error, ignored;
  if (status == 0) fs::rename(temporary, film, error);
  if (status == 0 && !error) return;
  fs::remove(temporary, ignored);
  throw ogive::write_error(film, error ? error.message() : failure_of("ffmpeg", "ffmpeg", status, most_seconds));
}

} // namespace

bool is_film(const fs::path &path) {
  return !path.stem().empty() && std::any_of(film_endings.begin(), film_endings.end(), [&](const char *ending) {
    return path.extension() == "." + std::string(ending);
  });
}

bool ffmpeg_available() { return run_program("ffmpeg", {"-version"}, most_seconds) == 0; }

void render_film(const ogive::StoredSeries &series, const Film &film, const fs::path &path) {
  if (!ffmpeg_available()) throw ogive::write_error(path, failure_of("ffmpeg", "ffmpeg", not_started, most_seconds));
  SectionPanel panel = film.panel;
  const auto read = [&](std::size_t k) { return ogive::read_frame(series, k, film.symmetry); };
  const auto numbers = shown_frames(series.frames.size(), film.most_frames);
  if (film.fits) {
    SeenBox box{.high_mm = panel.high_mm, .radius_mm = panel.radius_mm};
    for (const std::size_t k : numbers) box = extended(box, read(k));
    panel.low_mm = box.low_mm;
  }
  const PictureFolder pictures(path);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    ogive::Frame frame = read(numbers[k]);
    const std::string label = time_text(frame.time, film.motion);
    render_panel({{std::move(frame), label, film.from}}, pictures.path / options::printed("%05zu.png", k), panel);
  }
  encode(pictures.path, film.frames_per_second, path);
}

} // namespace draw
