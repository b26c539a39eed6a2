#pragma once

#include <optional>
#include <vector>

#include "modules/drive/drive.h"

namespace prs {

struct Resonance {
  double frequency = 0.0;  ///< |lambda|/(2 pi) [Hz]
  double damping = 0.0;    ///< -Re lambda/|lambda|
};

/// State about which a drive vibrates, and its excitation.
struct WorkingPoint {
  double force = 0.0;      ///< [N]
  double position = 0.0;   ///< [m]
  double speed = 0.0;      ///< Speed of a rolling screw [rad/s]; 0: held
  bool of_torque = false;  ///< Whether the motor's torque is varied, else a force on the load.
};

/// Small vibration; compliance and stiffness for a force, the others for a motor torque.
struct FrequencyResponse {
  bool of_torque = false;
  double tangent_stiffness = 0.0;  ///< 0 if flanks do not touch.
  std::vector<double> frequency = {}, compliance = {}, phase = {}, stiffness = {};
  std::vector<double> motor_speed = {}, motor_speed_phase = {}, position = {}, position_phase = {};
  std::vector<Resonance> resonances = {};
};

/// Solution of (A - w^2 M + i w D) X = input at each frequency [Hz].
FrequencyResponse small_vibration(const PrsDrive& drive, const WorkingPoint& point, std::vector<double> frequency);

}  // namespace prs
