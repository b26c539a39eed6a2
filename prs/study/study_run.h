#pragma once

#include "prs/components/components.h"
#include "prs/study/journal.h"

namespace prs {

/// Evaluates designs [first, first + count), or the first of them if that takes long; none after the run is
/// interrupted. A pure function, called from many threads at once.
using Evaluate = std::function<RowBlock(std::size_t first, std::size_t count)>;

/// The next designs to evaluate, about `most` of them; none after all are given away. From any thread.
using NextRange = std::function<std::optional<DesignRange>(std::size_t most)>;

/// Receives an encoded block, in any order, from any thread.
using TakeRecord = std::function<void(const std::string& record)>;

/// Number of processors that this process may use.
std::size_t available_processors();

/// Default number of threads of a run: one per processor, or one if TBB is missing.
std::size_t default_threads();

/// Evaluates `chunk` designs at a time on `threads` threads until none is left, and encodes them, in as many blocks as
/// `evaluate` makes of them. The number of blocks in progress is limited, so that a slow `take` slows the rest down. An
/// exception in one of the functions ends the run and is rethrown.
void run_schedule(std::size_t threads, std::size_t chunk, const NextRange& next, const Evaluate& evaluate,
                  const TakeRecord& take);

/// Calls `prepare(k)` for k = 0 .. count-1 on `threads` threads, and the functions that it returns one at a time in the
/// order of k.
void run_in_order(std::size_t count, std::size_t threads,
                  const std::function<std::function<void()>(std::size_t k)>& prepare);

/// Rows in the journals of one study: each design once, in the order of designs.
class StoredRows {
 public:
  /// Journals of one key; a design in several of them is taken from one.
  explicit StoredRows(std::vector<Journal> journals);

  const std::vector<Journal>& journals() const { return journals_; }
  std::vector<Journal> take_journals() && { return std::move(journals_); }

  /// Designs of the range that no journal holds.
  std::vector<DesignRange> missing(DesignRange all) const;

  std::size_t block_count() const { return pieces_.size(); }

  /// Block k; its designs follow those of the previous block. From any thread.
  RowBlock block(std::size_t k) const;

 private:
  /// Part taken from a record.
  struct Piece {
    std::size_t journal = 0;
    std::size_t record = 0;
    DesignRange designs;
  };

  std::vector<Journal> journals_;
  std::vector<Piece> pieces_;
};

/// Path such as `study.3-of-8.journal`; for a study in one piece `study.1-of-1.journal`.
std::filesystem::path journal_path(const std::filesystem::path& folder, Shard shard);

/// The journals in a folder, sorted by name.
std::vector<std::filesystem::path> journal_paths(const std::filesystem::path& folder);

/// The folder that a study writes into, locked against other studies as long as the object lives.
class StudyFolder {
 public:
  enum class Use {
    alone,         ///< No other process may use the folder.
    among_shards,  ///< Processes of other shards may.
  };

  /// Locks the folder, see `FolderLock`; `command`: name shown to other runs that use the folder.
  StudyFolder(std::filesystem::path path, Use use, const std::string& command = "prs study");

  const std::filesystem::path& path() const { return path_; }
  Use use() const { return use_; }

  /// Removes the journals. Call it after the files of the study are on the disk.
  void remove_journals() const;

 private:
  std::filesystem::path path_;
  Use use_;
  FolderLock lock_;
};

/// Evaluates designs until `next` has none left, as `run_schedule` does.
using RunDesigns = std::function<void(const NextRange& next, const TakeRecord& take)>;

/// Progress of a run. `found` designs had been computed before it began.
struct StudyProgress {
  std::size_t done = 0;
  std::size_t found = 0;
  std::size_t total = 0;
};

struct StudyRunOptions {
  bool restart = false;                    ///< Whether to discard earlier results.
  std::function<bool()> interrupted = {};  ///< Called before designs are given away.
  /// Called first, and after each block; from any thread.
  std::function<void(StudyProgress)> progress = {};
  std::function<void(const std::string&)> warn = {};  ///< Called with warnings about the folder.
};

/// Computes the designs of `header.shard` that no journal in the folder holds, into the journal of that shard; without
/// a folder, into a temporary file. Returns all rows computed so far; some are missing if the run was interrupted. The
/// journals stay. Throws StudyFolderError, std::system_error, and the exceptions of `run`.
StoredRows run_study(const JournalHeader& header, const StudyFolder* folder, const RunDesigns& run,
                     const StudyRunOptions& options);

/// Rows in the journals of the folders. Throws StudyFolderError if there are none, if they are of different studies,
/// and if designs are missing, which it then names.
StoredRows gather_rows(const std::vector<std::filesystem::path>& folders);

}  // namespace prs
