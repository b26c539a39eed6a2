#pragma once

#include "prs/mechanism/full_distribution.h"
#include "prs/sector/influence/influence_solver.h"

namespace prs {

/// The bodies of the full mechanism by their flexibilities, for one direction of the load and one position; all rollers
/// have the same.
struct FullBodies {
  FlexibilityAround screw, nut;    ///< Flexibilities with the sections of `screw_stations` and `nut_stations`.
  Eigen::MatrixXd roller;          ///< Flexibility at the contacts at the screw, then at those at the nut.
  std::optional<ThrustFace> face;  ///< Face of a nut that can lift off its shoulder, in mode 0.
};

/// Places at which a ring guides the rollers: the middles of their ends, or the outer nodes [m].
std::array<double, 2> guide_places(const FullModel& model);

/// Places on the screw whose displacements are needed, from the loaded section on [m]: rings that it carries, bearings,
/// a side force and a moment `at` a place of their own.
std::vector<double> screw_stations(const FullModel& model);
/// Rings on the nut, x [m].
std::vector<double> nut_stations(const FullModel& model);

/// Flexibilities by finite elements. Throws CaseError if a body cannot be meshed.
FullBodies full_bodies(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                       const FullModel& model, MatrixCache& cache = shared_matrix_cache());

/// Moment on the seat of a nut at which one side of its shoulder, a ring from r_i to r_o under linear pressure, lifts
/// off: F (r_o^2 + r_i^2)/(4 r_o) [N m].
double lifting_moment(const Structure::Nut& nut, const SupportForce& seat);

/// Contacts of all rollers on elastic bodies,
///
///     w = R U - C N + w_0,   N = k_0 <w - g>^1.5,   R' N = f,
///
/// U the motions of the screw's loaded section and of each roller along its axis. C holds the flexibilities of screw
/// and nut between all rollers, each roller's own, and those of housing springs and rings: a ring moves a roller as a
/// rigid line through both rings, its forces on the body that carries it are those of the line's equilibrium. w_0 is
/// due to a displaced seat of the nut, rollers out of place, and bending of the screw by loads behind the loaded
/// section. Reactions of bearings are unknowns next to U.
FullDistribution solve(const FullModel& model, const FullBodies& bodies, Detail detail = Detail::complete);

/// Contacts of N rollers around the axis, which differ in their gaps only, on elastic bodies:
///
///     y + g - R V + C N(y) = 0,   R' N(y) + E V = f,   N = k_0 <y>^1.5.
///
/// V are motions, followed by reactions of supports. C, R and E turn with the rollers, so that the waves 1, cos(m
/// theta_j) and sin(m theta_j) over the rollers j are uncoupled. SI units.
struct ContactsAround {
  /// Matrices for waves of one order m; contacts are those of one roller, at the screw first.
  struct Mode {
    Eigen::MatrixXd flexibility;  ///< C [m/N], symmetric.
    Eigen::MatrixXd rigid;        ///< R, one column for each of V.
    Eigen::MatrixXd support;      ///< E, symmetric: for motions [N/m], for reactions [m/N].
    Eigen::Index reactions = 0;   ///< Number of reactions, at the end of V.
  };
  struct Wave {
    std::size_t mode = 0;
    Eigen::VectorXd shape;  ///< Amplitudes over the rollers, of norm one; zero if no contact takes part.
    Eigen::VectorXd load;   ///< f: forces on the motions, displacements for the reactions.
  };

  std::vector<Mode> modes;
  std::vector<Wave> waves;
  Eigen::VectorXd hertz_constant;  ///< k_0 of a roller's contacts [N/m^1.5]
  Eigen::MatrixXd gap;             ///< g, one column for each roller [m].
  std::vector<bool> present;       ///< Whether each roller is present.
};

struct ContactsAroundOptions {
  double force = 1.0;   ///< Scale of residuals of forces [N].
  double length = 1.0;  ///< Scale of residuals of approaches [m].
  /// Stiffness of the contacts in the first state [N/m]; tangents in the matrix of a step are at least `least_tangent`
  /// times it.
  double stiffness = 1.0;
  double least_tangent = 1e-7;
  /// Tolerance of every residual; if no step reduces it further, a residual that rounding can leave is enough.
  double tolerance = 1e-12;
  double step_tolerance = 1e-6;  ///< Tolerance of a step's linear equations.
  int most_directions = 120;     ///< Largest number of directions of GMRES; then the equations are solved densely.
  int max_iterations = 50;
  int max_halvings = 40;
};

struct ContactsAroundSolution : fe::NewtonSummary {
  Eigen::MatrixXd y;                    ///< One column for each roller [m].
  Eigen::MatrixXd normal_load;          ///< N [N]
  std::vector<Eigen::VectorXd> motion;  ///< V of each wave.
};

/// A component of V.
struct WaveMotion {
  std::size_t wave = 0;
  Eigen::Index motion = 0;
};

/// Newton's method from `from`, or from linear contacts. With S the slopes dN/dy and S_m their means over the rollers,
/// a step solves by GMRES
///
///     (I + W (S/S_m - 1)) dy = dy_m,   W = I - (M^-1)_yy,
///
/// dy_m the step for slopes S_m and M its matrix, which the waves split into small ones. Equal rollers need no
/// iteration; if GMRES fails, the same equations are solved densely.
ContactsAroundSolution solve(const ContactsAround& contacts, const ContactsAroundOptions& options,
                             const ContactsAroundSolution* from = nullptr);

/// Tangent at a solution: rates of some motions by unit forces on them.
Eigen::MatrixXd compliance(const ContactsAround& contacts, const ContactsAroundSolution& solution,
                           const ContactsAroundOptions& options, const std::vector<WaveMotion>& motions);

}  // namespace prs
