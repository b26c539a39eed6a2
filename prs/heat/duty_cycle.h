#pragma once

#include "prs/heat/tabulated_losses.h"

namespace prs {

/// Losses over a cycle: none at rest, then those of each load case of the duty.
struct DutyLosses {
  std::vector<LossTable> tables;
  std::vector<TemperatureBox> covered = {};  ///< Temperatures of the load cases at which their tables hold.
  OfParts start = OfParts::Zero();           ///< First temperatures of the cycle.
};

/// Heat capacities of screw, rollers and nut [J/K]: those of the file, or the specific heat times
/// the masses of `measures`, the screw's over the length of the nut.
OfParts heat_capacities(const Conditions& c, const Mechanism& mechanism);

/// A part of a duty: the index of its table of losses, and its duration [s].
struct DutySegment {
  std::size_t table = 0;
  double duration = 0.0;
};

/// Temperatures and energies from `start` through the segments, as `duty_cycle` integrates them, with the times at
/// which parts first reach `limit` [K]; to the moment at which one passes `kHottest`.
HeatCycle warming(const ThermalNetwork& network, const OfParts& capacity, std::span<const DutySegment> segments,
                  const std::vector<LossTable>& tables, const OfParts& start, std::optional<double> limit = {});

/// The state that repeats itself from cycle to cycle of the duty in `c.heat`, or with `heat.cycles` the mission of so
/// many from `heat.start`: slip follows the temperatures at once, these follow
///
///     C dT/dt = Q_k(T) - K (T - T_ambient 1)
///
/// with the losses of load case k while it acts and none at rest. Losses stand in a `LossTable` of
/// each load case over the temperatures of the cycle. Integrated by linearly implicit Euler steps,
/// extrapolated (Deuflhard; Hairer and Wanner, Solving Ordinary Differential Equations II, IV.9),
/// to 1e-8 K in a step; the start of the cycle that is also its end is found by Newton's method.
/// Energies are integrated along with the temperatures, so that they balance to rounding.
/// The peak is that within steps too. `warnings` reports losses that are too rough for tables.
/// `known` of a case with other conductances, capacities or times serves where its tables hold for
/// the whole cycle, else `found` are new ones, over a wider range than this cycle needs.
HeatCycle duty_cycle(const Conditions& c, const Contacts& contacts, std::vector<Warning>& warnings,
                     const DutyLosses* known = nullptr, DutyLosses* found = nullptr,
                     std::optional<double> temperature_limit = {});

}  // namespace prs
