// SPDX-License-Identifier: BSD-3-Clause
#include "exit_status.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/write_error.hpp"

#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace options {

int run_main(const std::string &program, const std::function<int()> &run) {
  const auto reported = [&](const std::exception &error, ExitStatus status) {
    std::fprintf(stderr, "%s: error: %s\n", program.c_str(), error.what());
    return status;
  };
  try {
    return run();
  } catch (const ogive::SetupError &error) {
    return reported(error, bad_input);
  } catch (const ogive::WriteError &error) {
    return reported(error, not_finished);
  } catch (const std::exception &error) {
    return reported(error, failure);
  }
}

void limit_spinning(char **argv) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  ::setenv("GOMP_SPINCOUNT", "3000", 1);
  ::execv("/proc/self/exe", argv); // returns only where that fails; the program is then merely slower
}

} // namespace options
