#include "prs/export/robot.h"

#include <cmath>
#include <regex>

#include "modules/response/response.h"
#include "prs/embed.h"
#include "prs/report/report.h"
#include "prs/version.h"

PRS_EMBED(mjcf_form, "prs/export/joint.mjcf.xml")
PRS_EMBED(urdf_form, "prs/export/joint.urdf")

namespace prs {
namespace {

double largest_speed_of(const Case& c, const SystemCurves& curves) {
  if (!curves.friction.speed.empty()) return curves.friction.speed.back();
  if (c.response->curves.speed) return std::abs(*c.response->curves.speed);
  double speed = c.operation ? std::abs(c.operation->speed) : 0.0;
  for (const LoadCase& load : c.load_cases) speed = std::max(speed, std::abs(load.speed.value_or(0.0)));
  if (!(speed > 0.0))
    throw CaseError("response.curves.speed",
                    "missing; expected the largest speed, which the file does not state elsewhere; add `curves: "
                    "{speed: 1200 rpm}`, for example");
  return speed;
}

/// Remarks, in both formats, on effects that are left out.
std::string remarks(const RobotConstants& r, const ModelText& text) {
  return fmt::format(
      "  Planetary roller screw of {}, SHA-256 {}, by prs {}.\n"
      "  Friction is that under a load of {:.6g} N. Of the threads alone it is {:.6g} N + {:.6g} of the load\n"
      "  + {:.6g} N s/m of the speed, off by {:.4g} N at the most and {:.4g} N rms.\n"
      "  Lost: play ({:.4g} um), elasticity, friction that grows with the load and differs by sense.\n",
      std::regex_replace(html(text.case_file), std::regex("--"), "-&#45;"), text.case_sha256, kVersion, r.friction_load,
      r.no_load, r.per_load, r.per_speed, r.largest_error, r.rms_error, r.play * "µm"_per_si);
}

}  // namespace

RobotConstants robot_constants(const Case& c, const SystemCurves& curves, std::optional<double> friction_load) {
  const ResponseInput& in = *c.response;
  const double r = curves.lead / (2.0 * std::numbers::pi);
  RobotConstants robot;
  robot.gear_ratio = 1.0 / r;
  robot.reflected_mass = (in.motor.inertia + in.screw.inertia) / (r * r);
  robot.largest_force = std::max(curves.senses.tension.force.back(), curves.senses.compression.force.back());
  const double speed = largest_speed_of(c, curves);
  robot.largest_speed = std::abs(speed * r);
  robot.play = curves.senses.tension.origin + curves.senses.compression.origin;
  if (curves.friction.speed.empty())
    robot.screw_drives = robot.load_drives = 1.0;
  else
    static_cast<FrictionFit&>(robot) = fit_friction(curves.view(), robot.largest_force, speed);
  robot.friction_load = friction_load.value_or(0.5 * robot.largest_force);
  robot.friction_loss = robot.no_load + robot.per_load * robot.friction_load +
                        (in.screw.drag_torque + in.motor.friction_torque) / std::abs(r) + in.load.friction_force;
  robot.damping = robot.per_speed + in.motor.damping / (r * r) + in.load.damping;
  return robot;
}

nlohmann::ordered_json robot_json(const RobotConstants& r) {
  nlohmann::ordered_json json{{"gear_ratio_rad_per_m", r.gear_ratio},
                              {"reflected_mass_kg", r.reflected_mass},
                              {"friction_no_load_N", r.no_load},
                              {"friction_per_load", r.per_load},
                              {"friction_per_speed_N_s_per_m", r.per_speed},
                              {"friction_load_N", r.friction_load},
                              {"friction_loss_N", r.friction_loss},
                              {"damping_N_s_per_m", r.damping},
                              {"friction_error_largest_N", r.largest_error},
                              {"friction_error_rms_N", r.rms_error}};
  auto efficiency = nlohmann::ordered_json::object();
  if (r.screw_drives) efficiency["screw_drives"] = *r.screw_drives;
  if (r.load_drives) efficiency["load_drives"] = *r.load_drives;
  json["efficiency"] = std::move(efficiency);
  json["play_um"] = r.play * "µm"_per_si;
  json["largest_force_N"] = r.largest_force;
  json["largest_speed_m_per_s"] = r.largest_speed;
  return json;
}

namespace {

std::string joint(std::string_view form, const ResponseInput& in, const RobotConstants& r, const ModelText& text) {
  const auto& [upper, lower] = in.end_stops;
  const bool limited = upper && lower;
  const double least = limited ? lower->at : -1.0, most = limited ? upper->at : 1.0;
  const auto bounds = [](const char* flag, const char* name, double from, double to) {
    return fmt::format(" {}=\"true\" {}=\"{:.17g} {:.17g}\"", flag, name, from, to);
  };
  const auto& controller = in.motor.controller;
  const double torque = controller ? controller->largest_torque.value_or(0.0) : 0.0;
  return fmt::format(fmt::runtime(form), fmt::arg("remarks", remarks(r, text)), fmt::arg("name", text.name),
                     fmt::arg("start", in.start.position), fmt::arg("start_speed", in.start.speed),
                     fmt::arg("reflected", r.reflected_mass), fmt::arg("friction", r.friction_loss),
                     fmt::arg("damping", r.damping), fmt::arg("mass", in.load.mass),
                     fmt::arg("range", limited ? bounds("limited", "range", least, most) : ""),
                     fmt::arg("gear", r.gear_ratio),
                     fmt::arg("control", torque > 0.0 ? bounds("ctrllimited", "ctrlrange", -torque, torque) : ""),
                     fmt::arg("inertia", 1e-3 * in.load.mass), fmt::arg("lower", least), fmt::arg("upper", most),
                     fmt::arg("effort", r.largest_force), fmt::arg("velocity", r.largest_speed));
}

}  // namespace

std::string mjcf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text) {
  return joint(mjcf_form(), input, robot, text);
}
std::string urdf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text) {
  return joint(urdf_form(), input, robot, text);
}

}  // namespace prs
