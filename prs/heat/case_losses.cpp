#include "prs/heat/case_losses.h"

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

CaseLosses::CaseLosses(const Conditions& c, const Contacts& contacts, const LoadCase& load, LoadCase::Share share)
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
  OfParts heat = OfParts::Zero();
  PowerFlow flow;
  // Heat and power of the rollers of a nut; false where they have no slip.
  const auto add = [&](const SlipModel& model, const std::optional<SlipEquilibrium>& known) {
    const SlipEquilibrium found = known ? *known : find_slip_equilibrium(model);
    if (!found.ok()) {
      failure_ = fmt::format("slip ends as {}", name(found.status));
      return false;
    }
    slip_ratio_ = found.balance.motion.slip_ratio;
    const PowerFlow of_nut = power_flow(model, found.balance);
    heat += heat_of(lost_power(model, found.balance));
    flow.shaft += of_nut.shaft;
    flow.load += of_nut.load;
    return true;
  };
  const auto all = [&] {
    return std::optional(Losses{heat, std::max(flow.shaft, 0.0) + std::max(flow.load, 0.0),
                                std::max(-flow.shaft, 0.0) + std::max(-flow.load, 0.0)});
  };
  if (load_.share == LoadCase::Share::equal) return add(models_.equal_shares(load_, &oils), {}) ? all() : std::nullopt;
  const Conditions warm = at_temperatures(conditions_, load_, temperature);
  const SlipModels models(warm, contacts_, oils);
  std::array<std::optional<SlipEquilibrium>, 2> known;
  LoadCaseResult found;
  if (slip_takes_running_loads(conditions_.model, load_.share)) {
    RunningSolver solver(warm, contacts_, models);
    found = solver.solve(load_, Detail::numbers, known[0]);
    known[1] = solver.second_nut();
  } else {
    found = has_both_flanks(conditions_, load_.share) ? FlankSolver(warm, contacts_).solve(load_)
                                                      : analyze(warm, contacts_, kManyDesigns).load_cases.front();
  }
  if (!found.threads)
    failure_ = found.warnings.empty() ? "the loads of the threads do not converge" : sentence(found.warnings.back());
  if (!found.threads) return std::nullopt;
  const std::vector<SlipModel> nuts = models.of_nuts(found);
  for (std::size_t n = 0; n < nuts.size(); ++n)
    if (!add(nuts[n], known[n])) return std::nullopt;
  return all();
}

std::optional<OfParts> CaseLosses::estimate(const PerInterface<double>& oil, bool rough) const {
  const Oils oils = warm_oils(conditions_, oil);
  const SlipModel model = (rough ? rough_models_ : models_).equal_shares(load_, &oils);
  SlipBalance balance;
  if (!balance_at(model, slip_ratio_, balance)) return std::nullopt;
  return heat_of(lost_power(model, balance));
}

HeatSource mean_heat(const std::vector<LossShare>& exact, const std::vector<LossShare>& equal, bool may_grow) {
  const auto sum = [](const std::vector<LossShare>& parts, auto heat_of) -> std::optional<OfParts> {
    OfParts all = OfParts::Zero();
    for (const LossShare& part : parts) {
      const std::optional<OfParts> heat = heat_of(part);
      if (!heat) return std::nullopt;
      all += part.share * *heat;
    }
    return all;
  };
  const auto failure = std::make_shared<std::string>();
  return {[=](const OfParts& t) {
            return sum(exact, [&](const LossShare& part) -> std::optional<OfParts> {
              const std::optional<Losses> losses = part.losses->at(t);
              if (losses) return losses->heat;
              *failure = part.failure();
              return std::nullopt;
            });
          },
          [=] { return *failure; },
          [=](const PerInterface<double>& oil) {
            return sum(equal, [&](const LossShare& part) { return part.losses->estimate(oil); });
          },
          [=](const PerInterface<double>& oil) {
            return sum(equal, [&](const LossShare& part) { return part.losses->estimate(oil, true); });
          },
          may_grow};
}

}  // namespace prs
