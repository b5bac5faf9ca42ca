// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/checkpoint_file.hpp"
#include "ogive/sim/erosion.hpp"
#include "ogive/sim/fingerprint.hpp"
#include "ogive/sim/state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// The whole state of a model and of the loop that runs it, in one file. A run that is resumed from there ends with the
/// same bits as one that never stopped, with any number of threads. Another build of the program reads the file too,
/// but another compiler or processor computes other last bits.

namespace ogive {

namespace checkpoint_detail {

template <class V> inline constexpr bool is_vec3 = false;
template <class T> inline constexpr bool is_vec3<Vec3<T>> = true;
template <class V> inline constexpr bool is_array = false;
template <class T, std::size_t n> inline constexpr bool is_array<std::array<T, n>> = true;

/// A number, or several of fixed number: its bytes are its value.
template <class V>
concept RawValue = std::is_arithmetic_v<V> || is_vec3<V> || is_array<V>;

/// Collects the bytes of the state without copying arrays.
struct StateWriter {
  std::vector<std::string_view> pieces;
  std::deque<std::uint64_t> counts; ///< keeps its entries where they are

  void operator()(const std::string &, const RawValue auto &value) { plain(value); }
  template <class V> void operator()(const std::string &, const std::vector<V> &values) { array(values); }
  template <class V> void operator()(const std::string &, const FullOrEmpty<V> &list) { array(list.values); }
  template <class V> void operator()(const std::string &, const UpTo<V> &list) { array(list.values); }

  template <class V> void plain(const V &value) {
    pieces.emplace_back(reinterpret_cast<const char *>(&value), sizeof value);
  }
  template <class V> void array(const std::vector<V> &values) {
    plain(counts.emplace_back(values.size()));
    pieces.push_back(bytes_of(values));
  }
};

/// Reads them into arrays of a model whose lengths are right already.
struct StateReader {
  std::string_view rest;
  const std::string &file;

  void operator()(const std::string &name, RawValue auto &value) { fill(name, &value, sizeof value); }
  template <class V> void operator()(const std::string &name, std::vector<V> &values) {
    require_count(name, count(name), values.size());
    fill(name, values.data(), values.size() * sizeof(V));
  }
  template <class V> void operator()(const std::string &name, const FullOrEmpty<V> &list) {
    const std::uint64_t n = count(name);
    if (n > 0) require_count(name, n, list.full);
    list.values.resize(n);
    fill(name, list.values.data(), n * sizeof(list.values[0]));
  }

  template <class V> void operator()(const std::string &name, const UpTo<V> &list) {
    const std::uint64_t n = count(name);
    if (n > list.most) require_count(name, n, list.most);
    list.values.resize(n);
    fill(name, list.values.data(), n * sizeof(list.values[0]));
  }

