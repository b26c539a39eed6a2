#pragma once

#include <optional>
#include <string_view>

#include "contact/flank.h"

namespace contact {

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

using ProfilePoint = ProfileAt<double>;

/// One flank of a drawn thread.
struct ThreadSurface : Flank<double> {
  ThreadSurface() = default;
  explicit ThreadSurface(const Thread& thread);

  ProfilePlane plane = ProfilePlane::normal;

  double helix_angle() const;  ///< beta = atan(l/(2 pi r_T)) [rad], sign of the lead (1.3).
};

/// A thread without what only a person reads.
ThreadNumbers<double> numbers_of(const Thread& thread);

using RadiusLimits = RadiiOf<double>;

/// Radii where neighbouring flanks of a thread meet.
RadiusLimits sharp_limits(const Thread& thread);

/// The limits in force: the truncated thread where its heights are given, else the sharp one.
RadiusLimits flank_limits(const Thread& thread);

enum class ThreadStatus : std::int64_t {
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

/// The same of a flank that is that of the thread.
template <class Real>
simd::EnumOf<ThreadStatus, Real> status_of(const ThreadNumbers<Real>& t, const Flank<Real>& flank) {
  using Status = simd::EnumOf<ThreadStatus, Real>;
  using enum ThreadStatus;
  const auto nothing = [](const Real& x) { return x - x; };  // NaN of what is not finite
  const auto of_height = [&](const Real& h) { return select(isnan(h), Real(0.0), nothing(h)); };
  const Real finite = nothing(t.pitch_radius) + nothing(t.lead) + nothing(t.pitch) +
                      nothing(t.flank_angle) + nothing(t.profile_curvature) + nothing(t.thickness) +
                      of_height(t.inner_height) + of_height(t.outer_height);
  const RadiiOf<Real> sharp = sharp_limits(flank);
  const auto beyond =
      flank.smallest_radius < sharp.smallest || flank.largest_radius > sharp.largest;
  Status status = select(beyond, Status(beyond_sharp_limit), Status(ok));
  status = select(flank.smallest_radius <= 0.0, Status(radius_not_positive), status);
  status = select(t.inner_height < 0.0 || t.outer_height < 0.0, Status(height_negative), status);
  status =
      select(t.thickness > 0.0 && t.thickness < t.pitch, status, Status(thickness_out_of_range));
  status = select(t.flank_angle > 0.0 && t.flank_angle < 0.5 * std::numbers::pi, status,
                  Status(flank_angle_out_of_range));
  status = select(t.pitch > 0.0, status, Status(pitch_not_positive));
  status = select(t.pitch_radius > 0.0, status, Status(radius_not_positive));
  return select(finite == 0.0, status, Status(not_finite));
}

}  // namespace contact
