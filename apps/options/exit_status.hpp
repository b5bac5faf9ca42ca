// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/write_error.hpp"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

namespace options {

/// What all programs end with: done, an error that nobody foresaw, wrong input, a file that cannot be written or
/// another end before all is done.
enum ExitStatus { success = 0, failure = 1, bad_input = 2, not_finished = 3 };

/// Makes a lack of readers or of room for what a program prints an error of its end, not the end of its work: a pipe
/// that is closed sends no signal, and no file that is opened later takes the place of an output that is closed.
void outlive_output();

/// `status`, or where it is success and not all of standard output could be written: not_finished, with the reason as a
/// line on standard error.
int status_of_output(const std::string &program, int status);

/// The status of run(); where it throws, one line on standard error that begins with the name that the program then
/// has.
template <class Run> int run_main(const std::string &program, Run &&run) {
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
  const int status = status_of_run();
  return status_of_output(program, status);
}

} // namespace options
