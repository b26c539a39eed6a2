#include "prs/analyze.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "prs/case_error.h"
#include "prs/check_case.h"
#include "prs/load_distribution.h"
#include "prs/threads.h"

namespace prs {
namespace {

const char* key(Interface i) { return i == Interface::screw ? "screw" : "nut"; }

/// What the load distribution uses at an interface: the case's overrides before the geometry.
ContactLaw contact_law(const Case& c, Interface i, const InterfaceContact& contact) {
  const auto& constant = c.contact.hertz_constant[i];
  const auto& angle = c.contact.normal_angle[i];
  if (!contact.has_hertz() && !(constant && angle))
    throw CaseError("mechanism",
                    fmt::format("the {} threads give no Hertz contact: {}; mend profiles, flank "
                                "angles or diameters, or give both contact.hertz_constant.{} and "
                                "contact.normal_angle.{}",
                                label(i), failure(contact, i), key(i), key(i)));
  return {constant ? *constant : contact.hertz.hertz_constant,
          angle ? *angle : contact.normal_angle()};
}

void add_hertz_contacts(InterfaceLoads& loads, const contact::HertzConstants& hertz) {
  for (const double normal_load : loads.normal_load) {
    const contact::HertzContact at = contact::at_load(hertz, normal_load);
    loads.semi_major.push_back(at.semi_major);
    loads.semi_minor.push_back(at.semi_minor);
    loads.peak_pressure.push_back(at.peak_pressure);
  }
}

InterfaceLoads interface_loads(const LoadCase& load_case, const Mechanism& m, const ContactLaw& law,
                               const InterfaceContact& contact, std::vector<double> normal_load,
                               std::vector<double> approach) {
  InterfaceLoads loads;
  loads.hertz_constant = law.hertz_constant;
  loads.normal_angle = law.normal_angle;
  loads.normal_load = std::move(normal_load);
  loads.approach = std::move(approach);
  const double cosine = std::cos(law.normal_angle);
  const double roller_force = std::abs(load_case.axial_force) / m.rollers;
  for (const double n : loads.normal_load) {
    loads.axial_load.push_back(n * cosine);
    loads.load_rate.push_back(n * cosine / roller_force);
  }
  if (contact.has_hertz()) add_hertz_contacts(loads, contact.hertz);
  return loads;
}

/// Threads that carry the same load by assumption.
std::vector<double> equal_normal_loads(const LoadCase& load_case, const Mechanism& m, double psi) {
  const double contacts = static_cast<double>(m.rollers) * m.contacts_per_roller;
  return std::vector<double>(static_cast<std::size_t>(m.contacts_per_roller),
                             std::abs(load_case.axial_force) / contacts / std::cos(psi));
}

std::vector<double> hertz_approaches(const std::vector<double>& normal_load, double constant) {
  std::vector<double> approach;
  for (const double n : normal_load) approach.push_back(std::pow(n / constant, 2.0 / 3.0));
  return approach;
}

std::vector<std::string> thread_warnings(const PerInterface<InterfaceLoads>& threads) {
  std::vector<std::string> warnings;
  for (const Interface i : kInterfaces) {
    const auto open = std::count(threads[i].normal_load.begin(), threads[i].normal_load.end(), 0.0);
    if (open > 0)
      warnings.push_back(fmt::format("{} of {} {} contacts are open", open,
                                     threads[i].normal_load.size(), label(i)));
    const auto& pressure = threads[i].peak_pressure;
    const auto highest = std::max_element(pressure.begin(), pressure.end());
    if (highest != pressure.end() && *highest > kStaticPressureLimit)
      warnings.push_back(fmt::format("{} peak pressure {:.2f} GPa exceeds {:.1f} GPa", label(i),
                                     *highest * 1e-9, kStaticPressureLimit * 1e-9));
  }
  return warnings;
}

/// Solvers by direction and position: load cases on one sector share the symbolic factorization.
class SolverPool {
 public:
  SolverPool(const Case& c, const PerInterface<ContactLaw>& laws) : case_(c), laws_(laws) {}

