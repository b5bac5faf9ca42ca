// SPDX-License-Identifier: BSD-3-Clause
#include "shot/tested_range.hpp"

#include "apps/parse.hpp"
#include "catch.hpp"

namespace {

std::string outside(std::vector<const char *> arguments) { return shot::outside_tested_range(options_of(arguments)); }

const std::string begin = "outside of what was compared with tests: ";

} // namespace

TEST_CASE("the cases of the tests lie within the tested range") {
  CHECK(outside({}).empty());
  CHECK(outside({"--thickness-mm", "6", "--velocity-mps", "150"}).empty());
  CHECK(outside({"--thickness-mm", "30", "--nose", "conical", "--material", "aa5083_h116"}).empty());
  CHECK(outside({"--projectile", "fsp_20mm", "--thickness-mm", "12.7", "--velocity-mps", "218"}).empty());
}

TEST_CASE("what lies outside of the tested range is named, in one line") {
  CHECK(outside({"--velocity-mps", "700"}) == begin + "velocity_mps (tests: 145 to 450)");
  CHECK(outside({"--velocity-mps", "100"}) == begin + "velocity_mps (tests: 145 to 450)");
  CHECK(outside({"--nose", "hemispherical"}) == begin + "nose hemispherical");
  CHECK(outside({"--material", "aa6061_t651", "--nose", "conical"}) == begin + "metal aa6061_t651 of another source");
  CHECK(outside({"--obliquity-deg", "20", "--extent", "half", "--sph-radius-mm", "35"}) ==
        begin + "obliquity, pitch or yaw (tests: none)");
  CHECK(outside({"--layers-mm", "6,6", "--layer-materials", "steel_4340,steel_4340", "--damage", "none"}) ==
        begin + "several plates (tests: one); metal steel_4340");
  CHECK(outside({"--diameter-mm", "40", "--sph-radius-mm", "50", "--thickness-mm", "8", "--spacing-mm", "2"}) ==
        begin + "diameter_mm (tests: 19.9 to 20); thickness over diameter (tests: 0.3 to 1.5)");
}
