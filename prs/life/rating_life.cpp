#include "prs/life/rating_life.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prs {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double rating_life(double capacity, double load) {
  return load > 0.0 ? 1e6 * std::pow(capacity / load, kLifeExponent) : kInfinity;
}

double mean_load(std::span<const LoadStep> steps) {
  double revolutions = 0.0, damage = 0.0;
  for (const LoadStep& s : steps) {
    revolutions += s.revolutions;
    damage += std::pow(std::abs(s.axial_force), kLifeExponent) * s.revolutions;
  }
  return revolutions > 0.0 ? std::pow(damage / revolutions, 1.0 / kLifeExponent) : 0.0;
}

double combined_life(std::span<const double> lives) {
  const double shortest = lives.empty() ? kInfinity : *std::min_element(lives.begin(), lives.end());
  if (!std::isfinite(shortest)) return kInfinity;
  double hazard = 0.0;
  for (const double life : lives) hazard += std::pow(shortest / life, kWeibullSlope);
  return shortest * std::pow(hazard, -1.0 / kWeibullSlope);
}

PerInterface<double> failure_shares(double gamma) {
  const double screw_over_nut = std::pow((1.0 - gamma) / (1.0 + gamma), 1.72);
  const double screw = 1.0 / (1.0 + std::pow(screw_over_nut, kLifeExponent * kWeibullSlope));
  return {screw, 1.0 - screw};
}

double thread_life(double capacity, double equivalent_load, double failure_share, int threads) {
  return std::pow(threads / failure_share, 1.0 / kWeibullSlope) *
         rating_life(capacity, equivalent_load);
}

}  // namespace prs
