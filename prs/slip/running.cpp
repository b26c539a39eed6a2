#include "prs/slip/running.h"

#include <numeric>

#include "prs/indices.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_warnings.h"

namespace prs {
namespace {

using fe::NewtonStatus;

/// Reason why there are no loads of a running screw, if those at rest are known.
Warning why_not_running(const RunningLoads& r) {
  switch (r.status) {
    case RunningStatus::jammed:
    case RunningStatus::slip_no_equilibrium:
      return no_slip(r.status == RunningStatus::jammed, "running loads");
    case RunningStatus::iteration_limit:
      return Warning{"friction", "running_iteration_limit",
                     "running loads do not converge: a load still changes by {value} of the largest "
                     "in a round"}
          .with(r.change);
    default:
      return {"friction", "running_no_equilibrium",
              "running loads: with this friction no loads of the threads are in equilibrium"};
  }
}

/// Result without loads.
LoadCaseResult not_running(LoadCaseResult rest) {
  if (rest.threads)
    rest.warnings.push_back(why_not_running(*rest.running));
  else
    rest.running->status = running_status(rest.solve->status);
  rest.threads.reset();
  rest.full.reset();
  rest.axial_displacement = rest.axial_stiffness = rest.tangent_stiffness = {};
  return rest;
}

/// Result with running loads, with axial forces as in slip.
LoadCaseResult with_friction(LoadCaseResult loaded, LoadCaseResult slipped) {
  for (const Interface i : kInterfaces) {
    InterfaceLoads &to = (*loaded.threads)[i], &from = (*slipped.threads)[i];
    to.axial_load = std::move(from.axial_load);
    to.load_rate = std::move(from.load_rate);
    to.friction = std::move(from.friction);
    to.running_over_static = from.running_over_static;
    if (!to.rollers) continue;
    const auto row = static_cast<std::ptrdiff_t>(to.threads_per_roller);
    for (auto first = to.axial_load.begin(); double& share : to.rollers->share) {
      share = std::accumulate(first, first + row, 0.0) / loaded.load_case.axial_force;
      first += row;
    }
  }
  loaded.loads = slipped.loads;
  loaded.running = std::move(slipped.running);
  return loaded;
}

/// Takes the loads at rest for those of a running screw that are to be found.
void start(LoadCaseResult& rest) {
  rest.loads = ModelOptions::Loads::running;
  RunningLoads& running = rest.running.emplace();
  if (rest.threads)
    running.at_rest = {{largest(rest.threads->screw.normal_load), largest(rest.threads->nut.normal_load)},
                       rest.axial_displacement.value_or(0.0)};
}

/// A loose screw: it turns without friction, and its loads are those at rest.
LoadCaseResult running_without_contact(LoadCaseResult rest) {
  rest.running->status = RunningStatus::converged;
  rest.running->guide_force = rest.other_flank->guide_force;
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*rest.threads)[i];
    const std::vector<double> none(loads.normal_load.size(), 0.0);
    loads.friction = FrictionForces{loads.threads_per_roller, none, none, none};
  }
  return rest;
}

}  // namespace

LoadCaseResult RunningSolver::solve(const LoadCase& load_case, Detail detail, std::optional<SlipEquilibrium>& slip) {
  second_nut_.reset();
  return has_both_flanks(conditions_, load_case.share) ? of_flanks(load_case, slip)
         : conditions_.model.all_rollers()             ? of_all_rollers(load_case, detail, slip)
                                                       : of_sector(load_case, slip);
}

