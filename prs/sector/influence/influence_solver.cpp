#include "prs/sector/influence/influence_solver.h"

#include "prs/threads/initial_gaps.h"

namespace prs {
namespace {

/// Loads under which the shoulder's touching part converges; each changes the next only little.
constexpr int kMostRounds = 10;
/// The contact problem is not solved by its energy, and nothing is shifted.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

fe::NewtonStatus newton_status(ContactSolveStatus status) {
  switch (status) {
    case ContactSolveStatus::converged:
      return fe::NewtonStatus::converged;
    case ContactSolveStatus::line_search_failed:
      return fe::NewtonStatus::line_search_failed;
    case ContactSolveStatus::singular:
      return fe::NewtonStatus::not_positive_definite;
    case ContactSolveStatus::iteration_limit:
      break;
  }
  return fe::NewtonStatus::iteration_limit;
}

}  // namespace

InfluenceSolver::InfluenceSolver(const BodyFlexibilities& bodies, int rollers,
                                 const PerInterface<ContactLaw>& laws,
                                 const PerInterface<std::vector<double>>& gaps)
    : problem_(contact_problem(bodies.joined(), laws, gaps)),
      rollers_(rollers),
      face_(bodies.nut.face) {
  if (face_)
    touching_ = face_->touching_under(Eigen::VectorXd::Ones(problem_.contacts()), face_->all())
                    .value_or(face_->all());
}

LoadDistribution InfluenceSolver::solve(double axial_force) const {
  const double force = axial_force / rollers_;
  ContactSolution s = prs::solve(problem_, force);
  std::vector<ContactIteration> history = s.history;
  if (face_ && s.converged()) {
    ContactProblem problem = problem_;
    ThrustFace::Touching touching = touching_;
    bool settled = false;
    for (int round = 0; round < kMostRounds && s.converged(); ++round) {
      const auto now = face_->touching_under(s.normal_load.tail(problem_.contacts()), touching);
      settled = now == touching;
      if (settled || !now) break;
      auto nut = problem.flexibility.bottomRightCorner(problem_.contacts(), problem_.contacts());
      nut += rollers_ * (face_->flexibility(*now) - face_->flexibility(touching));
      touching = *now;
      s = prs::solve(problem, force);
      history.insert(history.end(), s.history.begin(), s.history.end());
    }
    if (s.converged() && !settled) s.status = ContactSolveStatus::iteration_limit;
  }

  LoadDistribution d;
  d.solve = newton_summary(s, history);
  const int contacts = problem_.contacts();
  for (const Interface i : kInterfaces) {
    const int first = i == Interface::screw ? 0 : contacts;
    for (int k = first; k < first + contacts; ++k) {
      d.normal_load[i].push_back(s.normal_load[k]);
      d.approach[i].push_back(s.approach[k]);
    }
  }
  d.axial_displacement = s.screw_motion;
  if (s.converged()) d.tangent_stiffness = rollers_ * s.tangent_stiffness;
  return d;
}

fe::NewtonSummary newton_summary(const ContactSummary& s,
                                 const std::vector<ContactIteration>& history) {
  fe::NewtonSummary summary;
  summary.status = newton_status(s.status);
  summary.relative_residual = s.residual;
  for (const ContactIteration& i : history)
    summary.history.push_back({.energy = kNone,
                               .relative_residual = i.residual,
                               .step_length = i.step_length,
                               .shift = kNone});
  return summary;
}

BodyGeometry influence_geometry(const Conditions& c, const Contacts& contacts,
                                const PerInterface<ContactLaw>& laws, Direction direction) {
  const Materials& materials = *c.materials;
  PerInterface<HertzPatch> patches;
  for (const Interface i : kInterfaces)
    patches[i] = nominal_patch(contacts.interfaces[i], laws[i], materials[body_of(i)],
                               materials[Part::roller]);
  return body_geometry(contacts.mechanism, *c.structure, materials, laws, patches, direction,
                       c.model);
}

InfluenceSolver influence_solver(const Conditions& c, const Contacts& contacts,
                                 const PerInterface<ContactLaw>& laws, Direction direction,
                                 double position, MatrixCache& cache) {
  const BodyGeometry geometry = influence_geometry(c, contacts, laws, direction);
  try {
    const BodyFlexibilities bodies = body_flexibilities(
        geometry, direction, position, flexibility_options(c.model.accuracy), cache);
    return {bodies, contacts.mechanism.rollers, laws,
            initial_gaps(contacts.mechanism, c.deviations, *c.materials,
                         {laws.screw.normal_angle, laws.nut.normal_angle}, direction)};
  } catch (const std::invalid_argument& reason) {
    throw CaseError("model.bodies",
                    fmt::format("`influence` cannot mesh these bodies: {}; take `refined` or fix "
                                "the geometry",
                                reason.what()));
  }
}

bool influence_is_kept(const Conditions& c, const Contacts& contacts,
                       const PerInterface<ContactLaw>& laws, Direction direction,
                       double position) try {
  MatrixCache kept(shared_matrix_cache(), MatrixCache::KeptOnly{});
  influence_solver(c, contacts, laws, direction, position, kept);
  return true;
} catch (const NotKept&) {
  return false;
}

}  // namespace prs
