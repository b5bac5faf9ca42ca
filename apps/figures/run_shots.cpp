#include "run_shots.hpp"

#include "ogive/io/write_error.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <system_error>
#include <utility>

namespace figures {

namespace {

namespace fs = std::filesystem;

/// perforate's command line for a task.
std::vector<std::string> arguments_of(const Workshop &workshop, const Task &task) {
  const ShotKey &key = task.key;
  const auto number = [](double value) { return ogive::shortest(value); };
  std::vector<std::string> arguments = {
      workshop.perforate.string(),
      "--model=" + key.model,
      "--material=" + key.material,
      "--nose=" + key.nose,
      "--thickness-mm=" + number(key.thickness_mm),
      "--velocity-mps=" + number(key.initial_velocity_mps),
      "--spacing-mm=" + number(key.spacing_mm),
      "--threads=" + std::to_string(workshop.threads),
      "--out=" + folder_of(workshop, key).string(),
      "--quiet",
      "--no-picture",
  };
  if (task.frames_us > 0)
    arguments.push_back("--output-every-us=" + number(task.frames_us));
  else
    arguments.push_back("--no-vtk");
  return arguments;
}

/// Starts the program with its output in `log`; returns its process, or -1.
pid_t start(std::vector<std::string> arguments, const fs::path &log) {
  std::vector<char *> argv;
  for (auto &argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = -1;
  const int error = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : -1;
}

/// A lock on a shot that other processes see, until it is destroyed. It goes with the process, however that ends.
class Lock {
public:
  Lock(const fs::path &file, bool wait) : descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor < 0) throw ogive::write_error(file, std::generic_category().message(errno));
    while (::flock(descriptor, LOCK_EX | (wait ? 0 : LOCK_NB)) != 0)
      if (errno != EINTR) {
        ::close(descriptor);
        descriptor = -1;
        break;
      }
  }
  Lock(Lock &&other) noexcept : descriptor(std::exchange(other.descriptor, -1)) {}
  Lock(const Lock &) = delete;
  Lock &operator=(Lock &&) = delete;
  ~Lock() {
    if (descriptor >= 0) ::close(descriptor);
  }
  bool held() const { return descriptor >= 0; }

private:
  int descriptor;
};

struct Running {
  Task task;
  Lock lock;
};

bool has_frames(const Workshop &workshop, const Task &task) {
  return task.frames_us <= 0 || fs::exists(folder_of(workshop, task.key) / "perforation.pvd");
}

/// How a process ended, in words.
std::string ending(int status) {
  if (WIFSIGNALED(status)) return std::string("killed by ") + ::strsignal(WTERMSIG(status));
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

std::string described(const ShotRow &row) {
  char text[160];
  std::snprintf(text, sizeof text, "%s: %.1f m/s, %.0f s, energy error %.3f %%", folder_name(row.key).c_str(),
                row.residual_velocity_mps, row.wall_s, 100 * row.energy_error);
  return text;
}

} // namespace

fs::path folder_of(const Workshop &workshop, const ShotKey &key) { return workshop.out / "shots" / folder_name(key); }

Outcome run_shots(const Workshop &workshop, const std::vector<Task> &tasks,
                  const std::function<void(const std::string &)> &say) {
  std::error_code error;
  fs::create_directories(workshop.out / "shots", error);
  if (error) throw ogive::write_error(workshop.out / "shots", error.message());

  Outcome outcome;
  std::map<pid_t, Running> running;
  std::vector<ShotRow> rows = read_all_rows(workshop.out);
  const auto is_done = [&](const Task &task) {
    return find_row(rows, task.key) != nullptr && has_frames(workshop, task);
  };
  // Takes the row from a finished run; says whether there is one.
  const auto collect = [&](const Task &task, const std::string &how) {
    try {
      const ShotRow row = read_summary(task.key, folder_of(workshop, task.key));
      if (find_row(rows, task.key) == nullptr) append_row(workshop.rows, row);
      rows.push_back(row);
      say(described(row));
      return true;
    } catch (const ogive::SetupError &reason) {
      if (!how.empty())
        outcome.failed.push_back(folder_name(task.key) + ": " + how + ", see " +
                                 (folder_of(workshop, task.key).string() + ".log") + ": " + reason.what());
      return false;
    }
  };
  const auto wait_for_one = [&] {
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, 0);
    const auto found = running.find(child);
    if (found == running.end()) return;
    if (collect(found->second.task, ending(status)))
      ++outcome.run;
    else
      say(outcome.failed.back());
    running.erase(found);
  };
  const auto begin = [&](const Task &task, bool wait) {
    Lock lock(workshop.out / "shots" / (folder_name(task.key) + ".lock"), wait);
    if (!lock.held()) return false;
    rows = read_all_rows(workshop.out);
    const bool finished = fs::exists(folder_of(workshop, task.key) / "summary.json") && has_frames(workshop, task);
    if (is_done(task) || (finished && collect(task, ""))) {
      ++outcome.known;
      return true;
    }
    const pid_t child = start(arguments_of(workshop, task), folder_of(workshop, task.key).string() + ".log");
    if (child < 0)
      outcome.failed.push_back(folder_name(task.key) + ": " + workshop.perforate.string() + " cannot be started");
    else
      running.emplace(child, Running{task, std::move(lock)});
    return true;
  };

  std::vector<Task> elsewhere;
  for (const bool wait : {false, true}) {
    for (const Task &task : wait ? std::exchange(elsewhere, {}) : tasks) {
      if (is_done(task)) {
        ++outcome.known;
        continue;
      }
      while (static_cast<int>(running.size()) >= workshop.jobs) wait_for_one();
      if (!begin(task, wait)) elsewhere.push_back(task);
    }
    while (!running.empty()) wait_for_one();
  }
  return outcome;
}

} // namespace figures
