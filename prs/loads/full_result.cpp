#include "prs/loads/full_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/loads/load_case_result.h"

namespace prs {
namespace {

/// Loads that differ by less are the same load, as rounding has it.
constexpr double kSameLoad = 1e-9;

/// Shares of the mean below which a thread carries nothing.
constexpr double kUnloaded = 1e-6;

std::vector<double> flat(const RollerThreads& values) {
  std::vector<double> all;
  for (const std::vector<double>& roller : values)
    all.insert(all.end(), roller.begin(), roller.end());
  return all;
}

RollerShares roller_shares(const InterfaceLoads& loads, const FullModel& f, double symmetric) {
  RollerShares s;
  s.missing = f.rollers - static_cast<int>(f.present.size());
  const auto threads = static_cast<std::size_t>(f.threads());
  s.share.assign(static_cast<std::size_t>(f.rollers), 0.0);
  const double unloaded =
      kUnloaded * f.axial_force / (static_cast<double>(f.rollers) * f.threads());
  for (const FullModel::Roller& r : f.present)
    for (std::size_t k = 0; k < threads; ++k) {
      const auto roller = static_cast<std::size_t>(r.number);
      const std::size_t at = roller * threads + k;
      s.share[roller] += loads.axial_load[at] / f.axial_force;
      if (loads.axial_load[at] <= unloaded) ++s.unloaded_threads;
      if (loads.normal_load[at] <= s.largest_normal_load * (1.0 + kSameLoad)) continue;
      s.largest_normal_load = loads.normal_load[at];
      s.largest_roller = r.number + 1;
      s.largest_thread = static_cast<int>(k) + 1;
    }
  s.overload_factor = s.largest_normal_load / symmetric;
  return s;
}

/// Rollers without anything of their own.
bool alike(const Deviations& d) {
  return d.roller_diameters.empty() && d.roller_position.near.empty() &&
         d.roller_position.far.empty() && d.missing_rollers.empty() &&
         d.pitch_error.roller.lists.empty();
}

/// The mechanism under a load case at a carrier angle.
auto models_of(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
               const PerInterface<ContactLaw>& laws) {
  return [&](double carrier_angle) {
    LoadCase at = load_case;
    at.spatial.carrier_angle = carrier_angle;
    return full_model(contacts.mechanism, *c.structure, *c.materials, c.model, laws, at,
                      c.deviations);
  };
}

}  // namespace

FullDistribution full_distribution(const LoadCase& load_case, const Conditions& c,
                                   const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                                   Detail detail) {
  return solve(models_of(load_case, c, contacts, laws)(load_case.spatial.carrier_angle), detail);
}

std::optional<Orbit> full_orbit(const LoadCase& load_case, const Conditions& c,
                                const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                                const SpatialLoad::Orbit& wanted) {
  return orbit(models_of(load_case, c, contacts, laws), wanted, load_case.spatial.carrier_angle,
               alike(c.deviations));
}

LoadCaseResult full_result(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                           const PerInterface<ContactLaw>& laws, Detail detail) {
  const SpatialLoad& load = load_case.spatial;
  const FullModel f = models_of(load_case, c, contacts, laws)(load.carrier_angle);
  FullDistribution d = solve(f, detail);
  LoadDistribution flattened;
  flattened.solve = d.solve;
  flattened.axial_displacement = d.axial_displacement;
  flattened.tangent_stiffness = d.tangent_stiffness;
  for (const Interface i : kInterfaces) {
    flattened.normal_load[i] = flat(d.normal_load[i]);
    flattened.approach[i] = flat(d.approach[i]);
  }
  LoadCaseResult result = solved_result(load_case, contacts, laws, std::move(flattened));
  if (!d.reason.empty()) result.warnings.push_back(d.reason);
  if (!result.threads) return result;

  FullLoads full;
  full.freedoms = d.freedoms;
  full.rollers = f.rollers;
  full.carrier_angle = load.carrier_angle;
  for (const int roller : d.idle_rollers) full.idle_rollers.push_back(roller + 1);
  full.screw_end = std::move(d.screw_end);
  full.nut = d.nut;
  full.rings = std::move(d.rings);
  full.bearings = std::move(d.bearings);
  full.symmetric = symmetric_loads(f);
  full.symmetric_stiffness = f.axial_force / full.symmetric.axial_displacement;
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*result.threads)[i];
    loads.threads_per_roller = f.threads();
    loads.rollers = roller_shares(loads, f, full.symmetric.largest_normal_load[i]);
  }
  if (load.orbit) {
    full.orbit = full_orbit(load_case, c, contacts, laws, *load.orbit);
    if (!full.orbit)
      result.warnings.push_back(
          "the orbit was left out: at some position of the carrier there is no equilibrium");
  }
  if (detail == Detail::complete && full.screw_end.compliance.size() == 0)
    result.warnings.push_back(
        "the stiffness of the screw's end is left out: with the loaded threads alone a part can "
        "move");
  for (const Interface i : kInterfaces) {
    const double opening = d.largest_opening[i] / std::cos(laws[i].normal_angle);
    const contact::ContactPoint& point = contacts.interfaces[i].geometry.point;
    if (point.ok() && point.backlash > 0.0 && opening > point.backlash)
      result.warnings.push_back(fmt::format(
          "a {} contact opens by {:.3g} mm, more than the backlash of {:.3g} mm: the other flank "
          "would touch, which the model leaves out",
          label(i), opening * 1e3, point.backlash * 1e3));
  }
  result.full = std::make_shared<const FullLoads>(std::move(full));
  return result;
}

}  // namespace prs
