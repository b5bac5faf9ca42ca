// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Values as bytes, one after another, in the order and size of the machine. A struct takes part with a function
/// `for_each_field(value, f)` that calls `f(member)` for each member: the same list writes and reads.

namespace ogive {

/// A number or a choice: written as its bytes. Not every byte is a bool.
template <class V>
concept PlainValue = (std::is_arithmetic_v<V> && !std::is_same_v<V, bool>) || std::is_enum_v<V>;

/// Writes values.
struct ArchiveWriter {
  std::string bytes; ///< written so far

  ///@{
  /// Appends a value; arrays, texts and optional values begin with their size.
  template <class V> void operator()(const V &value) {
    if constexpr (PlainValue<V>)
      bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
    else
      for_each_field(const_cast<V &>(value), *this); // the list serves readers too, and a writer changes nothing
  }
  void operator()(const std::string &text) {
    (*this)(std::uint64_t(text.size()));
    bytes += text;
  }
  template <class V> void operator()(const std::vector<V> &values) {
    (*this)(std::uint64_t(values.size()));
    for (const V &value : values) (*this)(value);
  }
  template <class V> void operator()(const std::optional<V> &value) {
    (*this)(std::uint64_t(value ? 1 : 0));
    if (value) (*this)(*value);
  }
  ///@}
};

/// Reads what ArchiveWriter has written. Whatever the bytes are, they are read within their bounds and no array becomes
/// larger than they are. Throws SetupError "<name>: is damaged: ..." for others.
struct ArchiveReader {
  std::string_view rest; ///< bytes that have not been read yet
  std::string name;      ///< for errors

  ///@{
  /// Reads a value.
  template <class V> void operator()(V &value) {
    if constexpr (PlainValue<V>)
      std::memcpy(&value, take(sizeof value).data(), sizeof value);
    else
      for_each_field(value, *this);
  }
  void operator()(std::string &text) { text = take(count(rest.size())); }
  template <class V> void operator()(std::vector<V> &values) {
    // An entry has at least one byte.
    std::uint64_t entries = count(rest.size());
    values.clear();
    for (; entries > 0; --entries) (*this)(values.emplace_back());
  }
  template <class V> void operator()(std::optional<V> &value) {
    value.reset();
    if (count(1) == 1) (*this)(value.emplace());
  }
  ///@}

  /// The next `size` bytes.
  std::string_view take(std::size_t size) {
    if (size > rest.size()) throw SetupError(name + ": is damaged: it ends too early");
    const std::string_view taken = rest.substr(0, size);
    rest.remove_prefix(size);
    return taken;
  }

private:
  std::uint64_t count(std::uint64_t most) {
    std::uint64_t n = 0;
    std::memcpy(&n, take(sizeof n).data(), sizeof n);
    if (n > most) throw SetupError(name + ": is damaged: it ends too early");
    return n;
  }
};

} // namespace ogive
