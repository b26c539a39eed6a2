#pragma once

#include "prs/loads/result.h"
#include "prs/model/limits.h"

namespace prs {

/// Values for screw, all rollers together and nut, in this order.
using OfParts = Eigen::Vector3d;

OfParts of_parts(const PerPart<double>& values);
PerPart<double> per_part(const OfParts& values);

/// Three lumped parts that exchange heat with each other and with their surroundings:
///
///     C dT/dt = Q - K (T - T_ambient 1),
///
/// K the symmetric matrix of the conductances [W/K], positive definite if every part has a path to the surroundings;
/// its rows add up to the conductances to ambient.
struct ThermalNetwork {
  Eigen::Matrix3d conductance;  ///< K [W/K]
  double ambient = 0.0;         ///< [K]

  /// Temperatures at which these heats [W] flow off: T_ambient 1 + K^-1 Q [K].
  OfParts steady(const OfParts& heat) const;
};

ThermalNetwork thermal_network(const Heat& heat);

/// Heat of friction in each part [W]: each interface heats both its bodies by halves, a torque of the carrier the part
/// that it acts on.
OfParts heat_of(const PowerBySource& power);

/// Temperature of the oil at the contacts of an interface, the mean of its two bodies [K].
PerInterface<double> oil_temperatures(const OfParts& temperature);

/// Heat of friction in the parts [W], over their temperatures [K].
struct HeatSource {
  /// Exact heat; none if there is no slip, for the reason in `failure`.
  std::function<std::optional<OfParts>(const OfParts& temperature)> exact;
  std::function<std::string()> failure;
  /// Estimate with nearly the same values for a small part of the effort, near the last temperatures of `exact`.
  std::function<std::optional<OfParts>(const PerInterface<double>& oil)> estimate;
  /// Estimate with errors of some per cent, for still less effort: to search for other steady states.
  std::function<std::optional<OfParts>(const PerInterface<double>& oil)> rough_estimate;
  /// Whether heat may grow with temperature, as when films become thin and flanks touch: then several steady states are
  /// searched. Full films and Coulomb's friction have one.
  bool may_grow = true;
};

struct SteadyHeat {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason;
  OfParts temperature = OfParts::Zero();  ///< [K]
  OfParts heat = OfParts::Zero();         ///< Heat in each part [W].
  int evaluations = 0;                    ///< Number of evaluations of the exact heat.
  bool others = false;                    ///< Whether hotter steady states exist.

  bool converged() const { return status == HeatStatus::converged; }
};

/// Result of a search with this outcome; `found` has `status` and `reason`.
template <class Found>
Found ended(Found& found, HeatStatus status, std::string reason) {
  found.status = status;
  found.reason = std::move(reason);
  return found;
}

/// Temperatures at which Q(T) = K (T - T_ambient 1), to `tolerance` [K]: the state that the parts reach from `start`,
/// by default from the temperature of their surroundings, the coolest if there are several. Newton's method on the
/// estimate, scaled part by part to the last exact heat and given a slope through those before (Broyden, Math. Comp.
/// 19, 1965, 577), which are then recomputed. If the estimate has another crossing between ambient temperature and the
/// found state, or Newton's method fails, the parts are followed in time by implicit Euler steps.
SteadyHeat find_steady_heat(const ThermalNetwork& network, const HeatSource& source,
                            const std::optional<OfParts>& start = {}, double tolerance = 1e-8);

}  // namespace prs
