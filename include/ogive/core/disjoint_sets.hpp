// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace ogive {

/// A partition of 0 to n - 1 whose parts are joined one by one. The smallest member names its part.
class DisjointSets {
public:
  /// Each number alone.
  explicit DisjointSets(Index n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index(0)); }
  /// The smallest member of the part that `i` belongs to.
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Makes one part of those of `i` and `j`.
  void join(Index i, Index j) {
    const Index a = root(i), b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  /// The smallest member of the part of each number.
  std::vector<Index> roots() {
    std::vector<Index> all(parent_.size());
    for (Index i = 0; i < static_cast<Index>(all.size()); ++i) all[i] = root(i);
    return all;
  }

private:
  std::vector<Index> parent_;
};

} // namespace ogive
