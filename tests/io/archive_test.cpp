// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/archive.hpp"

#include "catch.hpp"

#include <random>

using namespace ogive;

namespace {

enum class Colour { red, green };

struct Inner {
  double x = 0;
  std::string name;
  bool operator==(const Inner &) const = default;
};
template <class F> void for_each_field(Inner &inner, F &&f) { f(inner.x), f(inner.name); }

struct Outer {
  int n = 0;
  Colour colour = Colour::red;
  std::optional<double> maybe, never;
  std::vector<Inner> list;
  std::vector<double> numbers;
  bool operator==(const Outer &) const = default;
};
template <class F> void for_each_field(Outer &o, F &&f) {
  f(o.n), f(o.colour), f(o.maybe), f(o.never), f(o.list), f(o.numbers);
}

const Outer sample{-3, Colour::green, 0.1, {}, {{1.0 / 3, "a\nb"}, {2, ""}}, {1e-300, 4}};

} // namespace

TEST_CASE("values read back as they were written") {
  ArchiveWriter writer;
  writer(sample);
  Outer found;
  ArchiveReader reader{writer.bytes, "file"};
  reader(found);
  CHECK(found == sample);
  CHECK(reader.rest.empty());
}

TEST_CASE("bytes that end too early or count too far are refused with the file's name") {
  ArchiveWriter writer;
  writer(sample);
  Outer found;
  for (std::size_t size = 0; size < writer.bytes.size(); ++size)
    CHECK_THROWS_WITH((ArchiveReader{std::string_view(writer.bytes).substr(0, size), "file"}(found)),
                      "file: is damaged: it ends too early");
  std::mt19937 random(3);
  for (int k = 0; k < 20000; ++k) {
    std::string bytes = writer.bytes;
    for (int n = 0; n < 3; ++n) bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      ArchiveReader{bytes, "file"}(found);
      CHECK(found.list.size() + found.numbers.size() < bytes.size());
    } catch (const SetupError &) {
    }
  }
}
