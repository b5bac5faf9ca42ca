// SPDX-License-Identifier: BSD-3-Clause
#include "lock.hpp"

namespace study {

StudyLock lock_study(const Study &study) {
  using options::FolderLock;
  const auto locked = [&](const std::string &name, FolderLock::Kind kind, const std::string &part) {
    return std::make_unique<FolderLock>(study.out / name, kind,
                                        "another process works on this study" + part +
                                            "; wait for its end, or give another folder");
  };
  StudyLock lock;
  if (study.shards == 1) {
    lock.push_back(locked(".lock", FolderLock::exclusive, ""));
    return lock;
  }
  lock.push_back(locked(".lock", FolderLock::shared, ", without --shard"));
  const std::string parts = ".lock_of_", own = parts + std::to_string(study.shards), shard = "_shard_";
  const std::string other_number = ", in another number of shards";
  lock.push_back(locked(own, FolderLock::shared, other_number));
  // Shards of another number overlap with this one.
  for (const auto &entry : std::filesystem::directory_iterator(study.out)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(parts) && name != own && name.find(shard) == std::string::npos)
      locked(name, FolderLock::exclusive, other_number);
  }
  lock.push_back(locked(own + shard + std::to_string(study.shard), FolderLock::exclusive, ", on the same shard"));
  return lock;
}

} // namespace study
