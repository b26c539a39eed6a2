#include "prs/configurations/configurations_json.h"

#include "prs/configurations/roller_spacing.h"
#include "prs/model/units.h"
#include "prs/record/json_values.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

Json per_part(const PerPart<double>& values, double factor) {
  Json json;
  for (const Part p : kParts) put(json, name(p), values[p], factor);
  return json;
}

Json starts_json(Mechanism::Starts starts) {
  return {{"screw", starts.screw}, {"roller", starts.roller}};
}

Json rollers_json(const Configuration& c) {
  const Mechanism& m = c.mechanism;
  Json json;
  json["most"] = c.most_rollers;
  json["chosen"] = m.rollers;
  put(json, "crest_gap_mm", c.crest_gap, per_si::millimetre);
  put(json, "indexing_angle_deg", indexing_angle(m.type, m.starts, m.rollers), per_si::degree);
  json["alike"] = c.alike;
  return json;
}

Json gear_pair_json(const GearPair& pair) {
  Json json;
  json["roller_teeth"] = pair.roller_teeth;
  json["body_teeth"] = pair.body_teeth;
  put(json, "module_mm", pair.module, per_si::millimetre);
  json["series"] = pair.series;
  put(json, "working_pressure_angle_deg", pair.working_pressure_angle, per_si::degree);
  put(json, "profile_shift", pair.profile_shift);
  json["most_rollers"] = pair.most_rollers;
  return json;
}

Json configuration_json(const Configuration& c) {
  Json json;
  json["type"] = type_name(c.mechanism.type);
  json["starts"] = starts_json(c.mechanism.starts);
  put(json, "pitch_mm", axial_pitch(c.mechanism), per_si::millimetre);
  json["rolling_diameter_mm"] = per_part(c.rolling_diameter, per_si::millimetre);
  json["pitch_diameter_mm"] = per_part(c.pitch_diameter, per_si::millimetre);
  put(json, "centre_distance_mm", c.centre_distance, per_si::millimetre);
  put(json, "gear_ratio", c.gear_ratio);
  json["lead_mm"] = per_part(c.lead, per_si::millimetre);
  json["helix_angle_deg"] = per_part(c.helix_angle, per_si::degree);
  json["roller_hand"] = c.lead.roller > 0.0 ? "right" : "left";
  put(json, "roller_profile_radius_mm", c.mechanism.profile.roller.radius, per_si::millimetre);
  json["rollers"] = rollers_json(c);
  json["gears"] = Json::array();
  for (const GearPair& pair : c.gears) json["gears"].push_back(gear_pair_json(pair));
  return json;
}

}  // namespace

std::string_view type_name(Mechanism::Type type) {
  return type == Mechanism::Type::standard ? "standard" : "inverted";
}

Json configurations_json(const Configurations& all, const DocumentInfo& info) {
  Json document = document_head(info, {});
  document["configurations"] = Json::array();
  for (std::size_t k = 0; k < all.found.size(); ++k) {
    Json json{{"number", k + 1}};
    json.update(configuration_json(all.found[k]));
    document["configurations"].push_back(std::move(json));
  }
  document["left_out"] = Json::array();
  for (const LeftOut& left_out : all.left_out) {
    Json json{{"type", type_name(left_out.type)},
              {"starts", starts_json(left_out.starts)},
              {"reason", left_out.reason}};
    if (!left_out.detail.empty()) json["detail"] = left_out.detail;
    document["left_out"].push_back(std::move(json));
  }
  return document;
}

}  // namespace prs
