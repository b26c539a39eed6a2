#include "prs/export/robot.h"

#include <fmt/args.h>

#include <cmath>
#include <regex>

#include "modules/response/response.h"
#include "prs/embed.h"
#include "prs/report/report.h"
#include "prs/text.h"
#include "prs/version.h"

PRS_EMBED(mjcf_form, "prs/export/joint.mjcf.xml")
PRS_EMBED(mjcf_play_form, "prs/export/joint.play.xml")
PRS_EMBED(rotor_form, "prs/export/joint.rotor.xml")
PRS_EMBED(coupling_form, "prs/export/joint.coupling.xml")
PRS_EMBED(callback_form, "prs/export/joint.friction.py.in")
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

constexpr int kForces = 12, kSpeeds = 6;

/// Nodes at equal ratios.
std::vector<double> geometric(double first, double last, int count) {
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k) nodes.push_back(first * std::pow(last / first, k / (count - 1.0)));
  return nodes;
}

/// Friction of the threads over the lead [N] while the screw drives the load, or the load the screw.
double friction_force(const PrsCurves& curves, double r, double force, double speed, bool drives) {
  const int sense = (force < 0.0) == (r < 0.0) ? 1 : -1;
  return std::abs(prs_friction_torque(&curves, force, speed / std::abs(r), drives ? sense : -sense) / r);
}

LossTable losses_of(const SystemCurves& curves, const PrsCurves& view, double r, const RobotConstants& robot) {
  LossTable table;
  if (curves.friction.speed.empty()) return {{robot.largest_force}, {robot.largest_speed}, {{0.0}}, {{0.0}}};
  double least = robot.largest_force;
  for (const double root : curves.friction.root_force) least = std::min(least, root * root);
  table.force = geometric(std::max(least, 1e-4 * robot.largest_force), robot.largest_force, kForces);
  table.speed = geometric(curves.friction.speed.front() * std::abs(r), robot.largest_speed, kSpeeds);
  for (const bool drives : {true, false}) {
    std::vector<std::vector<double>>& rows = drives ? table.drive : table.back;
    const auto both = [&](double force, double speed) {
      return std::pair{friction_force(view, r, force, speed, drives), friction_force(view, r, -force, speed, drives)};
    };
    for (const double speed : table.speed)
      for (std::vector<double>& row = rows.emplace_back(); const double force : table.force) {
        const auto [tension, compression] = both(force, speed);
        row.push_back(0.5 * (tension + compression) / force);
      }
    for (std::size_t i = 0; i + 1 < table.speed.size(); ++i)
      for (std::size_t k = 0; k + 1 < table.force.size(); ++k) {
        const double force = std::sqrt(table.force[k] * table.force[k + 1]);
        const auto [tension, compression] = both(force, std::sqrt(table.speed[i] * table.speed[i + 1]));
        const double mean = 0.25 * force * (rows[i][k] + rows[i][k + 1] + rows[i + 1][k] + rows[i + 1][k + 1]);
        table.largest_error = std::max({table.largest_error, std::abs(tension - mean), std::abs(compression - mean)});
      }
  }
  return table;
}

/// One digit, rounded down.
double one_digit(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return unit * std::floor(value / unit);
}

JointSpring spring_of(const PrsDrive& drive, const ResponseInput& in, double r, const RobotConstants& robot) {
  constexpr int kNodes = 24;
  JointSpring s;
  const PrsCurves& curves = drive.curves;
  s.can_open = curves.tension.root != 0 || curves.compression.root != 0;
  s.play_tension = curves.tension.origin;
  s.play_compression = curves.compression.origin;
  const auto deflection = [&](double force) { return prs_static_deflection(&drive, force, drive.start_position); };
  const auto add = [&](double at, double force) {
    s.deflection.push_back(at);
    s.force.push_back(force);
  };
  // Nodes are denser at small forces, where flanks begin to touch; the last one is far beyond the curves.
  const auto force_of = [&](int k) {
    return k > kNodes ? 10.0 * robot.largest_force : robot.largest_force * std::pow(k / double{kNodes}, 2.0);
  };
  for (int k = kNodes + 1; k > 0; --k) add(deflection(-force_of(k)), -force_of(k));
  if (robot.play > 0.0) add(-s.play_compression, 0.0);
  add(s.play_tension, 0.0);
  for (int k = 1; k <= kNodes + 1; ++k) add(deflection(force_of(k)), force_of(k));
  BoundSignal load(in.load.force.terms());
  load.bind(0.0);
  s.start = in.start.deflection.value_or(deflection(load.at(0.0).value));
  const double force = std::max(robot.friction_load, 1e-3 * robot.largest_force);
  s.stiffness = 2.0 * force / (deflection(force) - deflection(-force) - robot.play);
  s.time = drive.material_damping;
  s.damping = s.stiffness * s.time;
  const std::size_t last = s.force.size() - 2;
  const double steepest = (s.force[last] - s.force[last - 1]) / (s.deflection[last] - s.deflection[last - 1]);
  double squared = steepest / drive.mass;
  if (drive.coupled != 0) {
    double c = 0.0, slope = 0.0, way = 0.0, tangent = 0.0;
    prs_shaft_compliance(&drive, drive.start_position, &c, &slope);
    s.twist = r * r * prs_series_force(&curves, s.start, c, &way, &tangent) / drive.coupling_stiffness;
    squared += steepest * r * r / drive.screw_inertia +
               drive.coupling_stiffness * (1.0 / drive.screw_inertia + 1.0 / drive.motor_inertia);
  } else {
    squared += steepest / robot.reflected_mass;
  }
  s.step = one_digit(0.1 / std::sqrt(squared));
  return s;
}

