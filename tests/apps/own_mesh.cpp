// SPDX-License-Identifier: BSD-3-Clause
#include "shot/own_mesh.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "mesh_io/sample.hpp"
#include "shot/files.hpp"
#include "shot/parts.hpp"
#include "shot/to_case.hpp"

using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using shot::Options;

namespace {

/// A whole block of 12 x 12 x 20 mm, whose rear half is part 2.
ogive::PartMesh<double> block() {
  auto body = mesh_io_test::bricks({-6e-3, -3e-3, 0, 3e-3, 6e-3}, {-6e-3, -3e-3, 0, 3e-3, 6e-3},
                                   {0, 5e-3, 10e-3, 15e-3, 20e-3});
  body.parts = {"1", "2"};
  for (std::size_t e = 0; e < body.mesh.hexes.size(); ++e) body.part_of.push_back(e < 32 ? 0 : 1);
  return body;
}

const double diameter_mm = 12 * std::sqrt(2.0);

} // namespace

TEST_CASE("an own mesh gives nose, sizes and parts, and its folder all that the case needs") {
  const TemporaryFolder folder;
  write(folder.path / "b.k", mesh_io_test::k_text(block()));
  write(folder.path / "p.toml",
        "mesh = \"b.k\"\nmesh_unit = \"mm\"\nprojectile_metal = \"fsp_steel\"\n[part.2]\nmetal = \"lead\"\n");
  const std::string file = (folder.path / "p.toml").string(), k = (folder.path / "b.k").string();
  const Options o = options_of({"--projectile", file.c_str(), "--spacing-mm", "1.5"});
  CHECK(o.nose == shot::Nose::mesh);
  CHECK(o.diameter_mm == Approx(diameter_mm).epsilon(1e-6));
  CHECK(o.length_mm == Approx(20));
  CHECK(o.friction == 0); // a flat front counts as blunt
  CHECK(shot::parts_of(o) == std::vector<std::string>{"1", "2"});
  CHECK(shot::part_materials(o) == std::vector<std::string>{"fsp_steel", "lead"});
  const auto metals = shot::projectile_metals_of(o);
  REQUIRE(metals.size() == 2);
  CHECK(materials::name_of(metals[1]) == "lead");
  const auto c = shot::to_case(o);
  CHECK(4 * ogive::volume(c.own_mesh.mesh) == Approx(12e-3 * 12e-3 * 20e-3).epsilon(1e-12));
  CHECK_THAT(o.out.string(), EndsWith("_p_12mm_303.5mps_projectile_metal=fsp_steel_spacing_mm=1.5") ||
                                 EndsWith("_p_12mm_303.5mps_spacing_mm=1.5"));

  const Options same = options_of({"--projectile-mesh", k.c_str(), "--projectile-metal", "fsp_steel", "--part-metals",
                                   "2=lead", "--spacing-mm", "1.5"});
  CHECK(same.own_mesh == o.own_mesh);
  CHECK(same.part_metals == o.part_metals);

  // The folder of the results.
  write(folder.path / "case.toml", shot::case_text(o));
  std::filesystem::rename(folder.path / "b.k", folder.path / shot::mesh_copy_name(o.projectile_mesh));
  std::filesystem::remove(folder.path / "p.toml");
  const std::string again = (folder.path / "case.toml").string();
  const Options third = options_of({"--config", again.c_str()});
  CHECK(third.own_mesh == o.own_mesh);
  CHECK(third.part_metals == o.part_metals);
  CHECK(third.diameter_mm == o.diameter_mm);
}

