// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"

#include "shot/run.hpp"

#include <unistd.h>

using shot::Options;

namespace {

std::string refusal_of_out(const Options &options) {
  return message_of([&] { shot::prepare_out(options); });
}

} // namespace

TEST_CASE("the output folder is created, and what is in it stays") {
  const TemporaryFolder folder;
  Options o;
  o.out = folder.path / "new" / "results";
  CHECK(refusal_of_out(o).empty());
  CHECK(std::filesystem::is_empty(o.out));
  write(o.out / "history.csv", "old");
  CHECK(refusal_of_out(o).empty());
  CHECK(std::filesystem::file_size(o.out / "history.csv") == 3);
}

TEST_CASE("an output folder that cannot be used is refused, and nothing is left behind") {
  const TemporaryFolder folder;
  Options o;
  const auto refused_with = [&](const std::filesystem::path &out, const std::string &reason) {
    o.out = out;
    CHECK_THAT(refusal_of_out(o), Catch::Matchers::StartsWith("--out = " + out.string() + ": " + reason));
  };
  write(folder.path / "file", "old");
  refused_with(folder.path / "file", "must be a folder, but a file of that name is there");
  refused_with(folder.path / "file" / "below", "must be a folder that can be created: Not a directory");
  CHECK(std::filesystem::file_size(folder.path / "file") == 3);
  {
    const FullDisk disk(0);
    refused_with(folder.path / "new" / "results", "must be a folder that can be written to: File too large");
  }
  CHECK_FALSE(std::filesystem::exists(folder.path / "new"));
  o.output_every_us = 0.5;
  o.end_us = 100000;
  o.spacing_mm = 0.1;
  refused_with(folder.path / "new" / "results", "needs up to ");
  CHECK_FALSE(std::filesystem::exists(folder.path / "new"));
}

TEST_CASE("a folder without permission to write is refused") {
  const TemporaryFolder folder;
  Options o;
  o.out = folder.path / "locked";
  std::filesystem::create_directory(o.out);
  std::filesystem::permissions(o.out, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  // The superuser may write anywhere.
  if (::access(o.out.c_str(), W_OK) == 0) return;
  const auto refused_with = [&](const std::string &reason) {
    CHECK_THAT(refusal_of_out(o), Catch::Matchers::StartsWith("--out = " + o.out.string() + ": " + reason));
  };
  refused_with("must be a folder that can be written to: Permission denied");
  o.out /= "below";
  refused_with("must be a folder that can be created: Permission denied");
}
