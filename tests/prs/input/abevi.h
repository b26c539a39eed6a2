#pragma once

#include <string>

namespace prs::input {

/// Threads of Abevi 2015's screw, for a case whose mechanism continues with the rollers.
inline const std::string kAbeviThreads = R"(mechanism:
  type: inverted
  lead: 5 mm
  starts: {screw: 3, roller: 1}
  flank_angle: 45 deg
  pitch_diameter: {screw: 21 mm, roller: 7 mm, nut: 35 mm}
  centre_distance: 14 mm
  profile: {screw: straight, roller: {convex: 4.949747468 mm}, nut: straight}
)";

/// A short version, with a plain nut, for a case that continues with its own blocks.
inline const std::string kShortAbevi = kAbeviThreads + R"(  rollers: 11
  contacts_per_roller: 4
structure:
  screw: {bore: 6 mm, free_length: 10 mm}
  roller: {end_length: 5 mm, end_diameter: 5 mm}
  nut: {length: 40 mm, outer_diameter: 46 mm, thrust: {tension: 0 mm, compression: 40 mm}}
materials: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}
)";

/// The screw of Abevi 2015 in CONFIG 1 as a person would write it.
inline const std::string kAbevi = kAbeviThreads + R"(  rollers: 11
  contacts_per_roller: 20
structure:
  screw: {bore: 6 mm, free_length: 10 mm}
  roller: {end_length: 5 mm, end_diameter: 5 mm}
  nut:
    length: 90 mm
    outer_diameter: 46 mm
    flanges:
      - {from: 0 mm, to: 10 mm, outer_diameter: 62 mm}
      - {from: 80 mm, to: 90 mm, outer_diameter: 62 mm}
    thrust: {tension: 10 mm, compression: 80 mm}
materials:
  youngs_modulus: 209 GPa
  poisson_ratio: 0.3
load_cases:
  - {name: pull, axial_force: 45 kN, direction: tension, position: 54.3333333 mm}
  - {name: push, axial_force: {from: 1 kN, to: 45 kN, steps: 45}, direction: compression, position: 4 mm}
)";

/// The text with one part of it replaced.
inline std::string abevi_with(const std::string& part, const std::string& replacement) {
  std::string text = kAbevi;
  return text.replace(text.find(part), part.size(), replacement);
}

}  // namespace prs::input
