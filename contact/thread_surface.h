#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "contact/curvature.h"

namespace contact {

using simd::select, simd::any, simd::sqrt, simd::abs, simd::max, simd::min, simd::hypot, simd::isnan, simd::sincos;

/// Plane in which flank angle and profile radius are measured.
enum class ProfilePlane : std::int64_t {
  normal,  ///< Perpendicular to the helix at the pitch radius (Sandu 2018, section 1.2).
  axial,   ///< Through the axis (Yao 2023, (2)-(4)).
};

/// A drawn thread as numbers: see `Thread`. `Real` is a number, or a batch with one per design.
template <class Real>
struct ThreadNumbers {
  Real pitch_radius, lead, pitch, flank_angle, profile_curvature;
  Real thickness;                   ///< Axial thickness at the pitch radius [m].
  Real inner_height, outer_height;  ///< Heights towards the axis and away from it; NaN: until flanks meet.
  simd::EnumOf<ProfilePlane, Real> plane;
};

/// Axial thread profile at one radius: the flank of a bottom face at angle 0 lies at the height
/// z = f(r) above the middle of the groove.
template <class Real>
struct ProfileAt {
  Real height{};      ///< f [m]
  Real slope{};       ///< f' [-], the tangent of the axial flank angle
  Real slope_rate{};  ///< f'' [1/m]
};

/// Radii between which a flank lies [m].
template <class Real>
struct RadiiOf {
  Real smallest{};
  Real largest{};
};

/// One flank of a thread as a helicoid, with the common terms of its formulas precomputed:
///
///     z(r, theta) = gamma f(r) + theta l/(2 pi)                          (Sandu 2018, (1.22))
///
/// gamma = +1 on the bottom face (outward normal against z) and -1 on the top face. A nut is
/// described by the air inside it: same formula, profile curvature of opposite sign (Sandu 2018,
/// section 1.2.4); `side` distinguishes its material from its air. Straight, convex and concave profiles
/// in both planes are one formula: the local flank angle phi obeys
///
///     sin(phi) = sin(alpha) + (r - r_T)/r_B,   stretch = 1/cos(beta) (normal plane) or 1 (axial),
///     f = f(r_T) + stretch (r - r_T)(sin(alpha) + sin(phi))/(cos(alpha) + cos(phi)),
///     f' = stretch tan(phi),   f'' = stretch/(r_B cos(phi)^3),
///
/// which is (1.10), (1.16) and (1.21) for any r_B, not only for r_T/sin(alpha).
template <class Real>
struct Flank {
  Real side = Real(1.0);             ///< +1 external thread, -1 nut (described by its air).
  Real pitch_radius = Real(0.0);     ///< [m]
  Real pitch = Real(0.0);            ///< [m]
  Real reduced_lead = Real(0.0);     ///< l/(2 pi) [m/rad]
  Real stretch = Real(1.0);          ///< Axial over profile-plane lengths along the axis.
  Real sin_flank = Real(0.0);        ///< sin(alpha)
  Real cos_flank = Real(1.0);        ///< cos(alpha)
  Real arc_curvature = Real(0.0);    ///< 1/r_B of the described volume [1/m]
  Real half_groove = Real(0.0);      ///< f(r_T) [m], p/4 unless the thickness is given.
  Real smallest_radius = Real(0.0);  ///< End of the flank on the side of the axis [m].
  Real largest_radius = Real(0.0);   ///< End of the flank away from the axis [m].

