#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "prs/study/journal.h"

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

}  // namespace prs
