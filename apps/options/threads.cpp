// SPDX-License-Identifier: BSD-3-Clause
#include "threads.hpp"

#include "given.hpp"

#include <algorithm>
#include <latch>
#include <system_error>
#include <thread>
#include <vector>

namespace options {

void require_threads(int count, const std::string &what, const std::string &remedy) {
  std::vector<std::thread> others;
  others.reserve(static_cast<std::size_t>(std::max(0, count - 1)));
  std::latch tried(1);
  std::string reason;
  while (reason.empty() && static_cast<int>(others.size()) + 1 < count) {
    try {
      others.emplace_back([&tried] { tried.wait(); });
    } catch (const std::system_error &error) {
      reason = error.code().message();
    }
  }
  tried.count_down();
  for (std::thread &other : others) other.join();
  if (reason.empty()) return;
  const std::string most = std::to_string(others.size() + 1);
  refuse(what, std::to_string(count),
         "only " + most + " can be started (" + reason + "); give " + (remedy.empty() ? "--threads " + most : remedy) +
             ", or raise the number of processes that the user may have (ulimit -u)");
}

} // namespace options
