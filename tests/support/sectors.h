#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "prs/sector/sector.h"

namespace test {

/// All arguments of `sector_model` as one value.
struct SectorCase {
  prs::Mechanism mechanism;
  prs::Structure structure;
  prs::Materials materials;
  prs::ModelOptions options;
  prs::PerInterface<prs::ContactLaw> laws;
  prs::Direction direction = prs::Direction::tension;
  double position = 0.0;
  prs::Deviations deviations = {};

  prs::SectorModel model() const {
    return prs::sector_model(mechanism, structure, materials, options, laws, direction, position, deviations);
  }
  prs::Sector build() const { return prs::build_sector(model()); }
};

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// The inverted screw of Abevi 2015 (tables 1 and 2) with the assumed nut, CONFIG 2 in tension.
inline SectorCase abevi() {
  SectorCase c;
  c.mechanism.lead = 5e-3;
  c.mechanism.starts = {3, 1};
  c.mechanism.pitch_diameter = {21e-3, 7e-3, 35e-3};
  c.mechanism.rollers = 11;
  c.mechanism.contacts_per_roller = 20;
  c.structure.screw = {6e-3, 10e-3};
  c.structure.roller = {5e-3, 5e-3, {}};
  c.structure.nut = {
      90e-3, 46e-3, {{0.0, 10e-3, 62e-3}, {80e-3, 90e-3, 62e-3}}, {.tension = 10e-3, .compression = 80e-3}};
  for (const prs::Part p : prs::kParts) c.materials[p] = {209e9, 0.3, {}};
  const double per_m = std::pow(1e3, 1.5);
  c.laws = {{3.6062e5 * per_m, 45.0288 * kDegree}, {4.2140e5 * per_m, 45.0803 * kDegree}};
  c.position = 29.1666667e-3;
  return c;
}

/// Short version with six contacts per roller in the middle of a short nut.
inline SectorCase short_screw() {
  SectorCase c = abevi();
  c.mechanism.contacts_per_roller = 6;
  c.structure.nut.length = 40e-3;
  c.structure.nut.flanges = {{0.0, 8e-3, 62e-3}, {32e-3, 40e-3, 62e-3}};
  c.structure.nut.thrust = {.tension = 8e-3, .compression = 32e-3};
  c.position = 20e-3 - 2.5 * axial_pitch(c.mechanism);
  return c;
}

/// A random sector: 4 to 99 threads, constants over two decades, every option of the model.
inline SectorCase random_sector(std::mt19937_64& random) {
  using prs::Direction, prs::Guidance, prs::ModelOptions;
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto log_uniform = [&](double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); };
  const auto whole = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };

  SectorCase c;
  prs::Mechanism& m = c.mechanism;
  m.type = whole(0, 1) ? prs::Mechanism::Type::inverted : prs::Mechanism::Type::standard;
  m.starts = {whole(1, 6), 1};
  const double pitch = log_uniform(0.4e-3, 4e-3);
  m.lead = (whole(0, 1) ? 1.0 : -1.0) * pitch * m.starts.screw;
  m.rollers = whole(3, 13);
  m.contacts_per_roller = whole(4, 99);
  const double roller = pitch * uniform(2.5, 6.0);
  const double screw = roller * uniform(1.5, 5.0);
  m.pitch_diameter = {screw, roller, screw + 2.0 * roller};

  if (whole(0, 4) == 0) m.pitch.roller = pitch + uniform(-1e-6, 1e-6);
  const double contacts = (m.contacts_per_roller - 1) * pitch;
  const double before = whole(0, 3) ? uniform(0.0, 2.0) * roller : 0.0;
  const double length = contacts + before + uniform(0.0, 3.0) * roller + 1e-6;
  c.position = before;
  c.structure.screw = {whole(0, 1) ? uniform(0.0, 0.7) * screw : 0.0, whole(0, 2) ? uniform(0.1, 3.0) * screw : 0.0};
  c.structure.roller = {uniform(0.3, 2.0) * roller, uniform(0.5, 1.0) * roller, {}};
  switch (whole(0, 3)) {
    case 0:
      c.structure.roller.guidance = {Guidance::Kind::outer_node, 0.0};
      break;
    case 1:
      c.structure.roller.guidance = {Guidance::Kind::ring, log_uniform(1e5, 1e9)};
      break;
    default:
      break;
  }
  const double nut = *m.pitch_diameter.nut * uniform(1.1, 1.8);
  c.structure.nut = {length,
                     nut,
                     {{0.0, 0.2 * length, 1.4 * nut}, {0.2 * length, 0.3 * length, 1.1 * nut}},
                     {.tension = uniform(0.0, 1.0) * length, .compression = length}};
  for (const prs::Part p : prs::kParts) c.materials[p] = {log_uniform(0.7e11, 4e11), uniform(0.2, 0.4), {}};
  for (const prs::Interface i : prs::kInterfaces)
    c.laws[i] = {log_uniform(1e9, 1e11) * std::sqrt(roller / 7e-3), uniform(20.0, 70.0) * kDegree};
  c.options.roller = whole(0, 4) ? ModelOptions::Roller::flexible : ModelOptions::Roller::rigid_bending;
  c.options.roller_shear = whole(0, 3) == 0;
  c.direction = whole(0, 1) ? Direction::tension : Direction::compression;
  return c;
}

