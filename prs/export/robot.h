#pragma once

#include "prs/export/system_model.h"
#include "prs/record/delivery.h"

namespace prs {

/// Constants of a drive for robot simulators (docs/response.md), with the keys of the document: one mass, one friction,
/// one damping; friction by force, speed and sense; MuJoCo's slides, where the play may have a joint of its own. The
/// friction load is by default the root mean square force of the case's run. Throws CaseError if there is no largest
/// speed, or no inertia in front of the joint of the play.
nlohmann::ordered_json robot_constants(const SystemModel& model, std::optional<double> friction_load, bool play_joint);

/// MuJoCo's format, and that of ROS.
std::string mjcf(const ResponseInput& input, const nlohmann::ordered_json& robot, const ModelText& text);
std::string urdf(const ResponseInput& input, const nlohmann::ordered_json& robot, const ModelText& text);

/// The Python module with MuJoCo's passive callback, friction by force, sense and speed, beside a file of its format:
/// `screw_friction.py` beside `screw.mjcf.xml`.
OutputFile mujoco_callback(const ResponseInput& input, const nlohmann::ordered_json& robot, ModelText text,
                           const std::string& mjcf_file);

}  // namespace prs
