// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "mesh_io/sample.hpp"

#include "ogive/mesh/nested_mesh.hpp"
#include "ogive/mesh_io/own_projectile.hpp"
#include "ogive/mesh_io/read_abaqus.hpp"
#include "ogive/mesh_io/read_ls_dyna.hpp"

using namespace mesh_io_test;

namespace {

/// As from a file.
FileMesh from_file(const PartMesh<double> &body) { return read_ls_dyna_mesh(k_text(body), "a.k", 1e-3); }

std::string refused(const PartMesh<double> &body, Extent extent = Extent::quarter) {
  return refusal([&] { own_projectile(from_file(body), extent); });
}

/// A block of 8 x 4 x 6 mm around the z axis whose upper half is another part.
PartMesh<double> block() {
  auto body = bricks({-4e-3, -2e-3, 0, 2e-3, 4e-3}, {-2e-3, 0, 2e-3}, {1e-3, 4e-3, 7e-3});
  body.parts = {"1", "7"};
  for (std::size_t e = 0; e < body.mesh.hexes.size(); ++e) body.part_of.push_back(e < 8 ? 0 : 1);
  return body;
}

/// A cylinder of two parts, a core of 6 mm in a jacket of 10 mm in diameter, for an extent; whole micrometres.
PartMesh<double> cylinder(Extent extent) {
  ProjectileShape<double> shape{Nose::blunt, 10e-3, 20e-3};
  shape.inner = {bore(3e-3, 20e-3, 20e-3)};
  auto quarter = nested_mesh(shape, 1.5e-3, Extent::quarter);
  for (auto &x : quarter.mesh.positions)
    for (int d = 0; d < 3; ++d) x[d] = 1e-3 * (std::round(x[d] * 1e6) / 1e3); // as a reader makes it of millimetres
  quarter.parts = {"1", "2"};
  return extended(quarter, extent);
}

} // namespace

TEST_CASE("a quarter and a half of a symmetric mesh are cut, its tip comes to z = 0") {
  const auto mesh = from_file(block());
  for (const Extent extent : {Extent::quarter, Extent::half, Extent::full}) {
    const auto own = own_projectile(mesh, extent);
    const int copies = symmetry_planes(extent).copies();
    CHECK(own.body.mesh.hexes.size() == std::size_t(16 / copies));
    CHECK(copies * volume(own.body.mesh) == Approx(8e-3 * 4e-3 * 6e-3).epsilon(1e-12));
    const auto parts = part_volumes(own.body);
    CHECK(parts[0] == Approx(parts[1]).epsilon(1e-12));
    CHECK(own.body.parts == std::vector<std::string>{"1", "7"});
    CHECK(own.shape.mesh_volume == Approx(8e-3 * 4e-3 * 6e-3).epsilon(1e-12));
    CHECK(own.shape.diameter == Approx(2 * std::hypot(4e-3, 2e-3)));
    CHECK(length(own.shape) == Approx(6e-3));
    CHECK_FALSE(is_sharp(own.shape));
    double lowest = 1;
    for (const auto &x : own.body.mesh.positions) lowest = std::min(lowest, x[2]);
    CHECK(lowest == 0);
    // Nodes in mirror planes lie there to the last bit.
    CHECK(boundary_facets(own.body.mesh).size() > facets_off_planes(boundary_facets(own.body.mesh),
                                                                    own.body.mesh.positions,
                                                                    symmetry_planes(Extent::quarter), 0.0)
                                                          .size() *
                                                      (extent == Extent::full ? 0 : 1));
  }
}