/// Axial force over four decades, up to a mean thread load that is heavy for the thread's size [N].
inline double random_force(const SectorCase& c, std::mt19937_64& random) {
  const double size = *c.mechanism.pitch_diameter.roller;
  const double heavy = 5e6 * size * size;  // about 250 N per thread on a 7 mm roller
  const double share = std::exp(std::uniform_real_distribution<double>(std::log(1e-4), 0.0)(random));
  return share * heavy * c.mechanism.rollers * c.mechanism.contacts_per_roller;
}

/// A random sector of extreme ratios, within the checks of a case: moduli and Hertz constants over nine decades, rings
/// from 1e-3 to 1e15 N/m, thin walls, slender and stout ends, free lengths from 0 and 1e-12 mm up, 2 to 60 threads.
inline SectorCase extreme_sector(std::mt19937_64& random) {
  using prs::Direction, prs::Guidance, prs::ModelOptions;
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto log_uniform = [&](double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); };
  const auto whole = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };
  const auto nine_decades = [&](double middle) { return middle * std::pow(10.0, uniform(-4.5, 4.5)); };

  SectorCase c;
  prs::Mechanism& m = c.mechanism;
  m.starts = {whole(1, 6), 1};
  const double roller = log_uniform(1e-3, 1e-1);
  const double pitch = roller * log_uniform(2e-2, 1.0);
  m.lead = pitch * m.starts.screw;
  m.rollers = whole(1, 13);
  m.contacts_per_roller = whole(2, 60);
  const double screw = roller * uniform(1.5, 5.0);
  m.pitch_diameter = {screw, roller, screw + 2.0 * roller};
  const double before = whole(0, 3) ? uniform(0.0, 2.0) * roller : 0.0;
  const double length = (m.contacts_per_roller - 1) * pitch + before + uniform(0.0, 3.0) * roller + 1e-6;
  c.position = before;
  const double free[] = {0.0, 1e-15, log_uniform(1e-15, 1e-6), log_uniform(1e-6, 1.0)};
  c.structure.screw = {whole(0, 1) ? (1.0 - log_uniform(1e-6, 1.0)) * screw : 0.0, free[whole(0, 3)]};
  c.structure.roller = {log_uniform(1e-2, 10.0) * roller, log_uniform(2e-2, 2.0) * roller, {}};
  switch (whole(0, 3)) {
    case 0:
      c.structure.roller.guidance = {Guidance::Kind::outer_node, 0.0};
      break;
    case 1:
    case 2:
      c.structure.roller.guidance = {Guidance::Kind::ring, log_uniform(1e-3, 1e15)};
      break;
    default:
      break;
  }
  const double nut = *m.pitch_diameter.nut * (1.0 + log_uniform(1e-4, 1.0));
  c.structure.nut = {length,
                     nut,
                     {{0.0, 0.2 * length, 1.4 * nut}, {0.2 * length, 0.3 * length, 1.1 * nut}},
                     {.tension = uniform(0.0, 1.0) * length, .compression = length}};
  for (const prs::Part p : prs::kParts) c.materials[p] = {nine_decades(2e11), uniform(0.0, 0.45), {}};
  for (const prs::Interface i : prs::kInterfaces) c.laws[i] = {nine_decades(1e10), uniform(20.0, 70.0) * kDegree};
  if (whole(0, 4) == 0) c.laws.nut.normal_angle = c.laws.screw.normal_angle;
  c.options.roller = whole(0, 4) ? ModelOptions::Roller::flexible : ModelOptions::Roller::rigid_bending;
  c.options.roller_shear = whole(0, 3) == 0;
  c.direction = whole(0, 1) ? Direction::tension : Direction::compression;
  return c;
}

/// Axial force over fifteen decades [N].
inline double extreme_force(std::mt19937_64& random) {
  return std::pow(10.0, std::uniform_real_distribution<double>(-6.0, 9.0)(random));
}

}  // namespace test
