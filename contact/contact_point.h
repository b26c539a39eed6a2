#pragma once

#include <array>

#include "contact/thread_surface.h"
#include "contact/vectors.h"

namespace contact {

/// Outcome of the search for a contact point.
enum class ContactPointStatus : std::int64_t {
  ok,
  not_computed,
  straight_on_straight,  ///< Neither profile is curved: no point contact.
  out_of_reach,          ///< The axes are so far apart or so close that the flanks never overlap.
  outside_flank,         ///< The point lies beyond the end of a flank.
  not_a_minimum,         ///< The clearance has only a saddle there: the surfaces intersect.
  not_converged,         ///< The clearance has no minimum on the flanks that the descent could find.
};

/// A roller next to the screw or inside the nut (the body). Frame of Sandu 2018, chapter 1: z
/// along the body's axis, x from there to the roller's axis, right-handed.
struct ThreadPair {
  ThreadSurface body;  ///< Screw, or nut described by its air.
  ThreadSurface roller;
  double centre_distance = 0.0;  ///< c, between the two axes [m], > 0.
};

/// The face of the roller that touches. The top face looks along +z.
enum class RollerFace { top = -1, bottom = 1 };  // gamma of the roller's surface

/// The two ways to load the mechanism (Sandu 2018, section 1.3).
enum class Configuration {
  i1_j2,  ///< Screw bottom on roller top, roller bottom on nut top: positive axial force.
  i2_j1,  ///< Screw top on roller bottom, roller top on nut bottom.
};

constexpr RollerFace roller_face_at_screw(Configuration c) {
  return c == Configuration::i1_j2 ? RollerFace::top : RollerFace::bottom;
}
constexpr RollerFace roller_face_at_nut(Configuration c) {
  return c == Configuration::i1_j2 ? RollerFace::bottom : RollerFace::top;
}

std::string_view name(ContactPointStatus status);

/// The end of a flank, in terms of the material.
enum class FlankEnd { root, crest };

constexpr std::string_view name(FlankEnd end) { return end == FlankEnd::root ? "root" : "crest"; }

/// A contact point or ellipse that reaches beyond the end of a flank.
struct FlankViolation {
  bool of_roller = false;  ///< Whether it is the roller's flank, else the body's.
  FlankEnd end = FlankEnd::root;
  double by = 0.0;  ///< Radial distance beyond that end [m], > 0.
};

/// Violations at both ends of both flanks at most; a range.
class FlankViolations {
 public:
  /// Records a contact from `innermost` to `outermost` radius [m] that reaches beyond the flank's ends.
  void add(const ThreadSurface& surface, bool of_roller, double innermost, double outermost);

  const FlankViolation* begin() const { return list_.data(); }
  const FlankViolation* end() const { return list_.data() + size_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

 private:
  std::array<FlankViolation, 4> list_;
  std::size_t size_ = 0;
};

/// Point at which two thread flanks touch, and the outcome of its search.
template <class Real>
struct ContactPointOf {
  simd::EnumOf<ContactPointStatus, Real> status = ContactPointStatus::not_computed;
  Real iterations{};  ///< Newton steps.
  Real residual{};    ///< Largest difference of the two surfaces' slopes at the point [-].

  Vector2<Real> position{};  ///< x, y measured from the body's axis [m].
  Real radius_on_body{};     ///< [m]
  Real radius_on_roller{};   ///< [m]
  /// Angles of the point about the two axes from x [rad]. The roller's angle at the
  /// screw is on the branch near -pi on the roller's top face and near +pi on its bottom face.
  Real angle_on_body{};
  Real angle_on_roller{};
  Vector3<Real> normal{};  ///< Unit vector, outward from the roller.
  /// Second derivatives of the axial clearance over x, y [1/m].
  TensorOf<Real> clearance_hessian{};
  /// Total axial play of the pair, both faces (Sandu 2018, (1.40)) [m]; negative: the threads are
  /// too thick by that much, 0 within the radii's rounding. Defined for equal pitches only.
  Real backlash{};

