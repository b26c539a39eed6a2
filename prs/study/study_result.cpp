#include "prs/study/study_result.h"

#include <algorithm>
#include <cmath>

namespace prs {
namespace {

std::vector<std::optional<double>> numbers(const RowBlock& block, std::size_t row,
                                           std::size_t responses) {
  std::vector<std::optional<double>> numbers(responses);
  for (std::size_t j = 0; j < responses; ++j) {
    const double value = block.responses[row * responses + j];
    if (!std::isnan(value)) numbers[j] = value;
  }
  return numbers;
}

}  // namespace

void add(StudyResult& result, const RowBlock& block) {
  if (result.rows.empty())
    result.rows.reserve(std::min(kMostRowsShown, design_count(result.study)));
  auto failure = block.failures.begin();
  for (std::size_t k = 0; k < block.rows; ++k) {
    const bool failed = failure != block.failures.end() && failure->row == k;
    const DesignStatus status = failed ? (failure++)->status : DesignStatus{};
    if (failed) ++(status.name == "refused" ? result.refused : result.failed);
    if (result.rows.size() >= kMostRowsShown) continue;
    result.rows.push_back({design(result.study, block.first + k), status,
                           numbers(block, k, result.study.responses.size())});
  }
  result.designs += block.rows;
}

}  // namespace prs
