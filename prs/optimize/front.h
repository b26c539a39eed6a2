#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "prs/optimize/optimization_result.h"

namespace prs {

/// Indices of the points that no other point dominates, of equal ones the first, ascending in the
/// first coordinate. Less is better. O(n log n) for two coordinates, else O(n x front).
std::vector<std::size_t> non_dominated(const std::vector<std::vector<double>>& points);

/// The front of the feasible designs.
std::vector<std::size_t> front_of(const Optimization& optimization,
                                  const std::vector<EvaluatedDesign>& designs);

/// The front of the designs of both searches, from their own fronts.
std::vector<std::size_t> joint_front(const OptimizationResult& result);

/// The design of `result.front` that the optimization's compromise chooses; the first of equal
/// ones.
std::optional<std::size_t> compromise_of(const OptimizationResult& result);

FrontComparison compare_fronts(const Optimization& optimization, const EvaluatedDesign& initial,
                               const Search& search, const Search& check);

}  // namespace prs
