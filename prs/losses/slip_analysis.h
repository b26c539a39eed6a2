#pragma once

#include "prs/loads/load_analysis.h"
#include "prs/loads/load_record.h"
#include "prs/slip/slip.h"

namespace prs {

/// The command `slip`: slip and friction of load cases, at the temperatures that they cause.
const Analysis<Result>& slip_analysis();

/// The thread of the largest power density.
struct HottestThread {
  Interface interface = Interface::screw;
  std::size_t thread = 0;             ///< Number from 1.
  std::optional<std::size_t> roller;  ///< Number from 1; for a full mechanism.
  std::optional<double> power;        ///< [W]
  double power_density = 0.0;         ///< [W/m^2]
  std::optional<int> of_nut;          ///< 1 or 2; for a double nut.
};

Record<InterfaceSlip> record_of(Type<InterfaceSlip>);
Record<PowerBySource> record_of(Type<PowerBySource>);
Record<RollerMoments> record_of(Type<RollerMoments>);
Record<RollerForces> record_of(Type<RollerForces>);
Record<SlipEstimates> record_of(Type<SlipEstimates>);
Record<HottestThread> record_of(Type<HottestThread>);
Record<EqualShareSlip> record_of(Type<EqualShareSlip>);
Record<SlipResult> record_of(Type<SlipResult>);
Record<SecondNut> record_of(Type<SecondNut>);
Record<Holding::Bound> record_of(Type<Holding::Bound>);
Record<Holding> record_of(Type<Holding>);

/// The sources of friction, in the order of the documents; titles are those of tables and figures.
struct PowerSource {
  std::string_view key;
  std::string_view title;
  double PowerBySource::*value;
};

inline constexpr PowerSource kPowerSources[] = {
    {"screw", "roller-screw", &PowerBySource::screw},
    {"nut", "roller-nut", &PowerBySource::nut},
    {"carrier_roller", "roller-carrier", &PowerBySource::carrier_roller},
    {"carrier_screw", "carrier-screw", &PowerBySource::carrier_screw},
    {"carrier_nut", "carrier-nut", &PowerBySource::carrier_nut},
};

/// Whether a load case has a slip result.
inline bool has_slip(const LoadCaseResult& result) { return result.slip && result.slip->converged(); }

inline bool is_held(const LoadCaseResult& result) { return result.slip && result.slip->is_held(); }

/// Outcome of the search for the slip ratio or, if the loads are not known, of their solve.
inline std::string_view slip_status_name(const LoadCaseResult& result) {
  if (result.heat && !result.heat->converged()) return name(result.heat->status);
  if (result.slip) return name(result.slip->status);
  return result.converged() ? name(SlipStatus::not_computed) : status_name(result);
}

/// The hottest thread, of both nuts if there are two; absent if there are no densities.
std::optional<HottestThread> hottest_thread(const SlipResult& slip);

}  // namespace prs
