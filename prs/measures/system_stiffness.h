#pragma once

#include "prs/measures/shaft.h"

namespace prs {

/// Axial stiffness of an axis, by what gives way.
struct SystemStiffness {
  struct Contribution {
    double stiffness = 0.0;  ///< [N/m]
    double share = 0.0;      ///< Of the total compliance; all sum to 1.
  };
  struct Contributions {
    std::optional<Contribution> mechanism, shaft, wind_up, support_bearing, housing;
  };
  double total = 0.0;  ///< [N/m]
  Contributions contributions;
};

/// In series, 1/k = sum 1/k_i, with
///
///     shaft    L/(E A) to one bearing, x (L - x)/(L E A) between two,
///     wind_up  (l/(2 pi))^2 L_t/(G J),   G = E/(2 (1 + nu)),
///     A = pi/4 (d^2 - b^2),   J = pi/32 (d^4 - b^4).
///
/// `mechanism`: the secant stiffness of the screw at rest [N/m]; `section`, `material`, `lead` l
/// [m]: of the screw, d its pitch diameter. Without friction.
SystemStiffness system_stiffness(double mechanism, const MeasureOptions::System& system,
                                 const ShaftSection& section, const Material& material,
                                 double lead);

}  // namespace prs
