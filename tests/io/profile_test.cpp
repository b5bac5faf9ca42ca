// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/io/read_profile.hpp"

using namespace ogive;

namespace {

std::string refusal(const std::string &text) {
  try {
    read_profile(text, "nose.csv");
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a profile is read from the front to the rear, z from its first point") {
  const auto profile = read_profile("# a cone\nz_mm,r_mm\n1,0.5\n\n5,2\n 10 , 2 \r\n", "nose.csv");
  REQUIRE(profile.size() == 3);
  CHECK(profile[0] == ProfilePoint<double>{0, 0.5e-3});
  CHECK(profile[1].z == Approx(4e-3));
  CHECK(profile[2].radius == Approx(2e-3));
}

TEST_CASE("a damaged profile is refused with file, line, value and what is allowed") {
  CHECK(refusal("") == "nose.csv: points of the profile = 0: must be 2 to 10000");
  CHECK(refusal("z,r\n0,1\n") == "nose.csv:1: columns: must be z_mm,r_mm");
  CHECK(refusal("z_mm;r_mm\n0;1\n").starts_with("nose.csv:1: columns are separated by semicolons"));
  CHECK(refusal("z_mm,r_mm\n0\n") == "nose.csv:2: fields in the row: must be 2, z_mm and r_mm");
  CHECK(refusal("z_mm,r_mm\n0,1,2\n") == "nose.csv:2: fields in the row: must be at most 2");
  CHECK(refusal("z_mm,r_mm\n0,1\n2,x\n") == "nose.csv:3: r_mm = x: must be a number");
  CHECK(refusal("z_mm,r_mm\nnan,1\n") == "nose.csv:2: z_mm = nan: must be a number");
  CHECK(refusal("z_mm,r_mm\n0,1\n0,2\n") == "nose.csv:3: z_mm = 0: must be larger than in the row before");
  CHECK(refusal("z_mm,r_mm\n0,0\n") == "nose.csv:2: r_mm = 0: must be positive; hexes need a flat at the tip");
  CHECK(refusal("z_mm,r_mm\n0,1\n") == "nose.csv: points of the profile = 1: must be 2 to 10000");
  CHECK(refusal("z_mm,r_mm\n0,0.1\n1,10\n")
            .starts_with("nose.csv: radius of point 1 of the profile (m) = 0.0001: must be at least 0.02"));
}
