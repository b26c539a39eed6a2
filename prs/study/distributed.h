#pragma once

#include "prs/components/communicator.h"
#include "prs/study/study_run.h"

namespace prs {

/// The processes that an MPI launcher (`mpirun`, `srun`) started together. Without a launcher, and
/// where MPI knows of one process only, the first rank is alone; without a launcher MPI is not even
/// loaded.
///
/// The first rank gives designs away and takes all rows, so that neither results nor files depend
/// on the number of ranks and only it needs the disk; it evaluates designs too. The others ask for
/// more whenever they deliver. A rank that dies ends the job, as launchers do.
class Ranks {
 public:
  /// `join` false: alone in any case. Throws modules::Missing where a launcher started several
  /// processes and this build has no MPI.
  explicit Ranks(bool join);
  /// The first rank ends the work of the others; all ranks wait for each other.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int size() const { return size_; }
  bool is_first() const { return rank_ == 0; }

  /// Threads that each rank should run: the processors that the ranks of this machine may use, in
  /// equal parts.
  std::size_t threads() const;

  /// Whether all ranks say the same. Every rank must call it.
  bool agree(const std::string& text) const;

  /// What `make` gives on the first rank, on all ranks. Every rank must call it. Where `make`
  /// throws, the others get nothing.
  std::optional<std::string> share(const std::function<std::string()>& make) const;

  /// First rank: `run` here, while the other ranks do their part of it.
  void lead(const NextRange& next, const TakeRecord& take, std::size_t chunk,
            const RunDesigns& run);

  /// Other ranks: evaluates designs that the first rank gives, on `threads` threads, until it ends
  /// the work. A rank that does not call it takes no part.
  void assist(const Evaluate& evaluate, std::size_t threads);

 private:
  /// Answers the other ranks with designs of `next` until none of them computes any more.
  void serve(const NextRange& next, const TakeRecord& take, std::size_t chunk);

  std::unique_ptr<Communicator> communicator_;  ///< Without a launcher: none.
  int rank_ = 0;
  int size_ = 1;
  bool served_ = false;  ///< First rank: the others are done; others: they have been heard of.
};

}  // namespace prs
