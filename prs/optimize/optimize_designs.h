#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/optimize/optimization_result.h"

namespace prs {

/// Value of an input in a design, as it could stand in the file: that of the file where the design
/// leaves it; absent where the file says nothing either.
std::optional<Level> value_in(const Factor& input, const Draw& draw);

/// The values of a design as `--set` takes them: `mechanism.flank_angle.screw=42.5 deg`. Those that
/// are the file's are left out.
std::vector<std::string> settings_of(const Optimization& optimization,
                                     const EvaluatedDesign& design);

/// `screw.peak_pressure_MPa.max >= 0.9 x initial`, with numbers of a design.
std::string constraint_text(const OptimizationResult& result, const Constraint& constraint);

/// Whether a design keeps one of its constraints.
bool keeps(const Constraint& constraint, const EvaluatedDesign& design,
           const EvaluatedDesign& initial);

/// Designs of both searches, and how many of them were feasible and had no answer.
struct SearchCounts {
  std::size_t designs = 0;
  std::size_t feasible = 0;
  std::size_t without_answer = 0;
};
SearchCounts count(const Search& search);

}  // namespace prs
