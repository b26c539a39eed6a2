#pragma once

namespace fe {

/// Straight bar that carries axial force only; freedoms (u_1, u_2) [m].
struct Bar {
  double axial_rigidity = 0.0;  ///< E A [N]
  double length = 0.0;          ///< L [m], > 0.

  /// E A / L [N/m], the factor of [[1, -1], [-1, 1]] (Abevi 2015, (A1)).
  double stiffness() const { return axial_rigidity / length; }

  /// Tension for the elongation u_2 - u_1 [N].
  double tension(double u1, double u2) const { return stiffness() * (u2 - u1); }
};

}  // namespace fe
