// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <utility>
#include <variant>

/// \file
/// A choice among types: the type itself where the choice is made by the compiler, a std::variant of types where it is
/// made when the program runs.

namespace ogive {

/// Calls `f(value)` with the value of a choice, whose type the compiler then knows. Call it outside of a loop, and the
/// loop pays nothing for the choice.
template <class C, class F> decltype(auto) with_choice(const C &choice, F &&f) { return f(choice); }

/// Calls `f(value)` with what the variant holds.
template <class... Cs, class F> decltype(auto) with_choice(const std::variant<Cs...> &choice, F &&f) {
  return std::visit(std::forward<F>(f), choice);
}

} // namespace ogive
