#include <nlohmann/json.hpp>

#include "prs/quantities/json_values.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/life_units.h"
#include "prs/quantities/model_summary.h"
#include "prs/model/units.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

Json interval_json(const Interval& i) { return Json::array({i.least, i.greatest}); }

/// A life at the capacity's value; its range is that of the capacity.
Json life_json(const LifeResult& r, double revolutions) {
  Json json = Json::object();
  if (!std::isfinite(revolutions)) return json;
  const LifeInUse life = in_use(r, revolutions);
  put(json, "l10_revolutions", revolutions);
  const auto scaled = [&](double capacity) {
    return revolutions * std::pow(capacity / r.dynamic_capacity, kLifeExponent);
  };
  json["l10_revolutions_range"] = interval_json(
      {scaled(r.dynamic_capacity_range.least), scaled(r.dynamic_capacity_range.greatest)});
  put(json, "l10_hours", life.hours);
  put(json, "l10_travel_km", life.travel, 1e-3);
  put(json, "l10_passes", life.passes);
  return json;
}

Json capacity_json(const LifeResult& r) {
  Json json;
  put(json, "dynamic_capacity_N", r.dynamic_capacity);
  json["dynamic_capacity_range_N"] = interval_json(r.dynamic_capacity_range);
  json["source"] = r.lemor ? "lemor" : "given";
  if (r.lemor) {
    json["geometry_factor"] = r.lemor->factor;
    json["geometry_factor_range"] = interval_json(r.lemor->factor_range);
    json["diameter_ratio"] = r.lemor->ratio;
    put(json, "element_diameter_mm", r.lemor->element_diameter, per_si::millimetre);
  }
  json["failure_share"] = {{"screw", r.failure_shares.screw}, {"nut", r.failure_shares.nut}};
  put(json, "static_capacity_equal_shares_N", r.equal_shares_static_capacity);
  put(json, "flank_edge_load_equal_shares_N", r.equal_shares_flank_edge_load);
  put(json, "static_capacity_given_N", r.life.static_capacity);
  return json;
}

Json loads_json(const LifeResult& r) {
  Json json;
  json["samples"] = r.steps.size();
  if (r.revolutions_known) {
    put(json, "revolutions", r.revolutions);
    put(json, "travel_m", r.revolutions * std::abs(r.contacts.mechanism.lead));
  }
  put(json, "duration_h", r.duration, 1.0 / 3600.0);
  put(json, "mean_load_N", r.mean_load);
  put(json, "largest_force_N", r.largest_force);
  return json;
}

/// A thread that is never loaded has no life: null, so that the others keep their places.
Json threads_json(const ThreadLives& t) {
  Json json;
  json["equivalent_load_N"] = shown(t.equivalent_load, 1.0);
  Json lives = Json::array();
  for (const double life : t.life)
    lives.push_back(std::isfinite(life) ? Json(life) : Json(nullptr));
  json["l10_revolutions"] = std::move(lives);
  json["largest_load_N"] = shown(t.largest_load, 1.0);
  if (!t.equivalent_range.empty()) json["equivalent_range_N"] = shown(t.equivalent_range, 1.0);
  return json;
}

Json flank_json(const LifeResult& r, const FlankLife& f) {
  Json json = life_json(r, f.life);
  put(json, "share_of_revolutions", f.revolutions / r.revolutions);
  put(json, "mean_load_N", f.mean_load);
  put(json, "largest_force_N", f.largest_force);
  put(json, "static_capacity_N", f.static_capacity);
  put(json, "flank_edge_load_N", f.flank_edge_load);
  put(json, "static_safety", f.static_safety());
  if (f.static_rating) json["static_safety_limit"] = name(f.static_rating->limit);
  json["equilibria"] = f.solves;
  put(json, "interpolation_error", f.interpolation_error);
  for (const Interface i : kInterfaces) {
    json[name(i)] = threads_json(f.threads[i]);
    put(json[name(i)], "peak_pressure_MPa", f.peak_pressure[i], per_si::megapascal);
  }
  return json;
}

Json cycles_json(const LifeResult& r) {
  const LoadCycles& c = *r.cycles;
  Json json;
  json["count"] = count(c.cycles);
  json["fatigue_slope"] = r.life.fatigue_slope;
  put(json, "equivalent_range_N", c.equivalent_range);
  json["largest_range_N"] = c.matrix.range_to;
  Json matrix;
  matrix["range_to_N"] = c.matrix.range_to;
  matrix["mean_from_N"] = c.matrix.mean_from;
  matrix["mean_to_N"] = c.matrix.mean_to;
  matrix["count"] = Json::array();
  for (int i = 0; i < c.matrix.bins; ++i) {
    Json row = Json::array();
    for (int k = 0; k < c.matrix.bins; ++k) row.push_back(c.matrix.at(i, k));
    matrix["count"].push_back(std::move(row));
  }
  json["matrix"] = std::move(matrix);
  return json;
}

}  // namespace

Json life_json(const LifeResult& r, const DocumentInfo& info) {
  Json document = document_head(info, r.warnings);
  put_contacts(document, r.contacts);
  Json json;
  json["converged"] = r.converged();
  if (r.failure) json["status"] = *r.failure;
  json["share"] = r.life.share == LoadCase::Share::equal ? "equal" : "solved";
  json["capacity"] = capacity_json(r);
  json["loads"] = loads_json(r);
  if (r.cycles) json["cycles"] = cycles_json(r);
  if (r.converged()) {
    json["system"] = life_json(r, r.system_life);
    json["equal_shares"] = life_json(r, r.equal_shares_life);
    json["catalogue"] = life_json(r, r.catalogue_life);
    put(json, "static_safety", r.static_safety());
    if (const auto limit = r.static_safety_limit()) json["static_safety_limit"] = name(*limit);
    if (r.weakest) {
      Json weakest = life_json(r, r.weakest->life);
      weakest["direction"] = name(r.weakest->direction);
      weakest["interface"] = name(r.weakest->interface);
      weakest["thread"] = r.weakest->thread + 1;
      put(weakest, "equivalent_load_N", r.weakest->equivalent_load);
      json["weakest_thread"] = std::move(weakest);
    }
    for (const Direction d : kDirections)
      if (r.flanks[d]) json[name(d)] = flank_json(r, *r.flanks[d]);
  }
  document["life"] = std::move(json);
  return document;
}

}  // namespace prs
