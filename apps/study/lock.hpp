// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study.hpp"

#include "options/folder_lock.hpp"

#include <memory>
#include <vector>

namespace study {

/// What keeps other processes from a study as long as it exists.
using StudyLock = std::vector<std::unique_ptr<options::FolderLock>>;

/// Locks a study, or the study's shard: processes may work on different shards if the number of shards is the same.
/// Throws SetupError if another process is at work, WriteError if there can be no such files.
[[nodiscard]] StudyLock lock_study(const Study &study);

} // namespace study
