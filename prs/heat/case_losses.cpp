#include "prs/heat/case_losses.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/slip/running.h"

namespace prs {
namespace {

Conditions with_coarse_patches(Conditions c) {
  c.model.patch_points = std::min(c.model.patch_points, kFewestPatchPoints);
  return c;
}

}  // namespace

Conditions at_temperatures(const Conditions& c, const LoadCase& load, const OfParts& temperature) {
  Conditions warm = c;
  warm.load_cases = {load};
  warm.deviations.temperature = per_part(temperature);
  return warm;
}

Oils warm_oils(const Conditions& c, const PerInterface<double>& oil) {
  return c.lubricant ? oils_at(*c.lubricant, oil) : Oils{};
}

bool heat_may_grow(const Conditions& c) { return c.friction->model == Friction::Model::mixed; }

CaseLosses::CaseLosses(const Conditions& c, const Contacts& contacts, const LoadCase& load,
                       LoadCase::Share share)
    : conditions_(c),
      contacts_(contacts),
      load_(load),
      models_(c, contacts, Oils{}),
      rough_models_(with_coarse_patches(c), contacts, Oils{}) {
  load_.share = share;
}

std::optional<Losses> CaseLosses::at(const OfParts& temperature) {
  const Oils oils = warm_oils(conditions_, oil_temperatures(temperature));
  if (load_.share == LoadCase::Share::equal) return of(models_.equal_shares(load_, oils));
  if (slip_takes_running_loads(conditions_.model, load_.share)) {
    const Conditions warm = at_temperatures(conditions_, load_, temperature);
    const SlipModels models(warm, contacts_, oils);
    std::optional<SlipEquilibrium> slip;
    const LoadCaseResult found =
        RunningSolver(warm, contacts_, models).solve(load_, Detail::numbers, slip);
    if (found.threads) return of(models.of(found), *slip);
    failure_ = fmt::format("running loads end as {}", name(found.running->status));
    return std::nullopt;
  }
  const Result loads =
      analyze(at_temperatures(conditions_, load_, temperature), contacts_, kManyDesigns);
  const LoadCaseResult& found = loads.load_cases.front();
  if (found.threads) return of(models_.of(found, oils));
  failure_ = found.warnings.empty() ? "the loads of the threads do not converge"
                                    : sentence(found.warnings.front());
  return std::nullopt;
}

std::optional<Losses> CaseLosses::of(const SlipModel& model) {
  return of(model, find_slip_equilibrium(model));
}

std::optional<Losses> CaseLosses::of(const SlipModel& model, const SlipEquilibrium& found) {
  if (!found.ok()) {
    failure_ = fmt::format("slip ends as {}", name(found.status));
    return std::nullopt;
  }
  slip_ratio_ = found.balance.motion.slip_ratio;
  const PowerFlow flow = power_flow(model, drive_torques(model, found.balance));
  return Losses{heat_of(lost_power(model, found.balance)),
                std::max(flow.shaft, 0.0) + std::max(flow.load, 0.0),
                std::max(-flow.shaft, 0.0) + std::max(-flow.load, 0.0)};
}

std::optional<OfParts> CaseLosses::estimate(const SlipModels& models,
                                            const PerInterface<double>& oil) const {
  const SlipModel model = models.equal_shares(load_, warm_oils(conditions_, oil));
  SlipBalance balance;
  if (!balance_at(model, slip_ratio_, balance)) return std::nullopt;
  return heat_of(lost_power(model, balance));
}

}  // namespace prs
