#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "prs/optimize/optimizer.h"

namespace test {

/// A variable between two numbers.
inline prs::Factor variable(std::string path, double from, double to) {
  prs::Factor factor;
  factor.path = factor.label = std::move(path);
  factor.distribution = {prs::Distribution::Kind::uniform, from, to};
  return factor;
}

/// A problem in formulas: responses of the values of all variables, levels counting by their numbers; none if the
/// design has no result.
struct Problem {
  prs::Optimization optimization;
  std::function<std::vector<double>(const std::vector<double>& x)> answer;
  mutable std::size_t asked = 0;  ///< Number of designs so far.

  std::vector<double> values(const std::vector<prs::Draw>& draws) const {
    std::vector<double> x;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const prs::Factor& factor = optimization.study.factors[i];
      const prs::Draw& draw = draws[i];
      x.push_back(draw.kind == prs::Draw::Kind::number  ? draw.number
                  : draw.kind == prs::Draw::Kind::level ? *factor.levels[draw.level].number
                  : factor.base                         ? factor.base->number.value_or(0.0)
                                                        : factor.distribution.first);
    }
    return x;
  }

  prs::EvaluateDesigns evaluate() const {
    return [this](const std::vector<std::vector<prs::Draw>>& designs) {
      prs::RowBlock block{0, designs.size(), {}, {}};
      const std::size_t width = optimization.study.responses.size();
      for (std::size_t row = 0; row < designs.size(); ++row) {
        std::vector<double> y = answer(values(designs[row]));
        if (y.empty()) {
          block.failures.push_back({row, {"refused", "x: got one that no mechanism has"}});
          y.assign(width, prs::kNoResponse);
        }
        block.responses.insert(block.responses.end(), y.begin(), y.end());
      }
      asked += designs.size();
      return block;
    };
  }

  prs::JournalHeader header() const {
    return {"0123", {"case.yaml", "", {}}, optimization.study.responses, prs::design_count(optimization), prs::Shard{}};
  }

  prs::OptimizationResult run() const {
    prs::Journal journal = prs::Journal::temporary(header());
    return *prs::optimize(optimization, evaluate(), journal, {});
  }
};

/// Two objectives to minimise, the responses `f` and `g`.
inline prs::Optimization two_objectives(std::vector<prs::Factor> variables) {
  prs::Optimization optimization;
  optimization.study.plan = prs::Plan::monte_carlo;
  optimization.study.factors = std::move(variables);
  optimization.study.responses = {"f", "g"};
  optimization.objectives = {{0, false}, {1, false}};
  return optimization;
}

/// Zitzler, Deb & Thiele (2000), problem 1: the front is g = 1 - sqrt(f), where all variables except the first are 0.
inline Problem zdt1(std::size_t dimensions) {
  std::vector<prs::Factor> variables;
  for (std::size_t i = 0; i < dimensions; ++i) variables.push_back(variable("x" + std::to_string(i), 0.0, 1.0));
  Problem problem{two_objectives(std::move(variables)), {}, 0};
  problem.answer = [](const std::vector<double>& x) {
    double sum = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) sum += x[i];
    const double h = 1.0 + 9.0 * sum / static_cast<double>(x.size() - 1);
    return std::vector{x[0], h * (1.0 - std::sqrt(x[0] / h))};
  };
  return problem;
}

/// Binh & Korn (1997): 4 x^2 + 4 y^2 and (x - 5)^2 + (y - 5)^2 for (x - 5)^2 + y^2 <= 25 and
/// (x - 8)^2 + (y + 3)^2 >= 7.7 with 0 <= x <= 5, 0 <= y <= 3. The front: x = y up to 3, then y
/// = 3.
inline Problem binh_korn() {
  Problem problem{two_objectives({variable("x", 0.0, 5.0), variable("y", 0.0, 3.0)}), {}, 0};
  problem.optimization.study.responses = {"f", "g", "c", "d"};
  problem.optimization.constraints = {{"c", 2, prs::Constraint::Sense::at_most, {prs::Limit::Kind::number, 25.0, 0}},
                                      {"d", 3, prs::Constraint::Sense::at_least, {prs::Limit::Kind::number, 7.7, 0}}};
  problem.answer = [](const std::vector<double>& v) {
    const double x = v[0], y = v[1];
    const auto square = [](double z) { return z * z; };
    return std::vector{4.0 * x * x + 4.0 * y * y, square(x - 5.0) + square(y - 5.0), square(x - 5.0) + y * y,
                       square(x - 8.0) + square(y + 3.0)};
  };
  return problem;
}

/// Srinivas & Deb (1994): the constraints bind along the front, which lies at x = -2.5.
inline Problem srinivas() {
  Problem problem{two_objectives({variable("x", -20.0, 20.0), variable("y", -20.0, 20.0)}), {}, 0};
  problem.optimization.study.responses = {"f", "g", "c", "d"};
  problem.optimization.constraints = {{"c", 2, prs::Constraint::Sense::at_most, {prs::Limit::Kind::number, 225.0, 0}},
                                      {"d", 3, prs::Constraint::Sense::at_most, {prs::Limit::Kind::number, -10.0, 0}}};
  problem.answer = [](const std::vector<double>& v) {
    const double x = v[0], y = v[1];
    const auto square = [](double z) { return z * z; };
    return std::vector{2.0 + square(x - 2.0) + square(y - 1.0), 9.0 * x - square(y - 1.0), x * x + y * y, x - 3.0 * y};
  };
  return problem;
}

}  // namespace test
