#include "prs/optimize/optimization_result.h"

#include <cmath>

namespace prs {

const EvaluatedDesign* OptimizationResult::chosen() const {
  if (compromise) return &search.designs[*compromise];
  return nearest ? &search.designs[*nearest] : nullptr;
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
