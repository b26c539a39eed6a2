#include "fe/chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fe/chain_hertz.h"
#include "fe/chain_station.h"
#include "fe/newton.h"
#include "fe/power_law_spring.h"

namespace fe {
namespace {

/// Two elastic rails, the second one grounded, with two equal contacts from one to the other at
/// every station: the load enters the first rail at station 0.
template <class Real>
struct Rails {
  static constexpr int kFreedoms = 2;
  static constexpr bool couples(int i, int j) { return i == j; }
  template <int C>
  static constexpr std::array<ChainTerm, 2> form() {
    return {{{0, 0, false}, {1, 0, true}}};
  }

  Real one = Real(1.0);
  Real rail[2];    ///< Stiffness between stations [N/m].
  Real ground[2];  ///< Stiffness to the second rail, at the first station and at all others [N/m].

  const Real& coefficient(int, int) const { return one; }
  const Real& support(int k) const { return ground[k == 0 ? 0 : 1]; }

  template <int I>
  bool held(int k, Index<I>) const {
    return I == 1 && support(k) > 1e300;
  }
  template <class Add>
  void add_station(int k, Add add) const {
    add(Index<1>{}, Index<1>{}, support(k));
  }
  template <class Add>
  void add_interval_start(int, Add add) const {
    add(Index<0>{}, Index<0>{}, rail[0]);
    add(Index<1>{}, Index<1>{}, rail[1]);
    add(Index<0>{}, Index<2>{}, -rail[0]);
    add(Index<1>{}, Index<3>{}, -rail[1]);
  }
  template <class Add>
  void add_interval_end(int, Add add) const {
    add(Index<0>{}, Index<0>{}, rail[0]);
    add(Index<1>{}, Index<1>{}, rail[1]);
  }
  using State = ChainState<Real, 2>;
  void add_forces(int k, const State& here, Real* force) const {
    force[1] += select(support(k) < 1e300, support(k) * here.head[1], Real(0.0));
  }
  void add_forces(int, const State& here, const State& next, Real* force, Real* next_force) const {
    for (int i = 0; i < 2; ++i) {
      const Real tension = rail[i] * next.difference(i, here);
      force[i] -= tension;
      next_force[i] += tension;
    }
  }
};

using RailChain = Chain<double, Rails<double>, ChainHertz<double>>;

struct SolvedRails {
  ChainSummary<double> summary;
  std::vector<RailChain::Record> records;
  double flexibility = 0.0;
};

SolvedRails solve_rails(const Rails<double>& rails, double k0, int stations, double load,
                        const NewtonOptions& options = {}) {
  SolvedRails s;
  s.records.resize(static_cast<std::size_t>(stations));
  const double shift = std::pow(load / (2 * stations * k0), 2.0 / 3.0);
  for (auto& r : s.records) {
    r = {};
    r.state.head[0] = shift;
    for (auto& c : r.contact) c.net_approach = shift;
  }
  const ChainHertz<double> law{{k0, k0}};
  RailChain chain(rails, law, stations, s.records.data());
  s.summary = chain.solve(load, load, options);
  const std::vector<RailChain::Record> solved = s.records;
  s.flexibility = chain.flexibility();
  s.records = solved;
  return s;
}

TEST(Chain, RigidRailsShareEqually) {
  const double held = std::numeric_limits<double>::infinity();
  const Rails<double> rails{1.0, {1e15, 1e15}, {held, 0.0}};
  const SolvedRails s = solve_rails(rails, 1e10, 6, 1200.0);
  ASSERT_TRUE(s.summary.converged);
  for (const auto& r : s.records)
    for (const auto& c : r.contact) EXPECT_NEAR(c.force / 100.0, 1.0, 1e-5);
  // 12 contacts side by side, each of tangent 1.5 N/delta.
  const double delta = std::pow(100.0 / 1e10, 2.0 / 3.0);
  EXPECT_NEAR(s.flexibility / (delta / (12 * 1.5 * 100.0)), 1.0, 1e-5);
}

TEST(Chain, OneStationIsItsContactsInSeriesWithTheGround) {
  const Rails<double> rails{1.0, {1.0, 1.0}, {2e7, 0.0}};
  const SolvedRails s = solve_rails(rails, 1e10, 1, 500.0);
  ASSERT_TRUE(s.summary.converged);
  const double delta = std::pow(250.0 / 1e10, 2.0 / 3.0);
  const auto& state = s.records[0].state;
  EXPECT_NEAR((state.head[0] + state.tail[0]) / (delta + 500.0 / 2e7), 1.0, 1e-13);
  const double energy = 0.4 * 2 * 250.0 * delta + 0.5 * 500.0 * 500.0 / 2e7 - 500.0 * (delta + 500.0 / 2e7);
  EXPECT_NEAR(s.summary.energy / energy, 1.0, 1e-12);
}

TEST(Chain, AgreesWithSparseSolverOnTheSameRails) {
  constexpr int kStations = 9;
  const Rails<double> rails{1.0, {3e8, 7e8}, {5e8, 2e6}};
  Model model;
  for (int k = 0; k < 2 * kStations; ++k) model.add_node();
  for (int k = 0; k < kStations; ++k) {
    if (k + 1 < kStations)
      for (int i = 0; i < 2; ++i) model.bars.push_back({2 * k + i, 2 * k + 2 + i, {rails.rail[i], 1.0}});
    model.elastic_supports.push_back({2 * k + 1, Dof::u, rails.support(k)});
    for (int i = 0; i < 2; ++i) model.springs.push_back({{2 * k}, {2 * k + 1}, 1.0, 0.0, {1e10, 0.0, 0.0}});
  }
  const Equations equations(model);
  NewtonSolver newton(equations);
  for (const double load : {1e-3, 1.0, 1e3, 1e6}) {
    const SolvedRails s = solve_rails(rails, 1e10, kStations, load);
    ASSERT_TRUE(s.summary.converged);
    State q(Eigen::VectorXd::Zero(equations.size()));
    for (int k = 0; k < kStations; ++k)
      q.head[equations.number(2 * k, Dof::u)] = std::pow(load / (18 * 1e10), 2.0 / 3.0);
    NewtonOptions options;
    options.force_scale = load;
    ASSERT_TRUE(newton.solve(equations.load_vector({{0, Dof::u, load}}), options, q).converged());
    for (int k = 0; k < kStations; ++k)
      for (int i = 0; i < 2; ++i) {
        const auto& state = s.records[static_cast<std::size_t>(k)].state;
        EXPECT_NEAR(state.head[i] / equations.displacement(q, 2 * k + i, Dof::u), 1.0, 1e-11)
            << load << ' ' << k << ' ' << i;
      }
  }
}

TEST(Chain, SaysWhyItStopped) {
  const Rails<double> rails{1.0, {3e8, 7e8}, {5e8, 2e6}};
  NewtonOptions options;
  options.max_iterations = 1;
  const SolvedRails limit = solve_rails(rails, 1e10, 9, 1e5, options);
  EXPECT_FALSE(limit.summary.converged);
  EXPECT_FALSE(limit.summary.singular);
  EXPECT_EQ(limit.summary.iterations, 1.0);
  EXPECT_GT(limit.summary.relative_residual, 1e-12);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_rails({1.0, {nan, 7e8}, {5e8, 2e6}}, 1e10, 9, 1e5).summary.converged);
  // Nothing holds the second rail: no equilibrium.
  EXPECT_FALSE(solve_rails({1.0, {3e8, 7e8}, {0.0, 0.0}}, 1e10, 9, 1e5).summary.converged);
}

TEST(ChainLaws, AreThePowerLawSpring) {
  for (const double compliance : {0.0, 1e-9, 3e-7, -1e-10, -4e-9}) {
    const PowerLawSpring spring{2e10, 0.0, compliance};
    const double compliances[] = {compliance};
    const ChainHertzInSeries<double> law{{2e10, 2e10}, {compliances, compliances}};
    for (const double w : {-1e-6, 0.0, 1e-12, 1e-8, 1e-6, 4e-6, 1e-5, 1e-3}) {
      const SpringResponse expected = evaluate(spring, w);
      const ChainResponse<double> r = law.evaluate(0, 0, w);
      EXPECT_NEAR(r.force, expected.force, 1e-13 * expected.force) << compliance << ' ' << w;
      EXPECT_NEAR(r.tangent, expected.tangent, 1e-13 * expected.tangent) << compliance << ' ' << w;
      EXPECT_NEAR(r.energy, expected.energy, 1e-12 * expected.energy) << compliance << ' ' << w;
      EXPECT_NEAR(law.law_approach(0, 0, w), law_approach(spring, w), 1e-13 * std::abs(w));
      if (compliance == 0.0) {
        const ChainHertz<double> hertz{{2e10, 2e10}};
        EXPECT_NEAR(hertz.evaluate(1, 0, w).force, expected.force, 1e-14 * expected.force);
        EXPECT_NEAR(hertz.evaluate(1, 0, w).tangent, expected.tangent, 1e-14 * expected.tangent);
        EXPECT_NEAR(hertz.evaluate(1, 0, w).energy, expected.energy, 1e-14 * expected.energy);
      }
    }
  }
}

}  // namespace
}  // namespace fe
