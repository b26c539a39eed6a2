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

/// Periodic state of a duty cycle, or a mission of some cycles. SI units.
struct HeatCycle {
  HeatStatus status = HeatStatus::iteration_limit;
  std::string reason = {};
  std::vector<double> time;                   ///< Times from the start of the cycle or the mission to its end [s].
  PerPart<std::vector<double>> temperature;   ///< Temperatures at these times [K].
  PerPart<double> peak, mean;                 ///< [K]
  double period = 0.0;                        ///< Duration of one cycle [s].
  int cycles = 1;                             ///< Number of cycles over which the rest counts.
  double energy_in = 0.0;                     ///< Energy input of shaft and load while they drive [J].
  double energy_lost = 0.0;                   ///< Energy lost by friction [J].
  std::optional<double> efficiency;           ///< Ratio of output to input; none without input.
  std::optional<PerPart<double>> start, end;  ///< Temperatures at both ends of a mission [K].
  /// Times at which the parts first reach the limit of temperature in a mission [s].
  PerPart<std::optional<double>> time_to_limit;

  bool converged() const { return status == HeatStatus::converged; }
  bool is_mission() const { return start.has_value(); }
  double duration() const { return period * cycles; }
};

}  // namespace prs
