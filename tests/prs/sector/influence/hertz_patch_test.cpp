#include "prs/sector/influence/grooved_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/hertz.h"
#include "support/half_space_spectrum.h"

namespace prs {
namespace {

using std::numbers::pi;

Material steel() {
  Material m;
  m.youngs_modulus = 209e9;
  m.poisson_ratio = 0.3;
  return m;
}

const Material kSteel = steel();
const HertzPatch kPatches[] = {{0.2e-3, 0.2e-3}, {0.25e-3, 0.15e-3}, {0.1e-3, 0.3e-3}};

TEST(HertzPatch, SeriesGivesThePressureBack) {
  const HertzPatch patch{0.3e-3, 0.4e-3};
  const double r = 3.5e-3, s = 0.1e-3, theta = 0.05;
  double sum = 0.0;
  for (int n = 0; n < 4000; ++n) sum += pressure_amplitude(patch, n, s, r) * std::cos(n * theta);
  const double peak = 1.5 / (pi * patch.along_profile * patch.along_circumference);
  const double exact =
      peak * std::sqrt(1.0 - std::pow(s / patch.along_profile, 2) - std::pow(r * theta / patch.along_circumference, 2));
  EXPECT_NEAR(sum, exact, 1e-3 * peak);
}

TEST(HertzPatch, MeanHarmonicCarriesTheUnitForce) {
  const HertzPatch patch{0.3e-3, 0.4e-3};
  const double r = 3.5e-3;
  double force = 0.0;
  const int cells = 10000;
  for (int i = 0; i < cells; ++i) {
    const double s = patch.along_profile * (2.0 * (i + 0.5) / cells - 1.0);
    force += 2.0 * pi * r * pressure_amplitude(patch, 0, s, r) * 2.0 * patch.along_profile / cells;
  }
  EXPECT_NEAR(force, 1.0, 1e-8);
}

TEST(HertzPatch, HalfSpaceCarriesFourFifthsOfItsShareOfTheApproach) {
  const double modulus = contact::contact_modulus({209e9, 0.3}, {209e9, 0.3});
  const contact::HertzConstants h = contact::hertz_constants(150.0, 260.0, modulus);
  const contact::HertzContact at = contact::at_load(h, 300.0);
  const double compliance = half_space_compliance({at.semi_major, at.semi_minor}, kSteel);
  EXPECT_NEAR(compliance * 300.0 / (0.4 * at.approach), 1.0, 1e-12);
  const double other =
      at.approach / 2.0 - 150.0 * at.semi_major * at.semi_major / 20.0 - 260.0 * at.semi_minor * at.semi_minor / 20.0;
  EXPECT_NEAR(compliance * 300.0 / other, 1.0, 1e-12);
}

TEST(HertzPatch, SpectrumAddsUpToTheCompliance) {
  for (const HertzPatch& patch : kPatches) {
    const double all = half_space_compliance(patch, kSteel);
    EXPECT_NEAR(half_space_remainder(patch, kSteel, 0.0) / all, 1.0, 1e-5);
    const double from = 4000.0, to = 12000.0;
    double sum = 0.0;
    const int cells = 400;
    for (int i = 0; i < cells; ++i)
      sum +=
          2.0 * test::half_space_spectrum(patch, kSteel, from + (to - from) * (i + 0.5) / cells) * (to - from) / cells;
    const double difference = half_space_remainder(patch, kSteel, from) - half_space_remainder(patch, kSteel, to);
    EXPECT_NEAR(sum, difference, 1e-4 * all);
  }
}

}  // namespace
}  // namespace prs
