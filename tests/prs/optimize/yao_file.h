#pragma once

#include <algorithm>
#include <string>

namespace test {

/// Yao et al. 2023, tables A1 and A2: the screw before its optimization, 300 N on each contact.
inline std::string yao_mechanism() {
  return R"(mechanism:  # tables A1 and A2
  type: standard
  profile_plane: axial
  lead: 25 mm
  starts: {screw: 5, roller: 1}
  flank_angle: {screw: 45 deg, roller: 45 deg, nut: 45 deg}  # these vary
  pitch_diameter: {screw: 48 mm, roller: 16 mm, nut: 80 mm}
  centre_distance: 32 mm
  profile: {screw: straight, roller: centred, nut: straight}
  thread:
    screw: {addendum: 0.715 mm, dedendum: 1.31 mm, thickness: 2 mm}
    roller: {addendum: 0.8 mm, dedendum: 1 mm, thickness: 2.4 mm}
    nut: {addendum: 0.715 mm, dedendum: 1.31 mm, thickness: 2 mm}
  rollers: 10
  contacts_per_roller: 1
materials: {youngs_modulus: 212 GPa, poisson_ratio: 0.29}
load_cases: [{axial_force: 3 kN, share: equal}]
)";
}

/// Lines of the mechanism's text.
inline long yao_lines() {
  const std::string text = yao_mechanism();
  return std::count(text.begin(), text.end(), '\n');
}

/// Section 4.1: the three flank angles between 40 and 50 deg.
inline std::string yao_optimize(const std::string& rest) {
  return R"(optimize:
  command: contact
  variables:
    - {path: mechanism.flank_angle.screw, from: 40 deg, to: 50 deg}
    - {path: mechanism.flank_angle.roller, from: 40 deg, to: 50 deg}
    - {path: mechanism.flank_angle.nut, from: 40 deg, to: 50 deg}
)" + rest +
         '\n';
}

}  // namespace test
