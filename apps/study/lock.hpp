// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study.hpp"

#include <vector>

namespace study {

/// One process at a time works on a study, or one on each of its shards, which are then of one number. The lock goes
/// with the process, however that ends.
class StudyLock {
public:
  /// Throws SetupError if another process has the study or this shard of it, WriteError if there can be no such file.
  explicit StudyLock(const Study &study);
  ~StudyLock();
  StudyLock(const StudyLock &) = delete;
  StudyLock &operator=(const StudyLock &) = delete;

private:
  void release();

  std::vector<int> descriptors;
};

} // namespace study
