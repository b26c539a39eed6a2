#include "prs/life/rating_life.h"

#include <algorithm>

namespace prs {
namespace {

/// Largest distance from 45 deg at which Lemor's factor is valid.
constexpr double kAngleTolerance = 5.0 * std::numbers::pi / 180.0;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double rolling_element_diameter(double pitch, double roller_diameter) {
  return std::sqrt(2.5 * pitch * roller_diameter * std::numbers::sqrt2);
}

std::optional<double> geometry_factor(double ratio) {
  if (!(ratio >= kFactorRatios.least && ratio <= kFactorRatios.greatest)) return std::nullopt;
  constexpr double kCoefficients[] = {-5394384948.0, 8851856787.0, -6308725579.0, 2564041511.0,
                                      -656422710.5,  110470028.7,  -12407228.47,  931488.7454,
                                      -47724.95951,  1892.829727,  26.98514873};
  double factor = 0.0;
  for (const double c : kCoefficients) factor = factor * ratio + c;
  return factor;
}

double size_factor(double element_diameter) {
  const double millimetres = 1e3 * element_diameter;
  return millimetres <= 25.4 ? std::pow(millimetres, 1.8) : 3.647 * std::pow(millimetres, 1.4);
}

double lemor_capacity(double factor, double contact_angle, int contacts, double element_diameter, double helix_angle) {
  return factor * std::pow(std::cos(contact_angle), 0.86) * std::pow(contacts, 2.0 / 3.0) *
         size_factor(element_diameter) * std::tan(contact_angle) * std::cbrt(std::cos(helix_angle));
}

double factor_ratio(const LemorGeometry& g) { return g.roller_diameter * std::cos(g.contact_angle) / g.nut_diameter; }

double contact_angle(const PerInterface<double>& normal_angle) {
  return 0.5 * std::numbers::pi - 0.5 * (normal_angle.screw + normal_angle.nut);
}

LemorGeometry lemor_geometry(const Mechanism& m, double contact_angle) {
  LemorGeometry g;
  g.pitch = axial_pitch(m);
  g.roller_diameter = *m.pitch_diameter.roller;
  g.nut_diameter = *m.pitch_diameter.nut;
  g.pitch_circle = 2.0 * *m.centre_distance;
  g.contact_angle = contact_angle;
  g.helix_angle = std::atan(std::abs(m.lead) / (std::numbers::pi * *m.pitch_diameter.screw));
  g.contacts = loaded_rollers(m) * m.contacts_per_roller;
  return g;
}

std::optional<LemorCapacity> lemor_capacity(const LemorGeometry& g) {
  LemorCapacity c;
  c.ratio = factor_ratio(g);
  const std::optional<double> factor = geometry_factor(c.ratio);
  if (!factor) return std::nullopt;
  c.factor = *factor;
  c.element_diameter = rolling_element_diameter(g.pitch, g.roller_diameter);
  const double per_pitch_circle = std::cos(g.contact_angle) / g.pitch_circle;
  c.factor_range = {c.factor, c.factor};
  for (const double diameter : {g.roller_diameter, c.element_diameter}) {
    const double ratio = std::clamp(diameter * per_pitch_circle, kFactorRatios.least, kFactorRatios.greatest);
    c.factor_range.least = std::min(c.factor_range.least, *geometry_factor(ratio));
    c.factor_range.greatest = std::max(c.factor_range.greatest, *geometry_factor(ratio));
  }
  c.factor_range.least *= 1.0 - kFactorFit;
  c.factor_range.greatest *= 1.0 + kFactorFit;
  const double per_factor = lemor_capacity(1.0, g.contact_angle, g.contacts, c.element_diameter, g.helix_angle);
  c.capacity = c.factor * per_factor;
  c.capacity_range = {c.factor_range.least * per_factor, c.factor_range.greatest * per_factor};
  return c;
}

double load_at_pressure(const contact::HertzConstants& hertz, double peak_pressure) {
  const double cube_root =
      2.0 * std::numbers::pi / 3.0 * hertz.semi_major_per_cbrt_load * hertz.semi_minor_per_cbrt_load * peak_pressure;
  return cube_root * cube_root * cube_root;
}

std::vector<Warning> beside_lemor_range(double contact_angle, double screw_diameter) {
  std::vector<Warning> warnings;
  if (std::abs(contact_angle - std::numbers::pi / 4) > kAngleTolerance)
    warnings.push_back(Warning{"mechanism.flank_angle", "beside_lemor_angle",
                               "contact angle {value}: the factor of Lemor's capacity is that of 45 deg"}
                           .with(contact_angle, {}, "deg"_unit));
  if (screw_diameter < kLeastComparedDiameter)
    warnings.push_back(
        Warning{"mechanism.pitch_diameter.screw", "below_compared_capacities",
                "Lemor's capacity was compared with makers' for screws from {limit} on; this one has {value}, and for "
                "the only smaller one, of {4 mm}, the capacity was twice the maker's, which is 8 times the life",
                "give the capacity of a catalogue as `life.dynamic_capacity`"}
            .with(screw_diameter, kLeastComparedDiameter, "mm"_unit, Warning::Worse::smaller)
            .as_assumption());
  return warnings;
}

std::optional<Warning> beyond_life_formula(double load, double dynamic_capacity) {
  if (load <= 0.5 * dynamic_capacity) return std::nullopt;
  return Warning{"", "beyond_life_formula",
                 "the mean load is {value} of the dynamic capacity; the life formula holds "
                 "up to half of it (ISO 281)"}
      .with(load / dynamic_capacity, 0.5, "%"_unit);
}

double rating_life(double capacity, double load) {
  return load > 0.0 ? 1e6 * std::pow(capacity / load, kLifeExponent) : kInfinity;
}

double reliability_factor(double reliability) {
  constexpr std::array<double, 6> kReliability = {0.90, 0.95, 0.96, 0.97, 0.98, 0.99};
  constexpr std::array<double, 6> kFactor = {1.0, 0.64, 0.55, 0.47, 0.37, 0.25};
  const auto place = [](double s) { return std::log(-std::log(s)); };
  std::size_t k = 0;
  while (k + 2 < kFactor.size() && reliability > kReliability[k + 1]) ++k;
  const double t =
      (place(reliability) - place(kReliability[k])) / (place(kReliability[k + 1]) - place(kReliability[k]));
  return std::pow(kFactor[k], 1.0 - t) * std::pow(kFactor[k + 1], t);
}

double modification_factor(double viscosity_ratio, double contamination, double load_ratio) {
  constexpr double kLeast = 0.1, kGreatest = 4.0, kMostLife = 50.0;
  if (viscosity_ratio < kLeast) return 0.1;
  const double kappa = std::min(viscosity_ratio, kGreatest);
  const auto [a, b] = kappa < 0.4   ? std::pair(2.2649, 0.054381)
                      : kappa < 1.0 ? std::pair(1.9987, 0.19087)
                                    : std::pair(1.9987, 0.071739);
  const double left = 1.0 - std::pow(2.5671 - a / std::pow(kappa, b), 0.83) * std::cbrt(contamination * load_ratio);
  return left > 0.0 ? std::min(0.1 * std::pow(left, -9.3), kMostLife) : kMostLife;
}

double mean_load(std::span<const LoadStep> steps) {
  double revolutions = 0.0, damage = 0.0;
  for (const LoadStep& s : steps) {
    revolutions += s.revolutions;
    damage += std::pow(std::abs(s.axial_force), kLifeExponent) * s.revolutions;
  }
  return revolutions > 0.0 ? std::pow(damage / revolutions, 1.0 / kLifeExponent) : 0.0;
}

double preloaded_bearing_load(double load, double preload) {
  constexpr double kReleased = 2.83;  // External load over the preload that it takes off.
  if (load > kReleased * preload) return load;
  const double ratio = 1.0 + (preload > 0.0 ? load / (kReleased * preload) : 0.0);
  return preload * ratio * std::sqrt(ratio);
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
  return std::pow(threads / failure_share, 1.0 / kWeibullSlope) * rating_life(capacity, equivalent_load);
}

}  // namespace prs
