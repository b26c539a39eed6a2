#pragma once

#include "modules/drive/friction_fit.h"
#include "prs/export/system_model.h"
#include "prs/record/delivery.h"

namespace prs {

/// Friction of the threads as a coefficient c of the transmitted force, by force and speed: 1/eta - 1 where the screw
/// drives, 1 - eta where the load does.
struct LossTable {
  std::vector<double> force, speed;              ///< Ascending, > 0 [N], [m/s].
  std::vector<std::vector<double>> drive, back;  ///< A row per speed.
  double largest_error = 0.0;                    ///< Between the nodes, in both senses of the force [N].
};

/// Screw and shaft as a spring between the slides of screw and load.
struct JointSpring {
  std::vector<double> deflection, force;  ///< Nodes of both senses, rising [m], [N].
  double play_tension = 0.0, play_compression = 0.0;
  double stiffness = 0.0, damping = 0.0;  ///< Secant of a closed flank at the friction load [N/m], [N s/m].
  double time = 0.0;                      ///< Damping over stiffness [s].
  bool can_open = true;
  double start = 0.0, twist = 0.0;  ///< Deflections of screw and coupling at the start [m].
  double step = 0.0;                ///< Step of time that follows the fastest vibration [s].
};

/// Constants of a drive for robot simulators: one mass, one friction, one damping (docs/response.md).
struct RobotConstants : FrictionFit {
  double gear_ratio = 0.0;                          ///< 1/r, signed [rad/m]
  double reflected_mass = 0.0;                      ///< [kg]
  double friction_loss = 0.0, friction_load = 0.0;  ///< [N]
  std::string friction_load_of;                     ///< Origin of that load.
  double damping = 0.0;                             ///< [N s/m]
  double play = 0.0, largest_force = 0.0, largest_speed = 0.0;
  double drag = 0.0;                                 ///< Dry friction of motor, bearings and seals [N]
  double rotor_friction = 0.0, motor_damping = 0.0;  ///< Parts of the motor [N], [N s/m]
  LossTable losses;
  JointSpring spring;
  bool play_joint = false;  ///< Whether the play is a joint of its own, in MuJoCo's format.
};

/// Constants of a model with its drive; the friction load is by default the root mean square force of the case's run.
/// Throws CaseError if there is no largest speed, or no inertia in front of the joint of the play.
RobotConstants robot_constants(const SystemModel& model, std::optional<double> friction_load, bool play_joint);

nlohmann::ordered_json robot_json(const RobotConstants& robot);

/// MuJoCo's format, and that of ROS.
std::string mjcf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text);
std::string urdf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text);

/// The Python module with MuJoCo's passive callback, friction by force, sense and speed, beside a file of its format:
/// `screw_friction.py` beside `screw.mjcf.xml`.
OutputFile mujoco_callback(const ResponseInput& input, const RobotConstants& robot, ModelText text,
                           const std::string& mjcf_file);

}  // namespace prs
