#pragma once

#include "prs/validation/validate.h"

namespace prs::sandu_2018 {

inline constexpr double kMeasuredSlipRatio = 0.3730;  ///< Experiment 6.

/// Slip of the first load case, with any status.
SlipResult slip_of(const Case& c);

/// Results for the values of one input; `change(case, value)` puts a value into the case.
template <class Change>
std::vector<SlipResult> sweep(const Case& c, const std::vector<double>& values, Change change) {
  std::vector<SlipResult> results;
  for (const double value : values) {
    Case varied = c;
    change(varied, value);
    results.push_back(slip_of(varied));
  }
  return results;
}

/// Least-squares line through points.
struct Line {
  double intercept = 0.0, slope = 0.0;
  double worst = 0.0;  ///< Largest distance of a point from it.
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y);

/// B_1 and B_2 over several ranges, next to the printed ones.
ValidationTable efficiency_fits(const Case& reference);

/// Power at one contact of each interface for increasing numbers of points (fig. 3.8).
ValidationTable patch_convergence(const Case& reference);

}  // namespace prs::sandu_2018
