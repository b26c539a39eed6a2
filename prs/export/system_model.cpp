#include "prs/export/system_model.h"

#include <cctype>

#include "modules/response/response.h"
#include "prs/run/commands.h"
#include "prs/sha256.h"

namespace prs {
namespace {

constexpr double kMicrometre = 1e-6;

nlohmann::ordered_json branch_json(const BranchTable& branch, double sign) {
  nlohmann::ordered_json deflection, force, stiffness;
  for (std::size_t k = 0; k < branch.at.size(); ++k) {
    deflection.push_back(sign * branch.deflection(k) / kMicrometre);
    force.push_back(sign * branch.force[k]);
    stiffness.push_back(branch.stiffness(k) * kMicrometre);
  }
  return {{"deflection_um", deflection}, {"force_N", force}, {"stiffness_N_per_um", stiffness}};
}

nlohmann::ordered_json torque_json(const SystemCurves& curves) {
  const FrictionTable& table = curves.friction;
  const PrsCurves view = curves.view();
  nlohmann::ordered_json force, speed, torque;
  for (const double root : table.root_force) force.push_back(root * std::abs(root));
  std::vector<double> speeds;
  for (auto s = table.speed.rbegin(); s != table.speed.rend(); ++s) speeds.push_back(-*s);
  speeds.insert(speeds.end(), table.speed.begin(), table.speed.end());
  for (const double s : speeds) {
    nlohmann::ordered_json row;
    for (const double root : table.root_force) {
      int beyond = 0;
      row.push_back(prs_torque(&view, root * std::abs(root), s, &beyond));
    }
    speed.push_back(s);
    torque.push_back(std::move(row));
  }
  return {{"force_N", force}, {"speed_rad_per_s", speed}, {"torque_Nm", torque}};
}

/// Whether a name is reserved in Modelica (Modelica Language Specification 3.4, section 2.3.3).
bool is_word_of_modelica(std::string_view name) {
  constexpr std::string_view kWords =
      " algorithm and annotation assert block break class connect connector constant "
      "constrainedby der discrete each else elseif elsewhen encapsulated end enumeration "
      "equation expandable extends external false final flow for function if import impure "
      "in initial inner input loop model not operator or outer output package parameter "
      "partial protected public pure record redeclare replaceable return stream then true "
      "type when while within Boolean Integer Modelica Real String ";
  return kWords.find(fmt::format(" {} ", name)) != kWords.npos;
}

}  // namespace

SystemModel system_model(const input::Source& source, const CurveOptions& options, WithDrive with_drive) {
  const Case stated = input::read_case_input(source, Command::check).values;
  const bool drive = with_drive == WithDrive::needed || (with_drive == WithDrive::stated && stated.response);
  const Command needed = drive ? Command::response : stated.preload ? Command::preload : Command::solve;
  const input::CaseInput in = input::read_case_input(source, needed);
  SystemModel model{
      input::compute_from(
          source, [&] { return drive ? response_curves(in.values, options) : system_curves(in.values, options); }),
      {model_name(source.name), source.name, sha256(source.text)},
      document_info(source, needed)};
  if (drive) {
    model.drive = input::compute_from(source, [&] { return with_signal_files(in.values, source); });
    model.case_with_drive = in.values;
  }
  model.info.command = "export";
  std::vector<Warning>& warnings = model.curves.warnings;
  warnings.insert(warnings.begin(), in.warnings.begin(), in.warnings.end());
  return model;
}

std::string model_name(const std::string& case_file) {
  std::string name;
  for (const char c : std::filesystem::path(case_file).stem().string())
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  // File names of 255 bytes must have room for the ending.
  name = name.substr(0, 100);
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 && !is_word_of_modelica(name)
             ? name
             : "screw_" + name;
}

std::string curves_text(const SystemCurves& curves) {
  const auto ends = [&](auto value) {
    return std::pair{value(curves.senses.compression), value(curves.senses.tension)};
  };
  const auto force = ends([](const BranchTable& b) { return b.force.back(); });
  const auto deflection = ends([](const BranchTable& b) { return b.deflection(b.at.size() - 1); });
  std::string text = fmt::format(
      "Force over deflection from -{:.6g} um, -{:.6g} N to {:.6g} um, {:.6g} N; tension is "
      "positive. Beyond, the force goes on in a straight line. Between the nodes it is within "
      "{:.1g} of the largest force, the stiffness within {:.1g} of the largest one. ",
      deflection.first / kMicrometre, force.first, deflection.second / kMicrometre, force.second, curves.force_error,
      curves.stiffness_error);
  const FrictionTable& table = curves.friction;
  if (table.root_force.empty()) return text + "The torque is force x lead / (2 pi): the case has no friction.";
  return text + fmt::format(
                    "Torque with friction from {:.4g} to {:.4g} rad/s in both senses, between the "
                    "nodes within {:.1g} of the largest torque.",
                    table.speed.front(), table.speed.back(), curves.torque_error);
}

nlohmann::ordered_json curves_json(const SystemCurves& curves) {
  nlohmann::ordered_json json;
  if (!curves.load_case.empty()) json["load_case"] = curves.load_case;
  json["lead_mm"] = curves.lead * 1e3;
  json["tension"] = branch_json(curves.senses.tension, 1.0);
  json["compression"] = branch_json(curves.senses.compression, -1.0);
  json["force_error"] = curves.force_error;
  json["stiffness_error"] = curves.stiffness_error;
  if (!curves.friction.root_force.empty()) {
    json["torque"] = torque_json(curves);
    json["torque_error"] = curves.torque_error;
  }
  return json;
}

}  // namespace prs
