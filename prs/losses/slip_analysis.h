#pragma once

#include "prs/loads/load_analysis.h"
#include "prs/loads/load_record.h"
#include "prs/slip/slip.h"

namespace prs {

/// Slip at a glance, the warnings below: up to four load cases at length, more as one row per case.
/// Within 100 columns. `all`: with the estimates beside what is computed, by equal thread loads and
/// by a fit.
std::string slip_table(const Result& result, bool all = false);

/// One case thread by thread: the power lost at both interfaces of a roller [W] as bars. For a case
/// without an answer, one line that says why.
std::string slip_chart(const LoadCaseResult& result);

/// `slip.csv`: one row a load case, failed ones included: slip ratio, efficiency, power lost to
/// each source, torques, the hottest thread and what equal shares would give. Fields as in
/// `load_cases.csv`.
std::string slip_csv(const Result& result, const CsvStyle& style = {});

/// `slip_threads.csv`: one row a thread and interface of every load case with an answer.
std::string slip_threads_csv(const Result& result, const CsvStyle& style = {});

/// Steady temperatures of the load cases that have a heat balance, a row each.
std::string heat_csv(const Result& result, const CsvStyle& style);

/// Temperatures over the cycle of a duty, a row for each time.
std::string heat_cycle_csv(const HeatCycle& cycle, const CsvStyle& style);

/// The command `slip`: slip and friction of load cases, at the temperatures that they come to.
const Analysis<Result>& slip_analysis();

Figure slip_patch_figure(const LoadCaseResult& result, const SlipPictures& pictures);
/// Figure of one thread of all rollers, counted from 0.
Figure thread_friction_figure(const LoadCaseResult& result, const PerInterface<PatchField>& fields, std::size_t thread);
/// Friction, power, efficiency and film over the speed (Stribeck's curve).
Figure stribeck_figure(const LoadCaseResult& result, const StribeckCurve& curve);
Figure slip_residue_figure(const LoadCaseResult& result, const SlipPictures& pictures);

/// A point to compare with, as a measurement or the case that a sweep starts from.
struct ReferencePoint {
  std::string title;
  double x = 0.0;
  std::optional<double> power_loss = std::nullopt;  ///< [W]
  std::optional<double> efficiency = std::nullopt;
};

/// What a figure of a sweep may show besides its curves.
struct PowerFigureOptions {
  std::string name = "power_by_source";
  std::string title = "Power lost by source";
  std::optional<double> relative_to = std::nullopt;  ///< Shows power as a share of this [W].
  std::vector<ReferencePoint> references = {};
  std::string comparison_title = {};
  std::vector<std::array<double, 2>> comparison = {};  ///< (x, efficiency) of another model.
};

/// Power of each source, stacked, and efficiency over a swept quantity `x`, given as it is shown
/// (Sandu 2018, fig. 3.9). Results without an answer interrupt the areas; at least one has one.
Figure power_by_source_figure(const std::vector<double>& x, const Axis& axis, const std::vector<SlipResult>& results,
                              const PowerFigureOptions& options);

/// Power of each source and efficiency over the load of each range, at most four; else a bar for
/// each load case.
Figures power_by_source(const Result& result, const FigureOptions& options);

/// Temperatures of the parts over the cycle of the duty, their means dashed.
Figures heat_cycle(const Result& result);

/// What `slip` can show, and by their names what `solve` can. Both must outlive the list.
Pictures slip_pictures(const Case& c, const Result& result);

/// The thread of the largest power density.
struct HottestThread {
  Interface interface = Interface::screw;
  std::size_t thread = 0;             ///< From 1.
  std::optional<std::size_t> roller;  ///< From 1; of a full mechanism.
  std::optional<double> power;        ///< [W]
  double power_density = 0.0;         ///< [W/m^2]
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

/// Whether a load case has an answer to slip.
inline bool has_slip(const LoadCaseResult& result) { return result.slip && result.slip->converged(); }

inline bool is_held(const LoadCaseResult& result) { return result.slip && result.slip->is_held(); }

/// How the search for the slip ratio ended or, where the loads are not known, their solve.
inline std::string_view slip_status_name(const LoadCaseResult& result) {
  if (result.heat && !result.heat->converged()) return name(result.heat->status);
  if (result.slip) return name(result.slip->status);
  return result.converged() ? name(SlipStatus::not_computed) : status_name(result);
}

/// Absent where there are no densities.
std::optional<HottestThread> hottest_thread(const SlipResult& slip);

}  // namespace prs
