// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"

#include "shot/defaults.hpp"
#include "shot/table.hpp"

using shot::Options;

TEST_CASE("without arguments the options are the main job") {
  const Options o = options_of({});
  CHECK(o == Options{});
  CHECK(o.out == "vtk_out/weldox_460e_mjc_blunt_12mm_303.5mps");
  CHECK(shot::default_out(o) == o.out);
  CHECK(shot::settled({}) == o);
}

TEST_CASE("friction, end and folder follow from the case unless given") {
  const Options steel = options_of({"--nose", "conical"});
  CHECK(steel.friction == 0.02);
  CHECK(steel.end_us == 2180); // six passages of 110 mm at 303.5 m/s
  const Options aluminium = options_of({"--nose", "conical", "--material=aa5083_h116", "--thickness-mm", "15"});
  CHECK(aluminium.friction == 0.02);
  CHECK(options_of({"--nose", "conical", "--method", "paper"}).friction == 0.08);
  CHECK(options_of({"--nose", "conical", "--method", "paper", "--material", "aa5083_h116"}).friction == 0.02);
  CHECK(options_of({"--method", "paper"}).friction == 0);
  CHECK(aluminium.out == "vtk_out/aa5083_h116_mjc_conical_15mm_303.5mps");
  const Options given = options_of({"--friction", "0.1", "--nose", "ogival", "--end-us", "50", "--out", "here"});
  CHECK(given.friction == 0.1);
  CHECK(given.end_us == 50);
  CHECK(given.out == "here");
}

TEST_CASE("cases that differ have folders of their own") {
  const std::string usual = Options{}.out.string();
  using Arguments = std::vector<const char *>;
  const auto suffix = [&](const Arguments &arguments) {
    const std::string out = options_of(arguments).out.string();
    return out.starts_with(usual) ? out.substr(usual.size()) : out;
  };
  CHECK(suffix({"--spacing-mm", "1"}) == "_spacing_mm=1");
  CHECK(suffix({"--damage", "none"}) == "_damage=none");
  CHECK(suffix({"--damage", "cockcroft_latham", "--failure", "removal"}) == "_damage=cockcroft_latham_failure=removal");
  CHECK(suffix({"--method", "paper"}) == "_paper");
  CHECK(suffix({"--method", "paper", "--lattice", "ring", "--seed", "3"}) == "_paper_lattice=ring_seed=3");
  CHECK(suffix({"--obliquity-deg", "30", "--extent", "half"}) == "_30deg_extent=half");
  CHECK(suffix({"--spacing-mm", "0.6", "--friction", "0", "--threads", "1", "--quiet", "--end-us", "300"}).empty());
  CHECK(options_of({"--nose", "conical", "--nose-length-mm", "40"}).out ==
        "vtk_out/weldox_460e_mjc_conical_12mm_303.5mps_nose_length_mm=40");
}

TEST_CASE("the command line overrides the file, and the last of a flag counts") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string();
  write(file, "thickness_mm = 8\nvelocity_mps = 250.5\nnose = \"ogival\"\nvtk = false\npicture = false\n");
  const Options o = options_of({"--velocity-mps", "1", "--config", file.c_str(), "--velocity-mps", "260", "--vtk"});
  CHECK(o.thickness_mm == 8);
  CHECK(o.velocity_mps == 260);
  CHECK(o.nose == shot::Nose::ogival);
  CHECK(o.friction == 0.02);
  CHECK(o.vtk);
  CHECK_FALSE(o.picture);
  CHECK_FALSE(options_of({"--no-vtk"}).vtk);
}

TEST_CASE("case.toml runs the same case again") {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "case.toml").string();
  Options all;
  all.material = "aa5083_h116_25mm";
  all.model = shot::FlowModel::jc;
  all.method = shot::Method::stabilised;
  all.damage = shot::DamageLaw::cockcroft_latham;
  all.damage_softening = 0.25;
  all.band_onset = 0.7;
  all.damage_pressure = shot::DamagePressure::own;
  all.failure = shot::FailureEffect::removal;
  all.thickness_mm = 25.1;
  all.clamp_radius_mm = 100.0 + 1.0 / 3;
  all.nose = shot::Nose::hemispherical;
  all.rigid = true;
  all.projectile_metal = "fsp_steel";
  all.tail_length_mm = 12.5;
  all.tail_diameter_mm = 15;
  all.velocity_mps = 1000.0 / 7;
  all.friction = 1.0 / 30;
  all.end_us = 100000;
  all.settle_us = 2500.5;
  all.spacing_mm = 2.0 / 3;
  all.sph_radius_mm = 30;
  all.extent = shot::Extent::half;
  all.lattice = shot::Lattice::cubic;
  all.seed = 12;
  all.form = shot::SphForm::standard;
  all.kernel = shot::SphKernel::wendland_c2;
  all.smoothing = shot::Smoothing::variable;
  all.element = shot::ElementRule::selective_reduced;
  all.pressure = shot::PressureLaw::mie_gruneisen;
  all.control_stiffness = 0.2;
  all.contact_stiffness = 0.05;
  all.linear_viscosity = 0.1;
  all.quadratic_viscosity = 2;
  all.out = "a \"quoted\" \\ folder";
  all.output_every_us = 0.5;
  all.checkpoint_every_us = 20;
  all.vtk = false;
  all.picture = false;
  all.quiet = true;
  all.threads = 3;
  for (const Options &o : {all, Options{}, options_of({"--nose", "conical", "--velocity-mps", "214.1"})}) {
    write(file, shot::to_toml(o));
    CHECK(options_of({"--config", file.c_str()}) == o);
  }
}
