#include "prs/optimize/optimize_designs.h"

#include <fmt/format.h>

#include <algorithm>

namespace prs {

std::optional<Level> value_in(const Factor& input, const Draw& draw) {
  switch (draw.kind) {
    case Draw::Kind::number:
      return Level{fmt::format("{}{}{}", draw.number, input.unit.empty() ? "" : " ", input.unit),
                   draw.number};
    case Draw::Kind::level:
      return input.levels[draw.level];
    case Draw::Kind::as_in_file:
      break;
  }
  return input.base;
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
