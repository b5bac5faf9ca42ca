// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/write_error.hpp"

#include <cstdio>
#include <exception>
#include <string>

namespace options {

/// What all programs end with: done, an error that nobody foresaw, wrong input, a file that cannot be written or
/// another end before all is done.
enum ExitStatus { success = 0, failure = 1, bad_input = 2, not_finished = 3 };

/// The status of run(); where it throws, one line on standard error that begins with the name that the program then
/// has.
template <class Run> int run_main(const std::string &program, Run &&run) {
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

} // namespace options