struct FrictionLoad {
  double force;
  const char* of;
};

/// Root mean square force of the case's run, half of the largest force where it does not come to its end.
FrictionLoad friction_load_of(const PrsDrive& drive, const ResponseInput& input, double largest) {
  try {
    const DriveResult run = run_drive(drive, input);
    if (run.status == DriveStatus::converged) {
      double sum = 0.0;
      for (const double force : run.force) sum += force * force;
      return {std::sqrt(sum / static_cast<double>(run.force.size())), "root mean square of the run of `response`"};
    }
  } catch (const modules::Missing&) {  // No integrator.
  } catch (const CaseError&) {         // The nut leaves the shaft.
  }
  return {0.5 * largest, "half of the largest, as the run of `response` does not come to its end here"};
}

std::string rows_of(std::string_view title, const std::vector<std::vector<double>>& rows, const LossTable& table) {
  std::string lines = fmt::format("  {}\n    speed, m/s", title);
  for (const double force : table.force) lines += fmt::format(" {:>8.4g} N", force);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lines += fmt::format("\n    {:>10.4g}", table.speed[i]);
    for (const double c : rows[i]) lines += fmt::format(" {:>10.4f}", c);
  }
  return lines + '\n';
}

/// Name and origin of the case.
std::string origin(const ModelText& text) {
  return fmt::format("Planetary roller screw of {}, SHA-256 {}, by prs {}.", text.case_file, text.case_sha256,
                     kVersion);
}

/// Slowest sliding at which the callback has the whole friction, but for 1 - tanh 1 [m/s].
double slow(const RobotConstants& r) { return 1e-3 * r.largest_speed; }

/// Remarks, in both formats, on what friction is there and on effects that are left out.
std::string remarks(const RobotConstants& r, const ModelText& text) {
  std::string lines = fmt::format(
      "  {}\n"
      "  Friction is a force in N, as `frictionloss` of MuJoCo's slides and `friction` of prismatic joints in ROS and\n"
      "  Gazebo are (of hinges a torque in N m), never a coefficient. It is that under a load of {:.6g} N,\n"
      "  {}. Of the threads alone it is {:.6g} N + {:.6g} of the load\n"
      "  + {:.6g} N s/m of the speed, off by {:.4g} N at the most and {:.4g} N rms.\n",
      std::regex_replace(html(origin(text)), std::regex("--"), "-&#45;"), r.friction_load, r.friction_load_of,
      r.no_load, r.per_load, r.per_speed, r.largest_error, r.rms_error);
  lines += fmt::format(
      "  By force F and sense, friction is (c |F| + {:.6g} N) tanh(v/v_0) with v_0 = {:.4g} m/s: c_drive where the\n"
      "  screw drives, c_back where the load does. Threads are within {:.4g} N of these tables, drag is that of "
      "motor,\n"
      "  bearings and seals; at rest it creeps, under half of the friction with 0.55 v_0.\n",
      r.drag, slow(r), r.losses.largest_error);
  lines += rows_of("c_drive = 1/eta_drive - 1", r.losses.drive, r.losses);
  return lines + rows_of("c_back = 1 - eta_back", r.losses.back, r.losses);
}

}  // namespace

