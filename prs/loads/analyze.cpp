#include "prs/loads/analyze.h"

#include <map>

#include "prs/bodies/body_solver.h"
#include "prs/loads/full_result.h"
#include "prs/model/check_case.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

/// Solvers by direction and position: load cases on one sector share all that does not depend on the load.
class SolverPool {
 public:
  SolverPool(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws, Solver solver)
      : conditions_(c), contacts_(contacts), laws_(laws), solver_(solver) {}

  LoadDistribution solve(Direction direction, double position, double axial_force) {
    DistributionSolver& solver = solvers_[{direction, position}];
    if (!solver)
      solver = body_solver(conditions_).at_rest({{conditions_, contacts_, laws_}, direction, position}, solver_);
    return solver(axial_force);
  }

 private:
  const Conditions& conditions_;
  const Contacts& contacts_;
  const PerInterface<ContactLaw>& laws_;
  Solver solver_;
  std::map<std::pair<Direction, double>, DistributionSolver> solvers_;
};

/// A result with contacts and warnings of the geometry only.
Result result_on(const Conditions& c, Contacts contacts, Detail detail) {
  Result result;
  result.contacts = std::move(contacts);
  result.model = c.model;
  if (detail == Detail::complete) result.warnings = geometry_warnings(c, result.contacts, c.load_cases);
  return result;
}

/// Checks the case with the radii that a design has computed.
void check_designed(Case& c, Mechanism mechanism) {
  mechanism.geometry = Mechanism::Geometry::simulation;
  std::swap(c.mechanism, mechanism);
  const std::vector<Problem> problems = check_case(c);
  std::swap(c.mechanism, mechanism);
  if (!problems.empty()) throw CaseError(problems.front());
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
    check_designed(designed, contacts.mechanism);
  }
  return contacts;
}

Mechanism checked_mechanism(Case& c) {
  Mechanism mechanism = resolved(c.mechanism);
  if (c.mechanism.geometry == Mechanism::Geometry::design) check_designed(c, mechanism);
  return mechanism;
}

Result analyze(const Conditions& c, Contacts contacts, AnalysisOptions options,
               const std::function<bool(const LoadCase&)>& left_out) {
  Result result = result_on(c, std::move(contacts), options.detail);
  const PerInterface<ContactLaw> laws = contact_laws(c, result.contacts);
  SolverPool pool(c, result.contacts, laws, options.solver);
  FullSolver own;
  FullSolver& full = options.full ? *options.full : own;
  for (const LoadCase& load_case : c.load_cases) {
    if (left_out && left_out(load_case)) {
      result.load_cases.emplace_back().load_case = load_case;
      continue;
    }
    if (load_case.share == LoadCase::Share::equal) {
      add(result, equal_share_result(load_case, result.contacts, laws), options.detail);
      continue;
    }
    if (c.model.all_rollers()) {
      add(result, full_result(load_case, c, result.contacts, laws, full, options.detail), options.detail);
      continue;
    }
    LoadDistribution loads = pool.solve(*load_case.direction, *load_case.position, load_case.axial_force);
    add(result, solved_result(load_case, result.contacts, laws, std::move(loads)), options.detail);
  }
  return result;
}

Result analyze_contacts(const Conditions& c, Contacts contacts, Detail detail) {
  Result result = result_on(c, std::move(contacts), detail);
  require_contacts(c, result.contacts);
  for (const LoadCase& load_case : c.load_cases)
    if (load_case.share == LoadCase::Share::equal) add(result, equal_share_result(load_case, result.contacts), detail);
  return result;
}

}  // namespace prs
