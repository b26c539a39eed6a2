#pragma once

#include <fmt/format.h>

#include "prs/sector/influence/flexibility.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Normal loads at the contacts of one roller with elastic bodies given by their flexibility. With N the normal loads,
/// first those at the screw, then those at the nut, C the flexibility of the three bodies together, U the axial motions
/// of screw and roller along the load and R the approach that they cause:
///
///     w = R U - C N,   N = k_0 <w - g>^1.5,   Q' N = (F, 0).
///
/// Q is R unless friction turns the loads. SI units.
///
/// Guides with a clearance follow the contacts in all vectors: there w - g is -v of the outward displacement v, N the
/// force on the roller in addition to that of the springs that hold its ends in C.
struct ContactProblem {
  Eigen::MatrixXd flexibility;     ///< C [m/N], symmetric without friction.
  Eigen::MatrixXd rigid;           ///< R, first column of the screw, then of the roller [-].
  Eigen::MatrixXd balance;         ///< Q
  Eigen::VectorXd hertz_constant;  ///< k_0 [N/m^1.5]
  Eigen::VectorXd gap;             ///< g, initial gap along the normal [m].

  std::optional<RingGuide> ring;
  double held_by = 0.0;  ///< Stiffness of the springs in place of the guides [N/m].

  int contacts() const { return static_cast<int>(hertz_constant.size()) / 2; }  ///< Number at each interface.
};

/// The contact problem of a sector: its laws with the compliance of teeth, its gaps, and the flexibility of its bodies.
ContactProblem contact_problem(const Eigen::MatrixXd& flexibility, const PerInterface<ContactLaw>& laws,
                               const PerInterface<std::vector<double>>& gaps);

/// Iteration with relative residual and step length only: the contact problem is not solved by its energy, and nothing
/// is shifted.
inline fe::NewtonIteration contact_iteration(double residual = 0.0, double step_length = 0.0) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {kNone, residual, step_length, kNone};
}

struct ContactSolution : fe::NewtonSummary {
  Eigen::VectorXd normal_load;   ///< N, screw then nut [N].
  Eigen::VectorXd approach;      ///< delta = <w - g> [m]
  Eigen::VectorXd guided;        ///< Displacements v of guides with a clearance [m].
  double screw_motion = 0.0;     ///< U of the screw's loaded section [m].
  double tangent_stiffness = 0;  ///< dF/dU of the screw at the load [N/m].
};

/// Newton's method on the approaches y = w - g and U, from rigid bodies that share the load equally:
///
///     y + g - R U + C N(y) = 0,   R' N(y) = (F, 0).
///
/// N(y) is continuously differentiable, so that the Newton step reduces the norm of the residual, which is used in the
/// line search. The potential energy would not do: without the half-space parts C is not positive definite, only C +
/// dy/dN is, up to loads for which Hertz itself loses its meaning. `force` is the axial force on the sector [N], > 0.
/// Takes some 10 us for 40 contacts.
ContactSolution solve(const ContactProblem& problem, double force);

/// dF/dU of the screw at the approaches y = w - g of contacts and guides [N/m].
double tangent_stiffness(const ContactProblem& problem, double force, const Eigen::VectorXd& y);

/// Contact ellipse at a normal load, with its axes taken along the profile and around the axis, whichever the major
/// axis is closer to. Needs `contact.has_hertz()`.
HertzPatch patch_at_load(const InterfaceContact& contact, double normal_load);

/// Ellipse with which flexibilities are computed for any loads: its size cancels with the half-space part. Peak
/// pressure is 2 % of E*, 1/E* = (1 - nu^2)/E of both bodies, that is 2.3 GPa for steel; if the geometry gives no
/// contact, the circle of a sphere with k_0 = 4/3 E* sqrt(R).
HertzPatch nominal_patch(const InterfaceContact& contact, const ContactLaw& law, const Material& body,
                         const Material& roller);

/// Flexibility of the three bodies of a roller screw for one direction of the load and one position
/// of the first contact on the nut.
struct BodyFlexibilities {
  Flexibility screw;
  Flexibility nut;
  Flexibility roller;

  /// Flexibility of all bodies together: screw and nut act on their own contacts, the roller on both.
  Eigen::MatrixXd joined() const;
};

/// Flexibilities of the bodies, computed in parallel if the cache does not hold them.
BodyFlexibilities body_flexibilities(const BodyGeometry& geometry, Direction direction, double position,
                                     const FlexibilityOptions& options, MatrixCache& cache = shared_matrix_cache());