RobotConstants robot_constants(const SystemModel& model, std::optional<double> friction_load, bool play_joint) {
  const SystemCurves& curves = model.curves;
  const ResponseInput& in = *model.drive;
  const double r = curves.lead / (2.0 * std::numbers::pi);
  const PrsDrive drive = drive_of(*model.case_with_drive, in, curves);
  RobotConstants robot;
  robot.play_joint = play_joint;
  robot.gear_ratio = 1.0 / r;
  robot.reflected_mass = (in.motor.inertia + in.screw.inertia) / (r * r);
  if (play_joint && !(in.coupling ? std::min(in.motor.inertia, in.screw.inertia) > 0.0 : robot.reflected_mass > 0.0))
    throw CaseError(in.screw.inertia > 0.0 ? "response.motor.inertia" : "response.screw.inertia",
                    "missing; expected the inertia of each part in front of the play; state it, or leave out --play");
  robot.largest_force = std::max(curves.senses.tension.force.back(), curves.senses.compression.force.back());
  const double speed = largest_speed_of(*model.case_with_drive, curves);
  robot.largest_speed = std::abs(speed * r);
  robot.play = curves.senses.tension.origin + curves.senses.compression.origin;
  if (curves.friction.speed.empty())
    robot.screw_drives = robot.load_drives = 1.0;
  else
    static_cast<FrictionFit&>(robot) = fit_friction(drive.curves, robot.largest_force, speed);
  const FrictionLoad load = friction_load ? FrictionLoad{*friction_load, "as stated by the option `friction-load`"}
                                          : friction_load_of(drive, in, robot.largest_force);
  robot.friction_load = load.force;
  robot.friction_load_of = load.of;
  robot.rotor_friction = in.motor.friction_torque / std::abs(r);
  robot.drag = in.screw.drag_torque / std::abs(r) + robot.rotor_friction;
  robot.friction_loss = robot.no_load + robot.per_load * robot.friction_load + robot.drag + in.load.friction_force;
  robot.motor_damping = in.motor.damping / (r * r);
  robot.damping = robot.per_speed + robot.motor_damping + in.load.damping;
  robot.losses = losses_of(curves, drive.curves, r, robot);
  if (play_joint) robot.spring = spring_of(drive, in, r, robot);
  return robot;
}

