#include "prs/preload/analyze_preload.h"

#include "prs/loads/load_case_result.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

std::vector<double> loads_of(const LoadSweep& sweep) {
  const double largest = std::max(std::abs(sweep.from), std::abs(sweep.to));
  std::vector<double> loads;
  const int last = sweep.steps - 1;
  for (int k = 0; k <= last; ++k) {
    const double load = k == last ? sweep.to : sweep.from + (sweep.to - sweep.from) * k / last;
    loads.push_back(std::abs(load) < 1e-12 * largest ? 0.0 : load);
  }
  return loads;
}

/// `where` introduces the reason why a load did not converge, which becomes a warning.
PreloadCurve curve_of(PreloadedMechanism& solvers, const std::vector<double>& loads,
                      double lost_motion_load, std::string_view where,
                      std::vector<Warning>& warnings) {
  const auto warn = [&](double load, const fe::NewtonSummary& summary) {
    warnings.push_back(
        Warning{"", "not_converged",
                fmt::format("{}{:.6g} N: not converged: {}, relative residual {:.1e}", where, load,
                            fe::name(summary.status), summary.relative_residual)}
            .with(summary.relative_residual));
  };
  const bool at_rest = std::ranges::all_of(
      kDirections, [&](Direction d) { return solvers[d].at_rest().solve.converged(); });
  for (const Direction d : kDirections)
    if (!solvers[d].at_rest().solve.converged()) warn(0.0, solvers[d].at_rest().solve);
  const auto solve = [&](double load) {
    PreloadPoint point = solvers.solve(load);
    if (at_rest && !point.solve.converged()) warn(load, point.solve);
    return point;
  };
  PreloadCurve curve;
  for (const double load : loads) curve.points.push_back(solve(load));
  for (const Direction d : kDirections)
    curve.stiffness_at_zero[d] = solvers[d].at_rest().tangent_stiffness;
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
      for (const Direction d : kDirections)
        load = std::max(load, point.sides[d].max_normal_load[i]);
    const double pressure = contact::at_load(contact.hertz, load).peak_pressure;
    if (pressure > kStaticPressureLimit)
      result.warnings.push_back(static_pressure_warning("preload.load", i, pressure));
  }
}

}  // namespace

std::optional<double> PreloadResult::peak_pressure(const SideLoads& loads) const {
  double peak = 0.0;
  for (const Interface i : kInterfaces) {
    if (!contacts.interfaces[i].has_hertz()) return std::nullopt;
    peak = std::max(
        peak,
        contact::at_load(contacts.interfaces[i].hertz, loads.max_normal_load[i]).peak_pressure);
  }
  return peak;
}

bool PreloadResult::converged() const {
  const auto all = [](const PreloadCurve& c) {
    return c.lost_motion && std::ranges::all_of(c.points, [](const PreloadPoint& point) {
             return point.solve.converged();
           });
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
  result.reference_force =
      c.deviations.temperature ? reference_preload(c, result.contacts) : result.force();
  if (!c.preload->backlash) result.interference = interference(sectors.tension, fit);
  for (const Direction d : kDirections) result.opening_force[d] = solvers[d].opening_force(d);

  const LoadSweep& sweep = c.preload->load;
  result.lost_motion_load = c.preload->lost_motion_load.value_or(
      kLostMotionShare * std::max(std::abs(sweep.from), std::abs(sweep.to)));
  const std::vector<double> loads = loads_of(sweep);
  result.curve = curve_of(solvers, loads, result.lost_motion_load, "at ", result.warnings);
  if (!c.preload->backlash) {
    PreloadedMechanism loose(
        preload_sectors(c, result.contacts, laws, c.preload->position, Play::of_warm_parts), Fit{});
    result.without_preload =
        curve_of(loose, loads, result.lost_motion_load, "without preload at ", result.warnings);
  }
  warn_of_pressure(result);
  return result;
}

}  // namespace prs
