#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "prs/mechanism/full_distribution.h"
#include "prs/sector/sector.h"

namespace test {

inline double largest(const prs::RollerThreads& loads) {
  double value = 0.0;
  for (const auto& roller : loads) value = std::max(value, *std::ranges::max_element(roller));
  return value;
}

inline double largest_difference(const prs::RollerThreads& a, const prs::RollerThreads& b) {
  double value = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t k = 0; k < a[j].size(); ++k) value = std::max(value, std::abs(a[j][k] - b[j][k]));
  return value;
}

/// Vector turned by `angle` about x.
inline prs::Lateral turned(prs::Lateral l, double angle) {
  return {l.y * std::cos(angle) - l.z * std::sin(angle), l.y * std::sin(angle) + l.z * std::cos(angle)};
}

/// Checks that the sector equals one of all rollers, if these are equal.
inline void expect_the_sector(const prs::FullModel& f) {
  const prs::FullDistribution full = prs::solve(f);
  ASSERT_TRUE(full.solve.converged());
  prs::SectorModel sector = f.sector;
  sector.gaps = f.present[0].gaps;
  const prs::LoadDistribution one = prs::SectorSolver(prs::build_sector(sector)).solve(f.axial_force);
  EXPECT_NEAR(full.axial_displacement, one.axial_displacement, 1e-10 * one.axial_displacement);
  EXPECT_NEAR(*full.tangent_stiffness, *one.tangent_stiffness, 1e-10 * *one.tangent_stiffness);
  for (const prs::Interface i : prs::kInterfaces) {
    const auto rollers = static_cast<std::size_t>(f.rollers);
    EXPECT_LT(largest_difference(full.normal_load[i], prs::RollerThreads(rollers, one.normal_load[i])),
              1e-10 * largest(full.normal_load[i]));
  }
}

}  // namespace test
