#pragma once

#include "prs/optimize/optimization_result.h"

namespace prs {

/// Turns answers into numbers to minimise such that domination among them is Deb's constrained
/// domination (Deb et al. 2002, IEEE Trans. Evol. Comput. 6, section VI): any feasible design
/// before any infeasible one, of two infeasible ones that with less violation.
///
/// A feasible design has its objectives, oriented so that less is better, relative to `scales`, as
/// they are up to 1000 and beyond that compressed to below 2000 without changing their order. An
/// infeasible one has 4000 + 1000 v/(1 + v) of its violation v in all of them, one without an
/// answer 6000.
class Fitness {
 public:
  /// Violations are measured against the file's own design, `initial`, which need not have an
  /// answer.
  Fitness(const Optimization& optimization, const EvaluatedDesign& initial);

  /// Sets the violation and, where a response is missing, the status of a design that has answers.
  void assess(EvaluatedDesign& design) const;

  /// One number an objective of a judged design.
  std::vector<double> operator()(const EvaluatedDesign& design) const;

 private:
  const Optimization& optimization_;
  const EvaluatedDesign& initial_;
  std::vector<double> scales_;  ///< Objective by objective: |initial|, or 1.
};

/// The objectives of a design, oriented so that less is better, in their units.
std::vector<double> costs(const Optimization& optimization, const EvaluatedDesign& design);

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
