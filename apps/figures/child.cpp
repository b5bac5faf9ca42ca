// SPDX-License-Identifier: BSD-3-Clause
#include "child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace figures {

HeldSignals::HeldSignals() {
  ::sigemptyset(&held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    ::sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_IGN) ::sigaddset(&held, signal);
  }
  ::sigaddset(&held, SIGCHLD);
  // Where a parent left it ignored, the kernel would throw away how children end.
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(SIGCHLD, &usual, &child_before);
  ::sigprocmask(SIG_BLOCK, &held, &before);
}

HeldSignals::~HeldSignals() {
  ::sigaction(SIGCHLD, &child_before, nullptr);
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
}

int HeldSignals::wait(std::optional<long> seconds) const {
  const timespec time{seconds.value_or(0), 0};
  const int signal = seconds ? ::sigtimedwait(&held, nullptr, &time) : ::sigwaitinfo(&held, nullptr);
  return signal > 0 && signal != SIGCHLD ? signal : 0;
}

pid_t start(std::vector<std::string> arguments, const std::filesystem::path &log, const HeldSignals &signals) {
  std::vector<char *> argv;
  argv.reserve(arguments.size() + 1);
  for (auto &argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t parent = ::getpid();
  // Not posix_spawn, which cannot ask for the signal.
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  ::sigprocmask(SIG_SETMASK, &signals.before, nullptr);
  ::close(STDIN_FILENO);
  ::close(STDOUT_FILENO);
  const bool opened = ::open("/dev/null", O_RDONLY) == STDIN_FILENO &&
                      ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666) == STDOUT_FILENO &&
                      ::dup2(STDOUT_FILENO, STDERR_FILENO) == STDERR_FILENO;
  if (opened) {
    ::execv(argv[0], argv.data());
    ::dprintf(STDERR_FILENO, "%s cannot be started: %s\n", argv[0], std::strerror(errno));
  }
  ::_exit(127);
}

std::optional<int> status_of(pid_t child) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(child, &status, WNOHANG)) < 0 && errno == EINTR) {
  }
  if (ended == 0) return std::nullopt;
  return ended == child ? status : W_EXITCODE(127, 0);
}

std::string ending(int status) {
  if (!WIFSIGNALED(status)) return "exit status " + std::to_string(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  return "killed by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
}

} // namespace figures