LoadCaseResult RunningSolver::of_flanks(const LoadCase& load_case, std::optional<SlipEquilibrium>& slip) {
  if (!flanks_) flanks_.emplace(conditions_, contacts_);
  const Direction named = *load_case.direction;
  LoadCaseResult rest = flanks_->solve(load_case);
  start(rest);
  if (!rest.threads) return not_running(std::move(rest));
  const PerInterface<double> at_rest = rest.running->at_rest.largest_normal_load;
  const std::size_t threads = rest.threads->screw.normal_load.size();
  const auto carries = [&](Interface i) {
    return at_rest[i] > 0.0 || largest(rest.other_flank->threads[i].normal_load) > 0.0;
  };
  if (std::ranges::none_of(kInterfaces, carries)) return running_without_contact(std::move(rest));
  const bool two_nuts = rest.other_flank->of_second_roller;
  BodyAnswer answer{NewtonStatus::converged, {}, rest.other_flank->guide_force};
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*rest.threads)[i];
    FlankThreads& other = rest.other_flank->threads[i];
    append(loads.normal_load, other.normal_load);
    loads.axial_load.resize(2 * threads);
    loads.load_rate.resize(2 * threads);
    answer.normal_load[i] = loads.normal_load;
    other = {};
  }
  const auto of_flank = [&](const std::vector<RollerPush>& push) {
    PerDirection<RollerPush> by_direction;
    by_direction[named] = push[0];
    by_direction[opposite(named)] = push[1];
    return by_direction;
  };

  PreloadPoint last;
  const RunningBodies bodies{[&](const std::vector<RollerPush>& push) {
    last = flanks_->go_on(load_case, of_flank(push));
    BodyAnswer to{last.solve.status, {}, {}};
    if (!last.solve.converged()) return to;
    to.guide_force = flanks_->guide_forces(last, named, of_flank(push));
    for (const Interface i : kInterfaces)
      for (const Direction d : {named, opposite(named)}) append(to.normal_load[i], last.sides[d].normal_load[i]);
    return to;
  }};
  std::vector<SlipEquilibrium> found =
      running_equilibrium(conditions_, contacts_, models_,
                          {{0, 1}, threads, two_nuts ? RunningRollers::Rows::nuts : RunningRollers::Rows::flanks},
                          answer, bodies, rest, last_spin_)
          .slip;
  if (!rest.running->converged()) {
    rest.other_flank.reset();
    return not_running(std::move(rest));
  }
  slip = std::move(found.front());
  if (two_nuts) second_nut_ = std::move(found.back());

  LoadCaseResult loaded = both_flanks_result(load_case, contacts_, laws_, std::move(last));
  loaded.other_flank->of_second_roller = two_nuts;
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*rest.threads)[i];
    FlankThreads& other = loaded.other_flank->threads[i];
    const auto cut = [&](std::vector<double>& values) {
      std::vector<double> behind(values.begin() + static_cast<std::ptrdiff_t>(threads), values.end());
      values.resize(threads);
      return behind;
    };
    other.normal_load = cut(loads.normal_load);
    other.axial_load = cut(loads.axial_load);
    cut(loads.load_rate);
    if (load_case.axial_force == 0.0) std::ranges::fill(loads.load_rate, kNoShare);
    for (const auto& [force, _] : kFrictionComponents) cut((*loads.friction).*force);
    loads.running_over_static = over_static(loads, at_rest[i]);
  }
  return with_friction(std::move(loaded), std::move(rest));
}

RunningSolver::SectorAt& RunningSolver::sector_at(Direction d, double position) {
  std::unique_ptr<SectorAt>& kept = sectors_[{d, position}];
  if (!kept) kept = std::make_unique<SectorAt>(LoadedSector{{conditions_, contacts_, laws_}, d, position});
  return *kept;
}

LoadCaseResult RunningSolver::of_sector(const LoadCase& load_case, std::optional<SlipEquilibrium>& slip) {
  SectorAt& at = sector_at(*load_case.direction, *load_case.position);
  RunningSector& bodies = *at.bodies;
  LoadCaseResult rest = solved_result(load_case, contacts_, laws_, bodies.at_rest(load_case.axial_force));
  start(rest);
  if (!rest.threads) return not_running(std::move(rest));
  const auto answer_to = [&](const RollerPush& push, NewtonStatus status) {
    BodyAnswer answer{status, bodies.normal_load(), {}};
    if (at.guides)
      answer.guide_force.push_back(at.guides->forces(answer.normal_load, push));
    else if (at.sector.has_loose_guides())
      answer.guide_force.push_back(bodies.guides().of_ends());
    return answer;
  };

  const auto threads = static_cast<std::size_t>(at.sector.contacts());
  const RunningBodies running{
      [&](const std::vector<RollerPush>& push) { return answer_to(push.front(), bodies.go_on(push.front())); },
      [&](const std::vector<RollerPush>& per_normal_load) -> std::optional<BodyAnswer> {
        RollerPush push = per_normal_load.front();
        if (!bodies.follow(push)) return std::nullopt;
        const BodyAnswer loads = answer_to(push, NewtonStatus::converged);
        for (const Interface i : kInterfaces)
          for (const auto k : up_to(threads)) {
            push.axial[i][k] *= loads.normal_load[i][k];
            push.radial[i][k] *= loads.normal_load[i][k];
          }
        return answer_to(push, NewtonStatus::converged);
      }};
  RunningEquilibrium found =
      running_equilibrium(conditions_, contacts_, models_, {{0}, threads},
                          answer_to(no_push(threads), NewtonStatus::converged), running, rest, last_spin_);
  slip = std::move(found.slip.front());
  if (!rest.running->converged()) return not_running(std::move(rest));
  return with_friction(solved_result(load_case, contacts_, laws_, bodies.loads(found.push.front())), std::move(rest));
}

