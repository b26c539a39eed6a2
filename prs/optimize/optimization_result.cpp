#include "prs/optimize/optimization_result.h"

#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::string> settings_of(const Optimization& optimization,
                                     const EvaluatedDesign& design) {
  return overrides(optimization.study, design.draws);
}

std::string constraint_text(const OptimizationResult& result, const Constraint& constraint) {
  const std::vector<std::string>& responses = result.optimization.study.responses;
  const std::string_view sign = constraint.sense == Constraint::Sense::at_least ? ">=" : "<=";
  const std::string& path = responses[constraint.response];
  switch (constraint.limit.kind) {
    case Limit::Kind::initial:
      return fmt::format("{} {} {} x initial", path, sign, constraint.limit.value);
    case Limit::Kind::response:
      return fmt::format("{} {} {}", path, sign, responses[constraint.limit.response]);
    case Limit::Kind::number:
      break;
  }
  return fmt::format("{} {} {}", path, sign, constraint.limit.value);
}

bool keeps(const Constraint& constraint, const EvaluatedDesign& design,
           const EvaluatedDesign& initial) {
  const double value = design.responses[constraint.response];
  const double limit = limit_of(constraint, design, initial);
  return constraint.sense == Constraint::Sense::at_least ? value >= limit : value <= limit;
}

SearchCounts count(const Search& search) {
  SearchCounts counts{search.designs.size(), 0, 0};
  for (const EvaluatedDesign& design : search.designs) {
    if (design.is_feasible()) ++counts.feasible;
    if (!design.status.converged()) ++counts.without_answer;
  }
  return counts;
}

}  // namespace prs
