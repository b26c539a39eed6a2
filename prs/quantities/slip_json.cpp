#include "prs/quantities/slip_json.h"

#include "prs/quantities/json_values.h"
#include "prs/quantities/slip_quantities.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

template <class Owner, std::size_t count>
Json members_json(const Owner& owner, const MemberQuantity<Owner> (&quantities)[count],
                  double factor = 1.0) {
  Json json = Json::object();
  for (const auto& [key, value] : quantities) put(json, key, owner.*value, factor);
  return json;
}

Json estimates_json(const SlipResult& slip) {
  Json json = Json::object();
  for (const auto& [key, value, factor] : kSlipEstimates) put(json, key, value(slip), factor);
  return json;
}

/// Absent where nothing is lost.
void put_shares(Json& json, const PowerBySource& power) {
  if (!(power.total() > 0.0)) return;
  Json shares = Json::object();
  for (const PowerSource& source : kPowerSources)
    put(shares, source.key, power.*source.value / power.total(), per_si::percent);
  json["share_percent"] = std::move(shares);
}

Json threads_json(const InterfaceSlip& threads) {
  Json json = Json::object();
  for (const auto& [key, values, factor] : kSlipThreadQuantities)
    if (!(threads.*values).empty()) json[key] = shown(threads.*values, factor);
  return json;
}

Json forces_json(const RollerForces& forces) {
  Json json = members_json(forces, kRollerForces);
  if (forces.centrifugal != 0.0) put(json, "centrifugal", forces.centrifugal);
  return json;
}

void put_hottest(Json& json, const SlipResult& slip) {
  const std::optional<double> density = at_hottest(slip, &InterfaceSlip::power_density);
  if (!density) return;
  Json hottest = Json::object();
  hottest["interface"] = name(slip.hottest.interface);
  hottest["thread"] = slip.hottest.thread + 1;
  put(hottest, "power_W", at_hottest(slip, &InterfaceSlip::power));
  put(hottest, "power_density_W_per_mm2", density, per_si::per_square_millimetre);
  json["hottest_thread"] = std::move(hottest);
}

void put_equal_shares(Json& json, const std::optional<EqualShareSlip>& equal) {
  if (!equal) return;
  Json object = Json::object();
  for (const auto& [key, value, factor] : kEqualShareQuantities)
    put(object, key, value(*equal), factor);
  json["equal_shares"] = std::move(object);
}

}  // namespace

nlohmann::ordered_json slip_json(const SlipResult& slip) {
  Json json;
  json["converged"] = slip.converged();
  json["status"] = name(slip.status);
  json["evaluations"] = slip.evaluations;
  put(json, "relative_residue", slip.relative_residue);
  if (!slip.converged()) return json;
  for (const auto& [key, value, factor] : kSlipQuantities) put(json, key, value(slip), factor);
  json["slip_ratio_estimates"] = estimates_json(slip);
  put_shares(json, slip.power);
  json["roller_moments_Nmm"] =
      members_json(slip.moments, kRollerMoments, per_si::newton_millimetre);
  json["roller_forces_N"] = forces_json(slip.forces);
  put_hottest(json, slip);
  put_equal_shares(json, slip.equal_shares);
  for (const Interface i : kInterfaces) json[name(i)] = threads_json(slip.threads[i]);
  return json;
}

}  // namespace prs
