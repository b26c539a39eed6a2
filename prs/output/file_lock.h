#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>

#include "prs/file_descriptor.h"

namespace prs {

/// A journal, or the folder of a study, does not fit the command. The message says how to fix it.
class StudyFolderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Opens a file that a study keeps in its folder, as ::open does. Throws StudyFolderError where a
/// symbolic link, a pipe or a folder stands in its place, and std::system_error.
FileDescriptor open_study_file(const std::filesystem::path& path, int flags);

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

/// The file in an output folder whose lock keeps other runs out.
inline constexpr std::string_view kFolderLock = "study.lock";

/// The lock of an output folder, on an open file: it ends with its process, however that ends.
class FolderLock {
 public:
  /// What the file says of the run that holds the lock.
  struct Run {
    std::string command;           ///< `prs slip`
    std::string case_digest = {};  ///< Runs of different cases do not wait for each other.
  };

  /// Creates the folder where it is missing, and waits a second for who has the lock. Alone in it
  /// (LOCK_EX), removes what processes that died left under temporary names; LOCK_SH is for runs
  /// that share the folder. Throws StudyFolderError that says who has it, and std::system_error.
  FolderLock(const std::filesystem::path& folder, int kind, const Run& run);
  FolderLock(FolderLock&&) = default;
  ~FolderLock();  ///< The last one removes the file.

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  FileDescriptor file_;
};

}  // namespace prs
