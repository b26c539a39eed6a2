#pragma once

#include <signal.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

#include "prs/file_descriptor.h"

namespace prs {

/// Blocks signals of a thread, from making a file to having it in the list below.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// A file or folder that must not outlive the program, while the object lives: it is removed also if a signal ends the
/// program (`remove_unfinished`). Otherwise its owner removes it.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  explicit UnfinishedPath(const std::filesystem::path& path);
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;
  ~UnfinishedPath();

 private:
  std::unique_ptr<std::string> path_;  ///< Fixed in memory.
};

/// Removes these paths, for a signal handler that ends the program. Threads that add or remove one from then on wait
/// for the end.
void remove_unfinished() noexcept;

/// A file under a temporary name in the folder of its target; removed unless it is published, even if a signal ends the
/// program, so that no reader sees an incomplete file and a full disk leaves the earlier one unchanged. A link, pipe,
/// socket or device is not replaced: std::runtime_error. Any other failure throws std::system_error that names the
/// target.
class StagedFile {
 public:
  explicit StagedFile(std::filesystem::path target);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Path of the file until it is published.
  const std::filesystem::path& temporary() const { return temporary_; }

  void append(std::string_view content);

  /// Closes the file. Reports delayed write errors of the system.
  void close();

  /// Writes the content to the disk.
  void sync();

  /// Closes the file and renames it to its target.
  void publish();

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< Empty if there is nothing to remove.
  UnfinishedPath unfinished_;
  FileDescriptor file_;
};

/// Error: a journal, or the folder of a study, does not fit the command. The message says how to fix it.
class StudyFolderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Opens a file that a study keeps in its folder, like ::open. Throws StudyFolderError if it is a symbolic link, a pipe
/// or a folder, and std::system_error.
FileDescriptor open_study_file(const std::filesystem::path& path, int flags);

/// Number of attempts of `lock_file` at a lock that another process holds.
inline constexpr int kMostLockTries = 50;

/// Waits a fiftieth of a second.
void wait_for_lock();

/// Locks an open file as flock(2) does; `operation` is LOCK_SH or LOCK_EX. Returns false if another process holds the
/// lock: it is retried for about a second, since killed processes do not end at once. Throws std::runtime_error that
/// names the path if the file cannot be locked at all. `wait` runs between two tries.
bool lock_file(const FileDescriptor& file, int operation, const std::filesystem::path& path,
               const std::function<void()>& wait = wait_for_lock);

/// Name of the file in an output folder whose lock keeps other runs out.
inline constexpr std::string_view kFolderLock = "study.lock";

/// Lock of an output folder, on an open file: it ends with its process, in any way.
class FolderLock {
 public:
  /// Description, in the file, of the run that holds the lock.
  struct Run {
    std::string command;           ///< `prs slip`
    std::string case_digest = {};  ///< Runs of different cases do not wait for each other.
  };

  /// Creates the folder if missing, and waits up to a second for another holder of the lock. Alone in it (LOCK_EX),
  /// removes temporary files of processes that died; LOCK_SH is for runs that share the folder. Throws StudyFolderError
  /// that names the holder, and std::system_error.
  FolderLock(const std::filesystem::path& folder, int kind, const Run& run);
  FolderLock(FolderLock&&) = default;
  ~FolderLock();  ///< The last holder removes the file.

 private:
  std::filesystem::path path_;
  FileDescriptor file_;
  UnfinishedPath unfinished_;  ///< The file, if no other run may share it.
};

}  // namespace prs
