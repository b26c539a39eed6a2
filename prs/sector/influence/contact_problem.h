#pragma once

#include "prs/sector/influence/flexibility.h"

namespace prs {

/// Normal loads at the contacts of one roller with elastic bodies given by their flexibility. With
/// N the normal loads, first those at the screw, then those at the nut, C the flexibility of the
/// three bodies together, U the axial motions of screw and roller along the load and R the approach
/// that they cause:
///
///     w = R U - C N,   N = k_0 <w - g>^1.5,   Q' N = (F, 0).
///
/// Q is R unless friction turns the loads. SI units.
struct ContactProblem {
  Eigen::MatrixXd flexibility;     ///< C [m/N], symmetric without friction.
  Eigen::MatrixXd rigid;           ///< R, first of the screw, then of the roller [-].
  Eigen::MatrixXd balance;         ///< Q
  Eigen::VectorXd hertz_constant;  ///< k_0 [N/m^1.5]
  Eigen::VectorXd gap;             ///< g, initial gap along the normal [m].

  int contacts() const { return static_cast<int>(gap.size()) / 2; }  ///< At each interface.
};

/// The contact problem of a sector: its laws, the compliance of teeth included, its gaps, and the
/// flexibility of its bodies.
ContactProblem contact_problem(const Eigen::MatrixXd& flexibility,
                               const PerInterface<ContactLaw>& laws,
                               const PerInterface<std::vector<double>>& gaps);

/// Flexibility of the three bodies together: screw and nut see their own contacts, the roller both.
Eigen::MatrixXd joined_flexibility(const Flexibility& screw, const Flexibility& nut,
                                   const Flexibility& roller);

struct ContactSolveOptions {
  /// Largest error of a compatibility condition over the mean Hertz approach, and of an equilibrium
  /// condition over the load.
  double tolerance = 1e-12;
  int max_iterations = 50;
  int max_halvings = 40;
};

enum class ContactSolveStatus { converged, iteration_limit, line_search_failed, singular };

/// One linear solve and what its step left.
struct ContactIteration {
  double residual = 0.0;     ///< Largest, relative as in the options.
  double step_length = 0.0;  ///< 1 is the full Newton step.
};

/// Says why a solver stopped; born failed.
struct ContactSummary {
  ContactSolveStatus status = ContactSolveStatus::iteration_limit;
  std::vector<ContactIteration> history;
  double residual = 0.0;  ///< Largest, relative as in the options.

  bool converged() const { return status == ContactSolveStatus::converged; }
  /// Linear solves.
  int iterations() const { return static_cast<int>(history.size()); }
};

struct ContactSolution : ContactSummary {
  Eigen::VectorXd normal_load;   ///< N, screw then nut [N].
  Eigen::VectorXd approach;      ///< delta = <w - g> [m]
  double screw_motion = 0.0;     ///< U of the screw's loaded section [m].
  double roller_motion = 0.0;    ///< U of the roller [m].
  double tangent_stiffness = 0;  ///< dF/dU of the screw at the load [N/m].
};

/// Newton on the approaches y = w - g and U, from rigid bodies that share the load equally:
///
///     y + g - R U + C N(y) = 0,   R' N(y) = (F, 0).
///
/// N(y) is continuously differentiable, so the Newton step lessens the norm of the residual, by
/// which it is searched along. The potential energy would not do: without the half-space parts C
/// is not positive definite, only C + dy/dN is, up to loads for which Hertz itself loses its
/// meaning. `force` is the axial force on the sector [N], > 0. A few 10 us for 40 contacts.
ContactSolution solve(const ContactProblem& problem, double force,
                      const ContactSolveOptions& options = {});

/// dF/dU of the screw where the approaches are y = w - g [N/m].
double tangent_stiffness(const ContactProblem& problem, double force, const Eigen::VectorXd& y);

}  // namespace prs
