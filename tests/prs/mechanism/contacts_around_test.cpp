#include "prs/mechanism/contacts_around.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kAround = 5, kContacts = 6;
constexpr double kAxialForce = 3000.0, kSideForce = 60.0;

double azimuth(Index roller) {
  return 2.0 * std::numbers::pi * static_cast<double>(roller) / static_cast<double>(kAround);
}

/// Three threads at each interface; the screw moves axially and laterally, the nut is fixed.
struct SmallScrew {
  VectorXd along = VectorXd::Zero(kContacts), across = along, roller = VectorXd::Constant(kContacts, 0.7);
  ContactsAround contacts;
  ContactsAroundOptions options{.force = kAxialForce, .length = 1e-6, .stiffness = 2e8};

  SmallScrew() {
    along.head(3).setConstant(0.7);
    across.head(3) << 0.5, 0.6, 0.7;
    roller.head(3) *= -1.0;
    std::srand(1);
    const auto any = [] {
      const MatrixXd a = MatrixXd::Random(kContacts, kContacts);
      return MatrixXd(1e-9 * a * a.transpose());
    };
    const double half = std::sqrt(0.5 * static_cast<double>(kAround));
    MatrixXd axial(kContacts, 2), bent(kContacts, 2);
    axial << std::sqrt(static_cast<double>(kAround)) * along, roller;
    bent << half * across, roller;
    contacts.modes = {{any(), axial, MatrixXd::Zero(2, 2), 0},
                      {any(), bent, MatrixXd::Zero(2, 2), 0},
                      {any(), roller, MatrixXd::Zero(1, 1), 0}};
    for (std::size_t w = 0; w < 5; ++w) {
      const std::size_t mode = (w + 1) / 2;
      ContactsAround::Wave wave{mode, VectorXd(kAround), VectorXd::Zero(contacts.modes[mode].rigid.cols())};
      for (Index j = 0; j < kAround; ++j) {
        const double angle = static_cast<double>(mode) * azimuth(j);
        wave.shape[j] = w == 0 || w % 2 == 1 ? std::cos(angle) : std::sin(angle);
      }
      wave.shape.normalize();
      contacts.waves.push_back(wave);
    }
    contacts.waves[0].load[0] = kAxialForce;
    contacts.waves[1].load[0] = kSideForce;
    contacts.hertz_constant = VectorXd::Constant(kContacts, 1e10);
    contacts.gap = 1e-6 * MatrixXd::Random(kContacts, kAround).cwiseAbs();
    contacts.present.assign(kAround, true);
  }

  /// G between two rollers.
  MatrixXd between(Index a, Index b) const {
    MatrixXd g = contacts.modes[0].flexibility;
    for (std::size_t m = 1; m < 3; ++m)
      g += 2.0 * std::cos(static_cast<double>(m) * (azimuth(a) - azimuth(b))) * contacts.modes[m].flexibility;
    return g / static_cast<double>(kAround);
  }

  /// Checks the equations roller by roller, in an independent form.
  void expect_equilibrium(const ContactsAroundSolution& s) const {
    ASSERT_TRUE(s.converged());
    double axial = 0.0, side = 0.0, other_side = 0.0;
    for (Index j = 0; j < kAround; ++j) {
      const VectorXd n = s.normal_load.col(j);
      axial += along.dot(n);
      side += std::cos(azimuth(j)) * across.dot(n);
      other_side += std::sin(azimuth(j)) * across.dot(n);
      EXPECT_NEAR(roller.dot(n), 0.0, 1e-8);
      if (!contacts.present[static_cast<std::size_t>(j)]) {
        EXPECT_EQ(n.norm(), 0.0);
        continue;
      }
      double own = 0.0;  // Motion of the roller along its axis.
      for (std::size_t w = 0; w < 5; ++w) own += contacts.waves[w].shape[j] * s.motion[w][s.motion[w].size() - 1];
      VectorXd w = along * s.motion[0][0] + roller * own +
                   across * (s.motion[1][0] * std::cos(azimuth(j)) + s.motion[2][0] * std::sin(azimuth(j)));
      for (Index l = 0; l < kAround; ++l) w -= between(j, l) * s.normal_load.col(l);
      for (Index k = 0; k < kContacts; ++k) {
        const double y = w[k] - contacts.gap(k, j);
        EXPECT_NEAR(n[k], 1e10 * std::pow(std::max(y, 0.0), 1.5), 1e-8 * kAxialForce);
      }
    }
    EXPECT_NEAR(axial, kAxialForce, 1e-8);
    EXPECT_NEAR(side, kSideForce, 1e-8);
    EXPECT_NEAR(other_side, 0.0, 1e-8);
  }
};

TEST(ContactsAround, LoadsFulfilTheEquationsOfEachRoller) {
  SmallScrew screw;
  screw.expect_equilibrium(solve(screw.contacts, screw.options));
  screw.contacts.gap *= 3.0;
  screw.expect_equilibrium(solve(screw.contacts, screw.options));
  screw.contacts.present[2] = false;
  screw.expect_equilibrium(solve(screw.contacts, screw.options));
}

TEST(ContactsAround, DenseEquationsAndAnyStartGiveTheSame) {
  SmallScrew screw;
  screw.contacts.present[1] = false;
  const ContactsAroundSolution s = solve(screw.contacts, screw.options);
  ContactsAroundOptions dense = screw.options;
  dense.most_directions = 0;
  const ContactsAroundSolution d = solve(screw.contacts, dense);
  ASSERT_TRUE(s.converged() && d.converged());
  EXPECT_LT((s.normal_load - d.normal_load).norm(), 1e-10 * kAxialForce);
  SmallScrew other = screw;
  other.contacts.gap *= 0.5;
  const ContactsAroundSolution from = solve(other.contacts, other.options);
  const ContactsAroundSolution again = solve(screw.contacts, screw.options, &from);
  ASSERT_TRUE(again.converged());
  EXPECT_LT((s.normal_load - again.normal_load).norm(), 1e-10 * kAxialForce);
}

TEST(ContactsAround, ComplianceIsTheSlopeOfTheMotions) {
  SmallScrew screw;
  screw.contacts.present[3] = false;
  const std::vector<WaveMotion> motions{{0, 0}, {1, 0}, {2, 0}};
  const MatrixXd c = compliance(screw.contacts, solve(screw.contacts, screw.options), screw.options, motions);
  EXPECT_LT((c - c.transpose()).norm(), 1e-10 * c.norm());
  for (std::size_t j = 0; j < 3; ++j) {
    const auto at = [&](double change) {
      SmallScrew changed = screw;
      changed.contacts.waves[motions[j].wave].load[0] += change;
      return solve(changed.contacts, screw.options).motion;
    };
    const double step = 0.1;
    const auto more = at(step), less = at(-step);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR((more[i][0] - less[i][0]) / (2.0 * step), c(static_cast<Index>(i), static_cast<Index>(j)),
                  1e-6 * c.norm());
  }
}

}  // namespace
}  // namespace prs
