#pragma once

#include "contact/contact_point.h"

namespace contact {

/// Contact point of a roller with one body and the curvatures there: all that a Hertz contact and
/// the slip in it need to know of the geometry. Directions are unit vectors in the pair's frame.
template <class Real>
struct InterfaceGeometryOf {
  ContactPointOf<Real> point{};

  // Principal curvatures of the material, convex > 0 [1/m], ascending in absolute value; `angle`
  // is that of the first direction about the normal, from the roller's helix tangent [rad].
  PrincipalOf<Real> body{};
  PrincipalOf<Real> roller{};
  /// Eigenvalues of the sum of the two curvature tensors (no factor 1/2) [1/m], ascending: the
  /// first direction is the major axis of the contact ellipse.
  PrincipalOf<Real> relative{};

  Vector3<Real> helix_tangent{};  ///< Roller's; growing theta.
  Vector3<Real> major_axis{};     ///< t_1
  Vector3<Real> minor_axis{};     ///< t_2 = n x t_1 (1.60)

  simd::Lanes<Real> ok() const { return point.ok(); }
  Real curvature_sum() const { return relative.first + relative.second; }  ///< (1.77) [1/m]
  /// Smaller relative curvature over the roller's largest one [-]: towards 0 the surfaces conform
  /// closely and Hertz's half-space assumption fails.
  Real openness() const { return relative.first / abs(roller.second); }
  /// Acute angle between the first directions of body and roller [rad] (1.61).
  Real first_directions_angle() const {
    return std::abs(std::remainder(body.angle - roller.angle, std::numbers::pi));
  }
  /// The tangent direction that lies `angle` from the roller's helix tangent.
  Vector3<Real> direction(const Real& angle) const {
    const auto [sine, cosine] = sincos(angle);
    return cosine * helix_tangent + sine * point.normal.cross(helix_tangent);
  }
};
using InterfaceGeometry = InterfaceGeometryOf<double>;

/// Solves for the contact point on one face of the roller and works out the curvatures there. The
/// ellipse is oriented by the *signed* sum of the curvature tensors; Sandu 2018, (1.65) and table
/// 1.4, and Yao 2023, (35), take absolute values or differences of them, which is wrong where one
/// surface is concave, as a nut always is. Where no admissible point exists, `point.status` says
/// why and everything but `point` is zero.
InterfaceGeometry interface_geometry(const ThreadPair& pair, RollerFace face);

/// How far a contact ellipse with those semi-axes [m] reaches beyond the ends of the two flanks,
/// measured radially in the tangent plane.
FlankViolations ellipse_beyond_flanks(const ThreadPair& pair, const InterfaceGeometry& interface,
                                      double semi_major, double semi_minor);

/// The interface on the other two faces of the pair, by symmetry.
InterfaceGeometry on_other_faces(const InterfaceGeometry& interface);

}  // namespace contact
