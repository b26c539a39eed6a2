#pragma once

#include <cmath>

namespace fe {

/// Value, slope and stored energy of a scalar force law at one deflection.
struct SpringResponse {
  double energy = 0.0;   ///< Stored [J].
  double force = 0.0;    ///< d energy / d approach [N], >= 0.
  double tangent = 0.0;  ///< d force / d approach [N/m], >= 0.
};

/// Unilateral power law, a contact that pushes and never pulls:
///
///     force = stiffness * <w - gap - series_compliance * force>^exponent
///
/// with w the approach of the two ends [m] and <x> = max(x, 0). The energy is convex in w, so a
/// Newton direction always descends. Exponent 3/2 is Hertz's point contact (Abevi 2015, (21), with
/// the exponent read as 3/2).
struct PowerLawSpring {
  double stiffness = 0.0;          ///< k_0 [N/m^exponent], > 0.
  double exponent = 1.5;           ///< >= 1.
  double gap = 0.0;                ///< Approach at which the ends first touch [m].
  double series_compliance = 0.0;  ///< Linear spring in series [m/N], >= 0.
};

/// Force of the power law alone, its own deflection `d` given: k d^n, n k d^(n-1), k d^(n+1)/(n+1).
inline SpringResponse power_law(double stiffness, double exponent, double d) {
  if (d <= 0.0) return {};
  const double root = exponent == 1.5 ? std::sqrt(d) : std::pow(d, exponent - 1.0);
  const double force = stiffness * d * root;
  return {force * d / (exponent + 1.0), force, exponent * stiffness * root};
}

/// Deflection d of the power law in series with the linear spring: d + c k d^n = total.
/// Convex and increasing, so Newton from the right end never overshoots the root.
inline double deflection_in_series(const PowerLawSpring& s, double total) {
  double d = total;
  for (int i = 0; i < 100; ++i) {
    const SpringResponse r = power_law(s.stiffness, s.exponent, d);
    const double step =
        (d + s.series_compliance * r.force - total) / (1.0 + s.series_compliance * r.tangent);
    d -= step;
    if (std::abs(step) <= 1e-15 * total) break;
  }
  return d;
}

/// Response of the spring to the approach `w` [m].
inline SpringResponse evaluate(const PowerLawSpring& s, double w) {
  const double total = w - s.gap;
  if (total <= 0.0) return {};
  if (s.series_compliance == 0.0) return power_law(s.stiffness, s.exponent, total);

  SpringResponse r = power_law(s.stiffness, s.exponent, deflection_in_series(s, total));
  r.energy += 0.5 * s.series_compliance * r.force * r.force;
  r.tangent /= 1.0 + s.series_compliance * r.tangent;
  return r;
}

}  // namespace fe
