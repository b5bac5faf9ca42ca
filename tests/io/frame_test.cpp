// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fem/hex_body.hpp"
#include "ogive/io/frame.hpp"
#include "ogive/material/library.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sph/body.hpp"

#include "catch.hpp"

using namespace ogive;

namespace {

MaterialPoint<double> stressed_point() {
  MaterialPoint<double> p;
  p.deviator = {200e6, -100e6, -100e6, 30e6, 40e6, 50e6};
  p.pressure = 150e6;
  p.density = 7800;
  p.plastic_strain = 0.25;
  p.plastic_strain_rate = 5e3;
  p.temperature = 400;
  p.damage = 0.5;
  return p;
}

/// Two particles, then one hex with a material point at each corner, of which the second half is unstressed.
auto particles_and_hex() {
  using Particles = SphBody<double, ModifiedJohnsonCook<double>>;
  using Hexes = HexBody<double, Bilinear<double>, SelectiveReduced>;
  Nodes<double> nodes;
  Particles plate;
  plate.name = "plate";
  plate.metal = library::weldox_460e_mjc<double>();
  plate.spacing = 0.6e-3;
  plate.nodes = add_nodes(nodes, {{1e-3, 2e-3, 3e-3}, {4e-3, 5e-3, 6e-3}});
  fill(plate.points, 2, stressed_point());
  store(plate.points, 1, initial_point(plate.metal));

  Hexes projectile;
  projectile.name = "projectile";
  projectile.metal = library::arne_tool_steel<double>();
  projectile.nodes =
      add_nodes(nodes, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  set_velocity(nodes, projectile.nodes, Vec3<double>(1, 2, -300));
  projectile.hexes = {{2, 3, 4, 5, 6, 7, 8, 9}};
  projectile.corners_of_nodes = corners_of_nodes(projectile.hexes, projectile.nodes);
  fill(projectile.points, 8, stressed_point());
  for (Index i = 4; i < 8; ++i) store(projectile.points, i, MaterialPoint<double>{});
  Model model{std::move(nodes), std::tuple{std::move(plate), std::move(projectile)}, SymmetryPlanes{false, true}};
  model.time = 42e-6;
  return model;
}

std::vector<float> values(const std::vector<Field> &fields, const char *name) {
  return find_field(fields, name, "part").values;
}

} // namespace

TEST_CASE("a frame has the bodies of the model in their order") {
  const Frame frame = gather_frame(particles_and_hex());
  CHECK(frame.time == 42e-6);
  CHECK(!frame.symmetry.x);
  CHECK(frame.symmetry.y);
  REQUIRE(frame.clouds.size() == 1);
  REQUIRE(frame.grids.size() == 1);
  CHECK(frame.clouds[0].name == "plate");
  CHECK(frame.clouds[0].part == 0);
  CHECK(frame.clouds[0].diameter == 0.6e-3F);
  CHECK(frame.grids[0].name == "projectile");
  CHECK(frame.grids[0].part == 1);
}

TEST_CASE("a frame's positions are each body's own, and hexes point at them") {
  const Frame frame = gather_frame(particles_and_hex());
  REQUIRE(frame.clouds[0].positions.size() == 2);
  CHECK(frame.clouds[0].positions[1] == Vec3<float>(4e-3F, 5e-3F, 6e-3F));
  REQUIRE(frame.grids[0].positions.size() == 8);
  CHECK(frame.grids[0].positions[6] == Vec3<float>(1, 1, 1));
  CHECK(frame.grids[0].hexes == std::vector<std::array<Index, 8>>{{0, 1, 2, 3, 4, 5, 6, 7}});
}

TEST_CASE("a particle's state is given in the units that the fields name") {
  const auto fields = gather_frame(particles_and_hex()).clouds[0].fields;
  const auto stress = values(fields, "stress_MPa");
  CHECK(std::vector(stress.begin(), stress.begin() + 6) == std::vector<float>{50, -250, -250, 30, 40, 50});
  const double expected_von_mises = std::sqrt(1.5 * (4e4 + 1e4 + 1e4 + 2 * (900 + 1600 + 2500)));
  CHECK(values(fields, "von_mises_MPa")[0] == Approx(expected_von_mises));
  CHECK(values(fields, "pressure_MPa") == std::vector<float>{150, 0});
  CHECK(values(fields, "plastic_strain") == std::vector<float>{0.25F, 0});
  CHECK(values(fields, "plastic_strain_rate_per_s") == std::vector<float>{5000, 0});
  CHECK(values(fields, "temperature_K") == std::vector<float>{400, 293});
  CHECK(values(fields, "damage") == std::vector<float>{0.5F, 0});
  CHECK(values(fields, "density_kg_per_m3") == std::vector<float>{7800, 7850});
  CHECK(values(fields, "velocity_m_per_s") == std::vector<float>(6, 0.F));
}

TEST_CASE("a hex with several material points shows their mean") {
  const HexGrid grid = gather_frame(particles_and_hex()).grids[0];
  CHECK(values(grid.cell_fields, "pressure_MPa") == std::vector<float>{75});
  CHECK(values(grid.cell_fields, "plastic_strain") == std::vector<float>{0.125F});
  const auto stress = values(grid.cell_fields, "stress_MPa");
  REQUIRE(stress.size() == 6);
  CHECK(stress[0] == Approx(25));
  CHECK(stress[5] == Approx(25));
  const auto velocity = values(grid.point_fields, "velocity_m_per_s");
  REQUIRE(velocity.size() == 24);
  CHECK(std::vector(velocity.begin() + 21, velocity.end()) == std::vector<float>{1, 2, -300});
}

TEST_CASE("a field that is missing is named together with those there are") {
  const auto grid = gather_frame(particles_and_hex()).grids[0];
  CHECK_THROWS_WITH(find_field(grid.point_fields, "heat", "projectile"),
                    "projectile field = heat: must be one of velocity_m_per_s");
}