  /// sin(phi) of the local flank angle; the profile exists where it is between 0 and 1.
  Real sin_local_flank(const Real& radius) const { return sin_flank + (radius - pitch_radius) * arc_curvature; }
  /// Whether the arc exists at that radius (wider than the flank itself, which ends at the radii
  /// above).
  simd::Lanes<Real> exists_at(const Real& radius) const {
    const Real s = sin_local_flank(radius);
    return radius > 0.0 && s > 0.0 && s < 1.0;
  }
  /// Valid where `exists_at`.
  ProfileAt<Real> profile(const Real& radius) const {
    const Real sine = sin_local_flank(radius);
    const Real cosine = sqrt((1.0 - sine) * (1.0 + sine));
    const Real rise = (radius - pitch_radius) * (sin_flank + sine) / (cos_flank + cosine);
    return {half_groove + stretch * rise, stretch * sine / cosine,
            stretch * arc_curvature / (cosine * cosine * cosine)};
  }
};

/// Radius at which the profile has risen by `rise` [m, profile plane] above its pitch radius; if the arc becomes
/// parallel to the radius or the axis before that, the radius there.
template <class Real>
Real radius_at_rise(const Flank<Real>& f, const Real& rise) {
  const Real cosine = min(max(f.cos_flank - rise * f.arc_curvature, Real(0.0)), Real(1.0));
  const Real sine = sqrt((1.0 - cosine) * (1.0 + cosine));
  return f.pitch_radius + select(cosine == 0.0 || cosine == 1.0, (sine - f.sin_flank) / f.arc_curvature,
                                 rise * (f.cos_flank + cosine) / (f.sin_flank + sine));
}

/// Radii where neighbouring flanks of a thread meet: at the root f = 0 and at the crest f = p/2, of the air for a nut
/// (Sandu 2018, (1.12), (1.17), (1.19), for any r_B). An arc that becomes parallel to the radius or the axis before
/// that ends there.
template <class Real>
RadiiOf<Real> sharp_limits(const Flank<Real>& f) {
  return {radius_at_rise(f, Real(-f.half_groove / f.stretch)),
          radius_at_rise(f, Real((0.5 * f.pitch - f.half_groove) / f.stretch))};
}

/// Flank of a thread. `internal`: a nut, described by its air; the groove of the air is as wide as the nut's thread is
/// thick.
template <class Real>
Flank<Real> flank_of(const ThreadNumbers<Real>& t, bool internal) {
  Flank<Real> f;
  f.side = Real(internal ? -1.0 : 1.0);
  f.pitch_radius = t.pitch_radius;
  f.pitch = t.pitch;
  f.reduced_lead = t.lead / (2.0 * std::numbers::pi);
  f.stretch = select(t.plane == ProfilePlane::normal,
                     hypot(Real(1.0), t.lead / (2.0 * std::numbers::pi * t.pitch_radius)), Real(1.0));
  const auto [sine, cosine] = sincos(t.flank_angle);
  f.sin_flank = sine;
  f.cos_flank = cosine;
  f.arc_curvature = internal ? -t.profile_curvature : t.profile_curvature;
  f.half_groove = 0.5 * (internal ? t.thickness : t.pitch - t.thickness);
  const RadiiOf<Real> sharp = sharp_limits(f);
  f.smallest_radius = select(isnan(t.inner_height), sharp.smallest, t.pitch_radius - t.inner_height);
  f.largest_radius = select(isnan(t.outer_height), sharp.largest, t.pitch_radius + t.outer_height);
  return f;
}

/// The part of a flank on which its arc exists, if the heights are given beyond it [m].
template <class Real>
RadiiOf<Real> usable_limits(const Flank<Real>& f) {
  const auto straight = f.arc_curvature == 0.0;
  const Real parallel_to_axis = f.pitch_radius - f.sin_flank / f.arc_curvature;
  const Real radial = f.pitch_radius + (1.0 - f.sin_flank) / f.arc_curvature;
  return {select(straight, f.smallest_radius, max(f.smallest_radius, min(parallel_to_axis, radial))),
          select(straight, f.largest_radius, min(f.largest_radius, max(parallel_to_axis, radial)))};
}

/// Curvature tensor of the *material* [1/m] on the flank at a radius where the profile exists, in the frame (helix
/// tangent t of growing theta, n x t), n the outward normal of the described volume (for a nut: of its air). Equal on
/// top and bottom face (Sandu 2018, (B.5), (B.10)).
template <class Real>
TensorOf<Real> curvature_tensor(const Flank<Real>& flank, const Real& radius) {
  // (B.10) with u = theta, v = r on the bottom face, and with the sign of (B.5).
  const ProfileAt<Real> f = flank.profile(radius);
  const Real l = flank.reduced_lead;
  const Real w = sqrt(1.0 + f.slope * f.slope + l * l / (radius * radius));
  const TensorOf<Real> described = curvature_tensor(FormsOf<Real>{
      .E = radius * radius + l * l,
      .F = f.slope * l,
      .G = 1.0 + f.slope * f.slope,
      .L = radius * f.slope / w,
      .M = -l / (radius * w),
      .N = f.slope_rate / w,
  });
  return flank.side * described;
}

/// Thread of one part as on its drawing. It describes the *material*, for a nut too.
struct Thread {
  bool internal = false;           ///< Whether it belongs to a nut.
  double pitch_radius = 0.0;       ///< r_T, thread as wide as gap [m], > 0.
  double lead = 0.0;               ///< l, axial travel of one turn [m]; > 0 right-handed, 0 grooves.
  double pitch = 0.0;              ///< p, axial distance of neighbouring threads [m], > 0.
  double flank_angle = 0.0;        ///< alpha, flank against the radial plane [rad], 0 < alpha < pi/2.
  double profile_curvature = 0.0;  ///< 1/r_B, convex material > 0, straight 0, concave < 0 [1/m].
  ProfilePlane plane = ProfilePlane::normal;
  /// Radial heights of the truncated thread from the pitch radius [m]; a nut's addendum points
  /// inwards. Without them the flanks run until they meet their neighbours (Sandu's sharp V).
  std::optional<double> addendum = std::nullopt;
  std::optional<double> dedendum = std::nullopt;
  /// Axial thickness of the thread at the pitch radius [m]; p/2 unless given.
  std::optional<double> thickness = std::nullopt;
};

/// Largest relative difference of pitches and leads that count as equal (rounding).
inline constexpr double kSamePitch = 1e-9;
bool same_pitch(double a, double b);
/// Whether two threads stay together along the axis: only then do they have a backlash.
bool same_pitch(const Thread& a, const Thread& b);

using ProfilePoint = ProfileAt<double>;

/// One flank of a drawn thread.
struct ThreadSurface : Flank<double> {
  ThreadSurface() = default;
  explicit ThreadSurface(const Thread& thread);

