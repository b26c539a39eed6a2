#include "prs/optimize/parallel_evaluation.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "prs/study/schedule.h"

namespace prs {
namespace {

/// Designs that a thread takes at once: as many as the other threads do, at most what the engine
/// takes.
std::size_t piece_of(const DesignEngine& engine, std::size_t designs, std::size_t threads) {
  return std::clamp<std::size_t>((designs + threads - 1) / threads, 1, engine.chunk());
}

void append(RowBlock& all, RowBlock block) {
  for (RowBlock::Failure& failure : block.failures) {
    failure.row += all.rows;
    all.failures.push_back(std::move(failure));
  }
  all.responses.insert(all.responses.end(), block.responses.begin(), block.responses.end());
  all.rows += block.rows;
}

}  // namespace

EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads) {
  return [&engine, threads](const std::vector<std::vector<Draw>>& designs) {
    const std::size_t piece = piece_of(engine, designs.size(), threads);
    if (threads == 1 || designs.size() <= piece) return engine.evaluate(designs);
    RowBlock all;
    run_in_order((designs.size() + piece - 1) / piece, threads,
                 [&](std::size_t k) -> std::function<void()> {
                   const auto from = designs.begin() + static_cast<std::ptrdiff_t>(k * piece);
                   const std::size_t count = std::min(piece, designs.size() - k * piece);
                   auto block = std::make_shared<RowBlock>(
                       engine.evaluate({from, from + static_cast<std::ptrdiff_t>(count)}));
                   return [&all, block] { append(all, std::move(*block)); };
                 });
    return all;
  };
}

}  // namespace prs
