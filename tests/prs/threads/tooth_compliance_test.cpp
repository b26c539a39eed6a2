#include "prs/threads/contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "prs/loads/analyze.h"
#include "support/sectors.h"

namespace prs {
namespace {

using std::numbers::pi;

const Material kSteel{209e9, 0.3, {}};

/// A tooth of straight flanks cut in slices from the crest's side of the load to the root, each
/// bent as a plate (plane strain) and sheared with 6/5, under a load along the axis at the pitch
/// line and the moment of the flank's radial component.
struct Slices {
  double bending = 0.0;
  double shear = 0.0;
};

Slices integrate(const ToothSection& t, const Material& m) {
  const double tangent = std::tan(t.flank_angle), e = m.youngs_modulus, nu = m.poisson_ratio;
  const int n = 200'000;
  Slices s;
  for (int i = 0; i < n; ++i) {
    const double y = t.height * (i + 0.5) / n, dy = t.height / n;  // from the load to the root
    const double width = t.pitch_width + 2.0 * y * tangent;
    // Radial force tan(beta) on the flank, half a width off the middle of the slice at the load.
    const double moment = y - 0.5 * t.pitch_width * tangent;
    s.bending += (1.0 - nu * nu) * 12.0 / (e * std::pow(width, 3)) * moment * y * dy;
    s.shear += 1.2 * 2.0 * (1.0 + nu) / (e * width) * dy;
  }
  return s;
}

TEST(Yamamoto, ShearIsThatOfATaperedPlate) {
  const ToothSection t{1.4e-3, 0.8e-3, 0.5e-3, 0.0, 1.6e-3};
  ToothSection tooth = t;
  tooth.flank_angle = std::atan((t.root_width - t.pitch_width) / (2.0 * t.height));
  const ToothDeflection d = yamamoto_deflection(tooth, kSteel, 20e-3);
  EXPECT_NEAR(d.shear / integrate(tooth, kSteel).shear, 1.0, 1e-9);
}

TEST(Yamamoto, BendingIsThatOfATaperedPlate) {
  ToothSection t{1.4e-3, 0.8e-3, 0.5e-3, 0.0, 1.6e-3};
  t.flank_angle = std::atan((t.root_width - t.pitch_width) / (2.0 * t.height));
  const ToothDeflection d = yamamoto_deflection(t, kSteel, 20e-3);
  EXPECT_NEAR(d.bending / integrate(t, kSteel).bending, 1.0, 1e-8);
}

TEST(Yamamoto, RadialTermIsLamesForSolidAndRing) {
  const double d = 20e-3, outer = 40e-3, pitch = 2e-3;
  const ToothSection t{1.4e-3, 1.0e-3, 0.4e-3, pi / 4.0, pitch};
  // 1 N/m along the thread at 45 deg is a pressure of 1/pitch on the cylinder; the thread moves axially by the radial
  // displacement.
  const double e = kSteel.youngs_modulus, nu = kSteel.poisson_ratio;
  EXPECT_NEAR(yamamoto_deflection(t, kSteel, d).radial, (1.0 - nu) * d / (2.0 * pitch * e), 1e-25);
  const double ring = (outer * outer + d * d) / (outer * outer - d * d) + nu;
  EXPECT_NEAR(yamamoto_deflection(t, kSteel, d, outer).radial, ring * d / (2.0 * pitch * e), 1e-25);
}

TEST(Yamamoto, ComplianceScalesWithWidthAndModulus) {
  const test::SectorCase c = test::abevi();
  Mechanism m = c.mechanism;
  m.flank_angle = {pi / 4.0, pi / 4.0, pi / 4.0};
  const PerInterface<double> psi{0.8, 0.75};
  const auto one = yamamoto_compliance(m, c.structure, c.materials, psi, 2e-3);
  const auto wide = yamamoto_compliance(m, c.structure, c.materials, psi, 4e-3);
  Materials stiff = c.materials;
  for (const Part p : kParts) stiff[p].youngs_modulus *= 3.0;
  const auto hard = yamamoto_compliance(m, c.structure, stiff, psi, 2e-3);
  for (const Interface i : kInterfaces) {
    EXPECT_GT(one[i], 0.0);
    EXPECT_NEAR(one[i] / wide[i], 2.0, 1e-12);
    EXPECT_NEAR(one[i] / hard[i], 3.0, 1e-12);
  }
}

}  // namespace
}  // namespace prs
