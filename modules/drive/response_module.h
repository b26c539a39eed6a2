#pragma once

#include <cstddef>
#include <vector>

#include "modules/drive/drive.h"
#include "modules/module.h"

namespace prs {

/// Input of an integration, in SI units.
struct DriveRun {
  PrsDrive drive;
  PrsSignals signals;
  double duration, sample_interval;
  std::size_t samples;
  double tolerance;                            ///< Relative
  double fastest;                              ///< Highest frequency of the signals [Hz]; 0: none.
  const std::vector<double>* times = nullptr;  ///< Times of the samples, ascending; null: every interval.
};

/// An extreme of the whole run.
struct DrivePeak {
  double value = 0.0, time = 0.0;
  bool is_reached = false;
};

struct DriveImpact {
  double time = 0.0;
  int flank = 1;  ///< 1 tension, -1 compression
  double speed = 0.0, energy = 0.0;
  DrivePeak force = {};
};

enum class DriveStatus { converged, step_limit, integration_failed, left_shaft };

/// Results of a run; series have one value per sample.
struct DriveResult {
  DriveStatus status = DriveStatus::integration_failed;
  double stopped_at = 0.0, position = 0.0;
  std::vector<double> time, x, v, phi, omega, phi_m, omega_m, delta, force, motor_torque, coupling_torque, external,
      stop_force;
  std::vector<double> lever_angle, lever_speed, lever_torque;  ///< Empty without a lever.
  double motor = 0.0, load = 0.0, stored_start = 0.0, stored_end = 0.0, turnover = 0.0;
  double screw_friction = 0.0, motor_friction = 0.0, load_friction = 0.0;
  double coupling = 0.0, contact = 0.0, end_stop = 0.0, viscous = 0.0;
  DrivePeak tension, compression, torque, stop, error;
  double lost_motion = 0.0, torque_squared = 0.0, error_squared = 0.0;
  double largest_force = 0.0, largest_speed = 0.0;  ///< Largest magnitudes at the screw.
  double fastest = 0.0;                             ///< Bound of the frequency of vibrations [rad/s].
  double last_reference = 0.0;                      ///< Last reference of the controller, before a jump at the end.
  std::vector<DriveImpact> impacts;
};

/// Integration of the drive over time, by CVODE of SUNDIALS.
struct ResponseModule : modules::Module {
  static constexpr modules::Name kName{"prs_sundials.so", "SUNDIALS", "libsundials-dev", ""};

  void (*integrate)(const DriveRun& run, DriveResult& result);
};

}  // namespace prs
