#pragma once

#include "prs/model/case.h"
#include "prs/sector/influence/influence.h"
#include "prs/sector/load_distribution.h"
#include "prs/sector/roller_push.h"

namespace prs {

/// Solves load after load on elastic bodies given by their flexibilities: the influence model. The
/// nut's shoulder only pushes; which part of it does is found for each load.
class InfluenceSolver {
 public:
  InfluenceSolver(const BodyFlexibilities& bodies, int rollers,
                  const PerInterface<ContactLaw>& laws,
                  const PerInterface<std::vector<double>>& gaps);

  /// Equilibrium under the axial force on the whole mechanism [N], > 0. A few 10 us, a few 100
  /// where the part of the shoulder that pushes changes.
  LoadDistribution solve(double axial_force) const { return solve(axial_force, {}); }

  /// The same with friction in these proportions to the normal loads, `per_normal_load`, and the
  /// centrifugal force of the threads; heads lie between guides. `sense` of the sector. Newton's
  /// method takes the friction of all contacts along, which makes C unsymmetric. The tangent
  /// stiffness is that with friction held. Needs `BodyGeometry::friction`.
  LoadDistribution solve(double axial_force, const RollerPush& per_normal_load, double sense,
                         double pitch) const {
    return solve(axial_force, turned(per_normal_load, sense, pitch));
  }

 private:
  /// A contact's force as (1 + a) n + b t of its normal and the direction along its flank, over N.
  struct Turned {
    Eigen::VectorXd along, across;  ///< 1 + a and b; none without friction.
    Eigen::VectorXd opening;        ///< By what else bends the rollers [m].
  };
  Turned turned(const RollerPush& per_normal_load, double sense, double pitch) const;
  LoadDistribution solve(double axial_force, const Turned& turned) const;
  ContactProblem problem(const Eigen::MatrixXd& joined, const Turned& turned) const;

  Eigen::MatrixXd joined_, bent_;
  PerInterface<ContactLaw> laws_;
  PerInterface<std::vector<double>> gaps_;
  int rollers_ = 1;
  std::optional<ThrustFace> face_;
  ThrustFace::Touching touching_;  ///< With equal loads, as `joined_` has it.
};

/// How a solve, or several in a row, ended.
fe::NewtonSummary newton_summary(const ContactSummary& summary,
                                 const std::vector<ContactIteration>& history);

/// What the bodies of a case are worked out from.
BodyGeometry influence_geometry(const Conditions& c, const Contacts& contacts,
                                const PerInterface<ContactLaw>& laws, Direction direction);

/// The influence model of a case for one direction of the load and one position of the first
/// contact on the nut. Throws CaseError where a body cannot be meshed.
InfluenceSolver influence_solver(const Conditions& c, const Contacts& contacts,
                                 const PerInterface<ContactLaw>& laws, Direction direction,
                                 double position, MatrixCache& cache = shared_matrix_cache(),
                                 bool friction = false);

/// Whether all that it takes is kept by the cache that the program's commands share.
bool influence_is_kept(const Conditions& c, const Contacts& contacts,
                       const PerInterface<ContactLaw>& laws, Direction direction, double position);

}  // namespace prs
