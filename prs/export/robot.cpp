#include "prs/export/robot.h"

#include <Eigen/Dense>
#include <cmath>

#include "prs/report/report.h"
#include "prs/response/response.h"
#include "prs/version.h"

namespace prs {
namespace {

constexpr int kSteps = 10;

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

/// Least squares with no coefficient below 0: the best of all choices of columns.
Eigen::Vector3d fitted_above_zero(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y) {
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = y.squaredNorm();
  for (unsigned choice = 1; choice < 8; ++choice) {
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index k = 0; k < 3; ++k)
      if ((choice >> k & 1U) != 0) chosen.push_back(k);
    const Eigen::MatrixXd part = columns(Eigen::all, chosen);
    const Eigen::VectorXd found = part.colPivHouseholderQr().solve(y);
    const double rest = (part * found - y).squaredNorm();
    if (!(found.minCoeff() >= 0.0) || !(rest < least * (1.0 - 1e-12))) continue;
    least = rest;
    best.setZero();
    best(chosen) = found;
  }
  return best;
}

void fit_friction(const PrsCurves& curves, double speed, RobotConstants& robot) {
  const double r = 1.0 / robot.gear_ratio;
  Eigen::MatrixXd columns(2 * kSteps * (2 * kSteps + 1), 3);
  Eigen::VectorXd y(columns.rows());
  Eigen::Index row = 0;
  for (int i = -kSteps; i <= kSteps; ++i)
    for (int k = 1; k <= kSteps; ++k)
      for (const int sigma : {1, -1}) {
        const double force = robot.largest_force * i / kSteps, turning = speed * k / kSteps;
        columns.row(row) << 1.0, std::abs(force), std::abs(turning * r);
        y(row++) = std::abs(prs_friction_torque(&curves, force, turning, sigma) / r);
      }
  // Columns of one size.
  const Eigen::Vector3d size(1.0, robot.largest_force, std::abs(speed * r));
  for (Eigen::Index k = 0; k < 3; ++k) columns.col(k) /= size(k);
  const Eigen::Vector3d p = fitted_above_zero(columns, y);
  const Eigen::VectorXd error = columns * p - y;
  robot.largest_error = error.cwiseAbs().maxCoeff();
  robot.rms_error = std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
  robot.no_load = p(0);
  robot.per_load = p(1) / size(1);
  robot.per_speed = p(2) / size(2);
  double screw = 0.0, load = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double force = robot.largest_force * i / kSteps;
    const auto share = [&](int sigma) {
      return std::abs(prs_friction_torque(&curves, force, speed, sigma) / (force * r));
    };
    const int driving = r < 0.0 ? -1 : 1;
    screw += 1.0 / (1.0 + share(driving)) / kSteps;
    load += (1.0 - share(-driving)) / kSteps;
  }
  if (screw > 0.0) robot.screw_drives = screw;
  if (load > 0.0) robot.load_drives = load;
}

/// What both formats say of what they leave out.
std::string remarks(const RobotConstants& r, const ModelText& text) {
  return fmt::format(
      "  Planetary roller screw of {}, SHA-256 {}, by prs {}.\n"
      "  Friction is that under a load of {:.6g} N. Of the threads alone it is {:.6g} N + {:.6g} of the load\n"
      "  + {:.6g} N s/m of the speed, off by {:.4g} N at the most and {:.4g} N rms.\n"
      "  Lost: play ({:.4g} um), elasticity, friction that grows with the load and differs by sense.\n",
      html(text.case_file), text.case_sha256, kVersion, r.friction_load, r.no_load, r.per_load, r.per_speed,
      r.largest_error, r.rms_error, r.play * per_si::micrometre);
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
    fit_friction(curves.view(), speed, robot);
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
  json["play_um"] = r.play * per_si::micrometre;
  json["largest_force_N"] = r.largest_force;
  json["largest_speed_m_per_s"] = r.largest_speed;
  return json;
}

std::string mjcf(const ResponseInput& in, const RobotConstants& r, const ModelText& text) {
  const auto& [upper, lower] = in.end_stops;
  const std::string range =
      upper && lower ? fmt::format(" limited=\"true\" range=\"{:.17g} {:.17g}\"", lower->at, upper->at) : "";
  const bool bound = in.motor.controller && in.motor.controller->largest_torque;
  const double torque = bound ? *in.motor.controller->largest_torque : 0.0;
  return fmt::format(
      "<!--\n{}-->\n<mujoco model=\"{}\">\n  <worldbody>\n    <body name=\"load\">\n"
      "      <joint name=\"axis\" type=\"slide\" axis=\"1 0 0\" armature=\"{:.17g}\" frictionloss=\"{:.17g}\" "
      "damping=\"{:.17g}\" solimpfriction=\"0.9999 0.9999 0.001\"{}/>\n"
      "      <geom type=\"box\" size=\"0.05 0.05 0.05\" mass=\"{:.17g}\" contype=\"0\" conaffinity=\"0\"/>\n"
      "    </body>\n  </worldbody>\n  <actuator>\n"
      "    <motor name=\"motor\" joint=\"axis\" gear=\"{:.17g}\"{}/>\n  </actuator>\n</mujoco>\n",
      remarks(r, text), text.name, r.reflected_mass, r.friction_loss, r.damping, range, in.load.mass, r.gear_ratio,
      bound ? fmt::format(" ctrllimited=\"true\" ctrlrange=\"{:.17g} {:.17g}\"", -torque, torque) : "");
}

std::string urdf(const ResponseInput& in, const RobotConstants& r, const ModelText& text) {
  const auto& [upper, lower] = in.end_stops;
  const bool limited = upper && lower;
  const double inertia = 1e-3 * in.load.mass;
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<!--\n{}"
      "  Also lost: reflected_mass_kg {:.9g}, for which the format has no place; a simulator moves {:.6g} kg alone.\n"
      "-->\n<robot name=\"{}\">\n  <link name=\"base\"/>\n  <link name=\"load\">\n    <inertial>\n"
      "      <mass value=\"{:.17g}\"/>\n"
      "      <inertia ixx=\"{:.9g}\" ixy=\"0\" ixz=\"0\" iyy=\"{:.9g}\" iyz=\"0\" izz=\"{:.9g}\"/>\n"
      "    </inertial>\n  </link>\n  <joint name=\"axis\" type=\"prismatic\">\n    <parent link=\"base\"/>\n"
      "    <child link=\"load\"/>\n    <axis xyz=\"1 0 0\"/>\n"
      "    <dynamics damping=\"{:.17g}\" friction=\"{:.17g}\"/>\n"
      "    <limit lower=\"{:.17g}\" upper=\"{:.17g}\" effort=\"{:.17g}\" velocity=\"{:.17g}\"/>\n  </joint>\n</robot>\n",
      remarks(r, text), r.reflected_mass, in.load.mass, text.name, in.load.mass, inertia, inertia, inertia, r.damping,
      r.friction_loss, limited ? lower->at : -1.0, limited ? upper->at : 1.0, r.largest_force, r.largest_speed);
}

}  // namespace prs
