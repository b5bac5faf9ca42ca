// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace options {

/// Exit statuses of all programs: done, an error that nobody foresaw, wrong input, a file that cannot be written or
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
int run_main(const std::string &program, const std::function<int()> &run);

} // namespace options
