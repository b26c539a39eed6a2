#include "contact/contact_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/hertz.h"
#include "contact/mechanism_geometry.h"
#include "support/allocations.h"
#include "support/count.h"
#include "tests/contact/mechanisms.h"
#include "tests/contact/units.h"

namespace contact {
namespace {

constexpr double kBothModuli = 115e9;

std::vector<simd::InstructionSet> sets_here() {
  using enum simd::InstructionSet;
  std::vector<simd::InstructionSet> sets;
  for (const simd::InstructionSet set : {scalar, baseline, avx2, avx512})
    if (simd::available(set)) sets.push_back(set);
  return sets;
}

MechanismNumbers<double> with_moduli(const MechanismGeometry& m) {
  MechanismNumbers<double> numbers = numbers_of(m);
  numbers.modulus_at_screw = kBothModuli;
  numbers.modulus_at_nut = 0.7 * kBothModuli;
  return numbers;
}

/// Random mechanisms, every fourth with stated heights and thicknesses, every ninth with an impossible thread.
std::vector<MechanismGeometry> random_mechanisms(int count) {
  test::RandomMechanisms usual(5), others(6, test::RandomMechanisms::Rollers::straight_or_concave);
  std::vector<MechanismGeometry> mechanisms;
  for (int k = 0; k < count; ++k) {
    MechanismGeometry m = k % 3 == 2 ? others.next() : usual.next();
    for (Thread* thread : {&m.screw, &m.roller, &m.nut}) {
      if (k % 4 != 1) break;
      thread->addendum = usual.uniform(0.05, 0.3) * thread->pitch;
      thread->dedendum = usual.uniform(0.05, 0.4) * thread->pitch;
      thread->thickness = usual.uniform(0.4, 0.6) * thread->pitch;
    }
    if (k % 9 == 8) m.nut.flank_angle = k % 2 == 0 ? -0.1 : 1.6;
    mechanisms.push_back(m);
  }
  return mechanisms;
}

/// Largest difference of corresponding numbers, over the scale of their kind.
struct Worst {
  double geometry = 0.0;   ///< Places over radii, angles in rad, directions.
  double curvature = 0.0;  ///< Difference over the larger curvature.
  double hertz = 0.0;      ///< Relative differences, times the degree of conformity of the surfaces.

  void add(double& worst, double difference) { worst = std::max(worst, std::abs(difference)); }

