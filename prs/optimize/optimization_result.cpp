#include "prs/optimize/optimization_result.h"

#include <cmath>

namespace prs {

std::size_t OptimizationResult::design_count() const {
  return search.designs.size() + (check ? check->designs.size() : 0);
}

const Search& OptimizationResult::search_of(std::size_t index) const {
  return index < search.designs.size() ? search : *check;
}

const EvaluatedDesign& OptimizationResult::design(std::size_t index) const {
  const std::size_t own = search.designs.size();
  return index < own ? search.designs[index] : check->designs[index - own];
}

const EvaluatedDesign* OptimizationResult::chosen() const {
  if (compromise) return &design(*compromise);
  return nearest ? &design(*nearest) : nullptr;
}

double limit_of(const Constraint& constraint, const EvaluatedDesign& design,
                const EvaluatedDesign& initial) {
  switch (constraint.limit.kind) {
    case Limit::Kind::initial:
      return constraint.limit.value * initial.responses[constraint.response];
    case Limit::Kind::response:
      return design.responses[constraint.limit.response];
    case Limit::Kind::number:
      break;
  }
  return constraint.limit.value;
}

std::optional<double> change_percent(double value, double initial) {
  const double change = 100.0 * (value / initial - 1.0);
  // Against the rounding of a zero no change has a meaning.
  return std::abs(change) < 1e9 ? std::optional(change) : std::nullopt;
}

}  // namespace prs
