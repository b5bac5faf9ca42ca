// SPDX-License-Identifier: BSD-3-Clause
#include "exit_status.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <iostream>
#include <system_error>
#include <unistd.h>

namespace options {

void outlive_output() {
  std::signal(SIGPIPE, SIG_IGN);
  // Opened for reading alone: what is printed there counts as not written.
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(standard, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDONLY);
}

int status_of_output(const std::string &program, int status) {
  errno = 0;
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
  if (flushed && std::ferror(stdout) == 0 && std::cout) return status;
  std::fprintf(stderr, "%s: error: standard output could not be written%s\n", program.c_str(), reason.c_str());
  return status == success ? not_finished : status;
}

} // namespace options
