#include "prs/quantities/json.h"

#include <algorithm>
#include <array>

#include "prs/printable.h"
#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/json_values.h"
#include "prs/quantities/model_summary.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/slip_json.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

Json both(const contact::PrincipalValues& values, double factor) {
  return shown(std::array{values.first, values.second}, factor);
}

Json interface_json(const InterfaceContact& contact, bool same_pitch) {
  const contact::InterfaceGeometry& g = contact.geometry;
  Json json;
  const auto put_all = [&](const auto& quantities) {
    for (const ContactQuantity& q : quantities) put(json, q.key, q.value(contact), q.factor);
  };
  put_all(kContactPointQuantities);
  json["body_curvatures_per_mm"] = both(g.body, per_si::per_millimetre);
  json["roller_curvatures_per_mm"] = both(g.roller, per_si::per_millimetre);
  json["relative_curvatures_per_mm"] = both(g.relative, per_si::per_millimetre);
  put_all(kCurvatureQuantities);
  json["normal"] = g.point.normal;
  if (same_pitch) put(json, kBacklash.key, kBacklash.value(contact), kBacklash.factor);
  put_all(kHertzQuantities);
  return json;
}

/// An object {screw, roller, nut} of what `value` says of each thread.
Json per_part(const contact::MechanismGeometry& threads, auto value) {
  Json json;
  json["screw"] = value(threads.screw);
  json["roller"] = value(threads.roller);
  json["nut"] = value(threads.nut);
  return json;
}

Json loads_json(const InterfaceLoads& loads) {
  Json json;
  put(json, "hertz_constant_N_per_mm1_5", loads.hertz_constant, per_si::newton_per_millimetre1_5);
  put(json, "normal_angle_deg", loads.normal_angle, per_si::degree);
  for (const auto& [key, values, factor] : kThreadQuantities)
    if (!(loads.*values).empty()) json[key] = shown(loads.*values, factor);
  return json;
}

Json history_json(const std::vector<fe::NewtonIteration>& history) {
  Json array = Json::array();
  for (const fe::NewtonIteration& iteration : history) {
    Json json = Json::object();
    put(json, "energy_J", iteration.energy);
    put(json, "relative_residual", iteration.relative_residual);
    put(json, "step_length", iteration.step_length);
    put(json, "shift", iteration.shift);
    array.push_back(std::move(json));
  }
  return array;
}

void put_solve(Json& json, const LoadCaseResult& result) {
  json["converged"] = result.converged();
  json["status"] = status_name(result);
  if (!result.solve) return;
  json["iterations"] = result.solve->iterations();
  put(json, "relative_residual", result.solve->relative_residual);
}

void put_answer(Json& json, const LoadCaseResult& result) {
  for (const auto& [key, value, factor] : kCaseQuantities) put(json, key, result.*value, factor);
  if (!result.threads) return;
  for (const Interface i : kInterfaces) json[name(i)] = loads_json((*result.threads)[i]);
}

/// Documents of more cases leave the histories out.
constexpr std::size_t kMostHistories = 100;

Json load_case_json(const LoadCaseResult& result, bool with_history) {
  const LoadCase& load = result.load_case;
  Json json;
  json["name"] = load.name;
  put(json, "axial_force_N", load.axial_force);
  if (load.direction) json["direction"] = name(*load.direction);
  put(json, "position_mm", load.position, per_si::millimetre);
  put_solve(json, result);
  if (result.converged()) put_answer(json, result);
  if (result.slip) json["slip"] = slip_json(*result.slip);
  json["warnings"] = result.warnings;
  if (result.solve && with_history) json["newton_history"] = history_json(result.solve->history);
  return json;
}

}  // namespace

nlohmann::ordered_json document_head(const DocumentInfo& info,
                                     const std::vector<std::string>& warnings) {
  Json document;
  document["prs_version"] = info.version;
  document["schema_version"] = info.schema_version;
  if (!info.input_sha256.empty()) document["input_sha256"] = info.input_sha256;
  if (!info.overrides.empty()) document["overrides"] = info.overrides;
  document["warnings"] = warnings;
  return document;
}

nlohmann::ordered_json contacts_json(const Contacts& contacts) {
  const contact::MechanismGeometry& threads = contacts.threads;
  Json json;
  put(json, "centre_distance_mm", threads.centre_distance, per_si::millimetre);
  json["pitch_diameter_mm"] = per_part(threads, [](const contact::Thread& thread) {
    return 2.0 * thread.pitch_radius * per_si::millimetre;
  });
  json["helix_angle_deg"] = per_part(threads, [](const contact::Thread& thread) {
    return contact::ThreadSurface(thread).helix_angle() * per_si::degree;
  });
  json["profile_radius_limits_mm"] = per_part(threads, [](const contact::Thread& thread) {
    const contact::RadiusLimits limits = contact::flank_limits(thread);
    return shown(std::array{limits.smallest, limits.largest}, per_si::millimetre);
  });
  json["max_rollers"] = contact::largest_roller_count(threads);
  for (const Interface i : kInterfaces) {
    const contact::Thread& body = i == Interface::screw ? threads.screw : threads.nut;
    if (contacts.interfaces[i].geometry.ok())
      json[name(i)] =
          interface_json(contacts.interfaces[i], contact::same_pitch(body, threads.roller));
  }
  return json;
}

nlohmann::ordered_json threads_json(const Contacts& contacts) {
  Json json;
  for (const Part p : kParts) {
    Json part;
    for (const WidthQuantity& q : kWidthQuantities)
      put(part, q.key, q.value(thread_of(contacts.threads, p)), q.factor);
    if (!part.empty()) json[name(p)] = std::move(part);
  }
  return json;
}

void put_contacts(nlohmann::ordered_json& document, const Contacts& contacts) {
  document["contact"] = contacts_json(contacts);
  if (Json threads = threads_json(contacts); !threads.empty())
    document["threads"] = std::move(threads);
}

nlohmann::ordered_json to_json(const Result& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  if (result.contacts.threads.centre_distance > 0.0) put_contacts(document, result.contacts);
  const auto is_solved = [](const LoadCaseResult& load_case) {
    return load_case.solve.has_value();
  };
  if (std::ranges::any_of(result.load_cases, is_solved)) document["model"] = model_json(result);
  document["load_cases"] = Json::array();
  const bool with_history = result.load_cases.size() <= kMostHistories;
  for (const LoadCaseResult& load_case : result.load_cases)
    document["load_cases"].push_back(load_case_json(load_case, with_history));
  return document;
}

std::string json_text(const nlohmann::ordered_json& document) {
  return printable_json(document.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace prs
