// SPDX-License-Identifier: BSD-3-Clause
#include "figures_fake.hpp"

#include <algorithm>
#include <csignal>

using namespace figures;
namespace fs = std::filesystem;

TEST_CASE("Shots are run once: rows, summaries without a row and frames count as known") {
  const FakeWorkshop fake;
  const std::vector<Task> tasks{task_at(150), task_at(200), task_at(250)};
  std::vector<std::string> said;
  Outcome outcome = fake.run(tasks, &said);
  CHECK(outcome.run == 3);
  CHECK(outcome.known == 0);
  CHECK(outcome.failed.empty());
  CHECK(outcome.stopped_by == 0);
  CHECK(said.size() == 3);
  CHECK(fake.rows().size() == 3);
  CHECK(find_row(fake.rows(), task_at(150).key)->perforated == 0);
  CHECK(find_row(fake.rows(), task_at(200).key)->perforated == 1);
  CHECK(fake.starts().at("mjc blunt 12 150") == 1);

  outcome = fake.run(tasks);
  CHECK(outcome.run == 0);
  CHECK(outcome.known == 3);

  // Stopped between the end of a shot and its row.
  fs::remove(fake.workshop.rows);
  outcome = fake.run(tasks);
  CHECK(outcome.run == 0);
  CHECK(outcome.known == 3);
  CHECK(fake.rows().size() == 3);

  // Rows suffice, the folders may be gone.
  fs::remove_all(fake.workshop.out / "shots");
  CHECK(fake.run(tasks).known == 3);
  for (const auto &[shot, count] : fake.starts()) CHECK(count == 1);

  // Frames that are wanted are made, and no second row.
  outcome = fake.run({task_at(200, 5), task_at(250)});
  CHECK(outcome.run == 1);
  CHECK(outcome.known == 1);
  CHECK(fake.rows().size() == 3);
  CHECK(fake.run({task_at(200, 5)}).known == 1);
  CHECK(fake.starts().at("mjc blunt 12 200") == 2);

  // Those of a run that was killed half-way do not count.
  fs::remove(folder_of(fake.workshop, task_at(200).key) / "summary.json");
  CHECK(fake.run({task_at(200, 5)}).run == 1);
  CHECK(fake.rows().size() == 3);

  // The same shot twice in a list.
  outcome = fake.run({task_at(300), task_at(300, 5), task_at(300)});
  CHECK(outcome.run == 2);
  CHECK(outcome.known == 1);
  CHECK(fake.rows().size() == 4);
}

TEST_CASE("A shot that fails is told in one line and loses no other") {
  const FakeWorkshop fake(R"(
case $velocity in
  301) echo "perforate: stopped at 3 us" >&2; fault='{"what": "negative volume"}' ;;
  302) echo "some other line"; echo "perforate: error: --spacing-mm = 4: must be less" >&2; echo "advice"; exit 2 ;;
  303) echo; echo "the last line"; kill -SEGV $$ ;;
  304) kill -KILL $$ ;;
  305) fault='{"what": "a\nb"}' ;;
  306) exit 0 ;;
  307) fault='"text"' ;;
  308) velocity=999 ;;
  309) echo "no json" > "$out/summary.json"; exit 0 ;;
  310) residual=null ;;
  311) thickness='"a,b"' ;;
esac
)");
  const auto tasks = tasks_from(300, 13);
  std::vector<std::string> said;
  Outcome outcome = fake.run(tasks, &said);
  CHECK(outcome.run == 2);
  CHECK(fake.rows().size() == 2);
  REQUIRE(outcome.failed.size() == 11);
  std::map<std::string, std::string> reasons;
  for (const auto &line : outcome.failed) {
    CHECK(line.find('\n') == std::string::npos);
    CHECK(line.ends_with(".log"));
    reasons[line.substr(line.find("mps_2mm") - 3, 3)] = line;
  }
  const auto says = [&](const char *velocity, const char *reason) {
    INFO(reasons[velocity]);
    CHECK(reasons[velocity].find(reason) != std::string::npos);
  };
  says("301", "the run stopped: negative volume");
  says("302", "exit status 2: perforate: error: --spacing-mm = 4: must be less; see ");
  says("303", "killed by signal 11 (Segmentation fault): the last line; see ");
  says("304", "killed by signal 9");
  says("305", "the run stopped: a?b");
  says("306", "summary.json: must be a file that can be read");
  says("307", "summary.json: ");
  says("308", "is the summary of another shot");
  says("309", "is no summary of perforate");
  says("310", "must be number, but is null");
  says("311", "must be number, but is string");
  CHECK(std::count_if(said.begin(), said.end(), [](const auto &line) { return line.starts_with("failed: "); }) == 11);

  // They are tried again, the others are not.
  fake.behave("");
  outcome = fake.run(tasks);
  CHECK(outcome.run == 11);
  CHECK(outcome.known == 2);
  CHECK(fake.rows().size() == 13);
  CHECK(fake.starts().at("mjc blunt 12 300") == 1);

  // An old summary does not hide that a new run failed.
  fs::create_directories(fake.folder.path / "kept");
  fake.behave("cp $here/kept/* \"$out\"; exit 3");
  fs::copy(folder_of(fake.workshop, task_at(300).key) / "summary.json", fake.folder.path / "kept");
  CHECK(fake.run({task_at(300, 5)}).failed.size() == 1);
  CHECK(fake.rows().size() == 13);

  fs::remove(fake.workshop.perforate);
  outcome = fake.run({task_at(400)});
  REQUIRE(outcome.failed.size() == 1);
  CHECK(outcome.failed[0].find("cannot be started: No such file or directory; see ") != std::string::npos);
}

