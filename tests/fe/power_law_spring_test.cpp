#include "fe/power_law_spring.h"

#include <gtest/gtest.h>

#include "support/finite_difference.h"

namespace fe {
namespace {

const PowerLawSpring kLaws[] = {
    {1.1e10, 0.0, 0.0},    {3.0e8, 2e-6, 0.0},   {1.1e10, 0.0, 3e-9},
    {1.1e10, -1e-6, 8e-9}, {1.1e10, 0.0, -2e-9}, {3.0e9, 2e-6, -5e-9},
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
      if (approach > 0.6 * largest_deflection(law)) continue;
      const double w = law.gap + approach, total = w - law.gap;
      const double n = evaluate(law, w).force;
      const double expected = law.stiffness * std::pow(total - law.series_compliance * n, 1.5);
      // The argument of the power is a difference: its rounding is amplified by total/d.
      const double d = std::pow(n / law.stiffness, 2.0 / 3.0);
      EXPECT_NEAR(n / expected, 1.0, 1.5e-14 * (total / d + 4.0));
    }
}

TEST(PowerLawSpring, TakesBackAtMostHalfOfTheDeflection) {
  for (const PowerLawSpring& law : {PowerLawSpring{1.1e10, 0.0, -2e-9}, PowerLawSpring{3.0e9, 2e-6, -5e-9}}) {
    const double d = largest_deflection(law);
    const SpringResponse at = response_in_series(law, d);
    EXPECT_NEAR(at.tangent / power_law(law.stiffness, d).tangent, 2.0, 1e-12);
    // Both branches meet there, and beyond it the tangent stays.
    const double w = law.gap + d + law.series_compliance * at.force;
    for (const double sign : {-1.0, 1.0}) {
      const SpringResponse near = evaluate(law, w + sign * 1e-9 * d);
      EXPECT_NEAR(near.force / at.force, 1.0, 1e-8);
      EXPECT_NEAR(near.tangent / at.tangent, 1.0, 1e-8);
      EXPECT_NEAR(near.energy / at.energy, 1.0, 1e-8);
    }
    EXPECT_EQ(evaluate(law, w + 3.0).tangent, at.tangent);
  }
}

TEST(PowerLawSpring, IsConvexHoweverFarItIsPushed) {
  for (const PowerLawSpring& law : kLaws) {
    double last_force = 0.0, last_tangent = 0.0;
    for (double approach = 1e-12; approach < 1e9; approach *= 1.7) {
      const SpringResponse r = evaluate(law, law.gap + approach);
      ASSERT_TRUE(std::isfinite(r.energy) && std::isfinite(r.force) && std::isfinite(r.tangent));
      ASSERT_GT(r.force, last_force);
      ASSERT_GE(r.tangent, last_tangent * (1.0 - 1e-12));
      last_force = r.force;
      last_tangent = r.tangent;
    }
  }
}

TEST(PowerLawSpring, DeflectionIsThatOfThePowerLawAlone) {
  for (const PowerLawSpring& law : kLaws) {
    EXPECT_EQ(law_approach(law, law.gap), 0.0);
    for (const double approach : {1e-7, 3e-6}) {
      const double w = law.gap + approach, d = law_approach(law, w);
      const double n = evaluate(law, w).force;
      EXPECT_NEAR(power_law(law.stiffness, d).force / n, 1.0, 1e-12);
      EXPECT_NEAR((d + law.series_compliance * n) / (w - law.gap), 1.0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace fe