/// Solves load after load on elastic bodies given by their flexibilities: the influence model. The nut's shoulder only
/// pushes; the part that does is found for each load.
class InfluenceSolver {
 public:
  InfluenceSolver(const BodyFlexibilities& bodies, int rollers, const PerInterface<ContactLaw>& laws,
                  const PerInterface<std::vector<double>>& gaps);

  /// Equilibrium under the axial force on the whole mechanism [N], > 0. Takes some 10 us, some 100 us if the pushing
  /// part of the shoulder changes.
  LoadDistribution solve(double axial_force) const { return solve(axial_force, {}); }

  /// Equilibrium with friction in these proportions to the normal loads, `per_normal_load`, and the centrifugal force
  /// of the threads; heads lie between guides. `sense` of the sector. Newton's method includes the friction of all
  /// contacts, which makes C unsymmetric. The tangent stiffness is that with friction held constant. Needs
  /// `BodyGeometry::friction`.
  LoadDistribution solve(double axial_force, const RollerPush& per_normal_load, double sense, double pitch) const {
    return solve(axial_force, turned(per_normal_load, sense, pitch));
  }

 private:
  /// A contact's force as (1 + a) n + b t with its normal n and the direction t along its flank, over N.
  struct Turned {
    Eigen::VectorXd along, across;  ///< 1 + a and b; empty without friction.
    Eigen::VectorXd opening;        ///< Opening of the contacts by other bending of the rollers [m].
  };
  Turned turned(const RollerPush& per_normal_load, double sense, double pitch) const;
  LoadDistribution solve(double axial_force, const Turned& turned) const;
  ContactProblem problem(const Eigen::MatrixXd& joined, const Turned& turned) const;
  /// Number of rows of normal and tangential forces of one body.
  Eigen::Index of_one() const { return (joined_.rows() - guides()) / 2; }
  Eigen::Index guides() const { return guides_ ? guides_->between.rows() : 0; }

  Eigen::MatrixXd joined_, bent_;  ///< Guides with a clearance follow the contacts.
  std::optional<Flexibility::Guides> guides_;
  PerInterface<ContactLaw> laws_;
  PerInterface<std::vector<double>> gaps_;
  int rollers_ = 1;
  std::optional<ThrustFace> face_;
  ThrustFace::Touching touching_;  ///< State under equal loads, to which `joined_` belongs.
};

/// Continues from a solution in which the nodes `touching` of the nut's shoulder push, until the pushing nodes are
/// those that touch under its loads. `loads()`: loads of the nut at the solution. `solve(change)`: finds the next
/// solution, with this change of the nut's flexibility.
template <class Loads, class Solve>
void settle_on_shoulder(const ThrustFace& face, ThrustFace::Touching touching, fe::NewtonSummary& solution, Loads loads,
                        Solve solve) {
  constexpr int kMostRounds = 10;  // Each round changes the loads, and with them the nodes, only little.
  for (int round = 0; round < kMostRounds && solution.converged(); ++round) {
    const auto now = face.touching_under(loads(), touching);
    if (now == touching) return;
    if (!now) break;
    std::vector<fe::NewtonIteration> history = std::move(solution.history);
    solve(face.flexibility(*now) - face.flexibility(touching));
    touching = *now;
    solution.history.insert(solution.history.begin(), history.begin(), history.end());
  }
  if (solution.converged()) solution.status = fe::NewtonStatus::iteration_limit;
}

/// Result of `mesh`; CaseError where the bodies cannot be meshed.
template <class Mesh>
auto meshed_or_refused(Mesh mesh) try {
  return mesh();
} catch (const std::invalid_argument& reason) {
  throw CaseError("model.bodies", fmt::format("`influence` cannot mesh these bodies: {}; take `refined` or fix "
                                              "the geometry",
                                              reason.what()));
}

/// Inputs from which the bodies of a case are computed.
BodyGeometry influence_geometry(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                                Direction direction);

/// The influence model of a case for one direction of the load and one position of the first contact on the nut. Throws
/// CaseError if a body cannot be meshed.
InfluenceSolver influence_solver(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                                 Direction direction, double position, MatrixCache& cache = shared_matrix_cache(),
                                 bool friction = false);

/// Whether the cache shared by the program's commands holds all matrices of the model.
bool influence_is_kept(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                       Direction direction, double position);

}  // namespace prs
