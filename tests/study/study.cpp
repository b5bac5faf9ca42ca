// SPDX-License-Identifier: BSD-3-Clause
#include "sample.hpp"
#include "study/limits.hpp"

#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "ogive/io/write_error.hpp"
#include "shot/signals.hpp"
#include "study/finish.hpp"

#include <csignal>
#include <set>

using namespace study;
namespace fs = std::filesystem;

namespace {

/// A study in a folder of its own.
struct SmallStudy {
  TemporaryFolder folder;
  Study study{.out = folder.path / "out"};
  mutable std::vector<std::string> said{};

  explicit SmallStudy(int jobs = 1) { study.jobs = jobs; }

  Outcome run(const std::vector<Case> &cases) const {
    said.clear();
    return run_cases(study, cases, [this](const std::string &line) { said.push_back(line); });
  }
  std::vector<Row> rows() const { return read_all_rows(study.out, {}); }
};

/// The case with frames.
Case with_frames(Case shot) {
  shot.options.vtk = true;
  return shot;
}

bool contains(const std::string &text, const std::string &part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("Shots are run once: rows, summaries without a row and frames count as known") {
  const SmallStudy small;
  const auto cases = small_cases({150, 200, 250});
  Outcome outcome = small.run(cases);
  CHECK(outcome.run == 3);
  CHECK(outcome.known == 0);
  CHECK(outcome.failed.empty());
  CHECK(outcome.stopped_by == 0);
  REQUIRE(small.said.size() == 3);
  CHECK(small.said[0].starts_with("stabilised_mjc_weldox_460e_blunt_4mm_150mps_2mm: undecided, "));
  CHECK(velocities_of(small.rows()) == std::vector<double>{150, 200, 250});
  const auto hashes = hashes_of(small.rows());

  outcome = small.run(cases);
  CHECK(outcome.run == 0);
  CHECK(outcome.known == 3);

  // Stopped between the end of a shot and its row.
  fs::remove(rows_file(small.study));
  outcome = small.run(cases);
  CHECK(outcome.run == 0);
  CHECK(outcome.known == 3);
  CHECK(hashes_of(small.rows()) == hashes);

  // Rows suffice, the folders may be gone.
  fs::remove_all(small.study.out / "shots");
  CHECK(small.run(cases).known == 3);

  // Frames that are wanted are made, and no second row.
  outcome = small.run({with_frames(cases[1]), cases[2]});
  CHECK(outcome.run == 1);
  CHECK(outcome.known == 1);
  CHECK(small.run({with_frames(cases[1])}).known == 1);
  CHECK(small.run({cases[1]}).known == 1);
  CHECK(hashes_of(small.rows()) == hashes);

  // Those of a run that was killed half-way do not count.
  fs::remove(folder_of(small.study, cases[1]) / "summary.json");
  CHECK(small.run({with_frames(cases[1])}).run == 1);
  CHECK(hashes_of(small.rows()) == hashes);

  // The same shot twice in a list.
  outcome = small.run({small_case(300), with_frames(small_case(300)), small_case(300)});
  CHECK(outcome.run == 2);
  CHECK(outcome.known == 1);
  CHECK(small.rows().size() == 4);
}

TEST_CASE("A shot that fails is reported in one line and loses no other") {
  const SmallStudy small;
  auto cases = small_cases({200, 250, 300});
  cases[0].options.sph_radius_mm = 3; // within the projectile's radius
  fs::create_directories(small.study.out / "shots");
  write(folder_of(small.study, cases[1]), "a file where a folder must be");
  Outcome outcome = small.run(cases);
  CHECK(outcome.run == 1);
  REQUIRE(outcome.failed.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(lines_in(outcome.failed[k]) == 0);
    CHECK(outcome.failed[k].starts_with(cases[k].name + ": "));
    CHECK(small.said[k] == "failed: " + outcome.failed[k]);
  }
  CHECK(velocities_of(small.rows()) == std::vector<double>{300});

  // They are tried again, the other is not.
  fs::remove(folder_of(small.study, cases[1]));
  cases[0].options.sph_radius_mm = 15;
  outcome = small.run(cases);
  CHECK(outcome.run == 2);
  CHECK(outcome.known == 1);
}

TEST_CASE("Results of another case in the folder of a shot are a failure that names the option") {
  const SmallStudy small;
  CHECK(small.run({small_case(200)}).run == 1);
  const auto hashes = hashes_of(small.rows());
  const Outcome outcome = small.run({small_case(200, {{"friction", "0.3"}}), small_case(250)});
  CHECK(outcome.run == 1);
  REQUIRE(outcome.failed.size() == 1);
  CHECK(contains(outcome.failed[0], "are of a case with another friction; give another --out or remove them"));
  CHECK(hashes_of(small.rows())[0] == hashes[0]);

  // What is no part of the case may differ.
  CHECK(small.run({small_case(200, {{"output_every_us", "1"}, {"vtk", "false"}})}).known == 1);
}

TEST_CASE("A shot that is undecided at the end of its time resumes when it is given more") {
  const SmallStudy small, whole;
  CHECK(small.run({small_case(200)}).run == 1);
  CHECK(is_undecided(small.rows().at(0)));
  CHECK(contains(small.said.at(0), "undecided, "));
  CHECK(small.run({small_case(200)}).known == 1);
  CHECK(small.run({small_case(200, {{"end_us", "6"}})}).run == 1);
  REQUIRE(small.rows().size() == 1);
  CHECK(number(small.rows().at(0), "simulated_us") >= 6);
  whole.run({small_case(200, {{"end_us", "6"}})});
  CHECK(hashes_of(small.rows()) == hashes_of(whole.rows()));
}

TEST_CASE("The search for a limit ends with a reason at a shot without a verdict and above all velocities") {
  const SmallStudy small;
  std::vector<std::string> said;
  const auto report = [&](const std::string &line) { said.push_back(line); };
  Series series = series_of(small_case(200));
  series.guess_mps = 200;
  const Outcome undecided = find_limits(small.study, {series}, 5, report);
  CHECK(undecided.run == 1);
  REQUIRE(undecided.failed.size() == 1);
  CHECK(contains(undecided.failed[0], "undecided at 5"));
  CHECK(contains(undecided.failed[0], "a later --end-us decides it"));

  // All shots up to the highest velocity were stopped.
  std::vector<double> velocities{200};
  for (const SmallStudy fast; velocities.back() <= shot::largest_velocity_mps;) {
    auto rows = std::vector<Row>{};
    for (const double v : velocities) rows.push_back(sample_row(shot_of(series, v, {}).key, 1e9));
    const auto next = next_velocity(series, rows, 5);
    REQUIRE(next);
    if (*next > shot::largest_velocity_mps) {
      fs::create_directories(fast.study.out);
      for (const Row &row : rows) append_row(rows_file(fast.study), row, {});
      const Outcome above = find_limits(fast.study, {series}, 5, report);
      CHECK(above.run == 0);
      REQUIRE(above.failed.size() == 1);
      CHECK(contains(above.failed[0], "no shot up to 3000 m/s perforates"));
    }
    velocities.push_back(*next);
  }
}

TEST_CASE("Two jobs give the same hashes as one") {
  const auto cases = small_cases({150, 200, 250, 300, 350, 400});
  const SmallStudy one(1), two(2), many(20);
  CHECK(one.run(cases).run == 6);
  CHECK(two.run(cases).run == 6);
  CHECK(many.run(cases).run == 6);
  CHECK(hashes_of(two.rows()) == hashes_of(one.rows()));
  CHECK(hashes_of(many.rows()) == hashes_of(one.rows()));
  const auto hashes = hashes_of(one.rows());
  CHECK(std::set<std::string>(hashes.begin(), hashes.end()).size() == 6);

  // Few shots share all cores.
  const SmallStudy few(cores());
  few.run({cases[0]});
  auto rows = few.rows();
  CHECK(result(rows.at(0), "threads") == std::to_string(cores()));
  CHECK(hashes_of(rows).at(0) == hashes[0]);
}

TEST_CASE("A signal ends a study, and the next call resumes its shots from their checkpoints") {
  const auto cases = small_cases({150, 200, 250});
  const SmallStudy whole;
  CHECK(whole.run(cases).run == 3);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const SmallStudy small;
    std::size_t next = 0;
    {
      const shot::SignalCatcher catcher;
      const Outcome outcome = run_chosen(
          small.study, 1,
          [&](const std::vector<Row> &) -> std::optional<Case> {
            if (next == 1) std::raise(signal);
            return cases[next++];
          },
          [](const std::string &) {});
      CHECK(outcome.stopped_by == signal);
      CHECK(outcome.run == 1);
      CHECK(outcome.failed.empty());
    }
    CHECK(next == 2);
    CHECK(fs::exists(folder_of(small.study, cases[1]) / shot::checkpoint_name));
    CHECK_FALSE(fs::exists(folder_of(small.study, cases[1]) / "summary.json"));
    const shot::SignalCatcher none_caught;
    const Outcome outcome = small.run(cases);
    CHECK(outcome.run == 2);
    CHECK(outcome.known == 1);
    CHECK(hashes_of(small.rows()) == hashes_of(whole.rows()));
  }
}

TEST_CASE("A full disk or damaged rows lose no shot") {
  const SmallStudy small;
  CHECK(small.run({small_case(200)}).run == 1);
  const auto file = rows_file(small.study);
  const std::string before = read_text(file);
  Outcome outcome;
  {
    const FullDisk full(fs::file_size(file) + 20);
    outcome = small.run({small_case(300)});
  }
  CHECK(outcome.run == 0);
  REQUIRE(outcome.failed.size() == 1);
  CHECK(contains(outcome.failed[0], "must be a folder that can be written to"));
  CHECK(read_text(file) == before);
  outcome = small.run(small_cases({200, 300}));
  CHECK(outcome.run == 1);
  CHECK(outcome.known == 1);

  write(file, before + "damaged\n");
  CHECK(contains(message_of([&] { small.run({small_case(400)}); }), "shots.csv:3: fields in the row = 1"));
  CHECK_FALSE(fs::exists(folder_of(small.study, small_case(400))));

  const SmallStudy blocked;
  write(blocked.study.out, "a file");
  CHECK_THROWS_AS(blocked.run({small_case(200)}), ogive::WriteError);
}

TEST_CASE("Bisection goes on for the other series where a shot fails, and counts known shots") {
  const SmallStudy small(2);
  const Series sound = series_of(small_case(200, {{"end_us", "3000"}}));
  Series broken = series_of(small_case(200, {{"thickness_mm", "5"}}));
  broken.options.sph_radius_mm = 3;
  fs::create_directories(small.study.out);
  // The bracket of 12 m/s shrinks with each shot that is decided.
  append_row(rows_file(small.study), sample_row(shot_of(sound, 100, {}).key, 105), {});
  append_row(rows_file(small.study), sample_row(shot_of(sound, 112, {}).key, 105), {});
  std::vector<std::string> said;
  const Outcome outcome =
      find_limits(small.study, {broken, sound}, 4, [&](const std::string &line) { said.push_back(line); });
  CHECK(outcome.known == 2);
  CHECK(outcome.failed.size() == 1); // one shot, then that series ends
  CHECK(outcome.run >= 2);
  CHECK(said.size() == static_cast<std::size_t>(outcome.run) + 1);
  const auto limits = limits_in({broken, sound}, small.rows());
  REQUIRE(limits.size() == 1);
  const auto estimate = ogive::limit_estimate(limits[0].bracket);
  REQUIRE(estimate.has_value());
  CHECK(estimate->half_width <= 2);
  CHECK_FALSE(next_velocity(sound, small.rows(), 4).has_value());
}

TEST_CASE("The search with another arrangement of the particles begins beside the limit of the first") {
  const SmallStudy small(2);
  const Texts columns{"seed"};
  Study study = small.study;
  study.own_columns = columns;
  const auto arranged = [&](const std::string &seed) {
    return series_of(case_of(small_case(200, {{"end_us", "3000"}, {"seed", seed}}).options, columns, ""));
  };
  const Series first = arranged("0"), other = arranged("1");
  fs::create_directories(study.out);
  for (const double v : {104.0, 108.0})
    append_row(rows_file(study), sample_row(shot_of(first, v, columns).key, 106), columns);
  std::vector<std::string> said;
  const Outcome outcome = find_limits(study, {first, other}, 4, [&](const std::string &line) { said.push_back(line); });
  CHECK(outcome.known == 2);
  CHECK(outcome.failed.empty());
  REQUIRE(outcome.run >= 2);
  CHECK(contains(said.at(0), "104mps")); // not 200, nor the guess from the thickness
  CHECK(limits_in({other}, read_all_rows(study.out, columns)).size() == 1);
  CHECK_FALSE(next_velocity(other, read_all_rows(study.out, columns), 4).has_value());
}

TEST_CASE("Other arrangements of the particles are searched, too, where a shot of the first fails") {
  const SmallStudy small(2);
  const Texts columns{"seed"};
  Study study = small.study;
  study.own_columns = columns;
  const auto arranged = [&](const std::string &seed) {
    return series_of(case_of(small_case(200, {{"end_us", "3000"}, {"seed", seed}}).options, columns, ""));
  };
  Series broken = arranged("0");
  broken.options.sph_radius_mm = 3;
  const Series sound = arranged("1");
  fs::create_directories(study.out);
  for (const double v : {100.0, 112.0})
    append_row(rows_file(study), sample_row(shot_of(sound, v, columns).key, 105), columns);
  const Outcome outcome = find_limits(study, {broken, sound}, 4, [](const std::string &) {});
  CHECK(outcome.failed.size() == 1);
  CHECK(outcome.run >= 2);
  CHECK_FALSE(next_velocity(sound, read_all_rows(study.out, columns), 4).has_value());
  // Once more, with nothing left to search but what fails.
  CHECK(find_limits(study, {broken, sound}, 4, [](const std::string &) {}).failed.size() == 1);
}

TEST_CASE("One process has a study, or one each of its shards") {
  const TemporaryFolder folder;
  const auto refused = [&](int shard, int shards) {
    const std::string message = message_of(
        [&] { const StudyLock lock = lock_study(Study{.out = folder.path, .shard = shard, .shards = shards}); });
    CHECK(lines_in(message) == 0);
    return message;
  };
  const std::string start = "--out = " + folder.path.string() + ": another process works on this study",
                    end = "; wait for its end, or give another folder";
  {
    const StudyLock all = lock_study(Study{.out = folder.path});
    CHECK(refused(1, 1) == start + end);
    CHECK(refused(1, 2) == start + ", without --shard" + end);
  }
  {
    const StudyLock shard = lock_study(Study{.out = folder.path, .shard = 1, .shards = 3});
    CHECK(refused(2, 3).empty());
    CHECK(refused(1, 3) == start + ", on the same shard" + end);
    CHECK(refused(1, 1) == start + end);
    // Parts of another number overlap with it.
    CHECK(refused(2, 2) == start + ", in another number of shards" + end);
  }
  CHECK(refused(2, 2).empty());
  CHECK(refused(1, 1).empty());
  CHECK_THROWS_AS(lock_study(Study{.out = folder.path / "missing"}), ogive::WriteError);
}