TEST_CASE("a mesh of the extent that the model has is taken as it is, and a smaller one is mirrored") {
  for (const Extent extent : {Extent::quarter, Extent::half, Extent::full}) {
    const auto body = cylinder(extent);
    const auto same = own_projectile(from_file(body), extent);
    CHECK(same.body.mesh.hexes == body.mesh.hexes);
    CHECK(same.body.mesh.positions == body.mesh.positions);
    CHECK(same.body.part_of == body.part_of);
  }
  const auto quarter = from_file(cylinder(Extent::quarter));
  const auto full = own_projectile(quarter, Extent::full);
  CHECK(full.body.mesh.hexes == cylinder(Extent::full).mesh.hexes);
  // A whole mesh, cut, has the hexes of the quarter again.
  const auto cut = own_projectile(from_file(cylinder(Extent::full)), Extent::quarter);
  CHECK(4 * volume(cut.body.mesh) == Approx(volume(full.body.mesh)).epsilon(1e-12));
  CHECK(cut.body.mesh.hexes.size() == quarter.body.mesh.hexes.size());
  // Two parts: the analytic volumes of core and jacket, less what rounding to micrometres costs.
  const auto parts = part_volumes(full.body);
  CHECK(parts[1] == Approx(std::numbers::pi * 9e-6 * 20e-3).epsilon(1e-3));
  CHECK(parts[0] + parts[1] == Approx(std::numbers::pi * 25e-6 * 20e-3).epsilon(1e-3));
}

TEST_CASE("the same body from LS-DYNA and from Abaqus is the same mesh to the last bit") {
  const auto body = cylinder(Extent::full);
  const auto k = own_projectile(read_ls_dyna_mesh(k_text(body), "a.k", 1e-3), Extent::quarter);
  const auto inp = own_projectile(read_abaqus_mesh(inp_text(body), "a.inp", 1e-3), Extent::quarter);
  CHECK(k.body.mesh.positions == inp.body.mesh.positions);
  // Sets of Abaqus group the elements by part in the file; the numbers of the elements give the order.
  CHECK(k.body.mesh.hexes == inp.body.mesh.hexes);
  CHECK(k.body.parts == inp.body.parts);
  CHECK(k.body.part_of == inp.body.part_of);
}

TEST_CASE("parts that touch may have nodes of their own, and are cut and mirrored like one body") {
  for (const Extent extent : {Extent::quarter, Extent::half, Extent::full}) {
    const auto shared = cylinder(Extent::full), apart = separated(shared);
    // Tied parts must share their nodes.
    CHECK_THAT(refused(apart, extent), Catch::Matchers::Contains("must be one node, tied parts share the nodes"));
    const auto own = own_projectile(from_file(apart), extent, Parts::touching);
    const auto same = own_projectile(from_file(shared), extent, Parts::touching);
    const auto tied = own_projectile(from_file(shared), extent);
    CHECK(part_volumes(own.body) == part_volumes(tied.body));
    CHECK(own.shape.diameter == tied.shape.diameter);
    CHECK(separated(own.body).mesh.positions == separated(same.body).mesh.positions);
    CHECK(separated(own.body).mesh.hexes == separated(same.body).mesh.hexes);
  }
  // Each part must be one closed body.
  auto body = block();
  body.part_of.assign(16, 0);
  body.part_of[0] = body.part_of[15] = 1; // at opposite corners
  CHECK_THAT(refusal([&] { own_projectile(from_file(body), Extent::full, Parts::touching); }),
             Catch::Matchers::Contains("all hexes must be one body, connected by faces"));
}

