// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study.hpp"

#include "options/folder_lock.hpp"

#include <optional>

namespace study {

/// One process at a time works on a study, or one on each of its shards.
struct StudyLock {
  options::FolderLock study;
  std::optional<options::FolderLock> shard;

  /// Throws SetupError if another process has the study or this shard of it.
  explicit StudyLock(const Study &s)
      : study(s.out / ".lock", s.shards > 1 ? options::FolderLock::shared : options::FolderLock::exclusive,
              "another process works on this study; wait for its end, or give another folder") {
    if (s.shards > 1)
      shard.emplace(s.out / (".lock." + std::to_string(s.shard) + "-of-" + std::to_string(s.shards)),
                    options::FolderLock::exclusive,
                    "another process works on this shard; wait for its end, or give another --shard");
  }
};

} // namespace study
