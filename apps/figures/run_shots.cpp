// SPDX-License-Identifier: BSD-3-Clause
#include "run_shots.hpp"

#include "child.hpp"
#include "shot_lock.hpp"

#include "ogive/io/write_error.hpp"
#include "shared/signals.hpp"

#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <list>
#include <map>
#include <system_error>
#include <utility>

namespace figures {

namespace {

namespace fs = std::filesystem;

/// How often shots that another process is running are looked after.
constexpr long poll_s = 1;

/// perforate's command line for a task.
std::vector<std::string> arguments_of(const Workshop &workshop, const Task &task) {
  const ShotKey &key = task.key;
  const auto number = [](double value) { return ogive::shortest(value); };
  std::vector<std::string> arguments = {
      workshop.perforate.string(),
      "--method=" + key.method,
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
      "--resume",
  };
  if (task.frames_us > 0)
    arguments.emplace_back("--output-every-us=" + number(task.frames_us));
  else
    arguments.emplace_back("--no-vtk");
  return arguments;
}

fs::path log_of(const Workshop &workshop, const ShotKey &key) { return folder_of(workshop, key).string() + ".log"; }

/// The line of a log that says why it failed: the first that perforate begins with its name, else the last.
std::string reason_in(const fs::path &log) {
  std::ifstream file(log);
  std::string line, last;
  while (!line.starts_with("perforate: ") && std::getline(file, line))
    if (!line.empty()) last = line;
  return ogive::printable(last);
}

/// Whether perforate came to its end, which it says in its summary, last of all.
bool is_finished(const Workshop &workshop, const Task &task) {
  return fs::exists(folder_of(workshop, task.key) / "summary.json");
}

/// Whether all frames are there that are wanted. The list of frames grows with them, also in a run that is then killed.
bool has_frames(const Workshop &workshop, const Task &task) {
  return task.frames_us <= 0 ||
         (is_finished(workshop, task) && fs::exists(folder_of(workshop, task.key) / "perforation.pvd"));
}

std::string described(const ShotRow &row) {
  char text[160];
  std::snprintf(text, sizeof text, "%s: %.1f m/s, %.0f s, energy error %.3f %%", folder_name(row.key).c_str(),
                row.residual_velocity_mps, row.wall_s, 100 * row.energy_error);
  return text;
}

/// A shot on its way. The lock is kept until its row is on the disk.
struct Running {
  Task task;
  ShotLock lock;
};

/// One call of run_shots.
struct Work {
  const Workshop &workshop;
  const std::function<void(const std::string &)> &say;
  HeldSignals signals{};
  std::vector<ShotRow> rows{}; ///< known when last looked
  std::map<pid_t, Running> running{};
  Outcome outcome{};

