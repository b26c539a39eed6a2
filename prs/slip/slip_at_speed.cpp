#include "prs/slip/slip_at_speed.h"

#include "prs/model/operation_check.h"
#include "prs/slip/running.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

/// Slip of a load case at another speed: loads of a running screw and of both flanks are found anew, others stay.
/// None where there is no equilibrium.
std::optional<SlipResult> slip_at_speed(const Conditions& c, const Contacts& contacts, const SlipModels& models,
                                        const LoadCaseResult& loaded, const LoadCase& at) {
  std::optional<SlipResult> slip;
  if (runs(c, loaded.load_case) || loaded.other_flank) {
    slip = slip_alone(c, contacts, at, models.oils());
  } else {
    SlipModel model = models.of(loaded);
    model.speed = *at.speed;
    slip = slip_result(model);
  }
  return slip && slip->converged() ? std::move(slip) : std::nullopt;
}

}  // namespace

std::optional<double> back_driving_efficiency(const Conditions& c, const Contacts& contacts,
                                              const LoadCaseResult& loaded) {
  Problems lacking;
  require_slip(c, lacking);
  if (!std::move(lacking).take().empty() || !loaded.threads) return std::nullopt;
  for (const Interface i : kInterfaces)
    if (!contacts.interfaces[i].geometry.ok() || !contacts.interfaces[i].has_hertz()) return std::nullopt;
  if (!rolls(contacts.mechanism)) return std::nullopt;
  Oils oils = oils_in_operation(c);
  const bool oiled = c.friction->facts().has_film() || c.carrier.is_oiled();
  if (oiled && !oils.carrier) return std::nullopt;  // its temperature is known from heat alone
  Conditions free = c;
  if (free.operation) free.operation->slip_ratio.reset();
  const SlipModels models(free, contacts, std::move(oils));
  LoadCase driving = loaded.load_case;
  const SlipModel as_stated = models.unloaded(driving);
  const bool by_screw = driven_by(as_stated.axial_force, as_stated.speed, as_stated.geometry.lead) == DrivenBy::screw;
  driving.speed = by_screw ? -as_stated.speed : as_stated.speed;
  const std::optional<SlipResult> found = slip_at_speed(free, contacts, models, loaded, driving);
  return found ? found->efficiency : std::nullopt;
}

StribeckCurve stribeck_curve(const Conditions& c, const Result& result, std::size_t load_case) {
  constexpr int kDecades = 4, kPerDecade = 10;
  const LoadCaseResult& loaded = result.load_cases[load_case];
  Conditions warm = c;
  if (loaded.heat && warms(c.heat)) warm.deviations.temperature = loaded.heat->temperature;
  const SlipModels models(warm, result.contacts, oils_of(c, loaded));
  LoadCase at = loaded.load_case;
  const double speed = models.unloaded(at).speed;
  StribeckCurve curve;
  for (int k = 0; k <= kDecades * kPerDecade; ++k) {
    // The speeds go from a thousandth to ten times the speed of the case.
    at.speed = speed * std::pow(10.0, static_cast<double>(k) / kPerDecade - 3.0);
    const std::optional<SlipResult> slip = slip_at_speed(warm, result.contacts, models, loaded, at);
    if (!slip) continue;
    curve.speed.push_back(std::abs(*at.speed));
    curve.power.push_back(slip->power.total());
    curve.efficiency.push_back(slip->efficiency);
    for (const Interface i : kInterfaces) {
      const InterfaceSlip& threads = slip->of_nut_that_carries(loaded.load_case).threads[i];
      const auto most = static_cast<std::size_t>(std::ranges::max_element(threads.dynamic_normal_load) -
                                                 threads.dynamic_normal_load.begin());
      curve.friction[i].push_back(threads.friction_coefficient.at(most));
      if (!threads.film_ratio.empty()) curve.film_ratio[i].push_back(threads.film_ratio.at(most));
    }
  }
  return curve;
}

}  // namespace prs
