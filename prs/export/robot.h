#pragma once

#include "modules/drive/friction_fit.h"
#include "prs/export/system_model.h"

namespace prs {

/// Constants of a drive for robot simulators: one mass, one friction, one damping (docs/response.md).
struct RobotConstants : FrictionFit {
  double gear_ratio = 0.0;                          ///< 1/r, signed [rad/m]
  double reflected_mass = 0.0;                      ///< [kg]
  double friction_loss = 0.0, friction_load = 0.0;  ///< [N]
  double damping = 0.0;                             ///< [N s/m]
  double play = 0.0, largest_force = 0.0, largest_speed = 0.0;
};

/// Constants of a case. Throws CaseError if there is no largest speed.
RobotConstants robot_constants(const Case& c, const SystemCurves& curves, std::optional<double> friction_load);

nlohmann::ordered_json robot_json(const RobotConstants& robot);

/// MuJoCo's format, and that of ROS.
std::string mjcf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text);
std::string urdf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text);

}  // namespace prs
