#include "contact/thread_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact {

namespace {

double axial_stretch(const Thread& t) {
  return t.plane == ProfilePlane::axial
             ? 1.0
             : std::hypot(1.0, t.lead / (2.0 * std::numbers::pi * t.pitch_radius));
}

/// Half the groove of the described volume at the pitch radius: a nut's air is as grooved as the
/// nut's thread is thick.
double half_groove_of(const Thread& t) {
  const double thickness = t.thickness.value_or(0.5 * t.pitch);
  return 0.5 * (t.internal ? thickness : t.pitch - thickness);
}

/// Curvature of the arc of the described volume.
double arc_curvature_of(const Thread& t) {
  return t.internal ? -t.profile_curvature : t.profile_curvature;
}

/// Radius at which the profile has risen by `rise` [m, profile plane] above its pitch radius.
double radius_at_rise(const Thread& t, double rise) {
  const double sin_flank = std::sin(t.flank_angle), cos_flank = std::cos(t.flank_angle);
  const double cosine = std::clamp(cos_flank - rise * arc_curvature_of(t), 0.0, 1.0);
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  if (cosine == 0.0 || cosine == 1.0) {
    return t.pitch_radius + (sine - sin_flank) / arc_curvature_of(t);
  }
  return t.pitch_radius + rise * (cos_flank + cosine) / (sin_flank + sine);
}

}  // namespace

bool same_pitch(double a, double b) {
  return std::abs(a - b) <= kSamePitch * std::max(std::abs(a), std::abs(b));
}

bool same_pitch(const Thread& a, const Thread& b) { return same_pitch(a.pitch, b.pitch); }

RadiusLimits sharp_limits(const Thread& thread) {
  const double stretch = axial_stretch(thread);
  const double half_groove = half_groove_of(thread);
  return {radius_at_rise(thread, -half_groove / stretch),
          radius_at_rise(thread, (0.5 * thread.pitch - half_groove) / stretch)};
}

RadiusLimits flank_limits(const Thread& thread) {
  RadiusLimits limits = sharp_limits(thread);
  const std::optional<double>& inner = thread.internal ? thread.addendum : thread.dedendum;
  const std::optional<double>& outer = thread.internal ? thread.dedendum : thread.addendum;
  if (inner) limits.smallest = thread.pitch_radius - *inner;
  if (outer) limits.largest = thread.pitch_radius + *outer;
  return limits;
}

RadiusLimits usable_limits(const ThreadSurface& s) {
  RadiusLimits limits{s.smallest_radius, s.largest_radius};
  if (s.arc_curvature != 0.0) {
    const double parallel_to_axis = s.pitch_radius - s.sin_flank / s.arc_curvature;
    const double radial = s.pitch_radius + (1.0 - s.sin_flank) / s.arc_curvature;
    limits.smallest = std::max(limits.smallest, std::min(parallel_to_axis, radial));
    limits.largest = std::min(limits.largest, std::max(parallel_to_axis, radial));
  }
  return limits;
}

std::string_view name(ThreadStatus status) {
  constexpr std::string_view kNames[] = {"ok",
                                         "not_finite",
                                         "radius_not_positive",
                                         "pitch_not_positive",
                                         "flank_angle_out_of_range",
                                         "thickness_out_of_range",
                                         "height_negative",
                                         "beyond_sharp_limit"};
  return kNames[static_cast<std::size_t>(status)];
}

ThreadStatus check(const Thread& t) {
  const double addendum = t.addendum.value_or(0.0), dedendum = t.dedendum.value_or(0.0);
  const double thickness = t.thickness.value_or(0.5 * t.pitch);
  for (const double x : {t.pitch_radius, t.lead, t.pitch, t.flank_angle, t.profile_curvature,
                         addendum, dedendum, thickness}) {
    if (!std::isfinite(x)) return ThreadStatus::not_finite;
  }
  if (t.pitch_radius <= 0.0) return ThreadStatus::radius_not_positive;
  if (t.pitch <= 0.0) return ThreadStatus::pitch_not_positive;
  if (t.flank_angle <= 0.0 || t.flank_angle >= 0.5 * std::numbers::pi) {
    return ThreadStatus::flank_angle_out_of_range;
  }
  if (thickness <= 0.0 || thickness >= t.pitch) return ThreadStatus::thickness_out_of_range;
  if (addendum < 0.0 || dedendum < 0.0) return ThreadStatus::height_negative;
  const RadiusLimits limits = flank_limits(t), sharp = sharp_limits(t);
  if (limits.smallest <= 0.0) return ThreadStatus::radius_not_positive;
  if (limits.smallest < sharp.smallest || limits.largest > sharp.largest) {
    return ThreadStatus::beyond_sharp_limit;
  }
  return ThreadStatus::ok;
}

ThreadSurface::ThreadSurface(const Thread& thread)
    : side(thread.internal ? -1.0 : 1.0),
      pitch_radius(thread.pitch_radius),
      pitch(thread.pitch),
      reduced_lead(thread.lead / (2.0 * std::numbers::pi)),
      stretch(axial_stretch(thread)),
      sin_flank(std::sin(thread.flank_angle)),
      cos_flank(std::cos(thread.flank_angle)),
      arc_curvature(arc_curvature_of(thread)),
      half_groove(half_groove_of(thread)),
      plane(thread.plane) {
  const RadiusLimits limits = flank_limits(thread);
  smallest_radius = limits.smallest;
  largest_radius = limits.largest;
}

double ThreadSurface::helix_angle() const { return std::atan(reduced_lead / pitch_radius); }

ProfilePoint ThreadSurface::profile(double radius) const {
  const double sine = sin_local_flank(radius);
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  const double rise = (radius - pitch_radius) * (sin_flank + sine) / (cos_flank + cosine);
  return {half_groove + stretch * rise, stretch * sine / cosine,
          stretch * arc_curvature / (cosine * cosine * cosine)};
}

SymmetricTensor curvature_tensor(const ThreadSurface& surface, double radius) {
  // (B.10) with u = theta, v = r on the bottom face, and with the sign of (B.5).
  const ProfilePoint f = surface.profile(radius);
  const double l = surface.reduced_lead;
  const double w = std::sqrt(1.0 + f.slope * f.slope + l * l / (radius * radius));
  const SymmetricTensor described = curvature_tensor(FundamentalForms{
      .E = radius * radius + l * l,
      .F = f.slope * l,
      .G = 1.0 + f.slope * f.slope,
      .L = radius * f.slope / w,
      .M = -l / (radius * w),
      .N = f.slope_rate / w,
  });
  return surface.side * described;
}

}  // namespace contact
