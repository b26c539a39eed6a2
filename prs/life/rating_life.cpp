#include "prs/life/rating_life.h"

#include <algorithm>
#include <limits>

namespace prs {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double rating_life(double capacity, double load) {
  return load > 0.0 ? 1e6 * std::pow(capacity / load, kLifeExponent) : kInfinity;
}

double reliability_factor(double reliability) {
  constexpr std::array<double, 6> kReliability = {0.90, 0.95, 0.96, 0.97, 0.98, 0.99};
  constexpr std::array<double, 6> kFactor = {1.0, 0.64, 0.55, 0.47, 0.37, 0.25};
  const auto place = [](double s) { return std::log(-std::log(s)); };
  std::size_t k = 0;
  while (k + 2 < kFactor.size() && reliability > kReliability[k + 1]) ++k;
  const double t = (place(reliability) - place(kReliability[k])) /
                   (place(kReliability[k + 1]) - place(kReliability[k]));
  return std::pow(kFactor[k], 1.0 - t) * std::pow(kFactor[k + 1], t);
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

double roller_failure_share(int rollers, double roller_diameter, double body_diameter) {
  const double over_body = std::pow(rollers * roller_diameter / body_diameter, 1.0 - kWeibullSlope);
  return over_body / (1.0 + over_body);
}

double thread_life(double capacity, double equivalent_load, double failure_share, int threads) {
  return std::pow(threads / failure_share, 1.0 / kWeibullSlope) *
         rating_life(capacity, equivalent_load);
}

}  // namespace prs
