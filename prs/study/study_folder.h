#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "prs/output/file_lock.h"
#include "prs/study/journal.h"

namespace prs {

/// `study.3-of-8.journal`; that of a study in one piece is `study.1-of-1.journal`.
std::filesystem::path journal_path(const std::filesystem::path& folder, Shard shard);

/// The journals in a folder, sorted by name.
std::vector<std::filesystem::path> journal_paths(const std::filesystem::path& folder);

/// The folder that a study writes into, kept from other studies as long as the object lives.
class StudyFolder {
 public:
  enum class Use {
    alone,         ///< No other process may use the folder.
    among_shards,  ///< Processes of other shards may.
  };

  /// See `FolderLock`; `command` is what other runs are told that uses the folder.
  StudyFolder(std::filesystem::path path, Use use, const std::string& command = "prs study");

  const std::filesystem::path& path() const { return path_; }
  Use use() const { return use_; }

  /// Removes the journals. Call it once the files of the study are on the disk.
  void remove_journals() const;

 private:
  std::filesystem::path path_;
  Use use_;
  FolderLock lock_;
};

}  // namespace prs
