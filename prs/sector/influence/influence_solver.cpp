#include "prs/sector/influence/influence_solver.h"

#include "fe/lu.h"
#include "prs/indices.h"
#include "prs/side_by_side.h"

namespace prs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNominalPressure = 0.02;  ///< Peak pressure over E*.

using Eigen::Index;

/// Largest error of a compatibility condition over the mean Hertz approach, and of an equilibrium
/// condition over the load.
constexpr double kTolerance = 1e-12;
constexpr int kMostIterations = 50, kMostHalvings = 40;

/// Least tangent of a guide in the matrix of a step, over its stiffness; no residual contains it.
constexpr double kLeastTangent = 1e-8;
/// Smallest step of a growing clearance, as a share of it.
constexpr double kLeastClearanceStep = 1e-4;

/// N(y) and its slope.
struct Loads {
  VectorXd value;
  VectorXd slope;
};

Loads loads_at(const ContactProblem& p, const VectorXd& y) {
  const Index contacts = p.hertz_constant.size();
  const Eigen::ArrayXd closed = y.head(contacts).array().max(0.0), root = closed.sqrt();
  Loads loads{VectorXd(y.size()), VectorXd(y.size())};
  loads.value.head(contacts) = p.hertz_constant.array() * closed * root;
  loads.slope.head(contacts) = 1.5 * p.hertz_constant.array() * root;
  for (Index k = contacts; k < y.size(); ++k) {
    const double v = -y[k];
    loads.value[k] = p.held_by * v + p.ring->force(v);
    // A roller that is free within all clearances still has a matrix.
    loads.slope[k] = std::max(p.ring->tangent(v), kLeastTangent * p.ring->stiffness) - p.held_by;
  }
  return loads;
}

/// Unknowns and the residual of the conditions there.
struct Trial {
  VectorXd y;
  Eigen::Vector2d motion;
  Loads loads;
  VectorXd residual;  ///< Relative residual: compatibility, then equilibrium.
};

/// The conditions under a force, in the form for Newton's method.
class Equilibrium {
 public:
  Equilibrium(const ContactProblem& p, double force)
      : p_(p), n_(p.gap.size()), force_(force), jacobian_(n_ + 2, n_ + 2), lu_(n_ + 2) {}

  /// Start: rigid bodies with equal shares, the largest gap closed as well.
  Trial start() {
    const auto contacts = static_cast<double>(p_.contacts());
    const Index first_nut = p_.contacts(), all = 2 * first_nut;
    Trial t;
    t.y.setZero(n_);
    for (Index i = 0; i < all; ++i) {
      const double cosine = std::abs(p_.rigid(i, 1));
      t.y[i] = std::pow(force_ / (contacts * cosine * p_.hertz_constant[i]), 2.0 / 3.0);
    }
    length_ = t.y.head(all).mean();
    t.motion[1] = (t.y[first_nut] + p_.gap.segment(first_nut, first_nut).maxCoeff()) / p_.rigid(first_nut, 1);
    t.motion[0] = t.motion[1] + (t.y[0] + p_.gap.head(first_nut).maxCoeff()) / p_.rigid(0, 0);
    evaluate(t);
    return t;
  }

  /// Newton's step from here, to be subtracted.
  VectorXd step(const Trial& at) {
    factorize(at);
    return lu_.solve(at.residual);
  }

  Trial moved(const Trial& at, const VectorXd& step, double share) const {
    Trial t;
    t.y = at.y - share * step.head(n_);
    t.motion = at.motion - share * step.tail<2>();
    evaluate(t);
    return t;
  }

  double tangent_stiffness(const Trial& at) {
    factorize(at);
    VectorXd rate = VectorXd::Zero(n_ + 2);
    rate[n_] = 1.0 / force_;  // rate for a unit of force, in relative equilibrium
    return 1.0 / lu_.solve(rate)[n_];
  }

