// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/draw/compare.hpp"

#include "apps/parse.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

using namespace commands::drawing;

namespace {

/// A folder with a case and its summary.
std::filesystem::path result(const std::filesystem::path &folder, const std::string &case_toml,
                             const std::string &summary) {
  std::filesystem::create_directories(folder);
  write(folder / "case.toml", case_toml);
  write(folder / "summary.json", summary);
  return folder;
}

} // namespace

TEST_CASE("what two results state differently, with change and per cent") {
  const TemporaryFolder folder;
  const auto first = result(folder.path / "a", "spacing_mm = 1\nfriction = 0\nkernel = \"cubic_spline\"\nthreads = 1\n",
                            R"({"nose": "blunt", "friction": 0, "plug_mass_g": 20.0, "fault": null, "wall_s": 3,
                                "failed_particles": 0, "test_origin": "measured", "layers": [{"dishing_mm": 1.5}],
                                "phase_s": {"force": 1.0}, "residual_velocity_mps": 150.0, "state_hash": "12"})");
  const auto second = result(folder.path / "b", "spacing_mm = 0.5\nfriction = 0\nkernel = \"wendland\"\nthreads = 2\n",
                             R"({"nose": "blunt", "friction": 0, "plug_mass_g": 21.0, "fault": null, "wall_s": 9,
                                 "failed_particles": 4, "layers": [{"dishing_mm": 1.25}], "buried_particles": 3,
                                 "phase_s": {"force": 2.0}, "residual_velocity_mps": null, "state_hash": "13"})");
  const auto all = differences(first, second);
  std::vector<std::string> keys;
  for (const auto &one : all) keys.push_back(one.key);
  // Entries of a TOML file come in the order of their keys.
  CHECK(keys == std::vector<std::string>{"kernel", "spacing_mm", "plug_mass_g", "failed_particles", "test_origin",
                                         "layers.0.dishing_mm", "residual_velocity_mps", "state_hash",
                                         "buried_particles"});
  const auto of = [&](const std::string &key) {
    return *std::find_if(all.begin(), all.end(), [&](const Difference &one) { return one.key == key; });
  };
  CHECK(of("kernel").second == "wendland");
  CHECK_FALSE(of("kernel").change);
  CHECK(of("plug_mass_g").change.value() == Approx(1));
  CHECK(of("plug_mass_g").percent.value() == Approx(5));
  CHECK(of("spacing_mm").percent.value() == Approx(-50));
  CHECK(of("layers.0.dishing_mm").change.value() == Approx(-0.25));
  CHECK(of("failed_particles").change.value() == Approx(4));
  CHECK_FALSE(of("failed_particles").percent);
  CHECK(of("residual_velocity_mps").second.empty());
  CHECK_FALSE(of("state_hash").change);
  CHECK(of("buried_particles").first.empty());
  CHECK(differences(first, first).empty());
  CHECK_THROWS_AS(differences(first, folder.path / "none"), ogive::SetupError);
}
