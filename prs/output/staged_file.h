#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "prs/file_descriptor.h"
#include "prs/output/unfinished.h"

namespace prs {

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
