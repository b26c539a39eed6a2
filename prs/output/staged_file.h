#pragma once

#include <signal.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

#include "prs/file_descriptor.h"

namespace prs {

/// Holds back signals of a thread, from making a file to having it in the list below.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// A file or folder that must not outlive the program, while the object lives: also where a signal
/// ends it (`remove_unfinished`). Its owner removes it otherwise.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  explicit UnfinishedPath(const std::filesystem::path& path);
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;
  ~UnfinishedPath();

 private:
  std::unique_ptr<std::string> path_;  ///< Stays where it is.
};

/// Removes these paths, for a handler of signals that ends the program.
/// Threads that make or forget one from then on wait for the end.
void remove_unfinished() noexcept;

/// A file under a temporary name in the folder of its target; gone again unless it is published,
/// also where a signal ends the program, so that no reader meets half a file and a full disk leaves
/// the earlier one as it was. A link, pipe, socket or device is not replaced: std::runtime_error.
/// Any other failure throws std::system_error that names the target.
class StagedFile {
 public:
  explicit StagedFile(std::filesystem::path target);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Path at which it stands until it is published.
  const std::filesystem::path& temporary() const { return temporary_; }

  void append(std::string_view content);

  /// Reserves space for `bytes` bytes, for writers that do not survive a full disk. `sync` gives
  /// back what was not needed.
  void reserve(std::uint64_t bytes);

  /// Closes the file. Reports write errors that the system held back.
  void close();

  /// Brings the content to the disk, also what others wrote under the temporary name.
  void sync();

  /// Closes the file and gives it its name.
  void publish();

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< Empty once there is nothing to remove.
  UnfinishedPath unfinished_;
  FileDescriptor file_;
};

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
