#include "prs/preload/preloaded_mechanism.h"

#include "prs/loads/load_case_result.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {

PerDirection<double> held_sections(const Structure::Thrust& thrust) {
  return {thrust.tension ? *thrust.tension : *thrust.compression,
          thrust.compression ? *thrust.compression : *thrust.tension};
}

PreloadSectors preload_sectors(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                               double position, Play play) {
  Preload preload = *c.preload;
  preload.position = position;
  const PreloadParts parts{contacts.mechanism, *c.structure, *c.materials, c.model, laws, c.deviations, preload};
  const PerDirection<double> section = held_sections(c.structure->nut.thrust);
  PreloadSectors sectors;
  for (const Direction d : kDirections) sectors[d] = build_preload_sector(parts, d, section[d], play);
  return sectors;
}

namespace {

PreloadSector reference_sector(const Conditions& c, const Contacts& contacts) {
  Conditions cold = c;
  cold.deviations.temperature.reset();
  return preload_sectors(cold, contacts, contact_laws(c, contacts), c.preload->position).tension;
}

std::vector<double> loads_of(const LoadSweep& sweep) {
  if (!sweep.loads.empty()) return sweep.loads;
  const double largest = std::max(std::abs(sweep.from), std::abs(sweep.to));
  std::vector<double> loads;
  const int last = sweep.steps - 1;
  for (int k = 0; k <= last; ++k) {
    const double load = k == last ? sweep.to : sweep.from + (sweep.to - sweep.from) * k / last;
    loads.push_back(std::abs(load) < 1e-12 * largest ? 0.0 : load);
  }
  return loads;
}

/// `where`: beginning of the sentence with the reason why a load did not converge, which becomes a warning.
PreloadCurve curve_of(PreloadedMechanism& solvers, const std::vector<double>& loads, double lost_motion_load,
                      std::string_view where, std::vector<Warning>& warnings) {
  const auto warn = [&](double load, const fe::NewtonSummary& summary) {
    warnings.push_back(Warning{"", "not_converged",
                               fmt::format("{}{{{:.6g} N}}: not converged: {}, relative residual {:.1e}", where, load,
                                           fe::name(summary.status), summary.relative_residual)}
                           .with(summary.relative_residual));
  };
  const bool at_rest =
      std::ranges::all_of(kDirections, [&](Direction d) { return solvers[d].at_rest().solve.converged(); });
  for (const Direction d : kDirections)
    if (!solvers[d].at_rest().solve.converged()) warn(0.0, solvers[d].at_rest().solve);
  const auto solve = [&](double load) {
    PreloadPoint point = solvers.solve(load);
    if (at_rest && !point.solve.converged()) warn(load, point.solve);
    return point;
  };
  PreloadCurve curve;
  for (const double load : loads) curve.points.push_back(solve(load));
  for (const Direction d : kDirections) curve.stiffness_at_zero[d] = solvers[d].at_rest().tangent_stiffness;
  const PreloadPoint pulled = solve(lost_motion_load);
  const PreloadPoint pushed = solve(-lost_motion_load);
  if (pulled.solve.converged() && pushed.solve.converged())
    curve.lost_motion = pulled.axial_displacement - pushed.axial_displacement;
  return curve;
}

void warn_of_pressure(PreloadResult& result) {
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = result.contacts.interfaces[i];
    if (!contact.has_hertz()) continue;
    double load = 0.0;
    for (const PreloadPoint& point : result.curve.points)
      for (const Direction d : kDirections) load = std::max(load, point.sides[d].max_normal_load[i]);
    const double pressure = contact::at_load(contact.hertz, load).peak_pressure;
    if (auto warning = static_pressure_warning("preload.load", i, pressure, result.contacts))
      result.warnings.push_back(*std::move(warning));
  }
}

}  // namespace

Fit preload_fit(const Conditions& c, const Contacts& contacts, const PreloadSectors& sectors) {
  const bool warm = c.deviations.temperature.has_value();
  const Fit fit = find_fit(warm ? reference_sector(c, contacts) : sectors.tension, *c.preload);
  const double found = interference(sectors.tension, fit);
  const double most = kMostDeviation * axial_pitch(contacts.mechanism);
  if (found <= most) return warm ? at_temperature(sectors.tension, fit) : fit;
  throw CaseError("preload.force", fmt::format("asks for an interference of {:.4g} mm; expected at most {:.4g} mm, a "
                                               "quarter of the pitch; take less preload",
                                               1e3 * found, 1e3 * most));
}

Conditions with_interference(Conditions c, const Contacts& contacts) {
  if (!c.preload || !c.preload->force) return c;
  Conditions cold = c;
  cold.deviations.temperature.reset();
  const PreloadSectors sectors = preload_sectors(cold, contacts, contact_laws(cold, contacts), cold.preload->position);
  c.preload->interference = interference(sectors.tension, preload_fit(cold, contacts, sectors));
  c.preload->force.reset();
  return c;
}

