#include "prs/measures/stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/sectors.h"

namespace prs {
namespace {

using std::numbers::pi;

TEST(SectionStiffness, IsThatOfTheBarsOfTheSectorTogether) {
  const test::SectorCase c = test::abevi();
  const PerPart<double> section = section_stiffness(c.mechanism, c.structure, c.materials);
  const Sector sector = c.build();
  // The screw's second bar lies between threads 1 and 2; a beam between them is p long, not 2 p.
  const fe::Bar& screw = sector.model.bars[1].bar;
  EXPECT_NEAR(section.screw / (c.mechanism.rollers * screw.axial_rigidity / screw.length), 1.0, 1e-13);
  const fe::Beam& roller = sector.model.beams[2].beam;
  EXPECT_NEAR(section.roller / (0.5 * c.mechanism.rollers * roller.axial_rigidity / axial_pitch(c.mechanism)), 1.0,
              1e-13);
  const double nut_area = pi / 4.0 * (46e-3 * 46e-3 - 35e-3 * 35e-3);
  EXPECT_NEAR(section.nut / (209e9 * nut_area / (5e-3 / 3)), 1.0, 1e-13);
}

TEST(ThreadStiffness, IsHertzAlongTheAxisWithoutTeeth) {
  const double k_0 = 1.1e10, force = 4e3;
  const double approach = std::pow(force / 5.0 / k_0, 2.0 / 3.0);  // normal along the axis
  EXPECT_NEAR(thread_stiffness(force, 5, axial_hertz_coefficient(k_0, 0.0), 0.0), force / approach,
              1e-13 * force / approach);
  // At 60 deg the normal load is twice the axial one and the axis twice as far as the normal.
  EXPECT_NEAR(axial_hertz_coefficient(k_0, pi / 3.0) / axial_hertz_coefficient(k_0, 0.0), std::pow(2.0, 5.0 / 3.0),
              1e-14);
}

TEST(ThreadStiffness, AddsComplianceOfTeethInSeries) {
  const double h = 4e-8, c = 3e-9;
  const double hertz = thread_stiffness(5e3, 100, h, 0.0);
  EXPECT_NEAR(1.0 / thread_stiffness(5e3, 100, h, c), 1.0 / hertz + c / 100.0, 1e-25);
  // The Hertz stiffness grows with the cube root of the load.
  EXPECT_NEAR(thread_stiffness(40e3, 100, h, 0.0) / hertz, 2.0, 1e-13);
}

TEST(ToothStiffness, IsProportionalToItsWidthAndStiffness) {
  test::SectorCase c = test::abevi();
  c.mechanism.flank_angle = {pi / 4.0, pi / 4.0, pi / 4.0};
  const auto stiffness = [&](Part p, double width) {
    return tooth_stiffness(c.mechanism, c.structure, c.materials, p, width);
  };
  const double screw = stiffness(Part::screw, 2e-3), nut = stiffness(Part::nut, 2e-3);
  EXPECT_NEAR(stiffness(Part::screw, 4e-3) / screw, 2.0, 1e-13);
  // The teeth are the same, but a nut expands.
  EXPECT_LT(nut, screw);
  c.materials.screw.youngs_modulus *= 3.0;
  EXPECT_NEAR(stiffness(Part::screw, 2e-3) / screw, 3.0, 1e-13);
}

}  // namespace
}  // namespace prs
