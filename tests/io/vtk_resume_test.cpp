// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/vtk.hpp"

#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

using namespace ogive;

namespace {

/// A series of `count` frames at every 10 us.
VtkSeries make_series(const std::filesystem::path &folder, int count, double start = 0) {
  auto series = open_series(folder, "run");
  Frame frame = sample::perforated_plate();
  for (int n = 0; n < count; ++n) frame.time = start + 10e-6 * n, add_frame(series, frame);
  return series;
}

} // namespace

TEST_CASE("a resumed series drops later frames and writes them anew") {
  const TemporaryFolder folder;
  auto whole = make_series(folder.path, 5);
  const std::string pvd = read_text(folder.path / "run.pvd");
  const int files = count_files(folder.path);
  const std::vector<VtkSeriesEntry> kept(whole.entries.begin(), whole.entries.begin() + 9);
  auto series = resume_series(folder.path, "run", 3, kept);
  CHECK(series.frames == 3);
  CHECK(count_files(folder.path) == 10);
  CHECK(read_text(folder.path / "run.pvd") == pvd_text({folder.path, "run", 3, kept}));
  Frame frame = sample::perforated_plate();
  for (int n = 3; n < 5; ++n) frame.time = 10e-6 * n, add_frame(series, frame);
  CHECK(read_text(folder.path / "run.pvd") == pvd);
  CHECK(count_files(folder.path) == files);
}

TEST_CASE("files that have gone or are another run's are not listed") {
  const TemporaryFolder folder;
  const auto old = make_series(folder.path, 3);
  std::filesystem::remove(folder.path / old.entries[1].file);
  const auto series = resume_series(folder.path, "run", 3, old.entries);
  CHECK(series.entries.size() == 8);
  CHECK(read_text(folder.path / "run.pvd").find(old.entries[1].file) == std::string::npos);
  // Another run in the same folder: the same names, other times.
  make_series(folder.path, 4, 1e-6);
  const auto none = resume_series(folder.path, "run", 3, old.entries);
  CHECK(none.entries.empty());
  CHECK(none.frames == 3);
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("entries that are no frames of the series are refused and nothing is removed") {
  const TemporaryFolder folder;
  auto series = make_series(folder.path, 2);
  write_atomically(folder.path / "precious.vtu", "data");
  const int files = count_files(folder.path);
  for (const char *file :
       {"precious.vtu", "frames/../precious.vtu", "frames/run_/../../precious.vtu", "", "/etc/passwd"}) {
    auto entries = series.entries;
    entries[2].file = file;
    CHECK_THROWS_AS(resume_series(folder.path, "run", 2, entries), SetupError);
  }
  auto entries = series.entries;
  entries[0].part_name = "a\"b";
  CHECK_THROWS_AS(resume_series(folder.path, "run", 2, entries), SetupError);
  CHECK_THROWS_AS(resume_series(folder.path, "run", -1, series.entries), SetupError);
  CHECK(count_files(folder.path) == files);
}
