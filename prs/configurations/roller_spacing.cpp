#include "prs/configurations/roller_spacing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prs {

double neighbour_gap(double centre_distance, double outer_radius, int rollers) {
  return 2.0 * (centre_distance * std::sin(std::numbers::pi / rollers) - outer_radius);
}

int most_rollers(double centre_distance, double outer_radius, double gap) {
  constexpr double kMost = 1000.0;
  const double ratio = (outer_radius + 0.5 * gap) / centre_distance;
  if (!(ratio < 1.0)) return 1;
  // A hair of tolerance, so that rollers that just reach the gap count.
  return static_cast<int>(
      std::min(kMost, std::floor(std::numbers::pi / std::asin(ratio) * (1.0 + 1e-12))));
}

double indexing_angle(Mechanism::Type type, Mechanism::Starts starts, int rollers) {
  const int forward = starts.screw % rollers;
  const int steps = type == Mechanism::Type::inverted ? forward : (rollers - forward) % rollers;
  return 2.0 * std::numbers::pi / starts.roller * steps / rollers;
}

bool go_in_alike(Mechanism::Starts starts, int rollers) { return starts.screw % rollers == 0; }

}  // namespace prs