  void evaluate(Trial& t) const {
    t.loads = loads_at(p_, t.y);
    t.residual.resize(n_ + 2);
    t.residual.head(n_) = (t.y + p_.gap - p_.rigid * t.motion + p_.flexibility * t.loads.value) / length_;
    t.residual.tail<2>() = (p_.balance.transpose() * t.loads.value - Eigen::Vector2d(force_, 0.0)) / force_;
  }

 private:
  void factorize(const Trial& at) {
    jacobian_.topLeftCorner(n_, n_) = p_.flexibility * at.loads.slope.asDiagonal();
    jacobian_.topLeftCorner(n_, n_).diagonal().array() += 1.0;
    jacobian_.topLeftCorner(n_, n_) /= length_;
    jacobian_.topRightCorner(n_, 2) = -p_.rigid / length_;
    jacobian_.bottomLeftCorner(2, n_) = p_.balance.transpose() * at.loads.slope.asDiagonal() / force_;
    jacobian_.bottomRightCorner<2, 2>().setZero();
    lu_.compute(jacobian_);
  }

  const ContactProblem& p_;
  Index n_;
  double force_;
  double length_ = 0.0;  ///< A typical approach.
  MatrixXd jacobian_;
  Eigen::PartialPivLU<MatrixXd> lu_;
};

}  // namespace

InfluenceSolver::InfluenceSolver(const BodyFlexibilities& bodies, int rollers, const PerInterface<ContactLaw>& laws,
                                 const PerInterface<std::vector<double>>& gaps)
    : joined_(bodies.joined()),
      bent_(bodies.roller.bent),
      guides_(bodies.roller.guides),
      laws_(laws),
      gaps_(gaps),
      rollers_(rollers),
      face_(bodies.nut.face) {
  if (guides_)
    for (MatrixXd* c : {&joined_, &bent_}) {
      const Index contacts = c->rows(), all = contacts + guides();
      c->conservativeResize(all, all);
      c->topRightCorner(contacts, guides()) = guides_->coupling;
      c->bottomLeftCorner(guides(), contacts) = guides_->coupling.transpose();
      c->bottomRightCorner(guides(), guides()) = guides_->between;
    }
  if (face_)
    touching_ = face_->touching_under(face_->equal_loads(static_cast<int>(gaps.nut.size())), face_->all())
                    .value_or(face_->all());
}

InfluenceSolver::Turned InfluenceSolver::turned(const RollerPush& push, double sense, double pitch) const {
  const auto contacts = static_cast<Index>(gaps_.screw.size());
  Turned t{VectorXd(2 * contacts), VectorXd(2 * contacts), {}};
  VectorXd radial = VectorXd::Zero(joined_.rows());
  for (const Interface i : kInterfaces) {
    const double to_roller = i == Interface::screw ? 1.0 : -1.0;
    const double cosine = std::cos(laws_[i].normal_angle), sine = std::sin(laws_[i].normal_angle);
    for (Index k = 0; k < contacts; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double x = sense * push.axial[i][at], y = push.radial[i][at];
      const Index row = i == Interface::screw ? k : contacts + k;
      t.along[row] = 1.0 + to_roller * (cosine * x + sine * y);
      t.across[row] = to_roller * (sine * x - cosine * y);
    }
    if (i == Interface::screw) continue;
    radial.segment(2 * contacts, contacts).setConstant(-sine * push.of_thread * pitch);
    radial.segment(3 * contacts, contacts).setConstant(cosine * push.of_thread * pitch);
  }
  // Each guide gets half of the force on its end.
  if (guides_) radial.tail(guides()).setConstant(0.5 * guides_->end_length * push.of_heads);
  const VectorXd opening = bent_ * radial;
  t.opening.resize(2 * contacts + guides());
  t.opening << opening.head(contacts), opening.segment(2 * contacts, contacts), opening.tail(guides());
  return t;
}

