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
    : joined_(bodies.joined()),
      bent_(bodies.roller.bent),
      laws_(laws),
      gaps_(gaps),
      rollers_(rollers),
      face_(bodies.nut.face) {
  if (face_)
    touching_ =
        face_->touching_under(face_->equal_loads(static_cast<int>(gaps.nut.size())), face_->all())
            .value_or(face_->all());
}

InfluenceSolver::Turned InfluenceSolver::turned(const RollerPush& push, double sense,
                                                double pitch) const {
  const auto contacts = static_cast<Eigen::Index>(gaps_.screw.size());
  Turned t{Eigen::VectorXd(2 * contacts), Eigen::VectorXd(2 * contacts), {}};
  Eigen::VectorXd radial = Eigen::VectorXd::Zero(joined_.rows());
  for (const Interface i : kInterfaces) {
    const double to_roller = i == Interface::screw ? 1.0 : -1.0;
    const double cosine = std::cos(laws_[i].normal_angle), sine = std::sin(laws_[i].normal_angle);
    for (Eigen::Index k = 0; k < contacts; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double x = sense * push.axial[i][at], y = push.radial[i][at];
      const Eigen::Index row = i == Interface::screw ? k : contacts + k;
      t.along[row] = 1.0 + to_roller * (cosine * x + sine * y);
      t.across[row] = to_roller * (sine * x - cosine * y);
    }
    if (i == Interface::screw) continue;
    radial.segment(2 * contacts, contacts).setConstant(-sine * push.of_thread * pitch);
    radial.tail(contacts).setConstant(cosine * push.of_thread * pitch);
  }
  const Eigen::VectorXd opening = bent_ * radial;
  t.opening.resize(2 * contacts);
  t.opening << opening.head(contacts), opening.segment(2 * contacts, contacts);
  return t;
}

ContactProblem InfluenceSolver::problem(const Eigen::MatrixXd& joined, const Turned& turned) const {
  const auto contacts = static_cast<Eigen::Index>(gaps_.screw.size());
  const Eigen::Index of_one = joined.rows() / 2;
  std::vector<Eigen::Index> normal, tangential;
  for (const Eigen::Index first : {Eigen::Index{0}, of_one})
    for (Eigen::Index k = 0; k < contacts; ++k) {
      normal.push_back(first + k);
      tangential.push_back(first + of_one - contacts + k);
    }
  if (turned.along.size() == 0) return contact_problem(joined(normal, normal), laws_, gaps_);
  ContactProblem p = contact_problem(joined(normal, normal) * turned.along.asDiagonal() +
                                         joined(normal, tangential) * turned.across.asDiagonal(),
                                     laws_, gaps_);
  Eigen::VectorXd axial = turned.along;
  axial.head(contacts) += std::tan(laws_.screw.normal_angle) * turned.across.head(contacts);
  axial.tail(contacts) += std::tan(laws_.nut.normal_angle) * turned.across.tail(contacts);
  p.balance = axial.asDiagonal() * p.rigid;
  p.gap += turned.opening;
  return p;
}

LoadDistribution InfluenceSolver::solve(double axial_force, const Turned& turned) const {
  const double force = axial_force / rollers_;
  const auto contacts = static_cast<Eigen::Index>(gaps_.screw.size());
  Eigen::MatrixXd joined = joined_;
  ContactSolution s = prs::solve(problem(joined, turned), force);
  std::vector<ContactIteration> history = s.history;
  if (face_ && s.converged()) {
    ThrustFace::Touching touching = touching_;
    bool settled = false;
    for (int round = 0; round < kMostRounds && s.converged(); ++round) {
      Eigen::VectorXd loads = Eigen::VectorXd::Zero(joined.rows() / 2);
      loads.head(contacts) = s.normal_load.tail(contacts);
      if (turned.along.size() > 0) {
        loads.tail(contacts) = loads.head(contacts).cwiseProduct(turned.across.tail(contacts));
        loads.head(contacts).array() *= turned.along.tail(contacts).array();
      }
      const auto now = face_->touching_under(loads, touching);
      settled = now == touching;
      if (settled || !now) break;
      joined.bottomRightCorner(loads.size(), loads.size()) +=
          rollers_ * (face_->flexibility(*now) - face_->flexibility(touching));
      touching = *now;
      s = prs::solve(problem(joined, turned), force);
      history.insert(history.end(), s.history.begin(), s.history.end());
    }
    if (s.converged() && !settled) s.status = ContactSolveStatus::iteration_limit;
  }

  LoadDistribution d;
  d.solve = newton_summary(s, history);
  for (const Interface i : kInterfaces) {
    const Eigen::Index first = i == Interface::screw ? 0 : contacts;
    for (Eigen::Index k = first; k < first + contacts; ++k) {
      d.normal_load[i].push_back(s.normal_load[k]);
      d.approach[i].push_back(s.approach[k]);
    }
  }
  d.axial_displacement = s.screw_motion;
  if (s.converged() && turned.along.size() > 0)
    s.tangent_stiffness = tangent_stiffness(problem(joined, {}), force, s.approach);
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
                                 double position, MatrixCache& cache, bool friction) {
  BodyGeometry geometry = influence_geometry(c, contacts, laws, direction);
  geometry.friction = friction;
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
