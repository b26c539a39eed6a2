#include <fmt/format.h>

#include <map>
#include <tuple>

#include "prs/size/requirement.h"

namespace prs {
namespace {

constexpr double kGravity = 9.80665;  // [m/s^2]
constexpr double kEqual = 1e-9;       ///< Share by which equal numbers may differ by rounding.
constexpr double kNoForce = 1e-6;     ///< Of the largest: counts as 0.
constexpr std::size_t kMostShown = 60;
constexpr int kForceSteps = 12, kSpeedSteps = 8;

std::vector<MotionSegment> cut(std::vector<MotionSegment> segments) {
  std::vector<MotionSegment> all;
  for (MotionSegment& s : segments) {
    if (!(s.start_speed * s.end_speed < 0.0)) {
      all.push_back(std::move(s));
      continue;
    }
    MotionSegment first = s, second = s;
    first.name += "-a", second.name += "-b";
    first.duration = s.duration * s.start_speed / (s.start_speed - s.end_speed);
    second.duration = s.duration - first.duration;
    first.end_speed = second.start_speed = 0.0;
    all.push_back(std::move(first));
    all.push_back(std::move(second));
  }
  return all;
}

void set_forces(std::vector<MotionSegment>& all, const Requirement::Load& load) {
  const double weight = load.moved_mass * kGravity;
  const double friction =
      load.guide_friction * weight * std::abs(std::cos(load.inclination)) + load.resistance;
  double largest = 0.0;
  for (MotionSegment& s : all) {
    s.force = load.moved_mass * s.acceleration() + weight * std::sin(load.inclination) +
              s.sense() * friction + s.external_force;
    largest = std::max(largest, std::abs(s.force));
  }
  for (MotionSegment& s : all)
    if (std::abs(s.force) < kNoForce * largest) s.force = 0.0;
}

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/// Step of a value, from 1; an upper border belongs to its step.
int step(double value, double largest, int steps) {
  if (!(largest > 0.0)) return 0;
  return static_cast<int>(std::ceil(value / largest * steps - kEqual));
}

/// Many segments in few classes, each with its cubic mean force by travel, at rest by time, and its
/// mean speed.
void put_into_classes(MotionCycle& c) {
  std::map<int, double> of_force;  // Largest by the sense of force.
  for (const MotionSegment& s : c.all)
    of_force[sign(s.force)] = std::max(of_force[sign(s.force)], std::abs(s.force));
  std::map<std::tuple<int, int, int, int>, std::size_t> known;
  std::vector<double> cubes;
  for (MotionSegment& s : c.all) {
    const int force = sign(s.force);
    const bool is_largest = force != 0 && std::abs(s.force) >= of_force[force] * (1.0 - kEqual);
    const auto [found, is_new] = known.try_emplace(
        {s.sense(), force,
         is_largest ? kForceSteps + 1 : step(std::abs(s.force), c.largest_force, kForceSteps),
         is_largest ? 0 : step(s.mean_speed(), c.largest_speed, kSpeedSteps)},
        c.shown.size());
    if (is_new) {
      c.shown.push_back({fmt::format("class-{}", found->second + 1)});
      c.shown.back().own_travel = 0.0;
      cubes.push_back(0.0);
    }
    s.shown_as = found->second;
    MotionSegment& of = c.shown[s.shown_as];
    of.duration += s.duration;
    *of.own_travel += s.travel();
    cubes[s.shown_as] +=
        std::pow(s.force, 3) * (s.sense() == 0 ? s.duration : std::abs(s.travel()));
  }
  for (std::size_t k = 0; k < c.shown.size(); ++k) {
    MotionSegment& of = c.shown[k];
    of.start_speed = of.end_speed = *of.own_travel / of.duration;
    of.force = std::cbrt(cubes[k] / (of.sense() == 0 ? of.duration : std::abs(*of.own_travel)));
  }
}

void set_totals(MotionCycle& c, const Requirement& r) {
  double cubes = 0.0, square = 0.0, at = 0.0, lowest = 0.0, highest = 0.0;
  std::optional<double> held;
  for (const MotionSegment& s : c.all) {
    const double v0 = s.start_speed, v1 = s.end_speed, way = std::abs(s.travel());
    const double force = std::abs(s.force);
    c.duration += s.duration;
    if (s.sense() != 0) c.moving += s.duration;
    c.travel += way;
    if (s.force != 0.0) c.loaded_travel += way;
    cubes += force * force * force * way;
    square += s.duration * (v0 * v0 + v0 * v1 + v1 * v1) / 3.0;
    c.largest_speed = std::max(c.largest_speed, s.largest_speed());
    if (force > c.largest_force * (1.0 + kEqual)) {
      c.largest_force = force;
      c.largest_sign = s.force > 0.0 ? 1.0 : -1.0;
    }
    if (!r.load.positive_force || direction_of(r, s.force) == Direction::compression)
      c.largest_compression = std::max(c.largest_compression, force);
    if (s.sense() == 0) held = std::max(held.value_or(0.0), force);
    at += s.travel();
    lowest = std::min(lowest, at);
    highest = std::max(highest, at);
  }
  c.way = highest - lowest;
  c.rms_speed = std::sqrt(square / c.duration);
  if (c.loaded_travel > 0.0) c.mean_load = std::cbrt(cubes / c.travel);
  if (c.moving > 0.0) c.mean_speed = c.travel / c.moving;
  c.holding_force =
      held.value_or(r.load.moved_mass * kGravity * std::abs(std::sin(r.load.inclination)));
  c.closed =
      std::abs(c.all.back().end_speed - c.all.front().start_speed) <= kEqual * c.largest_speed;
}

}  // namespace

Direction direction_of(const Requirement& r, double force) {
  const Direction positive = r.load.positive_force.value_or(Direction::compression);
  if (force > 0.0) return positive;
  return positive == Direction::tension ? Direction::compression : Direction::tension;
}

MotionCycle cycle_of(std::vector<MotionSegment> segments, const Requirement& r) {
  MotionCycle c;
  c.all = cut(std::move(segments));
  set_forces(c.all, r.load);
  set_totals(c, r);
  if (r.motion.loads) c.closed = true;
  c.in_classes = c.all.size() > kMostShown;
  for (std::size_t k = 0; k < c.all.size(); ++k) c.all[k].shown_as = k;
  c.in_classes ? put_into_classes(c) : void(c.shown = c.all);
  return c;
}

}  // namespace prs