ContactProblem InfluenceSolver::problem(const MatrixXd& joined, const Turned& turned) const {
  const auto contacts = static_cast<Index>(gaps_.screw.size());
  std::vector<Index> normal, tangential;
  for (const Index first : {Index{0}, of_one()})
    for (Index k = 0; k < contacts; ++k) {
      normal.push_back(first + k);
      tangential.push_back(first + of_one() - contacts + k);
    }
  for (Index k = joined.rows() - guides(); k < joined.rows(); ++k) normal.push_back(k);
  MatrixXd flexibility = joined(normal, normal);
  if (turned.along.size() > 0) {
    auto at_contacts = flexibility.leftCols(2 * contacts);
    at_contacts =
        (at_contacts * turned.along.asDiagonal() + joined(normal, tangential) * turned.across.asDiagonal()).eval();
  }
  ContactProblem p = contact_problem(flexibility, laws_, gaps_);
  if (guides_) {
    p.ring = guides_->ring;
    p.held_by = guides_->held_by;
  }
  if (turned.along.size() == 0) return p;
  VectorXd axial = turned.along;
  axial.head(contacts) += std::tan(laws_.screw.normal_angle) * turned.across.head(contacts);
  axial.tail(contacts) += std::tan(laws_.nut.normal_angle) * turned.across.tail(contacts);
  p.balance.topRows(2 * contacts) = axial.asDiagonal() * p.rigid.topRows(2 * contacts);
  p.gap += turned.opening;
  return p;
}

LoadDistribution InfluenceSolver::solve(double axial_force, const Turned& turned) const {
  const double force = axial_force / rollers_;
  const auto contacts = static_cast<Index>(gaps_.screw.size());
  MatrixXd joined = joined_;
  ContactSolution s = prs::solve(problem(joined, turned), force);
  const auto nut_loads = [&] {
    VectorXd loads = VectorXd::Zero(of_one());
    loads.head(contacts) = s.normal_load.tail(contacts);
    if (turned.along.size() > 0) {
      loads.tail(contacts) = loads.head(contacts).cwiseProduct(turned.across.tail(contacts));
      loads.head(contacts).array() *= turned.along.tail(contacts).array();
    }
    return loads;
  };
  if (face_)
    settle_on_shoulder(*face_, touching_, s, nut_loads, [&](const MatrixXd& change) {
      joined.block(of_one(), of_one(), of_one(), of_one()) += rollers_ * change;
      s = prs::solve(problem(joined, turned), force);
    });

  LoadDistribution d;
  d.solve = s;
  for (const Interface i : kInterfaces) {
    const Index first = i == Interface::screw ? 0 : contacts;
    for (Index k = first; k < first + contacts; ++k) {
      d.normal_load[i].push_back(s.normal_load[k]);
      d.approach[i].push_back(s.approach[k]);
    }
  }
  d.axial_displacement = s.screw_motion;
  if (s.converged() && turned.along.size() > 0) {
    VectorXd y(s.approach.size() + s.guided.size());
    y << s.approach, -s.guided;
    s.tangent_stiffness = tangent_stiffness(problem(joined, {}), force, y);
  }
  if (guides_ && s.converged()) {
    GuideLoads& guides = d.guides.emplace_back();
    for (const auto k : indices(guides.force)) {
      guides.displacement[k] = s.guided[static_cast<Index>(k)];
      guides.force[k] = guides_->ring.force(guides.displacement[k]);
    }
  }
  if (s.converged()) d.tangent_stiffness = rollers_ * s.tangent_stiffness;
  return d;
}

BodyGeometry influence_geometry(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                                Direction direction) {
  const Materials& materials = *c.materials;
  PerInterface<HertzPatch> patches;
  for (const Interface i : kInterfaces)
    patches[i] = nominal_patch(contacts.interfaces[i], laws[i], materials[body_of(i)], materials[Part::roller]);
  return body_geometry(contacts.mechanism, *c.structure, materials, laws, patches, direction, c.model);
}

