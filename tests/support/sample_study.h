#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "prs/study/designs.h"
#include "prs/study/study_result.h"

namespace prs::sample {

/// A factor with numbers for levels and 2 in the file.
inline Factor counted(std::string path, const std::vector<double>& levels, std::string label = {}) {
  Factor factor;
  factor.path = std::move(path);
  factor.label = label.empty() ? factor.path : std::move(label);
  factor.base = Level{"2", 2.0};
  for (const double level : levels) {
    std::string text = std::to_string(level);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    factor.levels.push_back({text, level});
  }
  return factor;
}

/// A factor that is drawn between two numbers.
inline Factor drawn(std::string path, double from, double to) {
  Factor factor = counted(std::move(path), {});
  factor.distribution = {Distribution::Kind::uniform, from, to};
  return factor;
}

/// The responses for the values of all factors, words counting 0, 1, ..; none: the design is refused.
using Answer = std::function<std::vector<double>(const std::vector<double>&)>;

/// A study of a formula in place of a solver.
inline StudyResult run(const Study& study, const Answer& answer) {
  RowBlock rows{0, design_count(study), {}, {}};
  for (std::size_t k = 0; k < rows.rows; ++k) {
    std::vector<double> x;
    const std::vector<Draw> values = draws(study, k);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Factor& factor = study.factors[i];
      if (values[i].kind == Draw::Kind::as_in_file)
        x.push_back(factor.base ? factor.base->number.value_or(0.0) : 0.0);
      else if (values[i].kind == Draw::Kind::level)
        x.push_back(factor.levels[values[i].level].number.value_or(static_cast<double>(values[i].level)));
      else
        x.push_back(values[i].number);
    }
    std::vector<double> y = answer(x);
    if (y.empty()) {
      rows.failures.push_back({k, {"refused", "mechanism.rollers: got 3; expected, say, 4"}});
      y.assign(study.responses.size(), kNoResponse);
    }
    rows.responses.insert(rows.responses.end(), y.begin(), y.end());
  }
  StudyAnalysis analysis(study);
  analysis.add(rows);
  StudyResult result;
  result.study = study;
  add(result, rows);
  result.summary = analysis.summary();
  return result;
}

/// y = 10 x and z = x for x = 1, 3, 4 besides 2 in the file; 3 is refused.
inline StudyResult counting() {
  Study study;
  study.command = Command::solve;
  study.factors = {counted("x", {1.0, 3.0, 4.0}, "the x")};
  study.responses = {"y", "z.max"};
  return run(study, [](const std::vector<double>& x) {
    return x[0] == 3.0 ? std::vector<double>{} : std::vector{10.0 * x[0], x[0]};
  });
}

/// Two pressures over three factors, the third of which has no effect: 5 + 3 x_a - x_b, and x_a x_b of the normalised
/// factors.
inline StudyResult sampled(Plan plan, std::size_t samples = 500) {
  Study study;
  study.command = Command::contact;
  study.plan = plan;
  study.samples = samples;
  study.seed = 7;
  study.factors = {drawn("a", 1.0, 3.0), drawn("b", 1.0, 3.0), drawn("c", 1.0, 3.0)};
  study.factors[0].label = "flank angle";
  study.factors[0].unit = "deg";
  study.responses = {"screw.peak_pressure_MPa.max", "nut.peak_pressure_MPa.max"};
  return run(study, [](const std::vector<double>& x) {
    const double a = x[0] - 2.0, b = x[1] - 2.0;
    return std::vector{5.0 + 3.0 * a - b, a * b};
  });
}

}  // namespace prs::sample