/// Running loads of all rollers at one carrier angle, and the workspace of their search.
struct RunningSolver::AllRunning {
  LoadCaseResult result;
  FullDistribution loads;
  std::vector<RollerPush> push;
  std::optional<SlipEquilibrium> slip;
};

RunningSolver::AllRunning RunningSolver::all_rollers_at(const LoadCase& load_case, FullSolver& solver) {
  RunningRollers rollers{{}, static_cast<std::size_t>(contacts_.mechanism.contacts_per_roller)};
  const std::vector<int>& missing = conditions_.deviations.missing_rollers;
  for (int r = 0; r < contacts_.mechanism.rollers; ++r)
    if (!contains(missing, r + 1)) rollers.present.push_back(static_cast<std::size_t>(r));
  const auto forces_on_guides = [&](const std::array<RingForce, 2>& rings) {
    std::vector<std::array<double, 2>> all;
    if (conditions_.model.roller == ModelOptions::Roller::flexible)
      for (const std::size_t r : rollers.present) all.push_back({rings[0].rollers[r], rings[1].rollers[r]});
    return all;
  };

  AllRunning all;
  all.result = full_result(load_case, conditions_, contacts_, laws_, solver, Detail::numbers);
  LoadCaseResult& rest = all.result;
  start(rest);
  if (!rest.threads) {
    rest = not_running(std::move(rest));
    return all;
  }
  const auto under = [&](std::vector<RollerPush> push, bool RollerPush::*kind) {
    for (RollerPush& one : push) one.*kind = true;
    all.loads = full_distribution(load_case, conditions_, contacts_, laws_, solver, Detail::numbers, push);
    BodyAnswer answer{all.loads.solve.status, {}, {}};
    if (!all.loads.solve.converged()) return answer;
    answer.guide_force = forces_on_guides(all.loads.rings);
    for (const Interface i : kInterfaces)
      for (const std::vector<double>& roller : all.loads.normal_load[i]) append(answer.normal_load[i], roller);
    return answer;
  };
  const RunningBodies bodies{[&](const std::vector<RollerPush>& push) { return under(push, &RollerPush::is_trial); },
                             [&](const std::vector<RollerPush>& push) -> std::optional<BodyAnswer> {
                               BodyAnswer answer = under(push, &RollerPush::per_normal_load);
                               if (answer.status != NewtonStatus::converged) return std::nullopt;
                               return answer;
                             }};
  const BodyAnswer at_rest{NewtonStatus::converged,
                           {rest.threads->screw.normal_load, rest.threads->nut.normal_load},
                           forces_on_guides(rest.full->rings)};
  RunningEquilibrium found =
      running_equilibrium(conditions_, contacts_, models_, rollers, at_rest, bodies, rest, last_spin_);
  all.slip = std::move(found.slip.front());
  all.push = std::move(found.push);
  if (!rest.running->converged()) rest = not_running(std::move(rest));
  return all;
}

LoadCaseResult RunningSolver::of_all_rollers(const LoadCase& load_case, Detail detail,
                                             std::optional<SlipEquilibrium>& slip) {
  LoadCase here = load_case;
  here.spatial.orbit.reset();
  here.modes.reset();
  if (here.travel) here.travel->turns = 0;  // Parts as turned, without positions.
  FullSolver solver(FullStart::neighbour);
  AllRunning all = all_rollers_at(here, solver);
  slip = std::move(all.slip);
  all.result.load_case = load_case;
  if (!all.result.threads) return std::move(all.result);
  LoadCaseResult result = with_friction(full_result(load_case, conditions_, contacts_, laws_, solver, detail, all.push),
                                        std::move(all.result));
  FullLoads full = *result.full;
  set_symmetric(full, result);
  if (load_case.spatial.orbit) {
    Orbit orbit = turned(here, *load_case.spatial.orbit);
    if (orbit.converged())
      full.orbit = std::move(orbit);
    else
      result.warnings.push_back(no_orbit(*orbit.failure));
  }
  result.full = std::make_shared<const FullLoads>(std::move(full));
  return result;
}