  ProfilePlane plane = ProfilePlane::normal;

  double helix_angle() const;  ///< beta = atan(l/(2 pi r_T)) [rad], sign of the lead (1.3).
};

/// A thread as numbers: heights that it does not state are NaN, a thickness that it does not state is half the pitch.
ThreadNumbers<double> numbers_of(const Thread& thread);

using RadiusLimits = RadiiOf<double>;

/// Radii where neighbouring flanks of a thread meet.
RadiusLimits sharp_limits(const Thread& thread);

/// Effective limits: the truncated thread if its heights are given, else the sharp one.
RadiusLimits flank_limits(const Thread& thread);

enum class ThreadStatus : std::int64_t {
  ok,
  not_finite,
  radius_not_positive,  ///< Pitch radius, or the radius at the inner end of the flank.
  pitch_not_positive,
  flank_angle_out_of_range,  ///< Not between 0 and pi/2.
  thickness_out_of_range,    ///< Not between 0 and the pitch.
  height_negative,           ///< Addendum or dedendum.
  beyond_sharp_limit,        ///< Addendum or dedendum reach past the meeting flanks or the arc's end.
};

std::string_view name(ThreadStatus status);

/// First error of a drawn thread. `beyond_sharp_limit` is worth a warning only; with the others the formulas are
/// undefined.
ThreadStatus check(const Thread& thread);

/// Check of a flank that belongs to the thread.
template <class Real>
simd::EnumOf<ThreadStatus, Real> status_of(const ThreadNumbers<Real>& t, const Flank<Real>& flank) {
  using Status = simd::EnumOf<ThreadStatus, Real>;
  using enum ThreadStatus;
  const auto nothing = [](const Real& x) { return x - x; };  // NaN for values that are not finite
  const auto of_height = [&](const Real& h) { return select(isnan(h), Real(0.0), nothing(h)); };
  const Real finite = nothing(t.pitch_radius) + nothing(t.lead) + nothing(t.pitch) + nothing(t.flank_angle) +
                      nothing(t.profile_curvature) + nothing(t.thickness) + of_height(t.inner_height) +
                      of_height(t.outer_height);
  const RadiiOf<Real> sharp = sharp_limits(flank);
  const auto beyond = flank.smallest_radius < sharp.smallest || flank.largest_radius > sharp.largest;
  Status status = select(beyond, Status(beyond_sharp_limit), Status(ok));
  status = select(flank.smallest_radius <= 0.0, Status(radius_not_positive), status);
  status = select(t.inner_height < 0.0 || t.outer_height < 0.0, Status(height_negative), status);
  status = select(t.thickness > 0.0 && t.thickness < t.pitch, status, Status(thickness_out_of_range));
  status =
      select(t.flank_angle > 0.0 && t.flank_angle < 0.5 * std::numbers::pi, status, Status(flank_angle_out_of_range));
  status = select(t.pitch > 0.0, status, Status(pitch_not_positive));
  status = select(t.pitch_radius > 0.0, status, Status(radius_not_positive));
  return select(finite == 0.0, status, Status(not_finite));
}

}  // namespace contact