  ~Work() {
    // Only an error leaves some running.
    for (const auto &[child, shot] : running) ::kill(child, SIGKILL);
    for (const auto &[child, shot] : running) ::waitpid(child, nullptr, 0);
  }
};

bool is_done(const Work &w, const Task &task) {
  return find_row(w.rows, task.key) != nullptr && has_frames(w.workshop, task);
}

/// Takes the row that a finished run left. Throws SetupError if it left none, WriteError if it cannot be kept.
void take_row(Work &w, const Task &task) {
  const ShotRow row = read_summary(task.key, folder_of(w.workshop, task.key));
  if (find_row(w.rows, task.key) == nullptr) {
    append_row(w.workshop.rows, row);
    w.rows.push_back(row);
  }
  w.say(described(row));
}

/// Takes the row of a shot that was run by a process that ended before it could do so; false if there is none.
bool has_row_now(Work &w, const Task &task) {
  if (!is_finished(w.workshop, task) || !has_frames(w.workshop, task)) return false;
  try {
    take_row(w, task);
    return true;
  } catch (const ogive::SetupError &) {
    return false; // its summary tells of a fault, or of another shot
  }
}

void note_failure(Work &w, const Task &task, const std::string &reason) {
  w.outcome.failed.push_back(folder_name(task.key) + ": " + reason + "; see " + log_of(w.workshop, task.key).string());
  w.say("failed: " + w.outcome.failed.back());
}

/// Takes what has ended out of those running.
void collect_ended(Work &w) {
  for (auto shot = w.running.begin(); shot != w.running.end();) {
    const auto status = status_of(shot->first);
    if (!status) {
      ++shot;
      continue;
    }
    const Task &task = shot->second.task;
    if (*status == 0) {
      try {
        take_row(w, task);
        ++w.outcome.run;
      } catch (const std::runtime_error &error) {
        note_failure(w, task, error.what());
      }
    } else if (w.outcome.stopped_by == 0) {
      const std::string reason = reason_in(log_of(w.workshop, task.key));
      note_failure(w, task, ending(*status) + (reason.empty() ? "" : ": " + reason));
    }
    shot = w.running.erase(shot);
  }
}

/// Starts a task, or finds that it needs no run; false if another process has it. Throws WriteError.
bool try_to_begin(Work &w, const Task &task) {
  if (is_done(w, task)) {
    ++w.outcome.known;
    return true;
  }
  ShotLock lock(w.workshop.out / "shots" / (folder_name(task.key) + ".lock"));
  if (lock.is_elsewhere()) return false;
  static bool told = false; // once for all rounds
  if (lock.missing() != 0 && !std::exchange(told, true))
    w.say("no locks in " + w.workshop.out.string() + " (" + std::generic_category().message(lock.missing()) +
          "): a shot must not be run by two processes at a time");
  // What the one before did is known only now.
  w.rows = read_all_rows(w.workshop.out);
  if (is_done(w, task) || has_row_now(w, task)) {
    ++w.outcome.known;
    return true;
  }
  const pid_t child = start(arguments_of(w.workshop, task), log_of(w.workshop, task.key), w.signals);
  if (child < 0)
    note_failure(w, task, "no process can be started");
  else
    w.running.emplace(child, Running{task, std::move(lock)});
  return true;
}

/// The same, where a file that cannot be written is the failure of this shot alone.
bool begin(Work &w, const Task &task) {
  try {
    return try_to_begin(w, task);
  } catch (const ogive::WriteError &error) {
    note_failure(w, task, error.what());
    return true;
  }
}

/// Ends the shots that are running; a signal that insists does not let them take their time.
void stop(Work &w, int signal) {
  w.outcome.stopped_by = signal;
  const auto told_at = std::chrono::steady_clock::now();
  for (const auto &[child, shot] : w.running) {
    ::kill(child, SIGTERM);
    ::kill(child, SIGCONT); // somebody may have paused it
  }
  for (collect_ended(w); !w.running.empty(); collect_ended(w))
    if (w.signals.wait({}) != 0 && std::chrono::steady_clock::now() - told_at > input::one_order)
      for (const auto &[child, shot] : w.running) ::kill(child, SIGKILL);
}

} // namespace

fs::path folder_of(const Workshop &workshop, const ShotKey &key) { return workshop.out / "shots" / folder_name(key); }

Outcome run_shots(const Workshop &workshop, const std::vector<Task> &tasks,
                  const std::function<void(const std::string &)> &say) {
  std::error_code error;
  fs::create_directories(workshop.out / "shots", error);
  if (error) throw ogive::write_error(workshop.out / "shots", error.message());

  Work w{workshop, say};
  w.rows = read_all_rows(workshop.out);
  std::list<Task> waiting(tasks.begin(), tasks.end());
  const auto has_room = [&] { return static_cast<int>(w.running.size()) < workshop.jobs; };
  for (bool told = false;;) {
    for (auto task = waiting.begin(); task != waiting.end() && has_room();)
      task = begin(w, *task) ? waiting.erase(task) : std::next(task);
    if (waiting.empty() && w.running.empty()) return w.outcome;

    const bool all_elsewhere = w.running.empty();
    if (all_elsewhere && !std::exchange(told, true))
      say("waiting for " + std::to_string(waiting.size()) + " shots that other processes run");
    // The end of a shot wakes us only if it is ours.
    const bool poll = !waiting.empty() && has_room();
    if (const int signal = w.signals.wait(poll ? std::optional(poll_s) : std::nullopt)) {
      stop(w, signal);
      return w.outcome;
    }
    collect_ended(w);
  }
}

} // namespace figures
