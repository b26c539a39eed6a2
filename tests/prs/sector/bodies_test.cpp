#include "prs/sector/sector_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/sectors.h"

namespace prs {
namespace {

using std::numbers::pi;

TEST(Bodies, NutIsASumOfRings) {
  const test::SectorCase c = test::abevi();
  // 70 mm of 46 mm and twice 10 mm of 62 mm, bored to 35 mm.
  const double volume = pi / 4.0 * (0.07 * (46e-3 * 46e-3 - 35e-3 * 35e-3) + 0.02 * (62e-3 * 62e-3 - 35e-3 * 35e-3));
  const double polar =
      pi / 32.0 * (0.07 * (std::pow(46e-3, 4) - std::pow(35e-3, 4)) + 0.02 * (std::pow(62e-3, 4) - std::pow(35e-3, 4)));
  const RoundBody nut = nut_body(c.mechanism, c.structure.nut);
  EXPECT_NEAR(nut.volume / volume, 1.0, 1e-13);
  EXPECT_NEAR(nut.polar_moment / polar, 1.0, 1e-13);
  EXPECT_NEAR(envelope_volume(c.structure.nut), pi / 4.0 * 62e-3 * 62e-3 * 90e-3, 1e-18);
}

TEST(Bodies, RollerIsAsLongAsThatOfTheSector) {
  // The beams of the sector: volume = sum of E A L over E.
  test::SectorCase c = test::abevi();
  const Sector sector = c.build();
  double volume = 0.0;
  for (const fe::BeamElement& b : sector.model.beams)
    volume += b.beam.axial_rigidity * b.beam.length / c.materials.roller.youngs_modulus;
  EXPECT_NEAR(roller_body(c.mechanism, c.structure.roller).volume / volume, 1.0, 1e-13);
}

TEST(Bodies, WeighWhatJungsCoefficientsSayOfSteel) {
  // (5.1), (5.2): 0.006165 d^2 and 0.02466 (D - T) T [kg/m, mm], T the wall, of 7850 kg/m^3.
  EXPECT_NEAR(tube(9e-3, 0.0, 1.0).volume * 7850.0, 0.006165 * 81.0, 1e-4 * 0.006165 * 81.0);
  const double nut = 0.02466 * (50.0 - 8.0) * 8.0;
  EXPECT_NEAR(tube(50e-3, 34e-3, 1.0).volume * 7850.0, nut, 1e-4 * nut);
}

TEST(Bodies, ThinRingHasItsMassAtItsRadius) {
  const RoundBody ring = tube(40e-3 + 1e-8, 40e-3 - 1e-8, 0.1);
  EXPECT_NEAR(ring.polar_moment / (ring.volume * 20e-3 * 20e-3), 1.0, 1e-6);
}

}  // namespace
}  // namespace prs
