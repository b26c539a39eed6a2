#include "prs/optimize/fitness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prs {
namespace {

constexpr double kLinear = 1e3;      // Up to here an objective is as it is,
constexpr double kInfeasible = 4e3;  // above twice that are the infeasible designs,
constexpr double kNoAnswer = 6e3;    // above these the ones without an answer.

/// Strictly increasing, smooth, between -2000 and 2000.
double compressed(double x) {
  const double size = std::abs(x);
  return size <= kLinear ? x : std::copysign(2.0 * kLinear - kLinear * kLinear / size, x);
}

/// What is missing to a constraint, relative.
double violation(const Constraint& constraint, const EvaluatedDesign& design,
                 const EvaluatedDesign& initial) {
  const double value = design.responses[constraint.response];
  const double limit = limit_of(constraint, design, initial);
  const double missing =
      constraint.sense == Constraint::Sense::at_least ? limit - value : value - limit;
  if (!(missing > 0.0)) return std::isnan(missing) ? std::numeric_limits<double>::infinity() : 0.0;
  double scale = std::max(std::abs(limit), std::abs(value));
  if (constraint.limit.kind != Limit::Kind::response) {
    const double usual = std::abs(initial.responses[constraint.response]);
    scale = std::max(std::abs(limit), std::isfinite(usual) ? usual : 0.0);
  }
  return missing / (scale > 0.0 ? scale : 1.0);
}

}  // namespace

Fitness::Fitness(const Optimization& optimization, const EvaluatedDesign& initial)
    : optimization_(optimization), initial_(initial) {
  for (const Objective& objective : optimization.objectives) {
    const double size = std::abs(initial.responses[objective.response]);
    scales_.push_back(std::isfinite(size) && size > 0.0 ? size : 1.0);
  }
}

void Fitness::assess(EvaluatedDesign& design) const {
  design.violation = std::numeric_limits<double>::infinity();
  if (!design.status.converged()) return;
  const auto none = std::ranges::find_if(design.responses, [](double y) { return std::isnan(y); });
  if (none != design.responses.end()) {
    const auto index = static_cast<std::size_t>(none - design.responses.begin());
    design.status = {"refused", fmt::format("{} is not defined in this design",
                                            optimization_.study.responses[index])};
    return;
  }
  design.violation = 0.0;
  for (const Constraint& constraint : optimization_.constraints)
    design.violation += violation(constraint, design, initial_);
}

std::vector<double> Fitness::operator()(const EvaluatedDesign& design) const {
  const std::size_t count = optimization_.objectives.size();
  if (!design.status.converged()) return std::vector<double>(count, kNoAnswer);
  if (!design.is_feasible()) {
    const double v = design.violation;
    const double share = std::isfinite(v) ? v / (1.0 + v) : 1.0;
    return std::vector<double>(count, kInfeasible + 1e3 * share);
  }
  std::vector<double> values = costs(optimization_, design);
  for (std::size_t k = 0; k < count; ++k) values[k] = compressed(values[k] / scales_[k]);
  return values;
}

std::vector<double> costs(const Optimization& optimization, const EvaluatedDesign& design) {
  std::vector<double> values;
  for (const Objective& objective : optimization.objectives) {
    const double value = design.responses[objective.response];
    values.push_back(objective.maximize ? -value : value);
  }
  return values;
}

}  // namespace prs
