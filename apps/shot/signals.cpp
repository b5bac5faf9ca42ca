// SPDX-License-Identifier: BSD-3-Clause
#include "signals.hpp"

#include <atomic>
#include <chrono>

namespace shot {

namespace {

/// Signals that come within this time of the first are the same order, sent to the whole group of processes and by a
/// parent, as `timeout` and batch systems do; one that comes later insists.
constexpr std::chrono::milliseconds one_order{1000};

constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};

// A handler can reach nothing else.
volatile std::sig_atomic_t caught = 0;
std::atomic<std::chrono::steady_clock::rep> caught_at = 0;
static_assert(decltype(caught_at)::is_always_lock_free);

extern "C" void note_signal(int signal) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  if (caught == 0) {
    caught_at = now.count();
    caught = signal;
  } else if (now - std::chrono::steady_clock::duration(caught_at) > one_order) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

} // namespace

SignalCatcher::SignalCatcher() {
  caught = 0;
  struct sigaction noting {};
  noting.sa_handler = note_signal;
  // A write that is under way is completed.
  noting.sa_flags = SA_RESTART;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    ::sigaction(signals[k], nullptr, &before[k]);
    // Programs in the background of a script and those that nohup starts must not stop.
    if (before[k].sa_handler != SIG_IGN) ::sigaction(signals[k], &noting, nullptr);
  }
}

SignalCatcher::~SignalCatcher() {
  for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &before[k], nullptr);
}

int caught_signal() { return caught; }

std::string signal_name(int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : signal == SIGHUP ? "SIGHUP" : "a signal";
}

} // namespace shot