InfluenceSolver influence_solver(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                                 Direction direction, double position, MatrixCache& cache, bool friction) {
  BodyGeometry geometry = influence_geometry(c, contacts, laws, direction);
  geometry.friction = friction;
  return meshed_or_refused([&]() -> InfluenceSolver {
    const BodyFlexibilities bodies =
        body_flexibilities(geometry, direction, position, flexibility_options(c.model.accuracy), cache);
    return {bodies, loaded_rollers(contacts.mechanism), laws,
            initial_gaps(contacts.mechanism, c.deviations, *c.materials,
                         {laws.screw.normal_angle, laws.nut.normal_angle}, direction)};
  });
}

bool influence_is_kept(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                       Direction direction, double position) try {
  MatrixCache kept(shared_matrix_cache(), MatrixCache::KeptOnly{});
  influence_solver(c, contacts, laws, direction, position, kept);
  return true;
} catch (const NotKept&) {
  return false;
}

HertzPatch patch_at_load(const InterfaceContact& contact, double normal_load) {
  const contact::HertzContact at = contact::at_load(contact.hertz, normal_load);
  const contact::InterfaceGeometry& g = contact.geometry;
  const double along_helix = std::abs(g.major_axis.dot(g.helix_tangent));
  const bool major_around_axis = along_helix > 0.5 * std::numbers::sqrt2;
  return major_around_axis ? HertzPatch{at.semi_minor, at.semi_major} : HertzPatch{at.semi_major, at.semi_minor};
}

HertzPatch nominal_patch(const InterfaceContact& contact, const ContactLaw& law, const Material& body,
                         const Material& roller) {
  const double modulus = contact::contact_modulus(body, roller);
  if (contact.has_hertz()) {
    const double at_one_newton = contact::at_load(contact.hertz, 1.0).peak_pressure;
    return patch_at_load(contact, std::pow(kNominalPressure * modulus / at_one_newton, 3.0));
  }
  const double root = 0.75 * law.hertz_constant / modulus;
  const double radius = 0.5 * std::numbers::pi * kNominalPressure * root * root;
  return {radius, radius};
}

BodyFlexibilities body_flexibilities(const BodyGeometry& geometry, Direction direction, double position,
                                     const FlexibilityOptions& options, MatrixCache& cache) {
  auto roller = std::async(kSideBySide, [&] { return roller_flexibility(geometry, direction, options, cache); });
  Flexibility screw = screw_flexibility(geometry, direction, options, cache);
  Flexibility nut = nut_flexibility(geometry, direction, position, options, cache);
  return {std::move(screw), std::move(nut), roller.get()};
}

ContactProblem contact_problem(const MatrixXd& flexibility, const PerInterface<ContactLaw>& laws,
                               const PerInterface<std::vector<double>>& gaps) {
  const auto n = static_cast<Index>(gaps.screw.size());
  ContactProblem p;
  p.flexibility = flexibility;
  p.flexibility.diagonal().head(n).array() += laws.screw.compliance;
  p.flexibility.diagonal().segment(n, n).array() += laws.nut.compliance;
  p.rigid = MatrixXd::Zero(flexibility.rows(), 2);
  p.hertz_constant.resize(2 * n);
  p.gap.setZero(flexibility.rows());
  p.rigid.col(0).head(n).setConstant(std::cos(laws.screw.normal_angle));
  p.rigid.col(1).head(n).setConstant(-std::cos(laws.screw.normal_angle));
  p.rigid.col(1).segment(n, n).setConstant(std::cos(laws.nut.normal_angle));
  p.balance = p.rigid;
  p.hertz_constant.head(n).setConstant(laws.screw.hertz_constant);
  p.hertz_constant.tail(n).setConstant(laws.nut.hertz_constant);
  p.gap.head(2 * n) << Eigen::Map<const VectorXd>(gaps.screw.data(), n), Eigen::Map<const VectorXd>(gaps.nut.data(), n);
  return p;
}

