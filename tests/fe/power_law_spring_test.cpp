#include "fe/power_law_spring.h"

#include <gtest/gtest.h>

#include "support/finite_difference.h"

namespace fe {
namespace {

const PowerLawSpring kLaws[] = {
    {1.1e10, 1.5, 0.0, 0.0},  {4.0e9, 1.0, 0.0, 0.0},     {3.0e8, 2.2, 2e-6, 0.0},
    {1.1e10, 1.5, 0.0, 3e-9}, {1.1e10, 1.5, -1e-6, 8e-9}, {3.0e8, 1.1, 5e-6, 2e-8},
};

TEST(PowerLawSpring, ForceIsDerivativeOfEnergy) {
  for (const PowerLawSpring& law : kLaws)
    for (const double d : {1e-7, 3e-6, 4e-5}) {
      const double w = law.gap + d;
      const auto energy = [&](double x) { return evaluate(law, x).energy; };
      const double force = evaluate(law, w).force;
      EXPECT_NEAR(test::derivative(energy, w, 0.01 * d) / force, 1.0, 1e-7);
    }
}

TEST(PowerLawSpring, TangentIsDerivativeOfForce) {
  for (const PowerLawSpring& law : kLaws)
    for (const double d : {1e-7, 3e-6, 4e-5}) {
      const double w = law.gap + d;
      const auto force = [&](double x) { return evaluate(law, x).force; };
      const double tangent = evaluate(law, w).tangent;
      EXPECT_NEAR(test::derivative(force, w, 0.01 * d) / tangent, 1.0, 1e-7);
    }
}

TEST(PowerLawSpring, NeverPulls) {
  for (const PowerLawSpring& law : kLaws)
    for (const double w : {law.gap, law.gap - 1e-9, law.gap - 1.0}) {
      const SpringResponse r = evaluate(law, w);
      EXPECT_EQ(r.energy, 0.0);
      EXPECT_EQ(r.force, 0.0);
      EXPECT_EQ(r.tangent, 0.0);
    }
}

TEST(PowerLawSpring, ForceWithSeriesComplianceSatisfiesItsImplicitLaw) {
  for (const PowerLawSpring& law : kLaws)
    for (double approach = 1e-9; approach < 1e-3; approach *= 7.3) {
      const double w = law.gap + approach, total = w - law.gap;
      const double n = evaluate(law, w).force;
      const double expected =
          law.stiffness * std::pow(total - law.series_compliance * n, law.exponent);
      // The argument of the power is a difference: its rounding is amplified by total/d.
      const double d = std::pow(n / law.stiffness, 1.0 / law.exponent);
      EXPECT_NEAR(n / expected, 1.0, 1e-14 * law.exponent * (total / d + 4.0));
    }
}

TEST(PowerLawSpring, LinearSpringsInSeriesAddTheirCompliances) {
  const PowerLawSpring law{4e9, 1.0, 0.0, 1e-9};
  const SpringResponse r = evaluate(law, 1e-5);
  const double k = 1.0 / (1.0 / 4e9 + 1e-9);
  EXPECT_NEAR(r.force / (k * 1e-5), 1.0, 1e-14);
  EXPECT_NEAR(r.tangent / k, 1.0, 1e-14);
  EXPECT_NEAR(r.energy / (0.5 * k * 1e-10), 1.0, 1e-14);
}

}  // namespace
}  // namespace fe
