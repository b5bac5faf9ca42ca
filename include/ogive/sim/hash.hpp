#pragma once

#include "ogive/core/nodes.hpp"
#include "ogive/material/points.hpp"
#include "ogive/sim/model.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace ogive {

/// Continues a 64-bit FNV-1a hash over the bytes of `values`, eight at a time.
template <class V> std::uint64_t hash_values(std::uint64_t hash, const std::vector<V> &values) {
  const auto *bytes = reinterpret_cast<const unsigned char *>(values.data());
  const std::size_t size = values.size() * sizeof(V);
  std::size_t at = 0;
  for (; at + 8 <= size; at += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes + at, 8);
    hash = (hash ^ word) * 0x100000001b3ULL;
    hash ^= hash >> 29;
  }
  for (; at < size; ++at) hash = (hash ^ bytes[at]) * 0x100000001b3ULL;
  return hash;
}

/// Hash of the state of a model: nodes and material points. Equal states have equal hashes, to the last bit.
template <class M> std::uint64_t state_hash(const M &model) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for_each_node_field(model.nodes,
                      [&](const char *, const char *, const auto &values) { hash = hash_values(hash, values); });
  for_each_body(model, [&](const auto &body) {
    for_each_point_field(body.points,
                         [&](const char *, const char *, const auto &values) { hash = hash_values(hash, values); });
  });
  return hash;
}

} // namespace ogive
