// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <csignal>
#include <string>

namespace shot {

/// While it exists, SIGINT (Ctrl-C), SIGTERM and SIGHUP are noted and nothing more, unless they were ignored before.
/// One that comes more than a second after the first ends the program at once.
class SignalCatcher {
public:
  SignalCatcher();
  ~SignalCatcher();
  SignalCatcher(const SignalCatcher &) = delete;
  SignalCatcher &operator=(const SignalCatcher &) = delete;

private:
  std::array<struct sigaction, 3> before{};
};

/// The first signal that was caught; 0 if none was.
int caught_signal();

/// "SIGINT"
std::string signal_name(int signal);

} // namespace shot
