// SPDX-License-Identifier: BSD-3-Clause
#include "exit_status.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <new>
#include <poll.h>
#include <system_error>
#include <unistd.h>

namespace options {

void outlive_output() {
  std::signal(SIGPIPE, SIG_IGN);
  // Opened for reading alone: what is printed there counts as not written.
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(standard, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDONLY);
}

namespace {

/// True if standard output is a pipe or a socket without a reader. errno does not show it when an earlier write failed.
bool reader_has_left() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

} // namespace

int status_of_output(const std::string &program, int status) {
  const int ended = status == only_printed ? success : status;
  errno = 0;
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
  if (flushed && std::ferror(stdout) == 0 && std::cout) return ended;
  if (status == only_printed && reader_has_left()) return success;
  std::fprintf(stderr, "%s: error: standard output could not be written%s\n", program.c_str(), reason.c_str());
  return ended == success ? not_finished : ended;
}

int run_main(const std::string &program, const std::function<int()> &run) {
  const auto reported = [&](const char *reason, ExitStatus status) -> int {
    std::fprintf(stderr, "%s: error: %s\n", program.c_str(), reason);
    return status;
  };
  const auto status_of_run = [&]() -> int {
    try {
      return run();
    } catch (const ogive::SetupError &error) {
      return reported(error.what(), bad_input);
    } catch (const ogive::WriteError &error) {
      return reported(error.what(), not_finished);
    } catch (const std::bad_alloc &) {
      return reported("there is not enough memory", failure);
    } catch (const std::exception &error) {
      return reported(error.what(), failure);
    }
  };
  outlive_output();
  return status_of_output(program, status_of_run());
}

} // namespace options
