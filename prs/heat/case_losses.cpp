#include "prs/heat/case_losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "prs/slip/running.h"

namespace prs {
namespace {

Conditions with_coarse_patches(Conditions c) {
  c.model.patch_points = std::min(c.model.patch_points, kFewestPatchPoints);
  return c;
}

Losses with_flow(const OfParts& heat, const PowerFlow& flow) {
  return {heat, std::max(flow.shaft, 0.0) + std::max(flow.load, 0.0),
          std::max(-flow.shaft, 0.0) + std::max(-flow.load, 0.0)};
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
  // The estimate is scaled: under preload without a load any force shows how heat follows the oil.
  if (share == LoadCase::Share::equal && load_.axial_force == 0.0) load_.axial_force = 1e3;
}

std::optional<Losses> CaseLosses::at(const OfParts& temperature) {
  const Oils oils = warm_oils(conditions_, oil_temperatures(temperature));
  if (load_.share == LoadCase::Share::equal) return of(models_.equal_shares(load_, oils));
  const Conditions warm = at_temperatures(conditions_, load_, temperature);
  const SlipModels models(warm, contacts_, oils);
  std::array<std::optional<SlipEquilibrium>, 2> known;
  LoadCaseResult found;
  if (slip_takes_running_loads(conditions_.model, load_.share)) {
    RunningSolver solver(warm, contacts_, models);
    found = solver.solve(load_, Detail::numbers, known[0]);
    known[1] = solver.second_nut();
    if (!found.threads)
      failure_ = fmt::format("running loads end as {}", name(found.running->status));
  } else if (has_both_flanks(conditions_, load_.share)) {
    found = FlankSolver(warm, contacts_).solve(load_);
    if (!found.threads) failure_ = "the loads of both flanks do not converge";
  } else {
    found = analyze(warm, contacts_, kManyDesigns).load_cases.front();
    if (!found.threads)
      failure_ = found.warnings.empty() ? "the loads of the threads do not converge"
                                        : sentence(found.warnings.front());
  }
  if (!found.threads) return std::nullopt;
  Losses all;
  PowerFlow flow;
  const std::vector<SlipModel> nuts = models.of_nuts(found);
  for (std::size_t n = 0; n < nuts.size(); ++n)
    if (!add(nuts[n], known[n] ? *known[n] : find_slip_equilibrium(nuts[n]), all.heat, flow))
      return std::nullopt;
  return with_flow(all.heat, flow);
}

std::optional<Losses> CaseLosses::of(const SlipModel& model) {
  OfParts heat = OfParts::Zero();
  PowerFlow flow;
  if (!add(model, find_slip_equilibrium(model), heat, flow)) return std::nullopt;
  return with_flow(heat, flow);
}

bool CaseLosses::add(const SlipModel& model, const SlipEquilibrium& found, OfParts& heat,
                     PowerFlow& flow) {
  if (!found.ok()) {
    failure_ = fmt::format("slip ends as {}", name(found.status));
    return false;
  }
  slip_ratio_ = found.balance.motion.slip_ratio;
  const PowerFlow of_nut = power_flow(model, drive_torques(model, found.balance));
  heat += heat_of(lost_power(model, found.balance));
  flow.shaft += of_nut.shaft;
  flow.load += of_nut.load;
  return true;
}

std::optional<OfParts> CaseLosses::estimate(const SlipModels& models,
                                            const PerInterface<double>& oil) const {
  const SlipModel model = models.equal_shares(load_, warm_oils(conditions_, oil));
  SlipBalance balance;
  if (!balance_at(model, slip_ratio_, balance)) return std::nullopt;
  return heat_of(lost_power(model, balance));
}

}  // namespace prs
