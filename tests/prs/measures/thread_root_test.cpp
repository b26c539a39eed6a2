#include "prs/measures/measures.h"

#include <gtest/gtest.h>

#include <numbers>

namespace prs {
namespace {

TEST(RootStress, IsThatOfACantilever) {
  const ToothSection tooth{1.4e-3, 0.8e-3, 0.3e-3, std::numbers::pi / 4.0, 1.6e-3};
  const RootStress s = root_stress(tooth, 500.0, 2e-3);
  EXPECT_NEAR(s.shear, 500.0 / (1.4e-3 * 2e-3), 1e-3);
  const double section_modulus = 2e-3 * 1.4e-3 * 1.4e-3 / 6.0;
  EXPECT_NEAR(s.bending * section_modulus, 500.0 * 0.3e-3, 1e-12);
}

}  // namespace
}  // namespace prs