MatrixXd BodyFlexibilities::joined() const {
  const Index n = screw.matrix.rows();
  MatrixXd c = roller.matrix;
  c.topLeftCorner(n, n) += screw.matrix;
  c.bottomRightCorner(n, n) += nut.matrix;
  return c;
}

namespace {

/// Newton's method from a state, which it updates.
ContactSolution solve(const ContactProblem& p, Equilibrium& equilibrium, Trial& at) {
  ContactSolution s;
  for (;;) {
    s.relative_residual = at.residual.cwiseAbs().maxCoeff();
    if (s.relative_residual <= kTolerance) {
      s.status = fe::NewtonStatus::converged;
      break;
    }
    if (s.iterations() == kMostIterations) break;
    const VectorXd step = equilibrium.step(at);
    s.history.push_back(contact_iteration());
    if (!step.allFinite()) {
      s.status = fe::NewtonStatus::not_positive_definite;
      break;
    }
    const double before = at.residual.squaredNorm();
    double share = 1.0;
    Trial trial = equilibrium.moved(at, step, share);
    int halvings = 0;
    while (!(trial.residual.squaredNorm() <= (1.0 - 1e-4 * share) * before) && halvings++ < kMostHalvings)
      trial = equilibrium.moved(at, step, share *= 0.5);
    if (halvings > kMostHalvings) {
      s.status = fe::NewtonStatus::line_search_failed;
      break;
    }
    at = std::move(trial);
    s.history.back() = contact_iteration(at.residual.cwiseAbs().maxCoeff(), share);
  }
  s.normal_load = at.loads.value.head(p.hertz_constant.size());
  s.approach = at.y.head(p.hertz_constant.size()).cwiseMax(0.0);
  s.guided = -at.y.tail(at.y.size() - p.hertz_constant.size());
  s.screw_motion = at.motion[0];
  if (s.converged()) s.tangent_stiffness = equilibrium.tangent_stiffness(at);
  return s;
}

}  // namespace

ContactSolution solve(const ContactProblem& p, double force) {
  if (!p.ring) {
    Equilibrium equilibrium(p, force);
    Trial at = equilibrium.start();
    return solve(p, equilibrium, at);
  }
  // A roller that no guide touches may have hardly any stiffness: the clearance grows from 0, and touching guides
  // follow it.
  ContactProblem grown = p;
  double& clearance = grown.ring->clearance = 0.0;
  Equilibrium equilibrium(grown, force);
  Trial at = equilibrium.start();
  ContactSolution s = solve(grown, equilibrium, at);
  for (double step = p.ring->clearance; s.converged() && clearance < p.ring->clearance;) {
    const double before = clearance;
    clearance = std::min(before + step, p.ring->clearance);
    Trial next = at;
    for (Index k = p.hertz_constant.size(); k < next.y.size(); ++k)
      if (std::abs(next.y[k]) > before) next.y[k] += std::copysign(clearance - before, next.y[k]);
    equilibrium.evaluate(next);
    ContactSolution found = solve(grown, equilibrium, next);
    found.history.insert(found.history.begin(), s.history.begin(), s.history.end());
    if (found.converged()) {
      at = std::move(next);
      s = std::move(found);
      step *= 2.0;
    } else if (step > kLeastClearanceStep * p.ring->clearance) {
      clearance = before;
      step *= 0.25;
      s.history = std::move(found.history);
    } else {
      return found;
    }
  }
  return s;
}

double tangent_stiffness(const ContactProblem& p, double force, const VectorXd& y) {
  Equilibrium equilibrium(p, force);
  Trial at = equilibrium.start();
  at.loads = loads_at(p, y);
  return equilibrium.tangent_stiffness(at);
}

}  // namespace prs
