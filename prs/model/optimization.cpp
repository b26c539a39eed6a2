#include "prs/model/optimization.h"

#include <cmath>

namespace prs {

std::string_view name(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::nsga2:
      return "nsga2";
    case Algorithm::nspso:
      return "nspso";
    case Algorithm::moead:
      return "moead";
    case Algorithm::sade:
      return "sade";
    case Algorithm::pso:
      return "pso";
    case Algorithm::cmaes:
      return "cmaes";
  }
  return "";
}

bool takes_several_objectives(Algorithm algorithm) {
  return algorithm == Algorithm::nsga2 || algorithm == Algorithm::nspso ||
         algorithm == Algorithm::moead;
}

std::size_t design_count(const Optimization& optimization) {
  const std::size_t searches = optimization.check ? 2 : 1;
  return 1 + searches * optimization.population * optimization.generations;
}

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