TEST_CASE("the unit of an own mesh scales it, its extent is that of the model") {
  const TemporaryFolder folder;
  const std::string k = (folder.path / "b.k").string();
  write(k, mesh_io_test::k_text(block()));
  const auto volume_of = [&](std::vector<const char *> more) {
    std::vector<const char *> arguments{"--projectile-mesh", k.c_str(), "--sph-radius-mm", "150"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Options o = options_of(arguments);
    return symmetry_planes(o.extent).copies() * ogive::volume(shot::to_case(o).own_mesh.mesh);
  };
  const double volume = 12e-3 * 12e-3 * 20e-3;
  CHECK(volume_of({"--spacing-mm", "4"}) == Approx(volume).epsilon(1e-12));
  CHECK(volume_of({"--spacing-mm", "4", "--extent", "half"}) == Approx(volume).epsilon(1e-12));
  CHECK(volume_of({"--spacing-mm", "4", "--extent", "full"}) == Approx(volume).epsilon(1e-12));
  CHECK(volume_of({"--spacing-mm", "4", "--mesh-unit", "cm"}) == Approx(1e3 * volume).epsilon(1e-12));
}

TEST_CASE("options of own meshes and parts that do not fit are refused") {
  const TemporaryFolder folder;
  const std::string k = (folder.path / "b.k").string(), p = (folder.path / "p.toml").string();
  write(k, mesh_io_test::k_text(block()));
  const char *mesh = k.c_str();
  CHECK(refusal({"--projectile-mesh", "a.stl"}) ==
        "--projectile-mesh = a.stl: must be a file that ends in .k, .key, .dyn, .inp or .vtu");
  CHECK_THAT(refusal({"--projectile-mesh", "gone.k"}),
             StartsWith("--projectile-mesh = gone.k: must be a mesh file that can be read"));
  CHECK(refusal({"--projectile-mesh", mesh, "--nose", "blunt"}) ==
        "--nose = blunt: contradicts projectile_mesh: give one of them");
  CHECK_THAT(refusal({"--projectile-mesh", mesh, "--diameter-mm", "12"}),
             StartsWith("--diameter-mm = 12: contradicts projectile_mesh, which gives 16.97"));
  CHECK(refusal({"--projectile-mesh", mesh, "--bore-radius-mm", "3"}) ==
        "--bore-radius-mm = 3: contradicts projectile_mesh: give one of them");
  CHECK(refusal({"--nose", "mesh"}) == "--nose = mesh: needs --projectile-mesh FILE");
  CHECK(refusal({"--projectile-mesh", mesh, "--part-metals", "3=lead"}) ==
        "--part-metals = 3: must be one of the parts 1, 2");
  CHECK(refusal({"--projectile-mesh", mesh, "--part-metals", "2=lead,2=lead"}) ==
        "--part-metals = 2: must be given once");
  CHECK_THAT(refusal({"--projectile-mesh", mesh, "--part-metals", "lead"}),
             StartsWith("--part-metals = lead: must be PART=METAL with commas between them"));
  CHECK_THAT(refusal({"--projectile-mesh", mesh, "--part-metals", "2=leed"}),
             StartsWith("--part-metals, 2 = leed: must be one of arne_tool_steel"));
  CHECK(refusal({"--part-metals", "core=lead"}) ==
        "--part-metals = core: needs a projectile with parts: --core-profile-mm, or a mesh with several");
  CHECK(refusal({"--bore-radius-mm", "3"}) == "--bore-depth-mm = 0: must be positive with --bore-radius-mm");
  CHECK(refusal({"--bore-depth-mm", "3"}) == "--bore-depth-mm = 3: needs --bore-radius-mm");
  CHECK(refusal({"--bore-radius-mm", "3", "--bore-depth-mm", "90"}) ==
        "--bore-depth-mm = 90: must be at most the length, 80 mm");
  CHECK_THAT(refusal({"--bore-radius-mm", "9.9", "--bore-depth-mm", "30"}),
             StartsWith("--bore-radius-mm: radius at z = 0.050000 m of inner surface 1 (m) = 0.0099: must be at most"));
  CHECK(refusal({"--filler-profile-mm", "1,2,3,4"}) == "--filler-profile-mm = 4: needs --core-profile-mm");
  write(p, "mesh = \"b.k\"\n[part.2]\nmetals = \"lead\"\n");
  CHECK(refusal({"--projectile", p.c_str()}) ==
        p + ":2: part.2 = a table: must be a table [part.NAME] with metal = \"NAME or FILE.toml\"");
  write(p, "mesh = \"b.k\"\npart = 3\n");
  CHECK(refusal({"--projectile", p.c_str()}) ==
        p + ":2: part = 3: must be a table [part.NAME] with metal = \"NAME or FILE.toml\"");
}

TEST_CASE("the whole bullet is three parts of three metals") {
  const Options o = options_of({"--projectile", "apm2_762", "--spacing-mm", "1"});
  CHECK(shot::parts_of(o) == std::vector<std::string>{"jacket", "filler", "core"});
  CHECK(shot::part_materials(o) == std::vector<std::string>{"gilding_metal", "lead", "apm2_core_steel"});
  CHECK(shot::projectile_metals_of(o).size() == 3);
  CHECK(o.mass_g == 10.7);
  // The masses of the parts, by their own densities, are within 2 % of that of the whole as it is quoted.
  const auto volumes = ogive::part_volumes(shot::shape_of(o));
  double mass = 0;
  for (std::size_t k = 0; k < 3; ++k)
    std::visit([&](const auto &metal) { mass += metal.density * volumes[k]; }, shot::projectile_metals_of(o)[k]);
  CHECK(1e3 * mass == Approx(10.7).epsilon(0.02));
  const Options other =
      options_of({"--projectile", "apm2_762", "--spacing-mm", "1", "--part-metals", "filler=ofhc_copper"});
  CHECK(shot::part_materials(other) == std::vector<std::string>{"gilding_metal", "ofhc_copper", "apm2_core_steel"});
}
