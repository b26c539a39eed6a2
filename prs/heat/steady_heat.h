#pragma once

#include <functional>
#include <optional>
#include <string>

#include "prs/heat/thermal_network.h"
#include "prs/loads/heat_result.h"

namespace prs {

/// Where bearing steel turns into austenite, Ac1 [K]: beyond it no part is what the case states.
inline constexpr double kHottest = 1000.0;

/// Heat that friction puts into the parts [W], over their temperatures [K].
struct HeatSource {
  /// None where there is no slip, for the reason that `failure` gives.
  std::function<std::optional<OfParts>(const OfParts& temperature)> exact;
  std::function<std::string()> failure;
  /// Nearly the same for a small part of the effort, near the last temperatures of `exact`.
  std::function<std::optional<OfParts>(const PerInterface<double>& oil)> estimate;
  /// Whether heat may grow with temperature, as where films get thin and flanks touch: then several
  /// steady states are looked for. Full films and Coulomb's friction have one.
  bool may_grow = true;
};

struct SteadyHeat {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason;
  OfParts temperature = OfParts::Zero();  ///< [K]
  OfParts heat = OfParts::Zero();         ///< Into each part [W].
  int evaluations = 0;                    ///< Of the exact heat.
  bool others = false;                    ///< Hotter steady states exist.

  bool converged() const { return status == HeatStatus::converged; }
};

/// Temperatures at which Q(T) = K (T - T_ambient 1), to 1e-8 K: the state that the parts reach from
/// `start`, by default from the temperature of their surroundings, the coolest where there are
/// several. Newton's method on the estimate, scaled part by part to the last exact heat, which is
/// then taken anew. Where the estimate has another crossing between ambient temperature and the
/// found state, or Newton's method fails, the way of the parts is followed in time by implicit
/// Euler steps.
SteadyHeat find_steady_heat(const ThermalNetwork& network, const HeatSource& source,
                            const std::optional<OfParts>& start = {});

}  // namespace prs
