// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace options {

/// What all programs end with: done, an error that nobody foresaw, wrong input, a file that cannot be written or
/// another end before all is done.
enum ExitStatus { success = 0, failure = 1, bad_input = 2, not_finished = 3 };

/// The status of run(); where it throws, one line on standard error that begins with the name that the program then
/// has.
int run_main(const std::string &program, const std::function<int()> &run);

/// Makes OpenMP's threads wait briefly in a busy loop and then sleep: threads that spin longer slow each other down as
/// soon as the machine has other work. GCC's OpenMP reads that from the environment when a program is loaded, so the
/// program is started once more, unless the user has chosen already. To be called first in main().
void limit_spinning(char **argv);

} // namespace options
