#include "contact/thread_surface.h"

#include <algorithm>
#include <limits>

namespace contact {

bool same_pitch(double a, double b) { return std::abs(a - b) <= kSamePitch * std::max(std::abs(a), std::abs(b)); }

bool same_pitch(const Thread& a, const Thread& b) { return same_pitch(a.pitch, b.pitch); }

ThreadNumbers<double> numbers_of(const Thread& t) {
  constexpr double kSharp = std::numeric_limits<double>::quiet_NaN();
  const double addendum = t.addendum.value_or(kSharp), dedendum = t.dedendum.value_or(kSharp);
  return {.pitch_radius = t.pitch_radius,
          .lead = t.lead,
          .pitch = t.pitch,
          .flank_angle = t.flank_angle,
          .profile_curvature = t.profile_curvature,
          .thickness = t.thickness.value_or(0.5 * t.pitch),
          .inner_height = t.internal ? addendum : dedendum,
          .outer_height = t.internal ? dedendum : addendum,
          .plane = t.plane};
}

RadiusLimits sharp_limits(const Thread& thread) { return sharp_limits(flank_of(numbers_of(thread), thread.internal)); }

RadiusLimits flank_limits(const Thread& thread) {
  const Flank<double> flank = flank_of(numbers_of(thread), thread.internal);
  return {flank.smallest_radius, flank.largest_radius};
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

ThreadStatus check(const Thread& thread) {
  const ThreadNumbers<double> numbers = numbers_of(thread);
  return status_of(numbers, flank_of(numbers, thread.internal));
}

ThreadSurface::ThreadSurface(const Thread& thread)
    : Flank<double>(flank_of(numbers_of(thread), thread.internal)), plane(thread.plane) {}

double ThreadSurface::helix_angle() const { return std::atan(reduced_lead / pitch_radius); }

}  // namespace contact
