// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace options {

/// Exit statuses of all programs: done, an unexpected error, wrong input, a file that cannot be written or another end
/// before all is done. `only_printed` is success of a command that only prints; the program ends with success.
enum ExitStatus { only_printed = -1, success = 0, failure = 1, bad_input = 2, not_finished = 3 };

/// Lets a program run to its end where standard output has no reader, no room or is closed: a closed pipe sends no
/// signal, and no file that is opened later gets the number of a closed output.
void outlive_output();

/// The exit status of a program whose work ended with `status`. It is not_finished if that is success and standard
/// output could not be written completely; the reason is then a line on standard error. After `only_printed` a pipe
/// whose reader has left counts as success, as `head` needs no more than the first lines.
int status_of_output(const std::string &program, int status);

/// Runs a program and returns its exit status. Where run() throws, the error is one line on standard error that begins
/// with the name that the program then has.
int run_main(const std::string &program, const std::function<int()> &run);

} // namespace options
