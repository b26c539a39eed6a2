#pragma once

#include <cmath>
#include <limits>

namespace fe {

/// Value, slope and stored energy of a scalar force law at one approach.
struct SpringResponse {
  double energy = 0.0;   ///< Stored energy [J].
  double force = 0.0;    ///< d energy / d approach [N], >= 0.
  double tangent = 0.0;  ///< d force / d approach [N/m], >= 0.
};

/// Unilateral power law, a contact that pushes and never pulls:
///
///     force = stiffness * <w - gap - series_compliance * force>^1.5
///
/// with w the approach of the two ends [m] and <x> = max(x, 0): Hertz's point contact (Abevi 2015, (21), with the
/// exponent read as 3/2). The energy is convex in w, so a Newton direction always descends.
///
/// The spring in series may take back part of the approach, series_compliance < 0. The law holds until half of what the
/// power law adds is taken back, 1 + series_compliance d force/dd = 1/2; from there on the force grows along its
/// tangent.
///
/// With an infinite stiffness only the spring in series remains, a stop with a gap: force = <w -
/// gap>/series_compliance, series_compliance > 0.
struct PowerLawSpring {
  double stiffness = 0.0;          ///< k_0 [N/m^1.5], > 0.
  double gap = 0.0;                ///< Approach at which the ends first touch [m].
  double series_compliance = 0.0;  ///< Linear spring in series, of either sign [m/N].
};

/// Force of the power law alone at its own approach `d`: k d^1.5, 1.5 k d^0.5, k d^2.5/2.5.
inline SpringResponse power_law(double stiffness, double d) {
  if (d <= 0.0) return {};
  const double root = std::sqrt(d);
  const double force = stiffness * d * root;
  return {force * d / 2.5, force, 1.5 * stiffness * root};
}

/// Deflection d of the power law up to which a series compliance < 0 takes back no more than half:
/// -1.5 c k d^0.5 = 1/2.
inline double largest_deflection(const PowerLawSpring& s) {
  if (s.series_compliance >= 0.0 || s.stiffness == 0.0) return std::numeric_limits<double>::infinity();
  const double root = -0.5 / (s.series_compliance * 1.5 * s.stiffness);
  return root * root;
}

/// Deflection d of the power law in series with the linear spring: d + c k d^1.5 = total, for
/// d <= `largest_deflection`. Increasing, convex for c > 0 and concave for c < 0, so that Newton in
/// sqrt(d) from d = total never overshoots the root.
inline double law_approach_in_series(const PowerLawSpring& s, double total) {
  const double a = s.series_compliance * s.stiffness;
  double x = std::sqrt(total);
  for (int i = 0; i < 100; ++i) {
    const double step = (x * x * (1.0 + a * x) - total) / (x * (2.0 + 3.0 * a * x));
    x -= step;
    if (std::abs(step) <= 1e-9 * x) break;  // the square of this change is below rounding
  }
  return x * x;
}

/// Response of both in series to an approach `d` of the power law alone.
inline SpringResponse response_in_series(const PowerLawSpring& s, double d) {
  SpringResponse r = power_law(s.stiffness, d);
  r.energy += 0.5 * s.series_compliance * r.force * r.force;
  r.tangent /= 1.0 + s.series_compliance * r.tangent;
  return r;
}

/// Response of the spring to the approach `w` [m].
inline SpringResponse evaluate(const PowerLawSpring& s, double w) {
  const double total = w - s.gap;
  if (total <= 0.0) return {};
  if (std::isinf(s.stiffness)) {
    const double force = total / s.series_compliance;
    return {0.5 * force * total, force, 1.0 / s.series_compliance};
  }
  if (s.series_compliance == 0.0) return power_law(s.stiffness, total);

  const double largest = largest_deflection(s);
  // At `largest` the series spring takes back a third of it: c k d^1.5 = -d/3.
  if (total > 2.0 / 3.0 * largest) {
    SpringResponse r = response_in_series(s, largest);
    const double beyond = total - (largest + s.series_compliance * r.force);
    r.energy += beyond * (r.force + 0.5 * r.tangent * beyond);
    r.force += r.tangent * beyond;
    return r;
  }
  return response_in_series(s, law_approach_in_series(s, total));
}

/// The spring with its response as a function of its net approach w - gap.
inline PowerLawSpring without_gap(PowerLawSpring s) {
  s.gap = 0.0;
  return s;
}

/// Deflection of the power law alone at the approach `w` [m].
inline double law_approach(const PowerLawSpring& s, double w) {
  const double total = w - s.gap;
  if (total <= 0.0) return 0.0;
  if (s.series_compliance == 0.0) return total;
  return std::pow(evaluate(s, w).force / s.stiffness, 1.0 / 1.5);
}

}  // namespace fe
