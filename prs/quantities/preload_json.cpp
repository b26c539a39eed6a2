#include <algorithm>
#include <nlohmann/json.hpp>

#include "prs/quantities/json_values.h"
#include "prs/quantities/preload_json.h"
#include "prs/model/units.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

Json per_direction(const PerDirection<std::optional<double>>& values, double factor) {
  Json json = Json::object();
  for (const Direction d : kDirections) put(json, name(d), values[d], factor);
  return json;
}

Json side_json(const PreloadResult& result, const SideLoads& side) {
  Json json;
  put(json, "axial_load_N", side.axial_load.screw);
  put(json, "max_normal_load_N", std::max(side.max_normal_load.screw, side.max_normal_load.nut));
  put(json, "peak_pressure_MPa", result.peak_pressure(side), per_si::megapascal);
  return json;
}

Json point_json(const PreloadResult& result, const PreloadPoint& point) {
  Json json;
  json["axial_force_N"] = point.axial_force;
  json["converged"] = point.solve.converged();
  json["status"] = fe::name(point.solve.status);
  json["iterations"] = point.solve.iterations();
  put(json, "relative_residual", point.solve.relative_residual);
  if (!point.solve.converged()) return json;
  put(json, "axial_displacement_um", point.axial_displacement, per_si::micrometre);
  put(json, "tangent_stiffness_N_per_um", point.tangent_stiffness, per_si::newton_per_micrometre);
  for (const Direction d : kDirections) json["sides"][name(d)] = side_json(result, point.sides[d]);
  return json;
}

void put_curve(Json& json, const PreloadResult& result, const PreloadCurve& curve) {
  json["stiffness_at_zero_N_per_um"] =
      per_direction(curve.stiffness_at_zero, per_si::newton_per_micrometre);
  put(json, "lost_motion_um", curve.lost_motion, per_si::micrometre);
  json["loads"] = Json::array();
  for (const PreloadPoint& point : curve.points) json["loads"].push_back(point_json(result, point));
}

}  // namespace

Json preload_json(const PreloadResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_contacts(document, result.contacts);
  Json json;
  json["arrangement"] =
      result.preload.arrangement == Preload::Arrangement::single_nut ? "single_nut" : "double_nut";
  put(json, "position_mm", result.preload.position, per_si::millimetre);
  for (const Direction d : kDirections)
    put(json["held_at_mm"], name(d), result.section[d], per_si::millimetre);
  if (result.at_rest.solve.converged()) put(json, "preload_force_N", result.force());
  put(json, "interference_um", result.interference, per_si::micrometre);
  put(json, "backlash_um", result.preload.backlash, per_si::micrometre);
  json["opening_force_N"] = per_direction(result.opening_force, 1.0);
  put(json, "lost_motion_load_N", result.lost_motion_load);
  put_curve(json, result, result.curve);
  if (result.without_preload) put_curve(json["without_preload"], result, *result.without_preload);
  document["preload"] = std::move(json);
  return document;
}

}  // namespace prs
