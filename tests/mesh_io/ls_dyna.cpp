// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "mesh_io/sample.hpp"

#include "ogive/mesh_io/read_ls_dyna.hpp"

using namespace mesh_io_test;

namespace {

FileMesh read(const std::string &text, double unit = 1e-3) { return read_ls_dyna_mesh(text, "a.k", unit); }
std::string refused(const std::string &text) {
  return refusal([&] { read(text); });
}

/// A unit cube as a file of columns, with what stands before and behind the nodes and the solid.
const std::string nodes = "*NODE\n"
                          "$    nid               x               y               z\n"
                          "       1             0.0             0.0             0.0       0       0\n"
                          "       2             1.0             0.0             0.0\n"
                          "       3           1.0d0             1.0             0.0\n"
                          "       4             0.0          1.0+00             0.0\n"
                          "      15             0.0             0.0             1.0\n"
                          "       6             1.0             0.0             1.0\n"
                          "       7             1.0             1.0             1.0\n"
                          "       8             0.0             1.0             1.5\n";
const std::string solid = "      12       3       1       2       3       4      15       6       7       8\n";

} // namespace

TEST_CASE("an LS-DYNA mesh is read from columns, with its numbers, part and lines") {
  const auto mesh = read("*KEYWORD\n*TITLE\na bullet\n" + nodes + "*PART\ncore\n       3       1       1\n" +
                         "*ELEMENT_SOLID\n$#   eid     pid\n" + solid + "*END\n*INCLUDE\nnever.k\n");
  REQUIRE(mesh.body.mesh.positions.size() == 8);
  CHECK(mesh.body.mesh.positions[1] == Vec3<double>(1e-3, 0, 0));
  CHECK(mesh.body.mesh.positions[2] == Vec3<double>(1e-3, 1e-3, 0));
  CHECK(mesh.body.mesh.positions[3] == Vec3<double>(0, 1e-3, 0));
  CHECK(mesh.body.mesh.positions[6] == Vec3<double>(0, 1e-3, 1e-3 * 1.5));
  CHECK(mesh.body.mesh.hexes == std::vector<std::array<Index, 8>>{{0, 1, 2, 3, 7, 4, 5, 6}});
  CHECK(mesh.node_numbers == std::vector<std::int64_t>{1, 2, 3, 4, 6, 7, 8, 15}); // in their order
  CHECK(mesh.hex_numbers == std::vector<std::int64_t>{12});
  CHECK(mesh.hex_lines == std::vector<long>{19});
  CHECK(mesh.body.parts == std::vector<std::string>{"3"});
  CHECK(read(nodes + "*ELEMENT_SOLID\n" + solid, 25.4e-3).body.mesh.positions[1][0] == 25.4e-3);
}

TEST_CASE("commas, the long format, solids on two lines and the line ends of Windows give the same mesh") {
  const auto mesh = read(nodes + "*ELEMENT_SOLID\n" + solid);
  const auto same = [&](const std::string &text) {
    const auto other = read(text);
    return other.body.mesh.positions == mesh.body.mesh.positions && other.body.mesh.hexes == mesh.body.mesh.hexes &&
           other.body.parts == mesh.body.parts;
  };
  std::string windows = "\xef\xbb\xbf" + nodes + "*ELEMENT_SOLID\n" + solid;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.insert(at, 1, '\r');
  CHECK(same(windows));
  CHECK(same(nodes + "*ELEMENT_SOLID (ten nodes format)\n      12       3\n"
                     "       1       2       3       4      15       6       7       8       0       0\n"));
  CHECK(same(nodes + "*element_solid\n      12       3\n"
                     "       1       2       3       4      15       6       7       8       0       0\n"));
  CHECK(same(nodes + "*ELEMENT_SOLID\n12,\t3, 1,2,3,4, 15,6,7,8\n"));
  CHECK(same(nodes + "*ELEMENT_SOLID+\n                  12                   3\n"
                     "                   1                   2                   3                   4"
                     "                  15                   6                   7                   8\n"));
}

TEST_CASE("damaged LS-DYNA meshes are refused with file, line and reason") {
  const std::string solids = nodes + "*ELEMENT_SOLID\n";
  CHECK(refused("") == "a.k: hexes = 0: must be at least 1");
  CHECK(refused(nodes) == "a.k: hexes = 0: must be at least 1");
  CHECK(refused("*INCLUDE\nother.k\n") == "a.k:1: *INCLUDE: other files are not read; put the mesh into one file");
  CHECK(refused(solids + solid + "*ELEMENT_SHELL\n") == "a.k:13: *ELEMENT_SHELL: must be *ELEMENT_SOLID, hexes alone");
  CHECK(refused("*NODE_TRANSFORM\n") == "a.k:1: *NODE_TRANSFORM: must be *NODE");
  CHECK(refused(nodes + "       7             1.0             1.0             1.0\n") ==
        "a.k:11: node 7: is given a second time");
  CHECK(refused(solids + solid + solid) == "a.k:13: hex 12: is given a second time, the first is in line 12");
  CHECK(refused(solids + "      12       3       1       2       3       4      15       6       7       9\n") ==
        "a.k:12: hex 12: node 9: must be a node of the file");
  CHECK(
      refused(solids + "      12       3       1       2       3       4      15      15      15      15\n") ==
      "a.k:12: hex 12: has node 15 twice: wedges, pyramids and tetrahedra cannot be taken, only hexes of eight nodes");
  CHECK(refused(solids + "12,3,1,2,3,4,15,6,7\n") == "a.k:12: hex 12: nodes = 7: must be 8");
  CHECK(refused(solids + "12,3,1,2,3,4,15,6,7,8,9,10\n") == "a.k:12: hex 12: has 9 nodes: must be a hex of 8");
  CHECK(refused(solids + "      12       3\n*END\n") == "a.k:12: hex 12: its nodes are missing");
  CHECK(refused(solids + "      12\t       3\n") ==
        "a.k:12: has a tab, with which columns cannot be counted; put blanks in its place");
  CHECK(refused(solids + "12,3,1,2,3,4,15,6,7,x\n") == "a.k:12: node = x: must be a whole number from 1 on");
  CHECK(refused(solids + "12,0,1,2,3,4,15,6,7,8\n") == "a.k:12: part = 0: must be a whole number from 1 on");
  CHECK(refused("*NODE\n1,0,0\n") == "a.k:2: fields of a node = 3: must be 4, number, x, y and z");
  CHECK(refused("*NODE\n1,0,0,abc\n") == "a.k:2: z = abc: must be a number");
  CHECK(refused("*NODE\n1,0,0,1e9\n") == "a.k:2: node 1: coordinates must be finite and below 1000 m");
}
