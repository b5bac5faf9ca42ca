// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"

#include "ogive/io/archive.hpp"
#include "ogive/io/checkpoint_file.hpp"
#include "ogive/version.hpp"
#include "shot/plates.hpp"
#include "shot/saved_case.hpp"

#include <random>

using shot::Options;
using shot::SavedCase;

namespace {

/// Writes a checkpoint of these options without a state, and returns its name.
std::string write_checkpoint_of(const std::filesystem::path &folder, const Options &options,
                                const std::string &program = "ogive shoot") {
  ogive::ArchiveWriter notes;
  notes(SavedCase{program, ogive::version, shot::to_complete_toml(options),
                  shot::metals_text(options, shot::plates_of(options)), 12.5});
  const auto file = folder / "checkpoint.bin";
  ogive::write_checkpoint_file(file, 8, notes.bytes, {});
  return file.string();
}

} // namespace

TEST_CASE("a run that goes on has the options of its checkpoint and the folder that it lies in") {
  const TemporaryFolder folder;
  Options o = options_of({"--nose", "conical", "--model", "jc", "--damage", "jc", "--velocity-mps", "214.1",
                          "--threads", "3", "--end-us", "70", "--no-picture", "--out", "elsewhere"});
  const std::string file = write_checkpoint_of(folder.path, o);
  Options restarted = options_of({"--restart", file.c_str()});
  REQUIRE(restarted.restart);
  CHECK(restarted.restart->file == file);
  CHECK(restarted.restart->time_us == 12.5);
  CHECK(restarted.out == folder.path);
  restarted.restart.reset();
  restarted.out = o.out;
  CHECK(restarted == o);
}

TEST_CASE("what leaves the physics as it is may be changed, nothing else") {
  const TemporaryFolder folder;
  const std::string file = write_checkpoint_of(folder.path, Options{});
  const Options o = options_of({"--restart", file.c_str(), "--end-us", "900", "--out", "here", "--output-every-us", "1",
                                "--checkpoint-every-us", "2", "--no-vtk", "--no-picture", "--quiet", "--threads", "2"});
  CHECK(o.end_us == 900);
  CHECK(o.out == "here");
  CHECK(o.output_every_us == 1);
  CHECK(o.checkpoint_every_us == 2);
  CHECK_FALSE(o.vtk);
  CHECK_FALSE(o.picture);
  CHECK(o.quiet);
  CHECK(o.threads == 2);
  for (const std::vector<const char *> &given : std::vector<std::vector<const char *>>{{"--thickness-mm", "8"},
                                                                                       {"--velocity-mps", "303.5"},
                                                                                       {"--material", "aa5083_h116"},
                                                                                       {"--spacing-mm", "1"}}) {
    std::vector<const char *> arguments{"--restart", file.c_str()};
    arguments.insert(arguments.end(), given.begin(), given.end());
    CHECK(refusal(arguments) == std::string(given[0]) + " = " + given[1] +
                                    ": the case is that of --restart; only these may be given: --end-us, --out, "
                                    "--output-every-us, --checkpoint-every-us, --vtk, --picture, --quiet, --threads");
  }
  CHECK(refusal({"--restart", file.c_str(), "--end-us", "12"}) ==
        "--end-us = 12: must not lie before the time of the checkpoint, 12.5 us");
  CHECK_THAT(refusal({"--restart", file.c_str(), "--threads", "0"}),
             Catch::StartsWith("--threads = 0: must be a whole"));
}

TEST_CASE("a metal from a file travels in the checkpoint") {
  const TemporaryFolder folder;
  const std::string steel = (folder.path / "my steel.toml").string();
  write(steel, materials::to_toml(plate_of(Options{}), ""));
  const Options o = options_of({"--material", steel.c_str()});
  const std::string file = write_checkpoint_of(folder.path, o);
  const auto before = materials::to_toml(plate_of(o), "");
  std::filesystem::remove(steel);
  const Options restarted = options_of({"--restart", file.c_str()});
  CHECK(restarted.material == steel);
  CHECK(materials::to_toml(plate_of(restarted), "") == before);
}