  SectorSolver& at(Direction direction, double position) {
    const auto key = std::pair(direction, position);
    auto found = solvers_.find(key);
    if (found == solvers_.end())
      found =
          solvers_
              .try_emplace(key, build_sector(case_.mechanism, *case_.structure, *case_.materials,
                                             case_.model, laws_, direction, position))
              .first;
    return found->second;
  }

 private:
  const Case& case_;
  const PerInterface<ContactLaw>& laws_;
  std::map<std::pair<Direction, double>, SectorSolver> solvers_;
};

LoadCaseResult equal_share_result(const Case& c, const LoadCase& load_case,
                                  const PerInterface<ContactLaw>& laws,
                                  const PerInterface<InterfaceContact>& contacts) {
  LoadCaseResult result;
  result.load_case = load_case;
  PerInterface<InterfaceLoads> threads;
  for (const Interface i : kInterfaces) {
    const std::vector<double> loads =
        equal_normal_loads(load_case, c.mechanism, laws[i].normal_angle);
    threads[i] = interface_loads(load_case, c.mechanism, laws[i], contacts[i], loads,
                                 hertz_approaches(loads, laws[i].hertz_constant));
  }
  result.warnings = thread_warnings(threads);
  result.threads = std::move(threads);
  return result;
}

LoadCaseResult solved_result(const Case& c, const LoadCase& load_case,
                             const PerInterface<ContactLaw>& laws,
                             const PerInterface<InterfaceContact>& contacts, SolverPool& pool) {
  LoadCaseResult result;
  result.load_case = load_case;
  SectorSolver& solver = pool.at(*load_case.direction, *load_case.position);
  LoadDistribution d = solver.solve(load_case.axial_force);
  result.solve = std::move(d.solve);
  if (!result.solve->converged()) {
    result.warnings.push_back(fmt::format("not converged: {}, relative residual {:.1e}",
                                          fe::name(result.solve->status),
                                          result.solve->relative_residual));
    return result;
  }
  result.axial_displacement = d.axial_displacement;
  result.axial_stiffness = load_case.axial_force / d.axial_displacement;
  result.tangent_stiffness = d.tangent_stiffness;
  PerInterface<InterfaceLoads> threads;
  for (const Interface i : kInterfaces)
    threads[i] = interface_loads(load_case, c.mechanism, laws[i], contacts[i],
                                 std::move(d.normal_load[i]), std::move(d.approach[i]));
  result.warnings = thread_warnings(threads);
  result.threads = std::move(threads);
  return result;
}

/// The case with its mechanism resolved. A designed mechanism must fit the structure as well.
Case with_resolved_mechanism(const Case& c) {
  Case r = c;
  r.mechanism = resolved(c.mechanism);
  if (c.mechanism.geometry == Mechanism::Geometry::design)
    for (const Problem& problem : check_case(r)) throw CaseError(problem.path, problem.message);
  return r;
}

}  // namespace

Result analyze(const Case& given) {
  const Case c = with_resolved_mechanism(given);
  Result result;
  result.mechanism = c.mechanism;
  const PerInterface<InterfaceContact> contacts = interface_contacts(c.mechanism, c.materials);
  PerInterface<ContactLaw> laws;
  for (const Interface i : kInterfaces) {
    laws[i] = contact_law(c, i, contacts[i]);
    if (contacts[i].has_hertz())
      result.contact[i] = contacts[i];
    else
      result.warnings.push_back(fmt::format(
          "the {} threads give no Hertz contact ({}): ellipses and pressures are absent", label(i),
          failure(contacts[i], i)));
  }

  SolverPool pool(c, laws);
  for (const LoadCase& load_case : c.load_cases)
    result.load_cases.push_back(load_case.share == LoadCase::Share::equal
                                    ? equal_share_result(c, load_case, laws, contacts)
                                    : solved_result(c, load_case, laws, contacts, pool));
  return result;
}

}  // namespace prs
