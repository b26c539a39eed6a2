#include "prs/life/load_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace prs {
namespace {

double revolutions(const std::vector<LoadStep>& steps) {
  double sum = 0.0;
  for (const LoadStep& s : steps) sum += s.revolutions;
  return sum;
}

TEST(LoadSteps, TravelInEitherSenseTurnsTheScrew) {
  LoadHistory h;
  h.force = {1e3, 2e3, -3e3};
  h.position = {0.0, 10e-3, 5e-3};
  const std::vector<LoadStep> steps = load_steps(h, -5e-3, std::nullopt, HistorySource::DrivenBy::screw);
  // 2 revolutions, then 1 back; each sample has half of its neighbours' steps.
  EXPECT_NEAR(steps[0].revolutions, 1.0, 1e-15);
  EXPECT_NEAR(steps[1].revolutions, 1.5, 1e-15);
  EXPECT_NEAR(steps[2].revolutions, 0.5, 1e-15);
  EXPECT_EQ(steps[2].axial_force, -3e3);
  EXPECT_FALSE(duration(h));
}

TEST(LoadSteps, SpeedAndTimeTurnTheScrew) {
  LoadHistory h;
  h.force = {1e3, 1e3, 1e3};
  h.time = {2.0, 3.0, 5.0};
  h.speed = {0.0, 4 * std::numbers::pi, -4 * std::numbers::pi};
  EXPECT_NEAR(revolutions(load_steps(h, 5e-3, std::nullopt, HistorySource::DrivenBy::screw)), 1.0 + 4.0, 1e-14);
  EXPECT_EQ(*duration(h), 3.0);
  h.speed.clear();
  EXPECT_NEAR(revolutions(load_steps(h, 5e-3, 2 * std::numbers::pi, HistorySource::DrivenBy::screw)), 3.0, 1e-14);
  h.time.clear();
  h.interval = 0.5;
  EXPECT_NEAR(revolutions(load_steps(h, 5e-3, 2 * std::numbers::pi, HistorySource::DrivenBy::screw)), 1.0, 1e-14);
  EXPECT_EQ(*duration(h), 1.0);
}

TEST(LoadSteps, SpeedAlongTheAxisTurnsTheScrewByTheLead) {
  LoadHistory h;
  h.force = {1e3, 1e3};
  h.interval = 2.0;
  h.speed = {-20e-3, 20e-3};
  h.speed_along_axis = true;
  EXPECT_NEAR(revolutions(load_steps(h, -5e-3, std::nullopt, HistorySource::DrivenBy::screw)), 8.0, 1e-14);
}

SpectrumLoad load(double force, Direction direction) {
  SpectrumLoad l;
  l.force = force;
  l.direction = direction;
  return l;
}

TEST(LoadSteps, OfASpectrumAreItsRevolutions) {
  SpectrumLoad by_turns = load(1e3, Direction::tension);
  SpectrumLoad by_way = load(2e3, Direction::compression);
  SpectrumLoad by_time = load(3e3, Direction::tension);
  by_turns.revolutions = 7.0;
  by_way.distance = 20e-3;
  by_time.duration = 60.0;
  const SpectrumLoad spectrum[] = {by_turns, by_way, by_time};
  const std::vector<LoadStep> steps = load_steps(spectrum, 5e-3, 4 * std::numbers::pi);
  EXPECT_EQ(steps[0].revolutions, 7.0);
  EXPECT_NEAR(steps[1].revolutions, 4.0, 1e-14);
  EXPECT_EQ(steps[1].axial_force, -2e3);
  EXPECT_NEAR(steps[2].revolutions, 120.0, 1e-12);
}

TEST(LoadSteps, SharesSumToOne) {
  SpectrumLoad a = load(1e3, Direction::tension), b = load(2e3, Direction::tension);
  a.share = 0.3333;
  b.share = 0.6663;
  const SpectrumLoad spectrum[] = {a, b};
  EXPECT_NEAR(revolutions(load_steps(spectrum, 5e-3, std::nullopt)), 1.0, 1e-15);
}

TEST(LargestSpeed, IsThatOfTheSamplesOrFromPositionToPosition) {
  LoadHistory h;
  EXPECT_FALSE(largest_speed(h, 5e-3));
  h.speed = {3.0, -7.0, 2.0};
  EXPECT_EQ(largest_speed(h, -5e-3), 7.0);
  h.speed_along_axis = true;  // [m/s]
  EXPECT_NEAR(*largest_speed(h, -5e-3), 7.0 * 2.0 * std::numbers::pi / 5e-3, 1e-10);
  h = {};
  h.force = {1.0, 1.0, 1.0};
  h.position = {0.0, 10e-3, 5e-3};
  EXPECT_FALSE(largest_speed(h, 5e-3));  // No clock.
  h.time = {0.0, 1.0, 1.25};
  EXPECT_NEAR(*largest_speed(h, 5e-3), 4.0 * 2.0 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace prs
