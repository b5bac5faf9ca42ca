// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"
#include "ogive/material/points.hpp"
#include "ogive/sim/model.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace ogive {

/// The hash of nothing.
inline constexpr std::uint64_t hash_start = 0xcbf29ce484222325ULL;

/// Continues a 64-bit FNV-1a hash over bytes, eight at a time. Every step is one to one: texts of the same length that
/// differ in one place only never have the same hash.
inline std::uint64_t hash_bytes(std::uint64_t hash, std::string_view bytes) {
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + at, 8);
    hash = (hash ^ word) * 0x100000001b3ULL;
    hash ^= hash >> 29;
  }
  for (; at < bytes.size(); ++at) hash = (hash ^ static_cast<unsigned char>(bytes[at])) * 0x100000001b3ULL;
  return hash;
}

/// The bytes of an array.
template <class V> std::string_view bytes_of(const std::vector<V> &values) {
  return {reinterpret_cast<const char *>(values.data()), values.size() * sizeof(V)};
}

/// Continues the hash over the bytes of `values`.
template <class V> std::uint64_t hash_values(std::uint64_t hash, const std::vector<V> &values) {
  return hash_bytes(hash, bytes_of(values));
}

/// Hash of the state of a model: nodes and the fields of for_each_point_field(). Equal states have equal hashes, to the
/// last bit.
template <class M> std::uint64_t state_hash(const M &model) {
  std::uint64_t hash = hash_start;
  for_each_node_field(model.nodes,
                      [&](const char *, const char *, const auto &values) { hash = hash_values(hash, values); });
  for_each_body(model, [&](const auto &body) {
    for_each_point_field(body.points,
                         [&](const char *, const char *, const auto &values) { hash = hash_values(hash, values); });
  });
  return hash;
}

} // namespace ogive
