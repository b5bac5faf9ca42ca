// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/bilinear.hpp"
#include "ogive/material/johnson_cook.hpp"
#include "ogive/material/metal.hpp"

/// \file
/// The materials of Liu, Swaddiwudhipong & Islam, Nucl. Eng. Des. 250 (2012) 108-115, and the classical Johnson-Cook
/// fits to the same tests.

namespace ogive::library {

/// Elastic and thermal constants of Weldox 460 E (Liu et al. 2012, Table 1) with a flow law. Damage is disabled; its
/// constants are those of Dey 2004 (D1 to D3 from a transcription, D4 and D5 as commonly quoted), W_cr follows from
/// them.
template <class T, class Law> Metal<T, Law> weldox_460e(Law flow, std::string source) {
  Metal<T, Law> m;
  m.name = "weldox_460e";
  m.source = std::move(source);
  m.density = T(7850);
  m.elasticity = {T(200e9), T(0.33)};
  m.eos = {PressureLaw::linear, T(1.49), T(1.93)};
  m.flow = flow;
  m.specific_heat = T(452);
  m.thermal_conductivity = T(45); // of low-alloy steels in textbooks
  m.room_temperature = T(293);
  m.melting_temperature = T(1800);
  m.source += "; D1 to D5 of Dey 2004 (D1 to D3 transcribed, the rest quoted), W_cr from them";
  m.confidence = "high: the flow stress is that of the paper or often quoted alike; D4 and D5 medium";
  m.damage.failure_strain = {T(0.636), T(1.936), T(-2.969), T(-0.014), T(1.014), T(5e-4)};
  m.damage.critical_work = critical_work_of_tension(m);
  return m;
}

/// Weldox 460 E, modified Johnson-Cook (Liu et al. 2012, Table 1).
template <class T> Metal<T, ModifiedJohnsonCook<T>> weldox_460e_mjc() {
  return weldox_460e<T>(ModifiedJohnsonCook<T>{T(503e6), T(581e6), T(0.481), T(0.01), T(0.94)},
                        "Liu et al. 2012, Table 1");
}

/// Weldox 460 E, classical Johnson-Cook with the power rate factor (Boervik, Hopperstad, Berstad & Langseth 2001; as
/// commonly quoted).
template <class T> Metal<T, JohnsonCook<T>> weldox_460e_jc() {
  return weldox_460e<T>(JohnsonCook<T>{T(490e6), T(383e6), T(0.45), T(0.0123), T(0.94), T(5e-4), RateFactor::power},
                        "Boervik, Hopperstad, Berstad & Langseth 2001 (quoted)");
}

/// Elastic and thermal constants of AA5083-H116 (Liu et al. 2012, Table 2) with a flow law. Damage is disabled; its
/// constants are those of Clausen, Boervik, Hopperstad & Benallal 2004 (as commonly quoted), W_cr follows from them.
template <class T, class Law> Metal<T, Law> aa5083_h116(Law flow, std::string source) {
  Metal<T, Law> m;
  m.name = "aa5083_h116";
  m.source = std::move(source);
  m.density = T(2700);
  m.elasticity = {T(70e9), T(0.3)};
  m.eos = {PressureLaw::linear, T(1.34), T(2.0)};
  m.flow = flow;
  m.specific_heat = T(910);
  m.thermal_conductivity = T(117); // of the alloy 5083 in textbooks
  m.room_temperature = T(293);
  m.melting_temperature = T(893);
  m.source += "; D1 to D5 of Clausen, Boervik, Hopperstad & Benallal 2004 (quoted), W_cr from them";
  m.confidence = "medium: quoted alike in several papers, not checked against the original";
  m.damage.failure_strain = {T(0.0261), T(0.263), T(-0.349), T(0.147), T(16.8), T(1)};
  m.damage.critical_work = critical_work_of_tension(m);
  return m;
}

/// AA5083-H116, modified Johnson-Cook: C and b of Liu et al. 2012, Table 2; A, B, a of Clausen et al. 2004, because the
/// paper gives them as an image only. `strength` scales A and B: 1 for the 15, 20 and 30 mm plates, 0.85 for the weaker
/// 25 mm plate (an assumption, see docs/assumptions.md).
template <class T> Metal<T, ModifiedJohnsonCook<T>> aa5083_h116_mjc(T strength = T(1)) {
  return aa5083_h116<T>(ModifiedJohnsonCook<T>{strength * T(167e6), strength * T(596e6), T(0.551), T(0.0114), T(0.56)},
                        std::string("Liu et al. 2012, Table 2 (C, b); Clausen et al. 2004 (A, B, a; quoted)") +
                            (strength == T(1) ? "" : ", A and B weakened by assumption"));
}

/// AA5083-H116, classical Johnson-Cook (Clausen, Boervik, Hopperstad & Benallal 2004, MSEA 364:260; as commonly
/// quoted).
template <class T> Metal<T, JohnsonCook<T>> aa5083_h116_jc() {
  return aa5083_h116<T>(JohnsonCook<T>{T(167e6), T(596e6), T(0.551), T(0.001), T(0.859), T(1), RateFactor::power},
                        "Clausen, Boervik, Hopperstad & Benallal 2004 (quoted)");
}

/// Hardened Arne tool steel of the projectiles, bilinear, without failure (Liu et al. 2012, Table 3).
template <class T> Metal<T, Bilinear<T>> arne_tool_steel() {
  Metal<T, Bilinear<T>> m;
  m.name = "arne_tool_steel";
  m.source = "Liu et al. 2012, Table 3";
  m.confidence = "high: read in the paper";
  m.density = T(7850);
  m.elasticity = {T(204e9), T(0.33)};
  m.eos = {PressureLaw::linear, T(1.49), T(1.93)};
  m.flow = {T(1.9e9), plastic_modulus(T(204e9), T(15e9))};
  m.specific_heat = T(452);
  m.melting_temperature = T(1800);
  return m;
}

} // namespace ogive::library
