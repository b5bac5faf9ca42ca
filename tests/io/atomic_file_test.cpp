// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/atomic_file.hpp"

#include "io/temporary_folder.hpp"

#include "catch.hpp"

using ogive::write_atomically;
using ogive::WriteError;

TEST_CASE("an atomic write makes and replaces a file and leaves nothing else") {
  const TemporaryFolder folder;
  const auto path = folder.path / "summary.json";
  write_atomically(path, "first");
  CHECK(read_text(path) == "first");
  const std::string bytes("second\0line", 11);
  write_atomically(path, bytes);
  CHECK(read_text(path) == bytes);
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("an atomic write that fails says why and leaves the old file") {
  const TemporaryFolder folder;
  const auto path = folder.path / "summary.json";
  write_atomically(path, "old");
  {
    const FullDisk full(1000);
    CHECK_THROWS_AS(write_atomically(path, std::string(5000, 'x')), WriteError);
  }
  CHECK(read_text(path) == "old");
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("an atomic write into a folder that is missing names the file and the reason") {
  const TemporaryFolder folder;
  const auto path = folder.path / "gone" / "summary.json";
  CHECK_THROWS_WITH(write_atomically(path, "text"), "cannot write " + path.string() + ": No such file or directory");
}

TEST_CASE("an atomic write does not replace what is no file") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_atomically(folder.path, "text"), WriteError);
  CHECK(std::filesystem::is_directory(folder.path));
  CHECK_THROWS_AS(write_atomically("/dev/null", "text"), WriteError);
  CHECK(std::filesystem::is_character_file("/dev/null"));
}
