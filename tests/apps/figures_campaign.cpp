// SPDX-License-Identifier: BSD-3-Clause
#include "figures_fake.hpp"

#include "draw/plot.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <thread>

using namespace figures;
namespace fs = std::filesystem;

namespace {

/// The program nose_shapes, silent, with a fake perforate.
pid_t start_campaign(const FakeWorkshop &fake, std::vector<std::string> arguments) {
  return in_child([&] {
    const auto log = fake.folder.path / ("log_" + std::to_string(::getpid()));
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    ::close(file);
    arguments.insert(arguments.begin(), {"nose_shapes", "--perforate=" + fake.workshop.perforate.string(),
                                         "--out=" + fake.workshop.out.string(), "--spacing-mm=2", "--jobs=2"});
    std::vector<const char *> argv;
    for (const auto &argument : arguments) argv.push_back(argument.c_str());
    return run_campaign({"nose_shapes", "", {11}, {}}, static_cast<int>(argv.size()), argv.data());
  });
}

template <class F> bool comes_true(F &&f) {
  for (int k = 0; k < 1000; ++k, std::this_thread::sleep_for(std::chrono::milliseconds(20)))
    if (f()) return true;
  return false;
}

/// Waits for shots that write their process into files pid_<velocity>, and returns these.
std::vector<std::string> wait_for_shots(const FakeWorkshop &fake, std::size_t count) {
  std::vector<std::string> processes;
  REQUIRE(comes_true([&] {
    processes.clear();
    for (const auto &entry : fs::directory_iterator(fake.folder.path))
      if (entry.path().filename().string().starts_with("pid_")) processes.push_back(read_text(entry.path()));
    return processes.size() == count && std::find(processes.begin(), processes.end(), "") == processes.end();
  }));
  return processes;
}

constexpr const char *sleeping = "printf %s $$ > $here/pid_$velocity; exec sleep 100";

/// The rows without the times that differ from run to run, sorted.
std::vector<std::string> comparable(const fs::path &folder) {
  std::vector<std::string> lines;
  for (const ShotRow &row : read_all_rows(folder)) {
    std::string line;
    for_each_column(row, [&](const std::string &name, const auto &value) {
      std::ostringstream text;
      text << value << ",";
      if (name != "wall_s" && name != "cpu_s" && name != "threads") line += text.str();
    });
    lines.push_back(line);
  }
  return lines;
}

} // namespace

TEST_CASE("A signal ends a campaign and its shots; the next call goes on") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    const FakeWorkshop fake("case $velocity in 3*) ;; *) " + std::string(sleeping) + " ;; esac");
    const pid_t campaign = start_campaign(fake, {"--shard=1/6"}); // blunt, MJC
    const auto shots = wait_for_shots(fake, 2);
    for (const auto &shot : shots) REQUIRE(is_alive(shot));
    ::kill(std::stoi(shots[0]), SIGSTOP);
    ::kill(campaign, signal);
    CHECK(shell_status(campaign) == 128 + signal);
    // Otherwise the campaign waits for them before it ends.
    if (signal == SIGKILL) CHECK(comes_true([&] { return !is_alive(shots[0]) && !is_alive(shots[1]); }));
    for (const auto &shot : shots) CHECK_FALSE(is_alive(shot));
    const std::string log = read_text(fake.folder.path / ("log_" + std::to_string(campaign)));
    CHECK(log.find("failed: ") == std::string::npos);
    if (signal != SIGKILL) {
      const std::string stopped = "nose_shapes: stopped by signal " + std::to_string(signal) + " (";
      CHECK(log.find(stopped) != std::string::npos);
    }

    fake.behave("");
    CHECK(shell_status(start_campaign(fake, {"--shard=1/6"})) == 0);
    for (const auto &[shot, count] : fake.starts())
      CHECK(count == 1 + (shot == "mjc blunt 12 200.4" || shot == "mjc blunt 12 224.7"));
  }
}