  void fill(const std::string &name, void *to, std::size_t size) {
    if (size > rest.size()) refuse_checkpoint(file, "is damaged: it ends within " + name);
    if (size > 0) std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
  }
  std::uint64_t count(const std::string &name) {
    std::uint64_t n = 0;
    return fill(name, &n, sizeof n), n;
  }
  void require_count(const std::string &name, std::uint64_t n, std::size_t length) {
    if (n != length)
      refuse_checkpoint(file, "has " + std::to_string(n) + " entries of " + name + ", the model has " +
                                  std::to_string(length));
  }
};

/// True for positions that lists can be built from: finite, and not so far away that sizes overflow.
template <class T> bool are_places(const std::vector<Vec3<T>> &positions) {
  return std::all_of(positions.begin(), positions.end(),
                     [](const Vec3<T> &x) { return x.allFinite() && x.cwiseAbs().maxCoeff() < T(1e6); });
}

/// Calls `need(ok, what)` for what the lists of a body are made from.
template <class T, class Law, class K, class F, class Need>
void check_lists(const SphBody<T, Law, K, F> &body, Need &&need) {
  const T most = T(kernel_support) * reference_smoothing_length(body), support = body.neighbours.support;
  need(are_places(body.neighbours.built_at), body.name + " positions of the lists");
  need(body.neighbours.built_at.empty() || (support > T(0.5) * most && support < T(2) * most),
       body.name + " support of the lists");
}

/// Nothing: hexes have no lists.
template <class T, class Law, class Rule, class Need> void check_lists(const HexBody<T, Law, Rule> &, Need &&) {}

/// Calls `need(ok, what)` for the state of a contact.
template <class T, class Need> void check_contact(const NodeToSurface<T> &contact, Need &&need) {
  const auto slaves = static_cast<Index>(contact.slaves.size()), facets = static_cast<Index>(contact.facets.size());
  const ContactState<T> &state = contact.state;
  const NearSlaves<T> &near = state.near;
  need(are_places(state.searched_at), contact.name + " positions of the search");
  need(state.lost >= -1 && state.lost < slaves, contact.name + " lost slave");
  need(std::is_sorted(near.slaves.begin(), near.slaves.end(), std::less_equal{}) &&
           (near.slaves.empty() || (near.slaves.front() >= 0 && near.slaves.back() < slaves)),
       contact.name + " near slaves");
  for (const std::size_t length : {near.forces.size(), near.normal_energy.size(), near.friction_energy.size(),
                                   near.room.size(), near.checked_at.size()})
    need(length == near.slaves.size(), contact.name + " near slaves");
  need(are_places(near.checked_at) && are_places(state.masters_checked_at),
       contact.name + " positions of the last check");
  need(state.searched_at.empty() || state.masters_checked_at.size() == contact.masters.size(),
       contact.name + " positions of the masters");
  need(std::all_of(near.forces.begin(), near.forces.end(),
                   [&](const ContactForce<T> &c) { return c.facet >= -1 && c.facet < facets; }),
       contact.name + " facet");
}

/// Refuses values that no run has and that would lead out of arrays or sizes.
template <class T, class Bodies> void check_restored(const Model<T, Bodies> &model, const std::string &file) {
  const auto need = [&](bool ok, const std::string &what) {
    if (!ok) refuse_checkpoint(file, "is damaged: " + what + " has impossible values");
  };
  need(model.steps >= 0 && model.steps < std::int64_t(1) << 60, "its number of steps");
  need(are_places(model.nodes.position), "its positions");
  for_each_body(model, [&](const auto &body) { check_lists(body, need); });
  for (const auto &contact : model.contacts) check_contact(contact, need);
  for (const auto &contact : model.particle_contacts) {
    need(are_places(contact.searched_at), contact.name + " positions of the search");
    need(contact.lost >= -1 && contact.lost < contact.nodes.size(), contact.name + " lost particle");
  }
  for (const auto &part : model.rigid_parts) {
    const T length = std::hypot(part.orientation.scalar, part.orientation.vector.norm());
    need(part.centre.allFinite() && part.velocity.allFinite() && part.angular_momentum.allFinite(),
         "the motion of a rigid part");
    need(std::abs(length - T(1)) < T(1e-3), "the orientation of a rigid part");
  }
}

} // namespace checkpoint_detail

/// Writes the state of the model and of its run, between two steps, to `path`; an old file there is replaced once the
/// new one is complete. `notes` are bytes of the program's own, for read_checkpoint_notes(). Throws WriteError, and
/// then the old file stays.
template <class T, class Bodies>
void write_checkpoint(const std::filesystem::path &path, const Model<T, Bodies> &model, const RunState<T> &run,
                      std::string_view notes = {}) {
  static_assert(sizeof(ContactForce<T>) == 2 * sizeof(Index) + 10 * sizeof(T),
                "no padding, which would have any value");
  checkpoint_detail::StateWriter writer;
  const std::uint64_t print = fingerprint(model);
  writer.plain(print);
  for_each_state_field(model, run, writer);
  write_checkpoint_file(path, sizeof(T), notes, std::move(writer.pieces));
}

/// Puts the model, which must be built as it was for the run that wrote the checkpoint, and the run's state where they
/// were then. Throws SetupError, one line, for the checkpoint of another model or one with impossible values, and then
/// changes neither.
template <class T, class Bodies> void restore(const Checkpoint &checkpoint, Model<T, Bodies> &model, RunState<T> &run) {
  if (checkpoint.scalar_bytes != sizeof(T))
    refuse_checkpoint(checkpoint.file, "has numbers of " + std::to_string(checkpoint.scalar_bytes) +
                                           " bytes, the model of " + std::to_string(sizeof(T)));
  checkpoint_detail::StateReader reader{checkpoint.state, checkpoint.file};
  std::uint64_t print = 0;
  reader.fill("the fingerprint", &print, sizeof print);
  if (print != fingerprint(model))
    refuse_checkpoint(checkpoint.file, "is of another model: another case, or made by another version of the program");
  Model<T, Bodies> restored = model;
  RunState<T> restored_run;
  for_each_state_field(restored, restored_run, reader);
  if (!reader.rest.empty()) refuse_checkpoint(checkpoint.file, "is damaged: it has bytes left over");
  renew_facets(restored);
  checkpoint_detail::check_restored(restored, checkpoint.file);
  renew_lists(restored);
  model = std::move(restored);
  run = restored_run;
}

} // namespace ogive
