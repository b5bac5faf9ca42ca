// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <time.h>
#include <unistd.h>

namespace shot {

/// Processor seconds of the threads that parallel loops of this thread use; other runs in the process do not count.
inline double team_cpu_s() {
  double seconds = 0;
#pragma omp parallel reduction(+ : seconds)
  {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    seconds += static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  return seconds;
}

/// Progress of a run on standard error: a bar on a terminal, a line now and then otherwise.
struct Progress {
  bool quiet = false;
  double before_s = 0;     ///< wall time of the run before this part of it
  double cpu_before_s = 0; ///< processor time of the run before this part of it
  bool terminal = isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double cpu_start = team_cpu_s(); ///< of this run's threads, which may have run other shots before
  double last_shown_s = -1e9;
};

/// Seconds of all parts of the run.
inline double elapsed_s(const Progress &p) {
  return p.before_s + std::chrono::duration<double>(std::chrono::steady_clock::now() - p.start).count();
}

/// Processor seconds of all threads in all parts of the run.
inline double cpu_s(const Progress &p) { return p.cpu_before_s + team_cpu_s() - p.cpu_start; }

/// "2 min 05 s"
inline std::string readable_duration(double seconds) {
  char text[48];
  seconds = std::round(std::max(seconds, 0.0));
  if (seconds < 60)
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  else
    std::snprintf(text, sizeof text, "%.0f min %02.0f s", std::floor(seconds / 60), std::fmod(seconds, 60));
  return text;
}

/// Shows where the run is: time of `end_us`, velocity, steps per second, and the time left if it runs to the end.
inline void show(Progress &p, double time_us, double end_us, double velocity_mps, long steps, bool last = false) {
  if (p.quiet) return;
  const double now = elapsed_s(p);
  if (!last && now - p.last_shown_s < (p.terminal ? 0.2 : 5.0)) return;
  p.last_shown_s = now;
  const double done = end_us > 0 ? time_us / end_us : 1.0;
  const std::string left = done > 0 ? readable_duration(now / done - now) : "?";
  const char *const end = p.terminal ? (last ? "\n" : "") : "\n";
  if (p.terminal) {
    std::string bar(30, '.');
    std::fill_n(bar.begin(), std::min(30, static_cast<int>(30 * done)), '#');
    std::fprintf(stderr, "\r\033[K[%s] ", bar.c_str());
  }
  std::fprintf(stderr, "%6.1f us of %.0f   projectile %7.1f m/s   %5.0f steps/s   at most %s left%s", time_us, end_us,
               velocity_mps, now > 0 ? static_cast<double>(steps) / now : 0.0, left.c_str(), end);
  std::fflush(stderr);
}

} // namespace shot
