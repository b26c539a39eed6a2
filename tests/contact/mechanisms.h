#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "contact/mechanism_geometry.h"
#include "tests/contact/units.h"

// Mechanisms that several tests of the contact room share.
namespace contact::test {

/// A thread as the papers tabulate it: mm, degrees, 1/mm; the curvature is that of the material.
inline Thread thread(double radius_mm, double lead_mm, double pitch_mm, double profile_curvature_per_mm = 0.0,
                     double flank_deg = 45.0) {
  Thread t;
  t.pitch_radius = radius_mm * mm;
  t.lead = lead_mm * mm;
  t.pitch = pitch_mm * mm;
  t.flank_angle = flank_deg * deg;
  t.profile_curvature = profile_curvature_per_mm * per_mm;
  return t;
}

inline Thread nut_thread(double radius_mm, double lead_mm, double pitch_mm, double profile_curvature_per_mm = 0.0,
                         double flank_deg = 45.0) {
  Thread t = thread(radius_mm, lead_mm, pitch_mm, profile_curvature_per_mm, flank_deg);
  t.internal = true;
  return t;
}

inline Thread axial(Thread t) {
  t.plane = ProfilePlane::axial;
  return t;
}

/// Sandu 2018, table 1.6, example 1.
inline MechanismGeometry sandu_example_1() {
  return {MechanismType::standard, thread(15, 10, 2), thread(5, 2, 2, std::sin(45 * deg) / 5), nut_thread(25, 10, 2),
          20 * mm};
}

/// Sandu 2018, table 1.6, example 3.
inline MechanismGeometry sandu_example_3() {
  return {MechanismType::standard, thread(9.75, 10, 2, 0, 68.21), thread(3.25, 2, 2, 0.2857, 68.21),
          nut_thread(16.25, 10, 2, 0, 68.21), 13 * mm};
}

/// The inverted screw of Abevi 2015 with the profile radius 3.5 mm/sin 45 deg.
inline MechanismGeometry abevi() {
  const double p = 5.0 / 3.0;
  return {MechanismType::inverted, thread(10.5, 5, p), thread(3.5, -p, p, 1 / 4.949747468), nut_thread(17.5, 5, p),
          14 * mm};
}

/// Yao 2023, tables A1 and 1 (flank angles of screw, roller, nut in degrees; 45 each there).
inline MechanismGeometry yao(double screw_deg = 45, double roller_deg = 45, double nut_deg = 45) {
  return {MechanismType::standard, axial(thread(24, 25, 5, 0, screw_deg)),
          axial(thread(8, 5, 5, std::sin(roller_deg * deg) / 8, roller_deg)), axial(nut_thread(40, 25, 5, 0, nut_deg)),
          32 * mm};
}

/// Random mechanisms around matched pitch radii: both types, hands and profile planes, straight,
/// convex and concave flanks of screw and nut, convex rollers from half to three times the usual
/// radius, each part with its own flank angle (+-2 deg), pitch radii and centre distance off by up
/// to 0.2 %. Not all of them have contact points on their flanks.
class RandomMechanisms {
 public:
  enum class Rollers { convex, straight_or_concave };

  /// With straight or concave rollers, screw and nut are convex and curve more.
  explicit RandomMechanisms(std::uint64_t seed, Rollers rollers = Rollers::convex) : random_(seed), rollers_(rollers) {}

  MechanismGeometry next() {
    const bool standard = integer(0, 1) == 1;
    const double hand = integer(0, 1) == 1 ? 1.0 : -1.0;
    const ProfilePlane plane = integer(0, 1) == 1 ? ProfilePlane::normal : ProfilePlane::axial;
    const int roller_starts = integer(1, 2);
    const int starts = standard ? integer(2 * roller_starts + 1, 2 * roller_starts + 5) : integer(1, 6);
    MechanismGeometry m;
    m.type = standard ? MechanismType::standard : MechanismType::inverted;
    const PitchRadii radii = matched_pitch_radii(m.type, uniform(4 * mm, 40 * mm), starts, roller_starts);
    const double pitch = std::min(6 * mm, uniform(0.06, 0.54) * std::min(radii.screw, radii.roller));
    const double flank = uniform(30 * deg, 60 * deg);

    const auto make = [&](double radius, int turns) {
      Thread t;
      t.pitch_radius = radius * (1.0 + uniform(-0.002, 0.002));
      t.lead = hand * turns * pitch;
      t.pitch = pitch;
      t.flank_angle = flank + uniform(-2 * deg, 2 * deg);
      t.plane = plane;
      return t;
    };
    m.screw = make(radii.screw, starts);
    m.roller = make(radii.roller, standard ? roller_starts : -roller_starts);
    m.nut = make(radii.nut, starts);
    m.nut.internal = true;
    const double usual = std::sin(flank) / radii.roller;
    m.roller.profile_curvature = usual * std::exp(uniform(-1.0, 0.7));
    for (Thread* body : {&m.screw, &m.nut}) {
      const int shape = integer(0, 3);
      if (shape == 2) body->profile_curvature = usual * std::exp(uniform(-1.0, 0.7));
      if (shape == 3) body->profile_curvature = -usual / uniform(2.0, 10.0);
    }
    m.centre_distance = (radii.screw + radii.roller) * (1.0 + uniform(-0.002, 0.002));
    if (rollers_ == Rollers::straight_or_concave) {
      m.roller.profile_curvature = integer(0, 1) == 1 ? 0.0 : -usual / uniform(2.0, 10.0);
      for (Thread* body : {&m.screw, &m.nut}) body->profile_curvature = usual * std::exp(uniform(-0.2, 0.7));
    }
    return m;
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  int integer(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

 private:
  std::mt19937_64 random_;
  Rollers rollers_;
};

}  // namespace contact::test
