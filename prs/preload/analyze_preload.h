#pragma once

#include "prs/loads/analyze.h"
#include "prs/loads/heat_result.h"
#include "prs/preload/preload_solver.h"

namespace prs {

/// Displacement over external load, with stiffness and lost motion around zero.
struct PreloadCurve {
  std::vector<PreloadPoint> points;  ///< In the order of the case's loads.
  /// dF/du without external load, reached from either sense [N/m]; absent where the screw is loose.
  PerDirection<std::optional<double>> stiffness_at_zero;
  /// Displacement between the lost-motion load in tension and in compression [m].
  std::optional<double> lost_motion;
};

/// Everything that `analyze_preload` computes from a case. SI units.
struct PreloadResult {
  Preload preload;
  Contacts contacts;
  PerDirection<double> section;  ///< Where the first nut is held, by the sense of the load [m].
  PreloadPoint at_rest;          ///< At the temperatures of the case.
  double reference_force = 0.0;  ///< Axial load of each side where the fit was made [N].
  double reference_temperature = 0.0;              ///< There [K].
  std::optional<PerPart<double>> temperature;      ///< Of the parts, where not that [K].
  std::optional<std::string> load_case;            ///< From whose heat they follow.
  HeatStatus heat_status = HeatStatus::converged;  ///< Of that heat.
  std::optional<double> interference;  ///< As `Preload::interference`; absent with play [m].
  /// External load at which the side that opposes it opens [N], > 0.
  PerDirection<std::optional<double>> opening_force;
  double lost_motion_load = 0.0;  ///< [N]
  PreloadCurve curve;
  std::optional<PreloadCurve> without_preload;  ///< Neither preload nor play; absent with play.
  std::vector<Warning> warnings;

  /// Axial load of each side at the screw without external load, at the temperatures of the case
  /// [N].
  double force() const { return at_rest.sides.tension.axial_load.screw; }
  /// Largest peak pressure of a side [Pa]; absent where the geometry gives no contact.
  std::optional<double> peak_pressure(const SideLoads& loads) const;
  bool converged() const;
};

/// Contacts -> both sides' model -> fit -> equilibrium at each load. Reads nothing, prints nothing.
/// The case must have passed `check_case` and the requirements of `preload`. A load that does not
/// converge is a point with its status. Throws CaseError where the geometry gives no contact and
/// the case does not override it.
/// With a block `heat` see prs/heat/warm_preload.h.
PreloadResult analyze_preload(const Conditions& c, Contacts contacts);
inline PreloadResult analyze_preload(const Case& c) {
  return analyze_preload(c, checked_contacts(c, Detail::complete));
}

}  // namespace prs