  void add(const InterfaceGeometry& n, const InterfaceGeometry& g, double radius) {
    add(geometry, (n.point.position.x - g.point.position.x) / radius);
    add(geometry, (n.point.position.y - g.point.position.y) / radius);
    add(geometry, n.point.angle_on_body - g.point.angle_on_body);
    add(geometry, n.point.angle_on_roller - g.point.angle_on_roller);
    add(geometry, (n.point.backlash - g.point.backlash) / radius);
    add(geometry, n.point.normal.x - g.point.normal.x);
    add(geometry, n.point.normal.z - g.point.normal.z);
    add(geometry, n.helix_tangent.y - g.helix_tangent.y);
    for (const auto& [lanes, scalar] :
         {std::pair(n.body, g.body), std::pair(n.roller, g.roller), std::pair(n.relative, g.relative)}) {
      const double scale = std::max(std::abs(g.roller.second), std::abs(g.relative.second));
      add(curvature, (lanes.first - scalar.first) / scale);
      add(curvature, (lanes.second - scalar.second) / scale);
    }
  }
  void add(const HertzConstants& n, const HertzConstants& h, double openness) {
    if (!h.ok()) return;
    add(hertz, openness * (n.ellipticity / h.ellipticity - 1.0));
    add(hertz, openness * (n.hertz_constant / h.hertz_constant - 1.0));
    add(hertz, openness * (n.semi_major_per_cbrt_load / h.semi_major_per_cbrt_load - 1.0));
  }
};

/// Each interface is compared with `interface_geometry` and `hertz_constants`, which are tested against the papers and
/// other solvers.
TEST(ContactNumbers, EveryInstructionSetFindsTheContactsOfOneMechanism) {
  const std::vector<MechanismGeometry> mechanisms = random_mechanisms(::test::count(2000, 100'000) + 3);
  std::vector<MechanismNumbers<double>> numbers;
  for (const MechanismGeometry& m : mechanisms) numbers.push_back(with_moduli(m));
  std::vector<MechanismContactNumbers<double>> found(numbers.size());
  for (const simd::InstructionSet set : sets_here()) {
    find_contacts(numbers, found, set);
    Worst worst;
    std::size_t sound = 0, contacts = 0;
    for (std::size_t k = 0; k < mechanisms.size(); ++k) {
      const MechanismGeometry& m = mechanisms[k];
      const Thread all[] = {m.screw, m.roller, m.nut};
      const bool threads = std::ranges::all_of(all, [](const Thread& t) {
        const RadiusLimits limits = flank_limits(t);
        const ThreadStatus status = check(t);
        return (status == ThreadStatus::ok || status == ThreadStatus::beyond_sharp_limit) &&
               limits.smallest < limits.largest;
      });
      ASSERT_EQ(found[k].sound != 0.0, threads) << k;
      if (!threads) continue;
      ++sound;
      const MechanismContact scalar = mechanism_contact(m, Configuration::i1_j2);
      const auto compare = [&](const InterfaceGeometry& n, const InterfaceGeometry& g, const HertzConstants& h,
                               double modulus) {
        // Reasons for failure may differ: a descent that finds no minimum ends anywhere.
        ASSERT_EQ(n.ok(), g.ok()) << k;
        if (!g.ok()) return;
        ++contacts;
        worst.add(n, g, m.centre_distance);
        const HertzConstants constants = hertz_constants(g.relative.first, g.relative.second, modulus);
        ASSERT_EQ(h.status, constants.status) << k;
        worst.add(h, constants, std::min(1.0, g.openness()));
      };
      compare(found[k].screw.geometry, scalar.screw, found[k].screw.hertz, kBothModuli);
      compare(found[k].nut.geometry, scalar.nut, found[k].nut.hertz, 0.7 * kBothModuli);
    }
    EXPECT_GT(sound, mechanisms.size() / 2);
    EXPECT_GT(contacts, sound / 2);
    EXPECT_LT(worst.geometry, 1e-13) << simd::name(set);
    EXPECT_LT(worst.curvature, 1e-13) << simd::name(set);
    EXPECT_LT(worst.hertz, 1e-13) << simd::name(set);
  }
}

TEST(ContactNumbers, NeighboursDoNotMatter) {
  const std::vector<MechanismGeometry> mechanisms = random_mechanisms(64);
  std::vector<MechanismNumbers<double>> numbers;
  for (const MechanismGeometry& m : mechanisms) numbers.push_back(with_moduli(m));
  for (const simd::InstructionSet set : sets_here()) {
    std::vector<MechanismContactNumbers<double>> together(numbers.size()), alone(1);
    const std::size_t before = ::test::allocations();
    find_contacts(numbers, together, set);
    EXPECT_EQ(::test::allocations(), before);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      find_contacts({&numbers[k], 1}, alone, set);
      const auto bits = [](const MechanismContactNumbers<double>& c) {
        return std::vector<double>{c.screw.geometry.point.position.x, c.screw.geometry.relative.first,
                                   c.nut.geometry.point.backlash, c.screw.hertz.hertz_constant,
                                   c.nut.hertz.ellipticity};
      };
      const std::vector<double> a = bits(together[k]), b = bits(alone[0]);
      for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) << simd::name(set) << " " << k << " " << i;
    }
  }
}

TEST(ContactNumbers, EllipsesAreThoseOfOneLoad) {
  const HertzConstants constants = hertz_constants(50.0, 400.0, kBothModuli);
  std::vector<double> loads = {0.0, -1.0, 1e-9, 1.0, 123.456, 4e3, 1e7, 0.0, 17.0, 3.0, 8e5};
  for (const simd::InstructionSet set : sets_here()) {
    std::vector<double> major, minor, pressure;
    set_ellipses(constants, loads, major, minor, pressure, set);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const HertzContact one = at_load(constants, loads[k]);
      EXPECT_NEAR(major[k], one.semi_major, 1e-13 * one.semi_major) << simd::name(set);
      EXPECT_NEAR(minor[k], one.semi_minor, 1e-13 * one.semi_minor) << simd::name(set);
      EXPECT_NEAR(pressure[k], one.peak_pressure, 1e-13 * one.peak_pressure) << simd::name(set);
    }
  }
}

}  // namespace
}  // namespace contact
