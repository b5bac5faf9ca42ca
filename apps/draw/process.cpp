// SPDX-License-Identifier: BSD-3-Clause
#include "process.hpp"

#include "ogive/io/write_error.hpp"
#include "options/text.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace draw {

namespace {

/// The exit status of a child, which is killed after `seconds`.
int await(pid_t child, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  int status = 0;
  bool killed = false;
  for (pid_t found = 0; (found = ::waitpid(child, &status, WNOHANG)) != child;) {
    if (found < 0 && errno != EINTR) return not_started;
    if (!killed && Clock::now() > end) killed = ::kill(child, SIGKILL) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return killed ? out_of_time : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs in the child: draws, and writes the error into the pipe `answers` if drawing fails.
[[noreturn]] void draw_and_exit(int answers, const std::function<void()> &draw) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  int status = 0;
  try {
    draw();
  } catch (const std::exception &error) {
    status = 1;
    // Shorter than what a pipe holds, so that it is written even if nobody reads yet.
    const std::string text = std::string(error.what()).substr(0, 4000);
    if (::write(answers, text.data(), text.size()) < 0) status = 2;
  }
  // Not exit(): output of the parent that is still in memory is the parent's.
  ::_exit(status);
}

} // namespace

int run_program(std::string program, std::vector<std::string> arguments, double seconds) {
  std::vector<char *> argv{program.data()};
  for (auto &argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return not_started;
  return await(child, seconds);
}

void draw_apart(const std::filesystem::path &picture, double seconds, const std::function<void()> &draw) {
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0) return draw();
  const pid_t child = ::fork();
  if (child == 0) draw_and_exit(pipe[1], draw);
  ::close(pipe[1]);
  if (child < 0) {
    ::close(pipe[0]);
    return draw();
  }
  const int status = await(child, seconds);
  std::string text(4000, '\0');
  const auto size = ::read(pipe[0], text.data(), text.size());
  ::close(pipe[0]);
  if (status == 0) return;
  if (size > 0) throw ogive::WriteError(text.substr(0, static_cast<std::size_t>(size)));
  throw ogive::write_error(picture, failure_of("drawing", "libgl1-mesa-dri", status, seconds));
}

std::string failure_of(const std::string &program, const std::string &package, int status, double seconds) {
  if (status == not_started) return program + " is not installed or not in PATH (Debian: " + package + ")";
  if (status == out_of_time) return options::printed("%s takes more than %g s", program.c_str(), seconds);
  return program + " fails with exit status " + std::to_string(status);
}

} // namespace draw
