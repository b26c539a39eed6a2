#include "prs/reference/curve_deviations.h"

#include <cmath>

#include "prs/indices.h"

namespace prs {

std::optional<CurveDeviations> curve_deviations(std::span<const double> computed, std::span<const double> reference) {
  if (computed.empty() || computed.size() != reference.size()) return std::nullopt;
  CurveDeviations d;
  const double share = 1.0 / static_cast<double>(computed.size());
  constexpr double kRounding = 1e-13;  // Rounding of values such as shares with the same sum on both sides.
  double squares = 0.0, magnitude = 0.0;
  for (const auto k : indices(computed)) {
    const double difference = computed[k] - reference[k];
    if (!std::isfinite(difference)) return std::nullopt;
    d.mean += share * difference;
    d.mean_magnitude += share * std::abs(difference);
    squares += share * difference * difference;
    magnitude += share * std::abs(computed[k]);
    if (std::abs(difference) <= std::abs(d.largest)) continue;
    d.largest = difference;
    d.largest_at = k;
  }
  d.rms = std::sqrt(squares);
  if (const double grain = kRounding * magnitude; grain > 0.0) d.mean = grain * std::round(d.mean / grain);
  return d;
}

std::optional<double> slope(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto k : indices(x)) {
    mean_x += x[k] / count;
    mean_y += y[k] / count;
  }
  for (const auto k : indices(x)) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  return xx > 0.0 && std::isfinite(xy) ? std::optional(xy / xx) : std::nullopt;
}

}  // namespace prs
