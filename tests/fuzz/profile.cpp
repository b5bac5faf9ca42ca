// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/read_profile.hpp"

#include "fuzz/must.hpp"
#include "fuzz/targets.hpp"

/// A profile of a projectile; one that is read is a body.
void fuzz::try_profile(std::string_view bytes) {
  ogive::Profile<double> profile;
  try {
    profile = ogive::read_profile(bytes, "nose.csv");
  } catch (const ogive::SetupError &) {
    return;
  }
  check(profile);
  must(profile.front().z == 0, "the profile begins at its front");
  must(volume(profile) > 0, "the profile has a volume");
}
