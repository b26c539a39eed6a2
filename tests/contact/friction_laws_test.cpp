#include "contact/friction_laws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace contact {
namespace {

/// Film over roughness 1.5, tau_0/p_0 0.01, K 0.02 s/m.
const RollingContactOf<double> kRolling{2e9, 330.0, 1.5, 0.01, 0.02};
const FrictionPointOf<double> kPoint{0.3, 0.8, 1e4};

TEST(FrictionLaws, CoulombFollowsThePressure) { EXPECT_DOUBLE_EQ(Coulomb{0.1}.in(kRolling)(kPoint), 0.1 * 0.8); }

TEST(FrictionLaws, JacodIsAnEyringFluid) {
  EXPECT_DOUBLE_EQ(Jacod<double>{}.in(kRolling)(kPoint), 0.01 * std::asinh(1e4 * 0.02 * 0.3));
}

TEST(FrictionLaws, MixedSharesTheLoadByTheFilm) {
  const double share = 1.0 / (2.5 * 2.5 * 2.5);
  EXPECT_DOUBLE_EQ((Mixed{0.12, 3.0}.in(kRolling)(kPoint)),
                   share * 0.12 * 0.8 + (1.0 - share) * 0.01 * std::asinh(1e4 * 0.02 * 0.3));
}

TEST(FrictionLaws, AtRestThereIsNoFilm) {
  EXPECT_EQ(friction_at_rest(friction_law(Coulomb{0.1})), 0.1);
  EXPECT_EQ(friction_at_rest(friction_law(Mixed{0.12, 2.0})), 0.12);
  EXPECT_EQ(friction_at_rest(friction_law(Jacod<double>{})), 0.0);
  EXPECT_FALSE(facts_of(kind_of<Jacod>).holds_at_rest());
  EXPECT_TRUE(facts_of(kind_of<Mixed>).holds_at_rest());
}

}  // namespace
}  // namespace contact
