#include "prs/model/groove.h"

#include <algorithm>
#include <cmath>

namespace prs {

double Groove::height(double x) const {
  const double from_middle = x - pitch * std::round(x / pitch);
  const double slope = std::tan(from_middle < 0.0 ? backward_angle : forward_angle);
  return std::clamp((0.25 * pitch - std::abs(from_middle)) / slope, -dedendum, addendum);
}

double Groove::position(FlankSide f, double height) const {
  return sign(f) * (0.25 * pitch - height * std::tan(angle(f)));
}

Eigen::Vector2d Groove::normal(FlankSide f) const {
  const double outwards = internal ? -1.0 : 1.0;
  return {outwards * std::sin(angle(f)), sign(f) * std::cos(angle(f))};
}

double sharp_height(double pitch, double flank_angle) { return 0.25 * pitch / std::tan(flank_angle); }

double default_root_depth(double pitch, double flank_angle) {
  return std::min(kRootDepth * pitch, sharp_height(pitch, flank_angle));
}

Groove default_groove(bool internal, double pitch, double pitch_radius, double backward_angle, double forward_angle) {
  const double highest = 0.95 * sharp_height(pitch, std::max(backward_angle, forward_angle));
  Groove g;
  g.internal = internal;
  g.pitch = pitch;
  g.pitch_radius = pitch_radius;
  g.addendum = std::min(kCrestHeight * pitch, highest);
  g.dedendum = std::min(kMeshedRootDepth * pitch, highest);
  g.backward_angle = backward_angle;
  g.forward_angle = forward_angle;
  return g;
}

}  // namespace prs
