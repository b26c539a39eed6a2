#pragma once

#include <array>

#include "modules/drive/response_module.h"
#include "modules/drive/small_vibration.h"
#include "prs/curves/system_curves.h"
#include "prs/record/csv_writer.h"
#include "prs/record/record.h"

namespace prs {

constexpr std::string_view name(DriveStatus s) {
  return s == DriveStatus::converged ? "converged" : s == DriveStatus::step_limit ? "step_limit" : "integration_failed";
}

/// Curves of the drive's screw for the block `response`: friction of static loads and the external force only, unless
/// the case states running ones.
SystemCurves response_curves(const Case& c, const CurveOptions& asked = {});

/// The block with the points of the files that its signals name. Throws InputError for a file, CaseError for errors in
/// the points.
ResponseInput with_signal_files(const Case& c, const input::Source& source);

/// The drive in the form for the equations; valid as long as the curves.
PrsDrive drive_of(const Case& c, const ResponseInput& input, const SystemCurves& curves);

/// The most loaded thread of an interface under the largest force.
struct MostLoaded {
  double normal_load = 0.0;  ///< [N]
  int thread = 1;
  std::optional<double> peak_pressure;  ///< [Pa]
};

/// A largest force of the run and the threads under it; none for a small force.
struct LargestForce {
  double force = 0.0, time = 0.0;
  std::optional<PerInterface<MostLoaded>> threads = {};  ///< Most loaded threads; without preload.
  std::optional<double> normal_load = {};                ///< Normal load of both sides, present with preload [N].
  std::optional<double> peak_pressure = {};              ///< Largest peak pressure [Pa].
  std::optional<ContactPressure> pressure = {};          ///< The one nearest to its limit.
};

struct SettlingResult {
  double final_position = 0.0;
  std::optional<double> reference = {};  ///< Reference of a position loop, at the end.
  std::optional<bool> settled = {};
  std::optional<double> time = {};
};

struct FollowingError {
  bool of_position = true;
  double largest = 0.0, time = 0.0, rms = 0.0;
};

/// A loss of energy in a run, with its name in tables and pictures.
struct EnergyLoss {
  const char* name;
  double DriveResult::*energy;
};
inline constexpr EnergyLoss kEnergyLosses[] = {{"screw friction", &DriveResult::screw_friction},
                                               {"motor friction", &DriveResult::motor_friction},
                                               {"load friction", &DriveResult::load_friction},
                                               {"coupling", &DriveResult::coupling},
                                               {"material", &DriveResult::contact},
                                               {"end stops", &DriveResult::end_stop},
                                               {"viscous", &DriveResult::viscous}};

/// Integration of a drive over the signals of its block. Throws CaseError where the nut leaves the shaft, and
/// modules::Missing.
DriveResult run_drive(const PrsDrive& drive, const ResponseInput& input, const std::vector<double>* times = nullptr);

/// Everything that `analyze_response` computes, SI units.
struct ResponseResult {
  ResponseInput input;
  bool has_preload = false;
  DriveResult run;
  PerDirection<std::optional<LargestForce>> largest;
  std::optional<FollowingError> following_error;
  std::optional<SettlingResult> settling;
  std::optional<FrequencyResponse> frequency_response;
  bool can_open = true;
  std::string load_case = {};                     ///< Load case with the position and conditions of the curves.
  double curves_force = 0.0, curves_speed = 0.0;  ///< Ends of the curves [N], [rad/s]; speed 0 without friction.
  std::vector<Warning> warnings;

  bool converged() const { return run.status == DriveStatus::converged; }
  double residual() const;
  double rms_torque() const;
  bool has_stops() const { return input.end_stops.upper || input.end_stops.lower; }
};

/// Curves -> equations -> integration -> results. The case must have passed `check_case` and the
/// requirements of `response`. Throws CaseError, InputError and modules::Missing. `times`: of the
/// samples, ascending, in place of every interval.
ResponseResult analyze_response(const Case& c, const input::Source& source, const std::vector<double>* times = nullptr);

/// A lever over its motion, as its screw sees it. SI units.
struct LeverMotion {
  PrsLinkage linkage;
  double inertia = 0.0;
  std::array<double, 2> angles = {};  ///< Smallest and largest angle.
  double lead = 0.0;                  ///< Lead of the screw; 0 if it is not known.

  PrsLever at(double share) const { return prs_lever(&linkage, angles[0] + share * (angles[1] - angles[0])); }
  PrsLever middle() const { return at(0.5); }
  double reflected_mass(const PrsLever& lever) const { return inertia / (lever.ratio * lever.ratio); }
  /// Turns of the screw per turn of the lever.
  double gear_ratio(const PrsLever& lever) const { return lever.ratio * 2.0 * std::numbers::pi / lead; }
};
Record<LeverMotion> record_of(Type<LeverMotion>);

/// The lever of a drive between its end stops, else from 1 to 179 deg; none without a linkage.
std::optional<LeverMotion> lever_motion(const ResponseInput& input, double lead);

/// Ratio, mass and inertia over the angle, in the middle too; those of the screw only with a lead.
std::string linkage_csv(const LeverMotion& motion, const CsvStyle& style);

}  // namespace prs
