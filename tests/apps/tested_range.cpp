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
  CHECK(outside({"--nose", "hemispherical", "--spacing-mm", "1"}).empty());
  CHECK(
      outside({"--projectile", "apm2_762_core", "--thickness-mm", "20", "--material", "aa6082_t6", "--spacing-mm", "1"})
          .empty());
  CHECK(outside({"--obliquity-deg", "30", "--extent", "half", "--sph-radius-mm", "35"}).empty());
}

TEST_CASE("what lies outside of the tested range is named, in one line") {
  CHECK(outside({"--velocity-mps", "800"}) == begin + "velocity_mps (tests: 145 to 730)");
  CHECK(outside({"--velocity-mps", "100"}) == begin + "velocity_mps (tests: 145 to 730)");
  CHECK(outside({"--projectile", "sphere"}) == begin + "nose sphere");
  CHECK(outside({"--length-mm", "30", "--bore-radius-mm", "5", "--bore-depth-mm", "20"}) ==
        begin + "a hollow projectile");
  CHECK(outside({"--material", "aa6061_t651", "--nose", "conical"}) == begin + "metal aa6061_t651");
  CHECK(outside({"--obliquity-deg", "40", "--pitch-deg", "2", "--extent", "half", "--sph-radius-mm", "40"}) ==
        begin + "obliquity_deg (tests: 0 to 30); pitch or yaw (tests: none)");
  CHECK(outside({"--layers-mm", "6,6", "--layer-materials", "steel_4340,steel_4340", "--damage", "none"}) ==
        begin + "several plates (tests: one); metal steel_4340");
  CHECK(outside({"--diameter-mm", "40", "--sph-radius-mm", "50", "--thickness-mm", "8", "--spacing-mm", "2"}) ==
        begin + "diameter_mm (tests: 6.17 to 20); thickness over diameter (tests: 0.3 to 4.2); spacing_mm (tests: 0.45 "
                "to 0.8)");
  CHECK(outside({"--projectile", "apm2_762"}) == begin + "projectile apm2_762");
  CHECK(outside({"--spacing-mm", "0.4"}) == begin + "spacing_mm (tests: 0.45 to 0.8)");
  CHECK(outside({"--spacing-mm", "1"}) == begin + "spacing_mm (tests: 0.45 to 0.8)");
  CHECK(outside({"--nose", "ogival", "--spacing-mm", "1.1"}) == begin + "spacing_mm (tests: 0.45 to 1)");
}
