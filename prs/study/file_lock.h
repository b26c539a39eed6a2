#pragma once

#include <filesystem>
#include <functional>

#include "prs/file_descriptor.h"

namespace prs {

/// How often `lock_file` asks for a lock that another process holds.
inline constexpr int kMostLockTries = 50;

/// Waits a fiftieth of a second.
void wait_for_lock();

/// Locks an open file as flock(2) does; `operation` is LOCK_SH or LOCK_EX. False where another
/// process holds the lock: it is asked for again for about a second, since processes that were
/// killed are not gone at once. Throws std::runtime_error that names the path where the file
/// cannot be locked at all. `wait` runs between two tries.
bool lock_file(const FileDescriptor& file, int operation, const std::filesystem::path& path,
               const std::function<void()>& wait = wait_for_lock);

}  // namespace prs
