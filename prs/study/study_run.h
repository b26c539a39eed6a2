#pragma once

#include "prs/study/journal.h"
#include "prs/study/schedule.h"

namespace prs {

/// The rows that journals of one study hold: each design once, in the order of designs.
class StoredRows {
 public:
  /// Journals of one key; what several of them hold is taken from one.
  explicit StoredRows(std::vector<Journal> journals);

  const std::vector<Journal>& journals() const { return journals_; }
  std::vector<Journal> take_journals() && { return std::move(journals_); }

  /// Designs of the range that no journal holds.
  std::vector<DesignRange> missing(DesignRange all) const;

  std::size_t block_count() const { return pieces_.size(); }

  /// Block k; its designs follow those of the block before. From any thread.
  RowBlock block(std::size_t k) const;

 private:
  /// What is taken of a record.
  struct Piece {
    std::size_t journal = 0;
    std::size_t record = 0;
    DesignRange designs;
  };

  std::vector<Journal> journals_;
  std::vector<Piece> pieces_;
};

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

/// Evaluates designs until `next` has none left: `run_schedule` here, or on several ranks.
using RunDesigns = std::function<void(const NextRange& next, const TakeRecord& take)>;

/// How far a run is. `found` designs had been computed before it began.
struct StudyProgress {
  std::size_t done = 0;
  std::size_t found = 0;
  std::size_t total = 0;
};

struct StudyRunOptions {
  bool restart = false;                    ///< Discards what was computed before.
  std::function<bool()> interrupted = {};  ///< Asked before designs are given away.
  /// Told first, and after each block; from any thread.
  std::function<void(StudyProgress)> progress = {};
  std::function<void(const std::string&)> warn = {};  ///< Told what is odd about the folder.
};

/// Computes the designs of `header.shard` that no journal in the folder holds, into the journal of
/// that shard; without a folder, into a temporary file. Returns all rows computed so far; some are
/// missing where the run was interrupted. The journals stay. Throws
/// StudyFolderError, std::system_error, and what `run` throws.
StoredRows run_study(const JournalHeader& header, const StudyFolder* folder, const RunDesigns& run,
                     const StudyRunOptions& options);

/// The rows that the journals in the folders hold. Throws StudyFolderError where there is none,
/// where they are of different studies, and where designs are missing, which it then names.
StoredRows gather_rows(const std::vector<std::filesystem::path>& folders);

}  // namespace prs
