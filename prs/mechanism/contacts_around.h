#pragma once

#include <Eigen/Core>
#include <vector>

#include "fe/newton_types.h"

namespace prs {

/// Contacts of N rollers around the axis, which differ in their gaps only, on elastic bodies:
///
///     y + g - R V + C N(y) = 0,   R' N(y) + E V = f,   N = k_0 <y>^1.5.
///
/// V are motions and, behind them, reactions of supports. C, R and E turn with the rollers, so that
/// the waves 1, cos(m theta_j) and sin(m theta_j) over the rollers j do not see each other. SI
/// units.
struct ContactsAround {
  /// Matrices for waves of one order m; contacts are those of one roller, at the screw first.
  struct Mode {
    Eigen::MatrixXd flexibility;  ///< C [m/N], symmetric.
    Eigen::MatrixXd rigid;        ///< R, one column for each of V.
    Eigen::MatrixXd support;      ///< E, symmetric: of motions [N/m], of reactions [m/N].
    Eigen::Index reactions = 0;   ///< Forces among V, the last of it.
  };
  struct Wave {
    std::size_t mode = 0;
    Eigen::VectorXd shape;  ///< Unit vector over the rollers; zero where no contact has a part.
    Eigen::VectorXd load;   ///< f: forces on the motions, displacements for the reactions.
  };

  std::vector<Mode> modes;
  std::vector<Wave> waves;
  Eigen::VectorXd hertz_constant;  ///< k_0 of a roller's contacts [N/m^1.5]
  Eigen::MatrixXd gap;             ///< g, one column for each roller [m].
  std::vector<bool> present;       ///< Rollers that are not missing.
};

struct ContactsAroundOptions {
  double force = 1.0;   ///< Force of which residuals of forces are shares [N].
  double length = 1.0;  ///< Length of which residuals of approaches are shares [m].
  /// Contacts of this stiffness give the first state [N/m]; tangents in the matrix of a step are at
  /// least `least_tangent` times it.
  double stiffness = 1.0;
  double least_tangent = 1e-7;
  /// Tolerance of every residual; where no step lessens it further, what rounding can leave is enough.
  double tolerance = 1e-12;
  double step_tolerance = 1e-6;  ///< Tolerance of a step's linear equations.
  int most_directions = 120;     ///< Most directions of GMRES, before the equations are solved densely.
  int max_iterations = 50;
  int max_halvings = 40;
};

struct ContactsAroundSolution : fe::NewtonSummary {
  Eigen::MatrixXd y;                    ///< One column for each roller [m].
  Eigen::MatrixXd normal_load;          ///< N [N]
  std::vector<Eigen::VectorXd> motion;  ///< V of each wave.
};

/// One of V.
struct WaveMotion {
  std::size_t wave = 0;
  Eigen::Index motion = 0;
};

/// Newton's method from `from`, or from linear contacts. With S the slopes dN/dy and S_m their
/// means over the rollers, a step solves by GMRES
///
///     (I + W (S/S_m - 1)) dy = dy_m,   W = I - (M^-1)_yy,
///
/// dy_m the step for slopes S_m and M its matrix, which the waves split into small ones. Rollers
/// that are alike need no iteration; where GMRES fails, the same equations are solved densely.
ContactsAroundSolution solve(const ContactsAround& contacts, const ContactsAroundOptions& options,
                             const ContactsAroundSolution* from = nullptr);

/// Tangent at a solution: rates of some motions by unit forces on them.
Eigen::MatrixXd compliance(const ContactsAround& contacts, const ContactsAroundSolution& solution,
                           const ContactsAroundOptions& options, const std::vector<WaveMotion>& motions);

}  // namespace prs
