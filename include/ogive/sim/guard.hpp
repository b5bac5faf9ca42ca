#pragma once

#include "ogive/fem/hex_force.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/model.hpp"

#include <cmath>
#include <optional>
#include <sstream>
#include <string>

namespace ogive {

/// What went wrong in the loop, where and when.
struct Fault {
  std::string what; ///< one line
  std::string body;
  Index id = -1; ///< node, particle or hex of the body; -1: none in particular
  double time_us = 0;
};

/// The first node with a velocity or position that is not a finite number, if any.
template <class T, class... Bodies> std::optional<Fault> find_not_finite(const Model<T, Bodies...> &model) {
  const auto finite = [&](Index n) {
    return model.nodes.position[n].allFinite() && model.nodes.velocity[n].allFinite();
  };
  const Index first =
      parallel_min(model.nodes.size(), model.nodes.size(), [&](Index n) { return finite(n) ? model.nodes.size() : n; });
  if (first == model.nodes.size()) return std::nullopt;
  Fault fault{"position or velocity is not a finite number", "nodes", first, double(model.time) * 1e6};
  for_each_body(model, [&](const auto &body) {
    if (first >= body.nodes.begin && first < body.nodes.end)
      fault.body = body.name, fault.id = first - body.nodes.begin;
  });
  return fault;
}

/// A hex without volume, if any.
template <class T, class... Bodies> std::optional<Fault> find_inverted(const Model<T, Bodies...> &model) {
  std::optional<Fault> fault;
  for_each_body(model, [&](const auto &body) {
    if constexpr (requires { body.hexes; })
      if (const Index hex = first_inverted(body, model.nodes); hex >= 0 && !fault)
        fault = Fault{"a hex has no volume left", body.name, hex, double(model.time) * 1e6};
  });
  return fault;
}

} // namespace ogive
