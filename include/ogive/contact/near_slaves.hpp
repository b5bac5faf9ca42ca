// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/node_to_surface.hpp"

#include <algorithm>
#include <utility>

namespace ogive {

/// Number of near slaves.
template <class T> Index size(const NearSlaves<T> &near) { return static_cast<Index>(near.slaves.size()); }

/// The contact force on slave `s`: none if it is not near.
template <class T> ContactForce<T> force_on(const NodeToSurface<T> &contact, Index s) {
  const NearSlaves<T> &near = contact.state.near;
  const auto found = std::lower_bound(near.slaves.begin(), near.slaves.end(), s);
  return found != near.slaves.end() && *found == s ? near.forces[found - near.slaves.begin()] : ContactForce<T>{};
}

/// Whether near slave `k` has something to keep when it is near no more: work that it has done, or a force.
template <class T> bool has_history(const NearSlaves<T> &near, Index k) {
  return near.forces[k].facet >= 0 || near.forces[k].lost || near.normal_energy[k] != T(0) ||
         near.friction_energy[k] != T(0);
}

/// Makes the active slaves the near ones, with those that have been pushed before.
template <class T> void keep_near(NodeToSurface<T> &contact) {
  const NearSlaves<T> old = std::exchange(contact.state.near, {});
  NearSlaves<T> &near = contact.state.near;
  Index next = 0;
  const auto keep_next = [&] {
    near.slaves.push_back(old.slaves[next]);
    near.forces.push_back(old.forces[next]);
    near.normal_energy.push_back(old.normal_energy[next]);
    near.friction_energy.push_back(old.friction_energy[next]);
    near.room.push_back(old.room[next]);
    near.checked_at.push_back(old.checked_at[next]);
    ++next;
  };
  const auto keep_history_before = [&](Index slave) {
    while (next < size(old) && old.slaves[next] < slave)
      if (has_history(old, next))
        keep_next();
      else
        ++next;
  };
  contact.candidates.entry.clear();
  for (const Index s : contact.candidates.active) {
    keep_history_before(s);
    contact.candidates.entry.push_back(size(near));
    if (next < size(old) && old.slaves[next] == s) {
      keep_next();
      continue;
    }
    near.slaves.push_back(s);
    near.forces.emplace_back();
    near.normal_energy.push_back(T(0));
    near.friction_energy.push_back(T(0));
    near.room.push_back(T(0));
    near.checked_at.push_back(Vec3<T>::Zero());
  }
  keep_history_before(static_cast<Index>(contact.slaves.size()));
}

} // namespace ogive