TEST_CASE("checkpoints of others and damaged ones are refused with one line") {
  const TemporaryFolder folder;
  const std::string file = write_checkpoint_of(folder.path, Options{}, "another");
  CHECK(refusal({"--restart", file.c_str()}) == "checkpoint = " + file + ": was not written by ogive shoot");
  ogive::write_checkpoint_file(file, 8, "notes", {});
  CHECK(refusal({"--restart", file.c_str()}) == "checkpoint = " + file + ": was not written by ogive shoot");

  write_checkpoint_of(folder.path, Options{});
  const std::string good = ogive::read_checkpoint_notes(file);
  std::mt19937 random(5);
  for (int k = 0; k < 300; ++k) {
    std::string notes = good;
    for (int n = 0; n < 3; ++n) notes[random() % notes.size()] = static_cast<char>(random());
    ogive::write_checkpoint_file(file, 8, notes, {});
    // Some digits make another case, all else is refused.
    const std::string message = refusal({"--restart", file.c_str()});
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("a run that takes up another does so if that is the same case and has not ended") {
  const TemporaryFolder folder;
  const std::string out = folder.path.string();
  const std::vector<const char *> given{"--nose", "conical", "--no-vtk", "--out", out.c_str()};
  const auto with = [&](std::vector<const char *> more) {
    more.insert(more.begin(), given.begin(), given.end());
    return options_of(more);
  };
  const Options fresh = with({});
  CHECK(with({"--resume"}) == fresh);

  const std::string file = write_checkpoint_of(folder.path, with({"--threads", "3", "--out", "moved"}));
  Options o = with({"--resume", "--threads", "2", "--quiet", "--no-picture"});
  REQUIRE(o.restart);
  CHECK(o.restart->file == file);
  CHECK(o.restart->time_us == 12.5);
  o.restart.reset();
  CHECK(o == with({"--threads", "2", "--quiet", "--no-picture"}));

  for (const std::vector<const char *> &other : std::vector<std::vector<const char *>>{{"--velocity-mps", "304"},
                                                                                       {"--spacing-mm", "0.7"},
                                                                                       {"--model", "jc"},
                                                                                       {"--friction", "0.1"},
                                                                                       {"--vtk"},
                                                                                       {"--output-every-us", "1"}}) {
    std::vector<const char *> more = other;
    more.push_back("--resume");
    std::vector<const char *> all{"--nose", "conical", "--no-vtk", "--out", out.c_str()};
    all.insert(all.end(), more.begin(), more.end());
    const std::string named = other.front();
    const std::string what = named == "--model" ? "another metal" : "a run with another " + named;
    CHECK(refusal(all) == "--resume = " + out + ": the checkpoint there cannot be resumed, it is of " + what +
                              "; give another --out, or leave --resume out to begin anew");
  }
  CHECK(with({"--end-us", "900", "--resume"}).restart);
  CHECK_THAT(refusal({"--nose", "conical", "--no-vtk", "--out", out.c_str(), "--resume", "--end-us", "12"}),
             Catch::Contains("its time, 12.5 us, is after --end-us"));

  write(folder.path / "summary.json", "{}");
  CHECK_FALSE(with({"--resume"}).restart);
  std::filesystem::remove(folder.path / "summary.json");
  REQUIRE(with({"--resume"}).restart);
  ogive::write_checkpoint_file(file, 8, "notes", {});
  CHECK_THAT(refusal({"--nose", "conical", "--no-vtk", "--out", out.c_str(), "--resume"}),
             Catch::Contains("was not written by ogive shoot"));
}

TEST_CASE("a run does not resume one with other constants of the metal") {
  const TemporaryFolder folder;
  const std::string steel = (folder.path / "steel.toml").string(), out = folder.path.string();
  const std::string text = materials::to_toml(plate_of(Options{}), "");
  write(steel, text);
  write_checkpoint_of(folder.path, options_of({"--material", steel.c_str(), "--out", out.c_str()}));
  const std::vector<const char *> resume{"--material", steel.c_str(), "--out", out.c_str(), "--resume"};
  CHECK(options_of(resume).restart);
  const auto at = text.find("\nC = ");
  REQUIRE(at != std::string::npos);
  write(steel, text.substr(0, at) + "\nC = 0.5" + text.substr(text.find('\n', at + 1)));
  CHECK_THAT(refusal(resume), Catch::Contains("it is of another metal"));
}
