#pragma once

#include "prs/input/study_reader.h"

namespace prs {

/// Derivative of a response by a factor.
struct Derivative {
  double value = 0.0;                ///< dR/dx, units of the response over that of the factor.
  std::optional<double> elasticity;  ///< (x/R) dR/dx; absent if R = 0.
  double error = 0.0;                ///< Estimated error of `value`.
};

/// Derivatives by one factor, in the order of the responses; absent if a response has none.
struct FactorDerivatives {
  std::vector<std::optional<Derivative>> responses;
  std::string reason;  ///< Reason why there are none.
};

/// A case with the derivatives of its responses by the factors of a study.
struct CaseDerivatives {
  Study study;  ///< Study with the recorded responses.
  std::vector<std::optional<double>> values;
  std::vector<FactorDerivatives> factors;
  std::vector<Warning> warnings = {};
};

/// Derivatives of the base case of a `derivatives` study. The load distribution q(x) of a load case solves r(q, x) = 0,
/// so that
///
///     dq/dx = K^-1 dr/dx at fixed q,   K the tangent stiffness at the solution,
///
/// and a response R(q, x) changes by dR/dt of R(q + t dq/dx, x + t): no equilibrium is solved again. Parts that depend
/// on x without an equilibrium (set-up of the sector, contact points to rounding, ellipses) are differentiated by
/// central differences of sixth order at two step widths; their difference is the reported error. A derivative that
/// does not converge, as across the face of a flange, is absent with a reason. All rollers, running loads and slip are
/// solved at each step of these differences; factors that are 0 have steps of a usual size.
///
/// Commands: `contact`, and `solve` and `slip` with bars or the refined model. Throws InputError and UnknownResponse as
/// DesignEngine does, and CaseError if the command or the model has no derivatives.
CaseDerivatives case_derivatives(const input::StudyInput& input);

}  // namespace prs
