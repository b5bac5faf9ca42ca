// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace options {

/// Throws SetupError "<what> = <count>: ..." unless `count` threads can be at work at once, the calling one among them.
/// To be called before anything is written: OpenMP ends the process where it cannot start a thread. `remedy` is what to
/// give instead; empty: as many --threads as could be started.
void require_threads(int count, const std::string &what = "--threads", const std::string &remedy = "");

} // namespace options