nlohmann::ordered_json robot_json(const RobotConstants& r) {
  nlohmann::ordered_json json{{"gear_ratio_rad_per_m", r.gear_ratio},
                              {"reflected_mass_kg", r.reflected_mass},
                              {"friction_no_load_N", r.no_load},
                              {"friction_per_load", r.per_load},
                              {"friction_per_speed_N_s_per_m", r.per_speed},
                              {"friction_load_N", r.friction_load},
                              {"friction_load_of", r.friction_load_of},
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
  json["losses"] = {{"force_N", r.losses.force},
                    {"speed_m_per_s", r.losses.speed},
                    {"c_drive", r.losses.drive},
                    {"c_back", r.losses.back},
                    {"drag_N", r.drag},
                    {"v_0_m_per_s", slow(r)},
                    {"largest_error_N", r.losses.largest_error}};
  if (r.play_joint)
    json["joint"] = {{"stiffness_N_per_um", r.spring.stiffness * 1e-6},
                     {"damping_N_s_per_m", r.spring.damping},
                     {"time_step_s", r.spring.step}};
  return json;
}

namespace {

std::string joint(std::string_view form, const ResponseInput& in, const RobotConstants& r, const ModelText& text) {
  const auto& [upper, lower] = in.end_stops;
  const bool limited = upper && lower, one = !r.play_joint;
  const double least = limited ? lower->at : -1.0, most = limited ? upper->at : 1.0;
  const auto bounds = [](const char* flag, const char* name, double from, double to) {
    return fmt::format(" {}=\"true\" {}=\"{:.17g} {:.17g}\"", flag, name, from, to);
  };
  const auto& controller = in.motor.controller;
  const double torque = controller ? controller->largest_torque.value_or(0.0) : 0.0;
  const JointSpring& s = r.spring;
  const double lead = 1.0 / std::abs(r.gear_ratio), squared = lead * lead;
  const bool coupled = !one && in.coupling.has_value();
  const double screw = coupled ? in.screw.inertia / squared : r.reflected_mass;
  // Limits take stiffness and damping over the mass that both sides have together.
  const double both = one ? 1.0 : 1.0 / (1.0 / screw + 1.0 / in.load.mass);
  const std::string flanks = r.play > 0.0
                                 ? bounds("limited", "range", -s.play_tension, s.play_compression) +
                                       fmt::format(" solreflimit=\"{:.9g} {:.9g}\" solimplimit=\"0.0001 0.0001 0.001\"",
                                                   -s.stiffness / both, -s.damping / both)
                                 : fmt::format(" stiffness=\"{:.9g}\" damping=\"{:.9g}\"", s.stiffness, s.damping);
  // Nothing in a docstring may end it.
  std::string plain = wrapped(printable(origin(text)), "", 100);
  std::ranges::replace(plain, '"', '\'');
  std::ranges::replace(plain, '\\', '/');
  const auto list = [](const std::vector<double>& values) { return fmt::format("[{:.9g}]", fmt::join(values, ", ")); };
  const auto table = [&](const std::vector<std::vector<double>>& rows) {
    std::string lines;
    for (const std::vector<double>& row : rows) lines += fmt::format("    [{:.6g}],\n", fmt::join(row, ", "));
    return "[\n" + lines + "]";
  };
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  const auto set = [&](const char* name, const auto& value) { values.push_back(fmt::arg(name, value)); };
  const auto filled = [&](std::string_view part) { return fmt::vformat(part, values); };
  set("remarks", remarks(r, text));
  set("name", text.name);
  set("origin", plain);
  set("start", in.start.position);
  set("start_speed", in.start.speed);
  set("reflected", r.reflected_mass);
  set("friction", r.friction_loss);
  set("damping", r.damping);
  set("mass", in.load.mass);
  set("range", limited ? bounds("limited", "range", least, most) : "");
  set("gear", r.gear_ratio);
  set("control", torque > 0.0 ? bounds("ctrllimited", "ctrlrange", -torque, torque) : "");
  set("inertia", 1e-3 * in.load.mass);
  set("lower", least);
  set("upper", most);
  set("effort", r.largest_force);
  set("velocity", r.largest_speed);
  set("play", r.play * "µm"_per_si);
  // Slides of rotor, screw and load.
  set("flanks", flanks);
  set("both", both);
  set("stiffness", s.stiffness);
  set("contact_damping", s.damping);
  set("step", s.step);
  set("load_friction", in.load.friction_force);
  set("load_damping", in.load.damping);
  set("screw_mass", screw);
  set("screw_friction", r.friction_loss - in.load.friction_force - (coupled ? r.rotor_friction : 0.0));
  set("screw_damping", r.per_speed + (coupled ? 0.0 : r.motor_damping));
  set("rotor_mass", in.motor.inertia / squared);
  set("rotor_friction", r.rotor_friction);
  set("motor_damping", r.motor_damping);
  set("twist_stiffness", coupled ? in.coupling->stiffness / squared : 0.0);
  set("twist_damping", coupled ? in.coupling->damping / squared : 0.0);
  set("driven", coupled ? "motor" : "screw");
  const double place = in.start.position + s.start;
  set("start_places",
      (coupled ? fmt::format("{:.17g} ", place + s.twist) : "") + fmt::format("{:.17g} {:.17g}", place, -s.start));
  set("start_speeds",
      (coupled ? fmt::format("{:.17g} ", in.start.speed) : "") + fmt::format("{:.17g} 0", in.start.speed));
  set("rotor", coupled ? filled(rotor_form()) : "");
  set("coupling", coupled ? filled(coupling_form()) : "");
  // The callback.
  set("screw", one ? "axis" : "screw");
  set("gap", one ? "" : "gap");
  set("moved", one ? screw + in.load.mass : screw);
  set("guides", one ? in.load.friction_force : 0.0);
  set("own_damping", one ? r.motor_damping + in.load.damping : coupled ? 0.0 : r.motor_damping);
  set("screw_drag", coupled ? r.drag - r.rotor_friction : r.drag);
  set("slow", slow(r));
  set("forces", list(r.losses.force));
  set("speeds", list(r.losses.speed));
  set("drive", table(r.losses.drive));
  set("back", table(r.losses.back));
  set("deflections", list(s.deflection));
  set("flank_forces", list(s.force));
  set("can_open", s.can_open ? "True" : "False");
  set("time", s.time);
  return filled(form);
}

}  // namespace

std::string mjcf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text) {
  return joint(robot.play_joint ? mjcf_play_form() : mjcf_form(), input, robot, text);
}
std::string urdf(const ResponseInput& input, const RobotConstants& robot, const ModelText& text) {
  return joint(urdf_form(), input, robot, text);
}
OutputFile mujoco_callback(const ResponseInput& input, const RobotConstants& robot, ModelText text,
                           const std::string& mjcf_file) {
  text.name = model_name(std::regex_replace(mjcf_file, std::regex("\\.mjcf\\.xml$"), ".xml")) + "_friction";
  return {text.name + ".py", joint(callback_form(), input, robot, text)};
}

}  // namespace prs