double reference_preload(const Conditions& c, const Contacts& contacts) {
  const PreloadSector sector = reference_sector(c, contacts);
  return PreloadSolver(fitted(sector, find_fit(sector, *c.preload))).at_rest().sides.tension.axial_load.screw;
}

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
  d.guides = std::move(point.guides);
  if (d.guides.size() == 2 && named == Direction::compression) std::swap(d.guides[0], d.guides[1]);
  for (const Interface i : kInterfaces) {
    d.normal_load[i] = point.sides[named].normal_load[i];
    for (const double load : d.normal_load[i])
      d.approach[i].push_back(std::pow(load / laws[i].hertz_constant, 2.0 / 3.0));
  }
  LoadCaseResult result = solved_result(load_case, contacts, laws, std::move(d));
  if (!result.threads) return result;
  result.other_flank.emplace();
  result.other_flank->rollers = loaded_rollers(contacts.mechanism);
  for (const Interface i : kInterfaces) {
    FlankThreads& other = result.other_flank->threads[i];
    other.normal_load = std::move(point.sides[opposite(named)].normal_load[i]);
    for (const double load : other.normal_load) other.axial_load.push_back(load * std::cos(laws[i].normal_angle));
  }
  if (load_case.axial_force == 0.0) {
    result.axial_stiffness.reset();
    for (const Interface i : kInterfaces) std::ranges::fill((*result.threads)[i].load_rate, kNoShare);
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
      if (const Sector& flank = *sectors.tension.flanks[d].sector; flank.bends() && !flank.has_loose_guides())
        at->second.guides[d].emplace(flank);
  }
  last_ = &at->second;
  const Direction named = *load_case.direction;
  solver_ = &last_->mechanism[named];
  PreloadPoint point = solver_->solve(-sense(named) * load_case.axial_force);
  // Warns of a loose screw without a load.
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      point.sides[d].normal_load[i].resize(solver_->sector().sides[d].springs[i].size());
  LoadCaseResult result = both_flanks_result(load_case, contacts_, laws_, point);
  if (!result.other_flank) return result;
  result.other_flank->of_second_roller = !solver_->sector().rollers_are_shared();
  PerDirection<RollerPush> none;
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      none[d].axial[i] = none[d].radial[i] = std::vector<double>(point.sides[d].normal_load[i].size(), 0.0);
  result.other_flank->guide_force = guide_forces(point, named, none);
  return result;
}

PreloadPoint FlankSolver::go_on(const LoadCase& load_case, const PerDirection<RollerPush>& push) {
  return solver_->go_on(-sense(*load_case.direction) * load_case.axial_force, push_loads(solver_->sector(), push));
}

std::vector<std::array<double, 2>> FlankSolver::guide_forces(const PreloadPoint& point, Direction named,
                                                             const PerDirection<RollerPush>& push) const {
  std::vector<std::array<double, 2>> all;
  for (const GuideLoads& roller : point.guides) all.push_back(roller.of_ends());
  if (!last_->guides.tension) {
    if (all.size() == 2 && named == Direction::compression) std::swap(all[0], all[1]);
    return all;
  }
  for (const Direction d : {named, opposite(named)})
    all.push_back(last_->guides[d]->forces(point.sides[d].normal_load, push[d]));
  if (!solver_->sector().rollers_are_shared()) return all;
  return {{all[0][0] + all[1][0], all[0][1] + all[1][1]}};
}

std::optional<double> PreloadResult::peak_pressure(const SideLoads& loads) const {
  double peak = 0.0;
  for (const Interface i : kInterfaces) {
    if (!contacts.interfaces[i].has_hertz()) return std::nullopt;
    peak = std::max(peak, contact::at_load(contacts.interfaces[i].hertz, loads.max_normal_load[i]).peak_pressure);
  }
  return peak;
}

bool PreloadResult::converged() const {
  const auto all = [](const PreloadCurve& c) {
    return c.lost_motion &&
           std::ranges::all_of(c.points, [](const PreloadPoint& point) { return point.solve.converged(); });
  };
  return heat_status == HeatStatus::converged && at_rest.solve.converged() && all(curve) &&
         (!without_preload || all(*without_preload));
}

PreloadResult analyze_preload(const Conditions& c, Contacts contacts) {
  PreloadResult result;
  result.preload = *c.preload;
  result.contacts = std::move(contacts);
  result.warnings = geometry_warnings(c, result.contacts, {});
  const PerInterface<ContactLaw> laws = contact_laws(c, result.contacts);
  result.section = held_sections(c.structure->nut.thrust);

  const PreloadSectors sectors = preload_sectors(c, result.contacts, laws, c.preload->position);
  const Fit fit = preload_fit(c, result.contacts, sectors);
  PreloadedMechanism solvers(sectors, fit);
  result.at_rest = solvers[Direction::tension].at_rest();
  result.reference_temperature = c.deviations.reference_temperature;
  result.temperature = c.deviations.temperature;
  result.reference_force = c.deviations.temperature ? reference_preload(c, result.contacts) : result.force();
  if (!c.preload->backlash) result.interference = interference(sectors.tension, fit);
  for (const Direction d : kDirections) result.opening_force[d] = solvers[d].opening_force(d);

  const LoadSweep& sweep = c.preload->load;
  result.lost_motion_load =
      c.preload->lost_motion_load.value_or(kLostMotionShare * std::max(std::abs(sweep.from), std::abs(sweep.to)));
  const std::vector<double> loads = loads_of(sweep);
  result.curve = curve_of(solvers, loads, result.lost_motion_load, "at ", result.warnings);
  if (!c.preload->backlash) {
    PreloadedMechanism loose(preload_sectors(c, result.contacts, laws, c.preload->position, Play::of_warm_parts),
                             Fit{});
    result.without_preload = curve_of(loose, loads, result.lost_motion_load, "without preload at ", result.warnings);
  }
  warn_of_pressure(result);
  return result;
}

}  // namespace prs
