// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "mesh_io/sample.hpp"

#include "ogive/mesh_io/read_abaqus.hpp"

using namespace mesh_io_test;

namespace {

FileMesh read(const std::string &text, double unit = 1e-3) { return read_abaqus_mesh(text, "a.inp", unit); }
std::string refused(const std::string &text) {
  return refusal([&] { read(text); });
}

const std::string nodes =
    "*Heading\n** a comment\n*Node, nset=all\n 1, 0., 0., 0.\n2,1.,0.,0.\n3,\t1.,1.,0.\n4,0,1.,0\n"
    "5,0,0,1.\n6,1,0,1\n7,1,1,1\n8,0,1,1.5\n9,5,5,5\n";

} // namespace

TEST_CASE("an Abaqus mesh is read with its sets as parts; keywords and elements go on over lines") {
  const auto mesh =
      read(nodes + "*Element, type=C3D8R,\n elset=\"Hard core\"\n12, 1,2,3,4,\n 5,6,7,8\n"
                   "*Solid Section, elset=hard core, material=steel\n,\n*Material, name=steel\n*Density\n7.8e-9\n");
  REQUIRE(mesh.body.mesh.positions.size() == 8); // node 9 belongs to nothing
  CHECK(mesh.body.mesh.positions[7] == Vec3<double>(0, 1e-3, 1e-3 * 1.5));
  CHECK(mesh.body.mesh.hexes == std::vector<std::array<Index, 8>>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(mesh.hex_numbers == std::vector<std::int64_t>{12});
  CHECK(mesh.hex_lines == std::vector<long>{15});
  CHECK(mesh.body.parts == std::vector<std::string>{"Hard_core"});
  std::string windows = nodes + "*ELEMENT,TYPE=C3D8\n12,1,2,3,4,5,6,7,8\n";
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.insert(at, 1, '\r');
  const auto same = read(windows);
  CHECK(same.body.mesh.positions == mesh.body.mesh.positions);
  CHECK(same.body.parts == std::vector<std::string>{"1"});
}

TEST_CASE("damaged Abaqus meshes are refused with file, line and reason") {
  const std::string solids = nodes + "*ELEMENT, TYPE=C3D8R, ELSET=core\n";
  CHECK(refused("*INCLUDE, INPUT=other.inp\n") ==
        "a.inp:1: *INCLUDE: other files are not read; put the mesh into one file");
  CHECK(refused("*NODE, INPUT=nodes.txt\n") ==
        "a.inp:1: *NODE, INPUT: other files are not read; put the mesh into one file");
  CHECK(refused("*NODE, SYSTEM=C\n") == "a.inp:1: *NODE, SYSTEM: must be rectangular");
  CHECK(refused("*NGEN\n") == "a.inp:1: *NGEN: must be written out as nodes and elements");
  CHECK(refused(nodes + "*ELEMENT, TYPE=C3D4\n") ==
        "a.inp:13: *ELEMENT, TYPE = C3D4: must be C3D8, C3D8R or C3D8I, hexes alone");
  CHECK(refused(nodes + "*ELEMENT\n") == "a.inp:13: *ELEMENT, TYPE = : must be C3D8, C3D8R or C3D8I, hexes alone");
  CHECK(refused(solids + "1,1,2,3,4,5,6,7\n") == "a.inp:14: fields of an element = 8: must be 9, number and 8 nodes");
  CHECK(refused(solids + "1,1,2,3,4,\n*END PART\n") ==
        "a.inp:14: fields of an element = 5: must be 9, number and 8 nodes");
  CHECK(
      refused(solids + "1,1,2,3,4,5,6,7,7\n") ==
      "a.inp:14: hex 1: has node 7 twice: wedges, pyramids and tetrahedra cannot be taken, only hexes of eight nodes");
  CHECK(refused(solids + "1,1,2,3,4,5,6,7,10\n") == "a.inp:14: hex 1: node 10: must be a node of the file");
  CHECK(refused(solids + "1,1,2,3,4,5,6,7,8\n*INSTANCE, NAME=a, PART=b\n0.,0.,5.\n") ==
        "a.inp:16: moves an instance: its nodes must have their final coordinates");
  CHECK(refused(solids + "1,1,2,3,4,5,6,7,8\n*SOLID SECTION, ELSET=other, MATERIAL=m\n") ==
        "a.inp:15: *SOLIDSECTION, ELSET = OTHER: must be a set of *ELEMENT, ELSET=; those of *ELSET are not read");
  // Capitals and blanks have no meaning in names; what a file name cannot have is an underscore.
  const auto two = read(nodes + "*ELEMENT, TYPE=C3D8, ELSET=Core\n1,1,2,3,4,5,6,7,8\n*ELEMENT, TYPE=C3D8, ELSET=CORE\n"
                                "2,5,6,7,8,1,2,3,4\n");
  CHECK(two.body.parts == std::vector<std::string>{"Core"});
  CHECK(refused(solids + "1,1,2,3,4,5,6,7,8\n*ELEMENT, TYPE=C3D8, ELSET=a+b\n2,1,2,3,4,5,6,7,8\n*ELEMENT, TYPE=C3D8, "
                         "ELSET=a/b\n3,1,2,3,4,5,6,7,8\n") ==
        "a.inp:17: *ELEMENT, ELSET = a/b: must differ from other sets by letters, digits, '-', '_' or '.'");
  CHECK(refused(nodes + "3,1,1,0\n") == "a.inp:13: node 3: is given a second time");
}
