#pragma once

#include <optional>
#include <span>

namespace prs {

/// Deviations of a computed curve from a reference: computed minus reference, point by point.
struct CurveDeviations {
  double mean = 0.0;
  double mean_magnitude = 0.0;
  double rms = 0.0;            ///< Root mean square.
  double largest = 0.0;        ///< Largest by magnitude, with its sign.
  std::size_t largest_at = 0;  ///< Index of that point.
};

/// Deviations; none if a point has no number.
std::optional<CurveDeviations> curve_deviations(std::span<const double> computed, std::span<const double> reference);

/// Slope of the least-squares line through points; none if all have the same x.
std::optional<double> slope(std::span<const double> x, std::span<const double> y);

}  // namespace prs