TEST_CASE("Signals that were ignored stay so, and one that insists ends shots that hold out") {
  const FakeWorkshop fake("trap '' TERM; printf %s $$ > $here/pid_$velocity; while :; do sleep 0.1; done");
  const pid_t campaign = in_child([&] {
    std::signal(SIGINT, SIG_IGN);
    return fake.run(tasks_from(300, 3)).stopped_by;
  });
  const auto shots = wait_for_shots(fake, 2);
  const auto after = [](int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); };
  ::kill(campaign, SIGINT);
  after(200);
  // The same order, told twice.
  ::kill(campaign, SIGTERM);
  after(200);
  ::kill(campaign, SIGTERM);
  after(1000);
  for (const auto &shot : shots) CHECK(is_alive(shot));
  ::kill(campaign, SIGTERM);
  CHECK(shell_status(campaign) == SIGTERM);
  for (const auto &shot : shots) CHECK_FALSE(is_alive(shot));
}

TEST_CASE("Bisection goes on for the other series where shots fail") {
  const FakeWorkshop fake("[ $nose = ogival ] && [ $model = jc ] && [ ${velocity%.*} -lt 297 ] && exit 3");
  CHECK(shell_status(start_campaign(fake, {"--shard=1/2"})) == 0);
  CHECK(shell_status(start_campaign(fake, {"--shard=2/2"})) == 3);
  std::map<std::string, std::vector<ShotRow>> series;
  for (const ShotRow &row : read_all_rows(fake.workshop.out)) series[row.key.model + row.key.nose].push_back(row);
  REQUIRE(series.size() == 6);
  for (const auto &[name, rows] : series) {
    const auto round = next_round({series_of(rows[0].key)}, rows, FIGURES_DATA_FOLDER);
    CHECK(round.empty() == (name != "jcogival"));
  }
  // A law whose every shot fails: one round, then the end.
  fake.behave("exit 3");
  fs::remove_all(fake.workshop.out);
  CHECK(shell_status(start_campaign(fake, {"--shard=1/6"})) == 3);
}

TEST_CASE("Three shards, one after another or at once, and two whole runs at once give the rows of one run") {
  const int drawn = draw::gnuplot_available() ? 0 : 3;
  const FakeWorkshop whole, one_by_one, at_once, two;
  CHECK(shell_status(start_campaign(whole, {})) == drawn);
  const auto expected = comparable(whole.workshop.out);
  CHECK(expected.size() > 60); // 36 of the list and the bisection's

  std::vector<pid_t> running;
  for (const char *shard : {"--shard=1/3", "--shard=2/3", "--shard=3/3"}) {
    CHECK(shell_status(start_campaign(one_by_one, {shard})) == 0);
    running.push_back(start_campaign(at_once, {shard}));
  }
  for (const pid_t campaign : running) CHECK(shell_status(campaign) == 0);
  running = {start_campaign(two, {}), start_campaign(two, {})};
  for (const pid_t campaign : running) CHECK(shell_status(campaign) == drawn);
  for (const FakeWorkshop *fake : {&one_by_one, &at_once, &two}) {
    CHECK(comparable(fake->workshop.out) == expected);
    for (const auto &[shot, count] : fake->starts()) CHECK(count == 1);
  }
  CHECK(fs::exists(at_once.workshop.out / "shots.2-of-3.csv"));
  CHECK_FALSE(fs::exists(at_once.workshop.out / "shots.csv"));

  // A run without shards draws what they made, and runs nothing.
  const auto before = one_by_one.starts();
  CHECK(shell_status(start_campaign(one_by_one, {})) == drawn);
  CHECK(shell_status(start_campaign(one_by_one, {"--no-run"})) == drawn);
  CHECK(one_by_one.starts() == before);
  CHECK(fs::exists(one_by_one.workshop.out / "nose_shapes_limits.csv"));
}

TEST_CASE("Rows without frames are enough where no pictures are asked for") {
  // Steel, blunt: the list of Fig. 6 holds shots of Figs. 7, 8 and 10, whose pictures need frames.
  Options with, without;
  without.pictures = false;
  const Campaign campaign{.name = "steel_blunt", .purpose = "", .figures = {6}, .plots = {}};
  const auto framed = [](const ListedShot &shot) { return shot.picture || shot.task.frames_us > 0; };
  const auto all = listed_shots(campaign, with, FIGURES_DATA_FOLDER);
  const auto few = listed_shots(campaign, without, FIGURES_DATA_FOLDER);
  CHECK(std::any_of(all.begin(), all.end(), framed));
  CHECK(std::none_of(few.begin(), few.end(), framed));
  CHECK(series_in(few) == series_in(all));
}
