#include "prs/export/robot.h"

#include <fmt/args.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "modules/drive/friction_fit.h"
#include "modules/response/response.h"
#include "prs/embed.h"
#include "prs/report/report.h"
#include "prs/text.h"
#include "prs/version.h"

PRS_EMBED(mjcf_form, "prs/export/joint.mjcf.xml")
PRS_EMBED(mjcf_play_form, "prs/export/joint.play.xml")
PRS_EMBED(remarks_form, "prs/export/joint.remarks.txt")
PRS_EMBED(rotor_form, "prs/export/joint.rotor.xml")
PRS_EMBED(coupling_form, "prs/export/joint.coupling.xml")
PRS_EMBED(callback_form, "prs/export/joint.friction.py.in")
PRS_EMBED(urdf_form, "prs/export/joint.urdf")

namespace prs {
namespace {

constexpr double kFar = 1e3;  ///< A limit that no screw reaches [m].

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

using Json = nlohmann::ordered_json;

/// Nodes at equal ratios.
std::vector<double> geometric(double first, double last, int count) {
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k) nodes.push_back(first * std::pow(last / first, k / (count - 1.0)));
  return nodes;
}

/// Friction of the threads as a coefficient of the force, by force and speed: 1/eta - 1 where the screw drives, 1 - eta
/// where the load does; the mean of both senses of the force, and its largest error between the nodes.
Json losses_of(const SystemCurves& curves, double r, double largest_force, double largest_speed) {
  std::vector<double> force{largest_force}, speed{largest_speed};
  if (const FrictionTable& table = curves.friction; !table.speed.empty()) {
    double least = largest_force;
    for (const double root : table.root_force) least = std::min(least, root * root);
    force = geometric(std::max(least, 1e-4 * largest_force), largest_force, 12);
    speed = geometric(table.speed.front() * std::abs(r), largest_speed, 6);
  }
  const PrsCurves view = curves.view();
  double error = 0.0;
  const auto coefficients = [&](bool drives) {
    const auto friction = [&](double f, double v) {
      const int sense = ((f < 0.0) == (r < 0.0)) == drives ? 1 : -1;
      return std::abs(prs_friction_torque(&view, f, v / std::abs(r), sense) / r);
    };
    std::vector<std::vector<double>> rows;
    for (const double v : speed) {
      rows.emplace_back();
      for (const double f : force) rows.back().push_back(0.5 * (friction(f, v) + friction(-f, v)) / f);
    }
    for (std::size_t i = 1; i < speed.size(); ++i)
      for (std::size_t k = 1; k < force.size(); ++k) {
        const double f = std::sqrt(force[k - 1] * force[k]), v = std::sqrt(speed[i - 1] * speed[i]);
        const double mean = 0.25 * f * (rows[i - 1][k - 1] + rows[i - 1][k] + rows[i][k - 1] + rows[i][k]);
        for (const double sign : {1.0, -1.0}) error = std::max(error, std::abs(friction(sign * f, v) - mean));
      }
    return rows;
  };
  Json losses{{"force_N", force}, {"speed_m_per_s", speed}};
  losses["c_drive"] = coefficients(true);
  losses["c_back"] = coefficients(false);
  losses["largest_error_N"] = error;
  losses["v_0_m_per_s"] = 1e-3 * largest_speed;
  return losses;
}

/// Slides of rotor, screw and load, with the screw and its shaft as a spring at the friction load and as a curve.
Json slides_of(const PrsDrive& drive, const ResponseInput& in, double r, const Json& robot) {
  const double rotor_friction = in.motor.friction_torque / std::abs(r), reflected = robot["reflected_mass_kg"];
  const double motor_damping = in.motor.damping / (r * r), largest = robot["largest_force_N"];
  const bool coupled = in.coupling.has_value();
  if (!((coupled ? std::min(in.motor.inertia, in.screw.inertia) : reflected) > 0.0))
    throw CaseError(in.screw.inertia > 0.0 ? "response.motor.inertia" : "response.screw.inertia",
                    "missing; expected the inertia of each part in front of the play; state it, or leave out --play");
  const double screw = coupled ? in.screw.inertia / (r * r) : reflected;
  const PrsCurves& curves = drive.curves;
  const double origin = curves.tension.origin, other = -curves.compression.origin, play = origin - other;
  const auto deflection = [&](double force) { return prs_static_deflection(&drive, force, drive.start_position); };
  // Nodes are denser at small forces, where flanks begin to touch; the last one is far beyond the curves.
  constexpr int kNodes = 24;
  std::vector<double> force, way;
  const auto add = [&](double f, double at) {
    force.push_back(f);
    way.push_back(at);
  };
  for (int k = -kNodes - 1; k <= kNodes + 1; ++k) {
    const double share = k / double{kNodes}, f = largest * share * (std::abs(k) > kNodes ? 10.0 : std::abs(share));
    if (k == 0 && play > 0.0) add(0.0, other);
    add(f, k == 0 ? origin : deflection(f));
  }
  const double steepest = (force.end()[-2] - force.end()[-3]) / (way.end()[-2] - way.end()[-3]);
  double fastest = steepest * (1.0 / in.load.mass + 1.0 / screw);
  BoundSignal load(in.load.acting().terms());
  load.bind(0.0);
  const double ratio = in.load.linkage ? prs_lever_at(&drive, drive.start_position).ratio : 1.0;
  const double start = in.start.deflection.value_or(deflection(load.at(0.0).value / ratio));
  const double at = std::max(robot["friction_load_N"].get<double>(), 1e-3 * largest);
  const double stiffness = 2.0 * at / (deflection(at) - deflection(-at) - play);
  const double damping = stiffness * drive.material_damping, both = 1.0 / (1.0 / screw + 1.0 / in.load.mass);
  Json s{{"screw_kg", screw},
         {"drag_N", in.screw.drag_torque / std::abs(r) + (coupled ? 0.0 : rotor_friction)},
         {"screw_friction_N",
          robot["friction_loss_N"].get<double>() - in.load.friction_force - (coupled ? rotor_friction : 0.0)},
         {"own_damping_N_s_per_m", coupled ? 0.0 : motor_damping},
         {"screw_damping_N_s_per_m",
          robot["friction_per_speed_N_s_per_m"].get<double>() + (coupled ? 0.0 : motor_damping)},
         {"stiffness_N_per_m", stiffness},
         {"damping_N_s_per_m", damping},
         {"material_damping_s", drive.material_damping},
         {"can_open", std::max(curves.tension.root, curves.compression.root)},
         {"deflection_m", way},
         {"force_N", force},
         {"both_kg", both},
         {"screw_start_m", in.start.position + start},
         {"gap_start_m", -start}};
  // Limits take stiffness and damping over the mass that both sides have together.
  s["flanks"] = play > 0.0 ? fmt::format(
                                 "limited=\"true\" range=\"{:.17g} {:.17g}\" solreflimit=\"{:.9g} {:.9g}\" "
                                 "solimplimit=\"0.0001 0.0001 0.001\"",
                                 -origin, -other, -stiffness / both, -damping / both)
                           : fmt::format("stiffness=\"{:.9g}\" damping=\"{:.9g}\"", stiffness, damping);
  if (coupled) {
    fastest += in.coupling->stiffness * (1.0 / in.screw.inertia + 1.0 / in.motor.inertia);
    double c = 0.0, slope = 0.0, u = 0.0, tangent = 0.0;
    prs_shaft_compliance(&drive, drive.start_position, &c, &slope);
    s["rotor_kg"] = in.motor.inertia / (r * r);
    s["rotor_friction_N"] = rotor_friction;
    s["rotor_damping_N_s_per_m"] = motor_damping;
    s["coupling_N_per_m"] = in.coupling->stiffness / (r * r);
    s["coupling_N_s_per_m"] = in.coupling->damping / (r * r);
    s["rotor_start_m"] =
        in.start.position + start + r * r * prs_series_force(&curves, start, c, &u, &tangent) / in.coupling->stiffness;
  }
  const double step = 0.1 / std::sqrt(fastest), unit = std::pow(10.0, std::floor(std::log10(step)));
  s["timestep_s"] = unit * std::floor(step / unit);
  return s;
}

/// Root mean square force of the case's run [N], and its origin; half of the largest force where the run does not come
/// to its end.
std::pair<double, const char*> friction_load_of(const PrsDrive& drive, const ResponseInput& input, double largest) {
  try {
    if (const DriveResult run = run_drive(drive, input); run.status == DriveStatus::converged) {
      double sum = 0.0;
      for (const double force : run.force) sum += force * force;
      return {std::sqrt(sum / static_cast<double>(run.force.size())), "the root mean square of the run of `response`"};
    }
  } catch (const modules::Missing&) {  // No integrator.
  } catch (const CaseError&) {         // The nut leaves the shaft.
  }
  return {0.5 * largest, "half of the largest, as the run of `response` does not come to its end here"};
}

std::string table_of(const Json& losses, const char* which) {
  std::string lines = "    speed, m/s";
  for (const double force : losses["force_N"]) lines += fmt::format(" {:>8.4g} N", force);
  for (std::size_t i = 0; i < losses[which].size(); ++i) {
    lines += fmt::format("\n    {:>10.4g}", losses["speed_m_per_s"][i].get<double>());
    for (const double c : losses[which][i]) lines += fmt::format(" {:>10.4f}", c);
  }
  return lines;
}

/// A form with numbers and texts in the places of their keys; those of an object have its key before their own.
std::string filled(std::string_view form, const Json& values) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  const auto add = [&](const std::string& key, const Json& value) {
    if (value.is_number()) store.push_back(fmt::arg(key.c_str(), value.get<double>()));
    if (value.is_string()) store.push_back(fmt::arg(key.c_str(), value.get<std::string>()));
  };
  for (const auto& [key, value] : values.items()) {
    add(key, value);
    if (value.is_object())
      for (const auto& [inner, part] : value.items()) add(key + '_' + inner, part);
  }
  return fmt::vformat(form, store);
}

