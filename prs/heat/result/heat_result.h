#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/model/part.h"

namespace prs {

/// Outcome of the search for steady or periodic temperatures.
enum class HeatStatus {
  converged,
  no_steady_state,  ///< The parts become hotter than oil and steel allow, or slip ends.
  iteration_limit,
};

constexpr std::string_view name(HeatStatus status) {
  constexpr std::string_view kNames[] = {"converged", "no_steady_state", "iteration_limit"};
  return kNames[static_cast<std::size_t>(status)];
}

/// Temperatures at which the losses of a load case balance the heat flow from the parts. SI units; all rollers
/// together.
struct HeatResult {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason = {};                  ///< Reason why it did not converge.
  int evaluations = 0;                      ///< Number of evaluations of the losses at temperatures.
  bool others = false;                      ///< Whether hotter steady states exist.
  PerPart<double> temperature;              ///< [K]
  std::optional<PerInterface<double>> oil;  ///< Temperature of the oil at the contacts [K]; none without lubricant.
  PerPart<double> heat;                     ///< Heat flow into each part [W].

  bool converged() const { return status == HeatStatus::converged; }
};

/// Periodic state of a duty cycle. SI units.
struct HeatCycle {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason = {};
  std::vector<double> time;                  ///< Times from the start of the cycle to its end [s].
  PerPart<std::vector<double>> temperature;  ///< Temperatures at these times [K].
  PerPart<double> peak, mean;                ///< [K]
  double period = 0.0;                       ///< [s]
  double energy_in = 0.0;                    ///< Energy input of shaft and load while they drive, per cycle [J].
  double energy_lost = 0.0;                  ///< Energy lost by friction, per cycle [J].
  std::optional<double> efficiency;          ///< Ratio of output to input; none without input.

  bool converged() const { return status == HeatStatus::converged; }
};

}  // namespace prs