TEST_CASE("Jobs run at the same time, not more than allowed, and hold none of our files") {
  FakeWorkshop fake(R"(
ls -l /proc/$$/fd > $here/files_$velocity
echo > $here/now_$velocity
[ $(ls $here/now_* | wc -l) -le 3 ] || exit 1
echo > $here/come_$velocity
for k in $(seq 200); do
  [ $(ls $here/come_* | wc -l) -lt 3 ] || break
  sleep 0.1
done
[ $(ls $here/come_* | wc -l) -ge 3 ] || exit 1
rm $here/now_$velocity
)");
  fake.workshop.jobs = 3;
  const Outcome outcome = fake.run(tasks_from(300, 9));
  for (const auto &line : outcome.failed) FAIL_CHECK(line);
  CHECK(outcome.run == 9);
  for (int k = 300; k < 309; ++k) {
    const std::string files = read_text(fake.folder.path / ("files_" + std::to_string(k)));
    CHECK(files.find("_2mm.log") != std::string::npos);
    CHECK(files.find(".lock") == std::string::npos);
    CHECK(files.find("shots.csv") == std::string::npos);
  }
}

TEST_CASE("Processes on one folder run each shot once between them") {
  for (const char *behaviour : {"sleep 0.0$(( ($$ * 7) % 10 ))", ""}) {
    FakeWorkshop fake(behaviour);
    fake.workshop.jobs = 3;
    const auto tasks = tasks_from(300, 60);
    const auto backwards = std::vector<Task>(tasks.rbegin(), tasks.rend());
    std::vector<pid_t> processes;
    for (const auto *list : {&tasks, &tasks, &backwards})
      processes.push_back(in_child([&] {
        const Outcome outcome = fake.run(*list);
        return outcome.failed.empty() && outcome.run + outcome.known == 60 ? 0 : 1;
      }));
    for (const pid_t process : processes) CHECK(shell_status(process) == 0);
    const auto starts = fake.starts();
    CHECK(starts.size() == 60);
    for (const auto &[shot, count] : starts) CHECK(count == 1);
    CHECK(fake.rows().size() == 60);
    CHECK(read_all_rows(fake.workshop.out).size() == 60);
  }
}

TEST_CASE("A full disk or damaged rows end a campaign without losing shots") {
  const FakeWorkshop fake;
  CHECK(fake.run(tasks_from(200, 20)).run == 20);
  Outcome outcome;
  {
    const FullDisk full(fs::file_size(fake.workshop.rows) + 20); // a summary has room, a row has none
    outcome = fake.run({task_at(300), task_at(301)});
  }
  CHECK(outcome.run == 0);
  REQUIRE(outcome.failed.size() == 2);
  CHECK(outcome.failed[0].find("cannot write ") != std::string::npos);
  CHECK(fake.rows().size() == 20);
  {
    const FullDisk full(fs::file_size(fake.workshop.rows) + 20);
    CHECK(fake.run({task_at(300), task_at(301)}).failed.size() == 2);
  }
  CHECK(fake.run({task_at(300), task_at(301)}).known == 2);
  CHECK(fake.starts().at("mjc blunt 12 300") == 1);
  CHECK(fake.rows().size() == 22);

  // While one shot runs another process damages the rows: the shot ends, too.
  fake.behave("printf %s $$ > $here/pid_$velocity; [ $velocity = 401 ] || exec sleep 100; echo damaged >> " +
              fake.workshop.rows.string());
  CHECK(message_of([&] { fake.run(tasks_from(400, 3)); }).find("shots.csv:24: fields in the row") != std::string::npos);
  CHECK_FALSE(is_alive(read_text(fake.folder.path / "pid_400")));
}

TEST_CASE("A campaign whose parent ignores the end of children sees how they end") {
  const FakeWorkshop fake("[ $velocity = 300 ] && exit 5");
  CHECK(shell_status(in_child([&] {
          std::signal(SIGCHLD, SIG_IGN);
          const Outcome outcome = fake.run(tasks_from(300, 3));
          const bool told = outcome.failed.size() == 1 && outcome.failed[0].find("exit status 5") != std::string::npos;
          return outcome.run == 2 && told ? 0 : 1;
        })) == 0);
}
