#pragma once

#include <map>

#include "prs/loads/analyze.h"
#include "prs/preload/preload_solver.h"
#include "prs/sector/roller_guides.h"

namespace prs {

/// Sectors by the sense of the load, without play and without preload.
using PreloadSectors = PerDirection<PreloadSector>;

/// Sections at which the first nut is held under each sense of the load [m]. Rigid shoulders of the housing: each sense
/// has its own; a single one holds both.
PerDirection<double> held_sections(const Structure::Thrust& thrust);

/// Both senses of a case with a block `preload`, its first contact at a position on the nut [m].
PreloadSectors preload_sectors(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                               double position, Play play = Play::of_cold_parts);

/// Fit of the case, with its first contact at `preload.position`, made at the reference temperature. The rollers float
/// at the temperatures of the sectors. Throws CaseError if no fit within the threads gives the preload force.
Fit preload_fit(const Conditions& c, const Contacts& contacts, const PreloadSectors& sectors);

/// The case with the interference for its preload force in place of the force, so that it is found once for many
/// temperatures. Throws CaseError as `preload_fit`.
Conditions with_interference(Conditions c, const Contacts& contacts);

/// Axial load of each side without external load, as the fit was made, at the reference temperature [N].
double reference_preload(const Conditions& c, const Contacts& contacts);

/// Equilibria of a fit under either sense of the load: one solver each, which differ in the section
/// that holds the nut.
class PreloadedMechanism {
 public:
  PreloadedMechanism(const PreloadSectors& sectors, const Fit& fit)
      : tension_(fitted(sectors.tension, fit)), compression_(fitted(sectors.compression, fit)) {}

  PreloadSolver& operator[](Direction d) { return d == Direction::tension ? tension_ : compression_; }
  /// Equilibrium under an external load [N], > 0 in tension.
  PreloadPoint solve(double axial_force) {
    return (*this)[axial_force < 0.0 ? Direction::compression : Direction::tension].solve(axial_force);
  }

 private:
  PreloadSolver tension_, compression_;
};

/// Load cases of a mechanism under preload, at rest: both flanks of its threads, or both nuts. The
/// fit is that of `preload.position`, the loads are those at the load case's. The case must have
/// passed `check_case` and the requirements of `preload`.
class FlankSolver {
 public:
  FlankSolver(const Conditions& c, const Contacts& contacts);

  /// Loads of the flank that the direction names, and of the other one. A load of 0 has no stiffness except the
  /// tangent, and no shares.
  LoadCaseResult solve(const LoadCase& load_case);

  /// Both sides of the last load case under pushes on the rollers, from the last state on. The pushes of a single nut
  /// belong to one roller: the centrifugal force is in one of them.
  PreloadPoint go_on(const LoadCase& load_case, const PerDirection<RollerPush>& push);

  /// R_near and R_far of the roller, or of one roller of each nut, first that of the named direction; none if rollers
  /// stay straight [N].
  std::vector<std::array<double, 2>> guide_forces(const PreloadPoint& point, Direction named,
                                                  const PerDirection<RollerPush>& push) const;

 private:
  struct At {
    PreloadedMechanism mechanism;
    PerDirection<std::optional<RollerGuides>> guides;
  };

  const Conditions& conditions_;
  const Contacts& contacts_;
  PerInterface<ContactLaw> laws_;
  PreloadSectors fitted_at_;  ///< Sectors with the fit's first contact.
  Fit fit_;
  std::map<double, At> at_position_;
  At* last_ = nullptr;
  PreloadSolver* solver_ = nullptr;
};

/// The result of a load case from both its sides.
LoadCaseResult both_flanks_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws, PreloadPoint point);

/// Displacement over external load, with stiffness and lost motion around zero.
struct PreloadCurve {
  std::vector<PreloadPoint> points;  ///< Points in the order of the case's loads.
  /// dF/du without external load, reached from either sense [N/m]; absent if the screw is loose.
  PerDirection<std::optional<double>> stiffness_at_zero;
  /// Displacement between the lost-motion load in tension and in compression [m].
  std::optional<double> lost_motion;
};

/// All results of `analyze_preload`. SI units.
struct PreloadResult {
  Preload preload;
  Contacts contacts;
  PerDirection<double> section;                    ///< Section that holds the first nut, by the sense of the load [m].
  PreloadPoint at_rest;                            ///< Equilibrium at the temperatures of the case.
  double reference_force = 0.0;                    ///< Axial load of each side at the reference temperature [N].
  double reference_temperature = 0.0;              ///< Reference temperature of the fit [K].
  std::optional<PerPart<double>> temperature;      ///< Temperatures of the parts, if different [K].
  std::optional<std::string> load_case;            ///< Load case whose heat determines them.
  HeatStatus heat_status = HeatStatus::converged;  ///< Status of that heat.
  std::optional<double> interference;              ///< Interference as in `Preload`; absent with play [m].
  /// External load at which the opposing side opens [N], > 0.
  PerDirection<std::optional<double>> opening_force;
  double lost_motion_load = 0.0;  ///< [N]
  PreloadCurve curve;
  std::optional<PreloadCurve> without_preload;  ///< Curve with neither preload nor play; absent with play.
  std::vector<Warning> warnings;

  /// Axial load of each side at the screw without external load, at the temperatures of the case
  /// [N].
  double force() const { return at_rest.sides.tension.axial_load.screw; }
  /// Largest peak pressure of a side [Pa]; absent if the geometry gives no contact.
  std::optional<double> peak_pressure(const SideLoads& loads) const;
  bool converged() const;
};

/// Contacts -> both sides' model -> fit -> equilibrium at each load. Reads and prints nothing. The case must have
/// passed `check_case` and the requirements of `preload`. A load that does not converge is a point with its status.
/// Throws CaseError if the geometry gives no contact and the case does not override it. With a block `heat` see
/// prs/heat/analyze_heat.h.
PreloadResult analyze_preload(const Conditions& c, Contacts contacts);
inline PreloadResult analyze_preload(const Case& c) {
  return analyze_preload(c, checked_contacts(c, Detail::complete));
}

}  // namespace prs
