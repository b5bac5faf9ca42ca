// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/any_flow_law.hpp"
#include "ogive/material/library.hpp"
#include "ogive/material/projectile_metals.hpp"
#include "ogive/mesh/projectile_shape.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// \file
/// Projectiles by name, with the source of their dimensions.

namespace ogive {

/// A projectile: shape, mass and metal.
template <class T> struct Projectile {
  std::string name;                       ///< as users write it
  std::string title;                      ///< in titles of pictures
  std::string source;                     ///< of the dimensions, with how far they can be trusted
  ProjectileShape<T> shape;               ///< SI units
  T mass{};                               ///< of the whole projectile, kg; 0: by the density of its metal
  bool rigid = false;                     ///< moves and turns as one, and does not deform
  Metal<T, AnyFlowLaw<T>> metal{};        ///< without damage; of several parts that of the core
  std::vector<std::string> part_metals{}; ///< of several parts: names of metals in the library of the programs, from
                                          ///< the outside in
};

namespace library {

/// A projectile of the paper, or a sphere of 20 mm in diameter, of the paper's hardened tool steel.
template <class T> Projectile<T> tool_steel_projectile(Nose nose) {
  const bool of_paper = nose == Nose::blunt || nose == Nose::conical || nose == Nose::ogival;
  return {std::string(name(nose)),
          std::string(name(nose)),
          of_paper ? "Liu et al. 2012, Fig. 4" : "ours: the diameter of the paper's",
          default_projectile<T>(nose),
          T(0),
          false,
          with_law<AnyFlowLaw<T>>(arne_tool_steel<T>())};
}

/// Hard core of the 7.62 mm APM2 bullet: 6.17 mm in diameter, 27.6 mm long, 5.25 g, an ogive of calibre-radius-head 3
/// (as the literature on aluminium plates quotes it, among others Forrestal, Boervik, Warren & Chen 2014, Exp. Mech.
/// 54:471). Its flat at the tip, 0.3 mm, is ours: hexes need one. Rigid, as that literature takes it.
template <class T> Projectile<T> apm2_762_core() {
  ProjectileShape<T> s{Nose::ogival, T(6.17e-3)};
  s.nose_length = s.diameter * std::sqrt(T(3) - T(0.25));
  s.tip_diameter = T(0.3e-3);
  s.shank_length = T(27.6e-3) - nose_height(s);
  return {"apm2_762_core",
          "core of the 7.62 mm APM2",
          "quoted: diameter, length, mass and ogive; assumption: flat of 0.3 mm at the tip",
          s,
          T(5.25e-3),
          true,
          with_law<AnyFlowLaw<T>>(apm2_core_steel<T>())};
}

/// Points of a tangent ogive of this calibre-radius-head with a flat at the tip, and of the cylinder behind it, all m:
/// `tip` is the radius of the flat, at z = `front`, and `rear` the end of the cylinder.
template <class T> Profile<T> ogive_profile(T front, T rear, T radius, T tip, T calibre_radius_head) {
  constexpr int points = 12;
  const T arc = T(2) * calibre_radius_head * radius, inner = arc - radius + tip;
  const T height = std::sqrt(arc * arc - inner * inner);
  Profile<T> profile;
  for (int k = 0; k <= points; ++k) {
    const T before = height * (T(1) - T(k) / T(points));
    profile.push_back({front + height - before, std::sqrt(arc * arc - before * before) - (arc - radius)});
  }
  profile.push_back({rear, radius});
  return profile;
}

/// The whole 7.62 mm APM2 bullet: the hard core of apm2_762_core() in a jacket of gilding metal, with lead in front of
/// the core and around it. Core and mass of the whole are as quoted, the other dimensions are from memory or chosen
/// such that the masses of the parts add up to that of the whole within 2 %: see `source`. The boat tail is left out.
/// The parts share their nodes: a jacket does not come off.
template <class T> Projectile<T> apm2_762() {
  const T length = T(34.8e-3), core_front = T(6.2e-3), core_rear = T(33.8e-3);
  ProjectileShape<T> s = projectile_of(ogive_profile(T(0), length, T(3.91e-3), T(0.6e-3), T(7)));
  s.inner = {ogive_profile(core_front, core_rear, T(0.5 * 6.17e-3), T(0.15e-3), T(3)),
             ogive_profile(T(3.5e-3), core_rear, T(3.35e-3), T(0.6e-3), T(7))};
  return {"apm2_762",
          "7.62 mm APM2",
          "quoted: core, mass of the whole; from memory: diameter of 7.82 mm, length of 34.8 mm; assumption: thickness "
          "of jacket and lead, ogive of the jacket, no boat tail, parts share nodes",
          s,
          T(10.7e-3),
          false,
          with_law<AnyFlowLaw<T>>(apm2_core_steel<T>()),
          {"gilding_metal", "lead", "apm2_core_steel"}};
}

/// A fragment simulator: a cylinder of this diameter (m) and mass (kg) with a chisel nose, two flats at 35 degrees from
/// the front with a flat of this width (m) between them. Its length is the one that gives the mass at 7850 kg/m3.
template <class T>
Projectile<T> fragment_simulator(std::string name, std::string title, std::string source, T diameter, T mass, T width) {
  const auto metal = fsp_steel<T>();
  ProjectileShape<T> s{Nose::chisel, diameter};
  s.tip_diameter = width;
  s.nose_length = T(0.5) * (diameter - width) * std::tan(T(35) / T(180) * std::numbers::pi_v<T>);
  const T section = std::numbers::pi_v<T> / T(4) * diameter * diameter;
  s.shank_length = (mass / metal.density - chisel_volume(s)) / section;
  return {std::move(name), std::move(title), std::move(source), s, mass, false, with_law<AnyFlowLaw<T>>(metal)};
}

/// The 20 mm fragment simulator: 19.9 mm, 53.78 g.
template <class T> Projectile<T> fsp_20mm() {
  return fragment_simulator<T>("fsp_20mm", "20 mm fragment simulator",
                               "quoted: diameter, mass; from memory: flats of 35 degrees, 9 mm between them",
                               T(19.9e-3), T(53.78e-3), T(9e-3));
}

/// The 12.7 mm (.50 calibre) fragment simulator: 12.57 mm, 13.41 g.
template <class T> Projectile<T> fsp_127mm() {
  return fragment_simulator<T>(
      "fsp_127mm", "12.7 mm fragment simulator",
      "from memory: diameter, mass, flats of 35 degrees; assumption: 5.7 mm between them, as the 20 mm one",
      T(12.57e-3), T(13.41e-3), T(5.7e-3));
}

/// All projectiles with a name.
template <class T> std::vector<Projectile<T>> all_projectiles() {
  std::vector<Projectile<T>> all;
  for (const Nose nose : paper_noses) all.push_back(tool_steel_projectile<T>(nose));
  all.push_back(tool_steel_projectile<T>(Nose::sphere));
  all.push_back(apm2_762<T>());
  all.push_back(apm2_762_core<T>());
  all.push_back(fsp_20mm<T>());
  all.push_back(fsp_127mm<T>());
  return all;
}

} // namespace library

} // namespace ogive
