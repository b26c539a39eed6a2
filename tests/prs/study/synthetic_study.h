#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "prs/model/study.h"
#include "prs/study/designs.h"
#include "prs/study/journal.h"
#include "prs/study/study_run.h"

namespace test {

inline constexpr std::size_t kResponses = 3;

/// A Monte Carlo study whose factors are numbers, and one of them words.
inline prs::Study synthetic_study(std::size_t designs) {
  prs::Study study;
  study.plan = prs::Plan::monte_carlo;
  study.samples = designs - 1;
  study.seed = 7;
  prs::Factor diameter{"mechanism.pitch_diameter.screw", "screw, \"d\"", "mm", {}, {}};
  diameter.base = prs::Level{"30 mm", 30.0};
  diameter.distribution = {prs::Distribution::Kind::uniform, 29.0, 31.0};
  prs::Factor profile{"mechanism.profile.nut", "profile", "", {}, {}};
  profile.levels = {{"straight", {}}, {"{convex: 6 mm}", {}}};
  profile.base = prs::Level{"{concave: 7 mm}", {}};
  study.factors = {diameter, profile};
  study.responses = {"axial_stiffness_N_per_um", "slip.efficiency", "screw.load_rate_percent.max"};
  return study;
}

/// Numbers of all sizes that depend on the design only; some designs have none.
inline prs::RowBlock synthetic_rows(std::size_t first, std::size_t count) {
  prs::RowBlock block{first, count, {}, {}};
  for (std::size_t row = 0; row < count; ++row) {
    const std::size_t k = first + row;
    const double x = std::fmod(0.6180339887498949 * static_cast<double>(k), 1.0);
    const bool fails = k % 97 == 13;
    const double none = prs::kNoResponse;
    for (std::size_t j = 0; j < kResponses; ++j)
      block.responses.push_back(fails ? none : std::exp(30.0 * (x - 0.5)) * static_cast<double>(j));
    if (fails)
      block.failures.push_back({row, {k % 2 == 0 ? "refused" : "failed", "design " + std::to_string(k) + ", \"no\""}});
  }
  return block;
}

inline prs::JournalHeader synthetic_header(std::size_t designs, prs::Shard shard = {}) {
  const prs::input::Source source{"case.yaml", "study: {}\n", {"mechanism.rollers=9"}};
  return {prs::study_key("1", source), source, synthetic_study(designs).responses, designs, shard};
}

/// Whether two blocks are equal bit by bit.
inline bool same_rows(const prs::RowBlock& a, const prs::RowBlock& b) { return prs::encode(a) == prs::encode(b); }

/// Text of the StudyFolderError that `run` throws; empty if it throws none.
std::string folder_error_of(auto run) {
  try {
    run();
  } catch (const prs::StudyFolderError& error) {
    return error.what();
  }
  return {};
}

}  // namespace test
