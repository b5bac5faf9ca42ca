// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ogive {

/// Stations from 0 to `length`: the intervals start near `first`, grow by `growth` (>= 1) up to `largest`, and are
/// scaled together so that they fill the length exactly. Lengths in m.
template <class T> std::vector<T> graded_stations(T length, T first, T growth, T largest) {
  std::vector<T> stations = {T(0)};
  for (T size = first; stations.back() < length; size = std::min(growth * size, std::max(first, largest)))
    stations.push_back(stations.back() + size);
  // The last interval is dropped where the length is met better without it.
  if (stations.size() > 2 && length - stations[stations.size() - 2] < stations.back() - length) stations.pop_back();
  const T scale = length / stations.back();
  for (T &s : stations) s *= scale;
  stations.back() = length;
  return stations;
}

} // namespace ogive