  simd::Lanes<Real> ok() const { return status == ContactPointStatus::ok; }
  /// psi, angle between normal and axis, arccos|n_z| [rad].
  Real normal_angle() const { return atan2(Vector2<Real>{normal.x, normal.y}.norm(), Real(abs(normal.z))); }
};
using ContactPoint = ContactPointOf<double>;

/// Finds the contact point of a pair: the minimum of the axial clearance between the two flanks
///
///     C(x, y) = f_R(r_R) + s f_B(r_B) - gamma (l_B theta_B - l_R theta_R)/(2 pi) + const,
///
/// s = +1 at a screw and -1 inside a nut, gamma = -1 on the roller's top face and +1 on its bottom face. There the
/// normals are opposite, as (A.4) requires, and the point is the same by construction (A.1), so (A.9) and (A.10) hold
/// as well; but the Jacobian is now the clearance Hessian, symmetric, regular also where the helix angles match (there
/// the Jacobian of (A.9), (A.10) is singular, since the angles enter by their cosines), and positive definite at a
/// contact, so that a descent never ends on one of the spurious roots that squaring (A.9) adds.
///
/// Newton's method from the pitch radii, to a slope difference of a few roundings; takes 3 to 5 steps, each halved
/// while it leaves the profiles or overshoots. Accepts a point only inside both flanks and with a positive definite
/// Hessian; else `status` gives the reason and the numbers are those of the last point. Profiles of which one is
/// strongly concave can have several minima; the one next to the pitch radii is found. Allocates nothing, throws
/// nothing.
ContactPoint find_contact_point(const ThreadPair& pair, RollerFace face);

/// Distances of a contact point beyond the ends of the flanks.
FlankViolations point_beyond_flanks(const ThreadPair& pair, const ContactPoint& point);

/// Contact point of the same pair on the other two faces. A half turn about x maps a thread onto
/// itself and its top onto its bottom face, so angles and n_y, n_z change sign and the radii stay
/// (Sandu 2018, appendix A).
ContactPoint on_other_faces(const ContactPoint& point);

/// Contact point of a roller with one body and the curvatures there: all geometric inputs of a Hertz contact and the
/// slip in it. Directions are unit vectors in the pair's frame.
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

  Vector3<Real> helix_tangent{};  ///< Tangent of the roller's helix; growing theta.
  Vector3<Real> major_axis{};     ///< t_1
  Vector3<Real> minor_axis{};     ///< t_2 = n x t_1 (1.60)

  simd::Lanes<Real> ok() const { return point.ok(); }
  Real curvature_sum() const { return relative.first + relative.second; }  ///< (1.77) [1/m]
  /// Smaller relative curvature over the roller's largest one [-]: towards 0 the surfaces conform
  /// closely and Hertz's half-space assumption fails.
  Real openness() const { return relative.first / abs(roller.second); }
  /// Acute angle between the first directions of body and roller [rad] (1.61).
  Real first_directions_angle() const { return std::abs(std::remainder(body.angle - roller.angle, std::numbers::pi)); }
  /// Tangent direction at `angle` from the roller's helix tangent.
  Vector3<Real> direction(const Real& angle) const {
    const auto [sine, cosine] = sincos(angle);
    return cosine * helix_tangent + sine * point.normal.cross(helix_tangent);
  }
};
using InterfaceGeometry = InterfaceGeometryOf<double>;

/// Solves for the contact point on one face of the roller and computes the curvatures there. The ellipse is oriented by
/// the *signed* sum of the curvature tensors; Sandu 2018, (1.65) and table 1.4, and Yao 2023, (35), take absolute
/// values or differences of them, which is wrong if one surface is concave, as a nut always is. If no admissible point
/// exists, `point.status` gives the reason and all but `point` is zero.
InterfaceGeometry interface_geometry(const ThreadPair& pair, RollerFace face);

/// Radial distances, in the tangent plane, by which a contact ellipse with these semi-axes [m] exceeds the ends of the
/// two flanks.
FlankViolations ellipse_beyond_flanks(const ThreadPair& pair, const InterfaceGeometry& interface, double semi_major,
                                      double semi_minor);

/// The interface on the other two faces of the pair, by symmetry.
InterfaceGeometry on_other_faces(const InterfaceGeometry& interface);

/// The end of a flank that a contact ellipse reaches first as it grows about its centre.
struct FlankEdge {
  bool of_roller = false;  ///< Whether it is on the roller's flank, else on the body's.
  FlankEnd end = FlankEnd::root;
  double scale = 0.0;  ///< Factor on both semi-axes to reach the edge [-].
};

/// The end that an ellipse of those semi-axes [m], both > 0, meets first as it grows: the smallest ratio of the radial
/// distance from the contact point to a root or crest over the ellipse's radial reach
///
///     sqrt((a t_1 e_r)^2 + (b t_2 e_r)^2)
///
/// e_r outwards from the axis of the flank's part, the reach by which `ellipse_beyond_flanks` measures. Flanks end at
/// the heights of their threads if these are given, else where they meet their neighbours. As a and b grow with
/// N^(1/3), the load at the edge is scale^3 N.
FlankEdge nearest_flank_edge(const ThreadPair& pair, const InterfaceGeometry& interface, double semi_major,
                             double semi_minor);

}  // namespace contact
