#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/model/part.h"

namespace prs {

/// How the search for steady or periodic temperatures ended.
enum class HeatStatus {
  converged,
  no_steady_state,  ///< The parts warm on until no oil and no steel stands it, or slip ends.
  iteration_limit,
};

constexpr std::string_view name(HeatStatus status) {
  constexpr std::string_view kNames[] = {"converged", "no_steady_state", "iteration_limit"};
  return kNames[static_cast<std::size_t>(status)];
}

/// Temperatures at which the losses of a load case and the heat that the parts pass on balance. SI
/// units; of all rollers together.
struct HeatResult {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason = {};                  ///< Reason why it did not converge.
  int evaluations = 0;                      ///< Evaluations of the losses at temperatures.
  bool others = false;                      ///< Hotter steady states exist.
  PerPart<double> temperature;              ///< [K]
  std::optional<PerInterface<double>> oil;  ///< Temperature of the oil at the contacts [K]; none without lubricant.
  PerPart<double> heat;                     ///< Heat that flows into each part [W].

  bool converged() const { return status == HeatStatus::converged; }
};

/// The state that repeats itself from cycle to cycle of a duty. SI units.
struct HeatCycle {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason = {};
  std::vector<double> time;                  ///< From the start of the cycle to its end [s].
  PerPart<std::vector<double>> temperature;  ///< At these times [K].
  PerPart<double> peak, mean;                ///< [K]
  double period = 0.0;                       ///< [s]
  double energy_in = 0.0;                    ///< Energy that shaft and load bring in while they drive, per cycle [J].
  double energy_lost = 0.0;                  ///< By friction, per cycle [J].
  std::optional<double> efficiency;          ///< What comes out over what goes in; none where nothing does.

  bool converged() const { return status == HeatStatus::converged; }
};

}  // namespace prs
