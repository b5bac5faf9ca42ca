// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace options {

/// Makes OpenMP's threads wait briefly in a busy loop and then sleep: threads that spin longer slow each other down as
/// soon as the machine has other work. GCC's OpenMP reads that from the environment when a program is loaded, so the
/// program is started once more, unless the user has chosen already. To be called first in main().
void limit_spinning(char **argv);

} // namespace options
