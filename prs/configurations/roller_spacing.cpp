#include "prs/configurations/roller_spacing.h"

#include <algorithm>
#include <tuple>

namespace prs {
namespace {

constexpr double kPressureAngle = std::numbers::pi / 9;
constexpr int kFewestTeeth = 12, kMostTeeth = 40;
constexpr double kMostShift = 1.0;

/// ISO 54, and DIN 780-1 below 1 mm, from 0.2 to 10 mm [m].
constexpr double kSeries1[] = {0.2e-3, 0.25e-3, 0.3e-3, 0.4e-3,  0.5e-3, 0.6e-3, 0.7e-3,
                               0.8e-3, 0.9e-3,  1e-3,   1.25e-3, 1.5e-3, 2e-3,   2.5e-3,
                               3e-3,   4e-3,    5e-3,   6e-3,    8e-3,   10e-3};
constexpr double kSeries2[] = {0.22e-3, 0.28e-3, 0.35e-3,  0.45e-3,  0.55e-3, 0.65e-3, 0.75e-3,
                               0.85e-3, 0.95e-3, 1.125e-3, 1.375e-3, 1.75e-3, 2.25e-3, 2.75e-3,
                               3.5e-3,  4.5e-3,  5.5e-3,   7e-3,     9e-3};

double involute(double angle) { return std::tan(angle) - angle; }

/// z_body -+ z_roller, of an internal or an external pair.
int teeth_between(Mechanism::Type type, const GearPair& pair) {
  return type == Mechanism::Type::standard ? pair.body_teeth - pair.roller_teeth
                                           : pair.body_teeth + pair.roller_teeth;
}

/// Working pressure angle and profile shift; false where base circles do not let them mesh or the
/// shift is too large.
bool fit(Mechanism::Type type, double centre_distance, GearPair& pair) {
  const int teeth = teeth_between(type, pair);
  const double cosine = 0.5 * pair.module * teeth / centre_distance * std::cos(kPressureAngle);
  if (!(cosine < 1.0)) return false;
  pair.working_pressure_angle = std::acos(cosine);
  pair.profile_shift = teeth * (involute(pair.working_pressure_angle) - involute(kPressureAngle)) /
                       (2.0 * std::tan(kPressureAngle));
  return std::abs(pair.profile_shift) <= kMostShift;
}

}  // namespace

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

std::vector<GearPair> gear_pairs(Mechanism::Type type, Mechanism::Starts starts,
                                 double centre_distance, int rollers, double gap) {
  std::vector<GearPair> pairs;
  const int first = (kFewestTeeth + starts.roller - 1) / starts.roller;
  for (int k = first; k * starts.roller <= kMostTeeth; ++k) {
    GearPair pair;
    pair.roller_teeth = k * starts.roller;
    pair.body_teeth = k * starts.screw;
    const int teeth = teeth_between(type, pair);
    if (teeth <= 0) continue;
    const double pitch_radius = centre_distance * pair.roller_teeth / teeth;
    const auto try_series = [&](const auto& modules, int series) {
      for (const double module : modules) {
        pair.module = module;
        pair.series = series;
        if (!fit(type, centre_distance, pair)) continue;
        pair.most_rollers =
            std::min(rollers, most_rollers(centre_distance, pitch_radius + module, gap));
        pairs.push_back(pair);
      }
    };
    try_series(kSeries1, 1);
    try_series(kSeries2, 2);
  }
  std::ranges::stable_sort(pairs, {}, [](const GearPair& p) {
    return std::tuple(-p.most_rollers, p.series, std::round(10.0 * std::abs(p.profile_shift)),
                      p.roller_teeth);
  });
  return pairs;
}

}  // namespace prs
