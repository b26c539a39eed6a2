#include "prs/preload/both_flanks.h"

#include "prs/loads/load_case_result.h"

namespace prs {

FlankSolver::FlankSolver(const Conditions& c, const Contacts& contacts)
    : conditions_(c),
      contacts_(contacts),
      laws_(contact_laws(c, contacts)),
      fitted_at_(preload_sectors(c, contacts, laws_, c.preload->position)),
      fit_(preload_fit(c, contacts, fitted_at_)) {}

LoadCaseResult both_flanks_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws, PreloadPoint point) {
  const Direction named = *load_case.direction;
  LoadDistribution d;
  d.solve = std::move(point.solve);
  d.axial_displacement = -sense(named) * point.axial_displacement;
  d.tangent_stiffness = point.tangent_stiffness;
  for (const Interface i : kInterfaces) {
    d.normal_load[i] = point.sides[named].normal_load[i];
    for (const double load : d.normal_load[i])
      d.approach[i].push_back(std::pow(load / laws[i].hertz_constant, 2.0 / 3.0));
  }
  LoadCaseResult result = solved_result(load_case, contacts, laws, std::move(d));
  if (!result.threads) return result;
  result.other_flank.emplace();
  result.other_flank->rollers = contacts.mechanism.rollers;
  for (const Interface i : kInterfaces) {
    FlankThreads& other = result.other_flank->threads[i];
    other.normal_load = std::move(point.sides[opposite(named)].normal_load[i]);
    for (const double load : other.normal_load)
      other.axial_load.push_back(load * std::cos(laws[i].normal_angle));
  }
  if (load_case.axial_force == 0.0) {
    result.axial_stiffness.reset();
    for (const Interface i : kInterfaces)
      std::ranges::fill((*result.threads)[i].load_rate, kNoShare);
  }
  return result;
}

LoadCaseResult FlankSolver::solve(const LoadCase& load_case) {
  const double position = *load_case.position;
  auto at = at_position_.find(position);
  if (at == at_position_.end()) {
    const PreloadSectors sectors = position == conditions_.preload->position
                                       ? fitted_at_
                                       : preload_sectors(conditions_, contacts_, laws_, position);
    at = at_position_.emplace(position, At{PreloadedMechanism(sectors, fit_), {}}).first;
    for (const Direction d : kDirections)
      if (const Sector& flank = *sectors.tension.flanks[d].sector; flank.bends())
        at->second.guides[d].emplace(flank);
  }
  last_ = &at->second;
  const Direction named = *load_case.direction;
  solver_ = &last_->mechanism[named];
  PreloadPoint point = solver_->solve(-sense(named) * load_case.axial_force);
  // A loose screw without a load.
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      point.sides[d].normal_load[i].resize(solver_->sector().sides[d].springs[i].size());
  LoadCaseResult result = both_flanks_result(load_case, contacts_, laws_, point);
  if (!result.other_flank) return result;
  result.other_flank->of_second_roller = !solver_->sector().rollers_are_shared();
  PerDirection<RollerPush> none;
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      none[d].axial[i] = none[d].radial[i] =
          std::vector<double>(point.sides[d].normal_load[i].size(), 0.0);
  result.other_flank->guide_force = guide_forces(point, named, none);
  return result;
}

PreloadPoint FlankSolver::go_on(const LoadCase& load_case, const PerDirection<RollerPush>& push) {
  return solver_->go_on(-sense(*load_case.direction) * load_case.axial_force,
                        push_loads(solver_->sector(), push));
}

std::vector<std::array<double, 2>> FlankSolver::guide_forces(
    const PreloadPoint& point, Direction named, const PerDirection<RollerPush>& push) const {
  if (!last_->guides.tension) return {};
  std::vector<std::array<double, 2>> all;
  for (const Direction d : {named, opposite(named)})
    all.push_back(last_->guides[d]->forces(point.sides[d].normal_load, push[d]));
  if (!solver_->sector().rollers_are_shared()) return all;
  return {{all[0][0] + all[1][0], all[0][1] + all[1][1]}};
}

}  // namespace prs
