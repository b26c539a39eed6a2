#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "prs/study/schedule.h"
#include "prs/study/stored_rows.h"
#include "prs/study/study_folder.h"

namespace prs {

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
