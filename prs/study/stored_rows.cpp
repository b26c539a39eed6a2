#include "prs/study/stored_rows.h"

#include <algorithm>

namespace prs {
namespace {

/// The rows of a block that answer `designs`, which it holds.
RowBlock cropped(const RowBlock& block, DesignRange designs) {
  const std::size_t skipped = designs.first - block.first;
  const std::size_t width = block.responses.size() / block.rows;
  const auto first = block.responses.begin() + static_cast<std::ptrdiff_t>(skipped * width);
  RowBlock rows{designs.first,
                designs.count,
                {first, first + static_cast<std::ptrdiff_t>(designs.count * width)},
                {}};
  for (const RowBlock::Failure& failure : block.failures)
    if (failure.row >= skipped && failure.row < skipped + designs.count)
      rows.failures.push_back({failure.row - skipped, failure.status});
  return rows;
}

}  // namespace

StoredRows::StoredRows(std::vector<Journal> journals) : journals_(std::move(journals)) {
  std::vector<Piece> records;
  for (std::size_t j = 0; j < journals_.size(); ++j)
    for (std::size_t r = 0; r < journals_[j].records().size(); ++r)
      records.push_back({j, r, journals_[j].records()[r].designs});
  std::ranges::sort(records, {}, [](const Piece& piece) { return piece.designs.first; });
  std::size_t next = 0;
  for (Piece& piece : records) {
    const std::size_t first = std::max(next, piece.designs.first);
    if (piece.designs.end() <= first) continue;
    piece.designs = {first, piece.designs.end() - first};
    next = piece.designs.end();
    pieces_.push_back(piece);
  }
}

std::vector<DesignRange> StoredRows::missing(DesignRange all) const {
  std::vector<DesignRange> held;
  held.reserve(pieces_.size());
  for (const Piece& piece : pieces_) held.push_back(piece.designs);
  return prs::missing(all, std::move(held));
}

RowBlock StoredRows::block(std::size_t k) const {
  const Piece& piece = pieces_[k];
  const Journal& journal = journals_[piece.journal];
  const Journal::Record& record = journal.records()[piece.record];
  RowBlock block = journal.block(record);
  return piece.designs == record.designs ? block : cropped(block, piece.designs);
}

}  // namespace prs
