#pragma once

#include <signal.h>

#include <cstdint>
#include <filesystem>
#include <memory>

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
/// the earlier one as it was. What cannot be written throws std::system_error that names the
/// target.
class StagedFile {
 public:
  explicit StagedFile(std::filesystem::path target);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Where it stands until it is published.
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

}  // namespace prs