std::string joint(std::string_view form, const ResponseInput& in, const Json& robot, const ModelText& text) {
  const auto& [upper, lower] = in.end_stops;
  const auto end = [](const std::optional<ResponseInput::EndStop>& stop, double without) {
    return stop ? stop->at : without;
  };
  const auto bounds = [](const char* flag, const char* name, double from, double to) {
    return fmt::format(" {}=\"true\" {}=\"{:.17g} {:.17g}\"", flag, name, from, to);
  };
  // One joint has one stiffness of limits, over the mass that they stop: that of the load.
  const double stop = std::max(lower ? lower->stiffness : 0.0, upper ? upper->stiffness : 0.0);
  const std::string range =
      stop > 0.0
          ? bounds("limited", "range", end(lower, -kFar), end(upper, kFar)) +
                fmt::format(" solreflimit=\"{:.9g} 0\" solimplimit=\"0.0001 0.0001 0.001\"", -stop / in.load.mass)
          : "";
  const auto& controller = in.motor.controller;
  const double torque = controller ? controller->largest_torque.value_or(0.0) : 0.0;
  const std::string origin = fmt::format("Planetary roller screw of {}, SHA-256 {}, by prs {}.",
                                         printable(text.case_file), text.case_sha256, kVersion);
  std::string lines;
  for (const auto& [key, value] : robot.items()) lines += fmt::format("    \"{}\": {},\n", key, value.dump());
  const auto fixed = [](const std::string& from, const char* what, const char* to) {
    return std::regex_replace(from, std::regex(what), to);
  };
  Json values = robot;
  values.update(
      {{"robot", lines},
       {"name", text.name},
       {"origin", fixed(wrapped(origin, "", 100), "[\"\\\\]", "'")},  // Nothing may end a docstring,
       {"origin_xml", fixed(html(origin), "--", "-&#45;")},           // or a comment.
       {"drive_table", table_of(robot["losses"], "c_drive")},
       {"back_table", table_of(robot["losses"], "c_back")},
       {"range", range},
       {"stops",
        stop > 0.0 ? fmt::format("\n  End stops are springs of {:.6g} N/m without damping{}.", stop,
                                 lower && upper && lower->stiffness != upper->stiffness ? ", the stiffer of both" : "")
                   : ""},
       {"no_stop",
        lower && upper ? "" : "\n  Where the case has no end stop, the format still needs a limit, 1 m away or more."},
       {"control", torque > 0.0 ? bounds("ctrllimited", "ctrlrange", -torque, torque) : ""},
       {"inertia", 1e-3 * in.load.mass},
       {"lower", end(lower, std::min(-1.0, end(upper, 0.0) - 1.0))},
       {"upper", end(upper, std::max(1.0, end(lower, 0.0) + 1.0))}});
  const bool coupled = robot.contains("slides") && robot["slides"].contains("rotor_kg");
  values["remarks"] = filled(remarks_form(), values);
  values["rotor"] = coupled ? filled(rotor_form(), values) : "";
  values["coupling"] = coupled ? filled(coupling_form(), values) : "";
  values["rotor_place"] = coupled ? filled("{slides_rotor_start_m:.17g} ", values) : "";
  values["rotor_speed"] = coupled ? filled("{start_speed_m_per_s:.17g} ", values) : "";
  values["driven"] = coupled ? "motor" : "screw";
  return filled(form, values);
}

}  // namespace

