#pragma once

#include <optional>
#include <string_view>

#include "contact/curvature.h"

namespace contact {

/// The plane in which flank angle and profile radius are measured.
enum class ProfilePlane {
  normal,  ///< Perpendicular to the helix at the pitch radius (Sandu 2018, section 1.2).
  axial,   ///< Through the axis (Yao 2023, (2)-(4)).
};

/// Thread of one part as on its drawing. It describes the *material*, for a nut too.
struct Thread {
  bool internal = false;      ///< A nut.
  double pitch_radius = 0.0;  ///< r_T, thread as wide as gap [m], > 0.
  double lead = 0.0;          ///< l, axial travel of one turn [m]; > 0 right-handed, 0 grooves.
  double pitch = 0.0;         ///< p, axial distance of neighbouring threads [m], > 0.
  double flank_angle = 0.0;   ///< alpha, flank against the radial plane [rad], 0 < alpha < pi/2.
  double profile_curvature = 0.0;  ///< 1/r_B, convex material > 0, straight 0, concave < 0 [1/m].
  ProfilePlane plane = ProfilePlane::normal;
  /// Radial heights of the truncated thread from the pitch radius [m]; a nut's addendum points
  /// inwards. Without them the flanks run until they meet their neighbours (Sandu's sharp V).
  std::optional<double> addendum = std::nullopt;
  std::optional<double> dedendum = std::nullopt;
  /// Axial thickness of the thread at the pitch radius [m]; p/2 unless given.
  std::optional<double> thickness = std::nullopt;
};

/// Pitches and leads that differ by a smaller share count as equal (rounding).
inline constexpr double kSamePitch = 1e-9;
bool same_pitch(double a, double b);
/// Whether two threads stay together along the axis: only then do they have a backlash.
bool same_pitch(const Thread& a, const Thread& b);

/// Axial thread profile at one radius: the flank of a bottom face at angle 0 lies at the height
/// z = f(r) above the middle of the groove.
struct ProfilePoint {
  double height = 0.0;      ///< f [m]
  double slope = 0.0;       ///< f' [-], the tangent of the axial flank angle
  double slope_rate = 0.0;  ///< f'' [1/m]
};

/// One flank of a thread as a helicoid, with the common terms of its formulas precomputed:
///
///     z(r, theta) = gamma f(r) + theta l/(2 pi)                          (Sandu 2018, (1.22))
///
/// gamma = +1 on the bottom face (outward normal against z) and -1 on the top face. A nut is
/// described by the air inside it: same formula, profile curvature of opposite sign (Sandu 2018,
/// section 1.2.4); `side` tells its material from its air. Straight, convex and concave profiles
/// in both planes are one formula: the local flank angle phi obeys
///
///     sin(phi) = sin(alpha) + (r - r_T)/r_B,   stretch = 1/cos(beta) (normal plane) or 1 (axial),
///     f = f(r_T) + stretch (r - r_T)(sin(alpha) + sin(phi))/(cos(alpha) + cos(phi)),
///     f' = stretch tan(phi),   f'' = stretch/(r_B cos(phi)^3),
///
/// which is (1.10), (1.16) and (1.21) for any r_B, not only for r_T/sin(alpha).
struct ThreadSurface {
  ThreadSurface() = default;
  explicit ThreadSurface(const Thread& thread);

  double side = 1.0;             ///< +1 external thread, -1 nut (described by its air).
  double pitch_radius = 0.0;     ///< [m]
  double pitch = 0.0;            ///< [m]
  double reduced_lead = 0.0;     ///< l/(2 pi) [m/rad]
  double stretch = 1.0;          ///< Axial over profile-plane lengths along the axis.
  double sin_flank = 0.0;        ///< sin(alpha)
  double cos_flank = 1.0;        ///< cos(alpha)
  double arc_curvature = 0.0;    ///< 1/r_B of the described volume [1/m]
  double half_groove = 0.0;      ///< f(r_T) [m], p/4 unless the thickness is given.
  double smallest_radius = 0.0;  ///< End of the flank on the side of the axis [m].
  double largest_radius = 0.0;   ///< Its other end [m].
  ProfilePlane plane = ProfilePlane::normal;

  double helix_angle() const;  ///< beta = atan(l/(2 pi r_T)) [rad], sign of the lead (1.3).

  /// sin(phi) of the local flank angle; the profile exists where it is between 0 and 1.
  double sin_local_flank(double radius) const {
    return sin_flank + (radius - pitch_radius) * arc_curvature;
  }
  /// Whether the arc exists at that radius (wider than the flank itself, which ends at the radii
  /// above).
  bool exists_at(double radius) const {
    const double s = sin_local_flank(radius);
    return radius > 0.0 && s > 0.0 && s < 1.0;
  }
  /// Valid where `exists_at`.
  ProfilePoint profile(double radius) const;
};

/// Radii between which a flank lies [m].
struct RadiusLimits {
  double smallest = 0.0;
  double largest = 0.0;
};

/// Where neighbouring flanks of a thread meet: at the root f = 0 and at the crest f = p/2, of the
/// air for a nut (Sandu 2018, (1.12), (1.17), (1.19), for any r_B). An arc that turns parallel to
/// the radius or the axis before that ends there.
RadiusLimits sharp_limits(const Thread& thread);

/// The limits in force: the truncated thread where its heights are given, else the sharp one.
RadiusLimits flank_limits(const Thread& thread);

/// The part of a flank on which its arc exists, where the heights are given beyond it [m].
RadiusLimits usable_limits(const ThreadSurface& surface);

enum class ThreadStatus {
  ok,
  not_finite,
  radius_not_positive,  ///< Pitch radius, or the radius at the inner end of the flank.
  pitch_not_positive,
  flank_angle_out_of_range,  ///< Not between 0 and pi/2.
  thickness_out_of_range,    ///< Not between 0 and the pitch.
  height_negative,           ///< Addendum or dedendum.
  beyond_sharp_limit,  ///< Addendum or dedendum reach past the meeting flanks or the arc's end.
};

std::string_view name(ThreadStatus status);

/// The first thing that is wrong with a drawn thread. `beyond_sharp_limit` is worth a warning only;
/// with the others the formulas have no meaning.
ThreadStatus check(const Thread& thread);

/// Curvature tensor of the *material* [1/m] on the flank at a radius where the profile exists, in
/// the frame (helix tangent t of growing theta, n x t), n the outward normal of the described
/// volume (for a nut: of its air). The same on top and bottom face (Sandu 2018, (B.5), (B.10)).
SymmetricTensor curvature_tensor(const ThreadSurface& surface, double radius);

}  // namespace contact
