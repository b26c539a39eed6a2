#include "prs/loads/analyze.h"

#include <map>
#include <memory>
#include <variant>

#include "prs/model/case_error.h"
#include "prs/sector/chain/fallback_solver.h"
#include "prs/model/check_case.h"
#include "prs/threads/contact_laws.h"
#include "prs/sector/influence/influence_solver.h"
#include "prs/loads/load_case_result.h"
#include "prs/sector/load_distribution.h"
#include "prs/threads/unusual.h"

namespace prs {
namespace {

/// Solvers by direction and position: load cases on one sector share what does not depend on the
/// load.
class SolverPool {
 public:
  SolverPool(const Case& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
             Detail detail)
      : case_(c), contacts_(contacts), laws_(laws), detail_(detail) {}

  LoadDistribution solve(Direction direction, double position, double axial_force) {
    const auto key = std::pair(direction, position);
    auto found = solvers_.find(key);
    if (found == solvers_.end())
      found = solvers_.try_emplace(key, solver(direction, position)).first;
    return std::visit([&](auto& s) { return s->solve(axial_force); }, found->second);
  }

 private:
  using Solver = std::variant<std::unique_ptr<SectorSolver>, std::unique_ptr<FallbackSolver>,
                              std::unique_ptr<InfluenceSolver>>;

  Solver solver(Direction direction, double position) const {
    if (case_.model.bodies == ModelOptions::Bodies::influence)
      return std::make_unique<InfluenceSolver>(
          influence_solver(case_, contacts_, laws_, direction, position));
    Sector sector = build_sector(case_.mechanism, *case_.structure, *case_.materials, case_.model,
                                 laws_, direction, position, case_.deviations);
    if (detail_ == Detail::numbers) return std::make_unique<FallbackSolver>(std::move(sector));
    return std::make_unique<SectorSolver>(std::move(sector));
  }

  const Case& case_;
  const Contacts& contacts_;
  const PerInterface<ContactLaw>& laws_;
  Detail detail_;
  std::map<std::pair<Direction, double>, Solver> solvers_;
};

/// A result that so far holds the contacts and what is unusual about the case.
Result contacts_of(const Case& c, Detail detail) {
  Result result;
  result.contacts = checked_contacts(c, detail);
  result.model = c.model;
  if (detail == Detail::numbers) return result;
  result.warnings = result.contacts.warnings;
  for (std::string& note : unusual_geometry(c, result.contacts))
    result.warnings.push_back(std::move(note));
  return result;
}

void require_contacts_of(const Case& c, const Contacts& contacts) {
  PerInterface<bool> lacks;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    lacks[i] = !contact.geometry.ok() || (c.materials && !contact.hertz.ok());
  }
  require_contacts(contacts, lacks, "mend profiles, flank angles or diameters");
}

void add(Result& result, LoadCaseResult load_case, Detail detail) {
  if (detail == Detail::complete) add_warnings(load_case, result.contacts);
  result.load_cases.push_back(std::move(load_case));
}

}  // namespace

Contacts checked_contacts(const Case& c, Detail detail) {
  Contacts contacts = find_contacts(c.mechanism, c.materials, detail);
  if (c.mechanism.geometry == Mechanism::Geometry::design) {
    Case designed = c;
    designed.mechanism = contacts.mechanism;
    designed.mechanism.geometry = Mechanism::Geometry::simulation;
    for (const Problem& problem : check_case(designed))
      throw CaseError(problem.path, problem.message);
  }
  return contacts;
}

Result analyze(const Case& given, Detail detail) {
  Result result = contacts_of(given, detail);
  Case c = given;
  c.mechanism = result.contacts.mechanism;
  const PerInterface<ContactLaw> laws = contact_laws(c, result.contacts);
  SolverPool pool(c, result.contacts, laws, detail);
  for (const LoadCase& load_case : c.load_cases) {
    if (load_case.share == LoadCase::Share::equal) {
      add(result, equal_share_result(load_case, result.contacts, laws), detail);
      continue;
    }
    LoadDistribution loads =
        pool.solve(*load_case.direction, *load_case.position, load_case.axial_force);
    add(result, solved_result(load_case, result.contacts, laws, std::move(loads)), detail);
  }
  return result;
}

Result analyze_contacts(const Case& c, Detail detail) {
  Result result = contacts_of(c, detail);
  require_contacts_of(c, result.contacts);
  for (const LoadCase& load_case : c.load_cases)
    if (load_case.share == LoadCase::Share::equal)
      add(result, equal_share_result(load_case, result.contacts), detail);
  return result;
}

}  // namespace prs