TEST_CASE("meshes that are no closed symmetric body of good hexes are refused with hex or node") {
  auto body = block();
  std::swap(body.mesh.hexes[2][0], body.mesh.hexes[2][4]), std::swap(body.mesh.hexes[2][1], body.mesh.hexes[2][5]);
  std::swap(body.mesh.hexes[2][2], body.mesh.hexes[2][6]), std::swap(body.mesh.hexes[2][3], body.mesh.hexes[2][7]);
  CHECK(refused(body) ==
        "a.k:52: hex 3: is inverted, the smallest Jacobian of its corners = -12 mm3: must be positive; "
        "nodes 1 to 4 are the lower face, counter-clockwise seen from nodes 5 to 8 above");

  body = block();
  body.mesh.positions[16][0] = -0.1e-3, body.mesh.positions[16][1] = 1.95e-3, body.mesh.positions[16][2] = 6.9e-3;
  CHECK_THAT(refused(body, Extent::full), Catch::Matchers::StartsWith("a.k:"));
  CHECK_THAT(refused(body, Extent::full), Catch::Matchers::Contains("must be"));

  body = block();
  body.mesh.positions.push_back(body.mesh.positions[0]);
  body.mesh.hexes[0][0] = static_cast<Index>(body.mesh.positions.size()) - 1;
  body.mesh.positions[0][2] += 1e-9; // is nobody's any more
  CHECK(refused(body, Extent::full) == "");

  body = bricks({0, 1e-6}, {0, 1e-6}, {4.0, 4.000001});
  CHECK(refused(body) ==
        "a.k: width = 0.00173 mm: must be at least a millionth of the distance from the origin, 4e+03 mm");

  body = bricks({0, 1e-3}, {0, 1e-3}, {0, 1e-3, 2e-3});
  const Index shift = static_cast<Index>(body.mesh.positions.size());
  for (Index n = 4; n < 8; ++n) body.mesh.positions.push_back(body.mesh.positions[n]);
  for (int a = 0; a < 4; ++a) body.mesh.hexes[1][a] += shift - 4;
  CHECK(refused(body) ==
        "a.k: node 5: lies where node 13 lies, at (0, 0, 1) mm: must be one node, tied parts share the "
        "nodes where they meet");

  body = bricks({0, 1e-3}, {0, 1e-3}, {0, 1e-3, 2e-3, 3e-3});
  body.mesh.hexes.erase(body.mesh.hexes.begin() + 1);
  CHECK(refused(body) == "a.k:22: hex 2: is not connected to hex 1: all hexes must be one body, connected by faces");
  body.mesh.hexes = {body.mesh.hexes[0], body.mesh.hexes[0]};
  CHECK_THAT(refused(body), Catch::Matchers::Contains("hex 2: overlaps hex 1: a face may belong to two hexes"));

  // Two bricks that meet along an edge, connected by a third and a fourth elsewhere.
  body = bricks({0, 1e-3, 2e-3}, {0, 1e-3, 2e-3}, {0, 1e-3, 2e-3});
  body.mesh.hexes.erase(body.mesh.hexes.begin() + 5), body.mesh.hexes.erase(body.mesh.hexes.begin() + 5);
  CHECK_THAT(refused(body),
             Catch::Matchers::EndsWith("belongs to 4 faces of the surface: must be 2, a closed surface"));
}

TEST_CASE("a mesh that cannot be cut is refused with the plane") {
  auto body = bricks({-2e-3, 2e-3}, {-2e-3, 0, 2e-3}, {0, 3e-3});
  CHECK(refused(body) == "a.k:17: hex 1: straddles the plane x = 0: the mesh cannot be cut there");
  CHECK(refused(body, Extent::half) == "");
  body = block();
  for (auto &x : body.mesh.positions)
    if (x[0] == 4e-3) x[0] = 5e-3;
  CHECK(refused(body) ==
        "a.k: node 1: has no image at (4, -2, 1) mm: the mesh must be symmetric about x = 0, or the model "
        "a full one");
  body = block();
  body.part_of[0] = 1;
  CHECK(refused(body) == "a.k:50: hex 1: has no image of the same part: the mesh must be symmetric about x = 0, or the "
                         "model a full one");
  body = bricks({-2e-3, -1e-3}, {0, 1e-3}, {0, 3e-3});
  CHECK(refused(body) ==
        "a.k: lies at x = -2 to -1 mm: must lie on both sides of x = 0, or end there and lie where x is "
        "positive");
  body = bricks({-1e-3, 4e-3}, {-1e-3, 1e-3}, {0, 3e-3});
  CHECK(refused(body, Extent::full) ==
        "a.k: centre of volume at x = 1.5 mm: must lie on the z axis, the line of flight");
}