void RunningSolver::set_symmetric(FullLoads& full, LoadCaseResult& result) const {
  Conditions nominal = conditions_;
  nominal.deviations = {};
  nominal.model.mechanism = ModelOptions::Mechanism::sector;
  LoadCase axial = result.load_case;
  axial.spatial = {};
  std::optional<SlipEquilibrium> slip;
  const SlipModels models(nominal, contacts_, models_.oils());
  const LoadCaseResult alike = RunningSolver(nominal, contacts_, models).solve(axial, Detail::numbers, slip);
  if (!alike.threads) return;
  full.symmetric = {*alike.axial_displacement, alike.tangent_stiffness, {}};
  full.symmetric_stiffness = *alike.axial_stiffness;
  for (const Interface i : kInterfaces) {
    full.symmetric.largest_normal_load[i] = largest((*alike.threads)[i].normal_load);
    RollerShares& shares = *(*result.threads)[i].rollers;
    shares.overload_factor = shares.largest_normal_load / full.symmetric.largest_normal_load[i];
  }
}

Orbit RunningSolver::turned(const LoadCase& load_case, const SpatialLoad::Orbit& wanted) {
  FullSolver solver(FullStart::neighbour);
  const auto solved = [&](double carrier_angle) {
    LoadCase at = load_case;
    at.spatial.carrier_angle = carrier_angle;
    at.spatial.orbit.reset();
    AllRunning all = all_rollers_at(at, solver);
    if (all.result.threads) return std::move(all.loads);
    FullDistribution failed;
    failed.reason = fmt::format("running loads end as {}", name(all.result.running->status));
    return failed;
  };
  return full_orbit(load_case, conditions_, contacts_, laws_, solved, wanted);
}

namespace {

bool has_slip_ratio_to_find(const LoadCase& load) {
  return load.travel && std::isnan(load.travel->stated_slip_ratio) &&
         load.travel->slip_ratio != Travel::SlipRatio::rolling;
}

}  // namespace

std::optional<Conditions> with_slip_ratios(const Conditions& c, const Contacts& contacts) {
  if (std::ranges::none_of(c.load_cases, has_slip_ratio_to_find)) return std::nullopt;
  Conditions stated = c;
  for (LoadCase& load : stated.load_cases) {
    if (!has_slip_ratio_to_find(load)) continue;
    double& found = load.travel->stated_slip_ratio;
    if (load.travel->slip_ratio == Travel::SlipRatio::ideal) {
      found = ideal_slip_ratio(kinematic_geometry(contacts, axial_force_on_nut(load)));
      continue;
    }
    const std::optional<SlipResult> slip = slip_alone(c, contacts, load);
    if (!slip || !slip->converged())
      throw CaseError(path_in(load, "travel.slip_ratio"),
                      "got solved, but `slip` finds none for this load case; expected a number from "
                      "0 to 1, rolling or ideal; write one of them");
    found = slip->slip_ratio;
  }
  return stated;
}

Result analyze_loads(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (const auto stated = with_slip_ratios(c, contacts)) return analyze_loads(*stated, std::move(contacts), options);
  const auto runs = [&](const LoadCase& load) { return solve_takes_running_loads(c.model, load.share); };
  if (std::ranges::none_of(c.load_cases, runs)) return analyze(c, std::move(contacts), options);
  require_rolling(c, contacts);
  Result result = analyze(c, std::move(contacts), options, runs);
  const SlipModels models(c, result.contacts);
  Conditions alone = c;  // `solve` has one flank, even if the other one is closed too.
  alone.preload.reset();
  RunningSolver solver(alone, result.contacts, models);
  for (LoadCaseResult& loaded : result.load_cases) {
    if (!runs(loaded.load_case)) continue;
    std::optional<SlipEquilibrium> slip;
    loaded = solver.solve(loaded.load_case, options.detail, slip);
    if (options.detail == Detail::complete) add_warnings(loaded, result.contacts);
  }
  return result;
}

}  // namespace prs