Json robot_constants(const SystemModel& model, std::optional<double> friction_load, bool play_joint) {
  const SystemCurves& curves = model.curves;
  const ResponseInput& in = *model.drive;
  const double r = curves.lead / (2.0 * std::numbers::pi);
  const PrsDrive drive = drive_of(*model.case_with_drive, in, curves);
  const double largest = std::max(curves.senses.tension.force.back(), curves.senses.compression.force.back());
  const double speed = largest_speed_of(*model.case_with_drive, curves);
  FrictionFit fit;
  fit.screw_drives = fit.load_drives = 1.0;
  if (!curves.friction.speed.empty()) fit = fit_friction(drive.curves, largest, speed);
  if (friction_load.value_or(0.0) > largest)
    throw CaseError("response.curves.force",
                    fmt::format("the curves end at {:.6g} N; expected at least the {:.6g} N of the option "
                                "`friction-load`, for example `curves: {{force: {:.6g} N}}`",
                                largest, *friction_load, 1.1 * *friction_load));
  const auto [load, of] = friction_load ? std::pair{*friction_load, "as stated by the option `friction-load`"}
                                        : friction_load_of(drive, in, largest);
  const double drag = (in.screw.drag_torque + in.motor.friction_torque) / std::abs(r);
  const double motor_damping = in.motor.damping / (r * r);
  Json robot{{"gear_ratio_rad_per_m", 1.0 / r},
             {"reflected_mass_kg", (in.motor.inertia + in.screw.inertia) / (r * r)},
             {"friction_no_load_N", fit.no_load},
             {"friction_per_load", fit.per_load},
             {"friction_per_speed_N_s_per_m", fit.per_speed},
             {"friction_load_N", load},
             {"friction_load_of", of},
             {"friction_loss_N", fit.no_load + fit.per_load * load + drag + in.load.friction_force},
             {"damping_N_s_per_m", fit.per_speed + motor_damping + in.load.damping},
             {"friction_error_largest_N", fit.largest_error},
             {"friction_error_rms_N", fit.rms_error},
             {"efficiency", Json::object()},
             {"play_um", (curves.senses.tension.origin + curves.senses.compression.origin) * "µm"_per_si},
             {"largest_force_N", largest},
             {"largest_speed_m_per_s", std::abs(speed * r)},
             {"drag_N", drag},
             {"motor_damping_N_s_per_m", motor_damping},
             {"load_mass_kg", in.load.mass},
             {"load_friction_N", in.load.friction_force},
             {"load_damping_N_s_per_m", in.load.damping},
             {"start_m", in.start.position},
             {"start_speed_m_per_s", in.start.speed}};
  if (fit.screw_drives) robot["efficiency"]["screw_drives"] = *fit.screw_drives;
  if (fit.load_drives) robot["efficiency"]["load_drives"] = *fit.load_drives;
  robot["losses"] = losses_of(curves, r, largest, std::abs(speed * r));
  if (play_joint) robot["slides"] = slides_of(drive, in, r, robot);
  return robot;
}

std::string mjcf(const ResponseInput& input, const Json& robot, const ModelText& text) {
  return joint(robot.contains("slides") ? mjcf_play_form() : mjcf_form(), input, robot, text);
}
std::string urdf(const ResponseInput& input, const Json& robot, const ModelText& text) {
  return joint(urdf_form(), input, robot, text);
}

OutputFile mujoco_callback(const ResponseInput& input, const Json& robot, ModelText text,
                           const std::string& mjcf_file) {
  text.name = model_name(std::regex_replace(mjcf_file, std::regex("\\.mjcf\\.xml$"), ".xml")) + "_friction";
  return {text.name + ".py", joint(callback_form(), input, robot, text)};
}

}  // namespace prs
