// All rollers of the Abevi screw (11 rollers, 20 threads, 45 kN, a side force): the parts of one
// solve, whole solves, many designs of unequal rollers, a turn of the carrier, in the same run.
// Compare ratios, not times.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "fe/cholesky.h"
#include "fe/cholmod.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/mechanism/full_influence.h"
#include "prs/mechanism/full_model.h"
#include "prs/mechanism/full_structure.h"
#include "prs/mechanism/modes.h"
#include "support/sectors.h"

namespace {

/// Model with a normal deviation of 2 um of each roller's diameter if `random` is given.
prs::FullModel model_of(double carrier_angle = 0.0, std::mt19937_64* random = nullptr) {
  test::SectorCase c = test::abevi();
  c.mechanism.centre_distance = 14e-3;
  if (random)
    for (int j = 0; j < c.mechanism.rollers; ++j)
      c.deviations.roller_diameters.push_back(std::normal_distribution<>(0.0, 2e-6)(*random));
  prs::LoadCase load;
  load.axial_force = 45e3;
  load.direction = c.direction;
  load.position = c.position;
  load.spatial.side_force.value = {1e3, -500.0};
  load.spatial.carrier_angle = carrier_angle;
  return prs::full_model(c.mechanism, c.structure, c.materials, c.options, c.laws, load, c.deviations);
}

/// Tangent with the stiffness of equal shares.
struct Tangent {
  prs::FullStructure structure = prs::full_structure(model_of());
  fe::Equations equations{structure.model};
  fe::SparseSymmetric matrix = equations.linear_stiffness();

  Tangent() { equations.secant_stiffness(std::vector<double>(equations.springs().size(), 3e8), matrix); }
};

void FullStructure(benchmark::State& state) {
  const prs::FullModel model = model_of();
  for (auto _ : state) benchmark::DoNotOptimize(prs::full_structure(model).loaded);
}
BENCHMARK(FullStructure);

void FullFreeMotions(benchmark::State& state) {
  const prs::FullModel model = model_of();
  const prs::FullStructure structure = prs::full_structure(model);
  for (auto _ : state) benchmark::DoNotOptimize(prs::free_motions(model, structure).count);
}
BENCHMARK(FullFreeMotions);

void FullEquations(benchmark::State& state) {
  const Tangent t;
  for (auto _ : state) benchmark::DoNotOptimize(fe::Equations(t.structure.model).size());
}
BENCHMARK(FullEquations);

void FullEquationsTaken(benchmark::State& state) {
  Tangent t;
  for (auto _ : state) benchmark::DoNotOptimize(t.equations.take(t.structure.model));
}
BENCHMARK(FullEquationsTaken);

void FullFactorize(benchmark::State& state) {
  const Tangent t;
  fe::Cholesky cholesky(t.matrix);
  for (auto _ : state) benchmark::DoNotOptimize(cholesky.factorize(t.matrix));
}
BENCHMARK(FullFactorize);

void FullFactorizeSupernodal(benchmark::State& state) {
  const Tangent t;
  const auto cholesky = fe::supernodal_factorization(t.matrix);
  for (auto _ : state) benchmark::DoNotOptimize(cholesky->factorize(t.matrix));
}
BENCHMARK(FullFactorizeSupernodal);

void full_case(benchmark::State& state, prs::Detail detail) {
  const prs::FullModel model = model_of();
  int solves = 0;
  for (auto _ : state) solves = prs::solve(model, detail).solve.iterations();
  state.counters["linear_solves"] = solves;
}

void FullCaseNumbers(benchmark::State& state) { full_case(state, prs::Detail::numbers); }
BENCHMARK(FullCaseNumbers);

/// Case with the stiffness of the screw's end.
void FullCaseComplete(benchmark::State& state) { full_case(state, prs::Detail::complete); }
BENCHMARK(FullCaseComplete);

/// Artificial flexibilities similar to those of bodies: a beam's and, from thread to thread, decreasing. Their values
/// do not affect the time.
prs::FullBodies made_up_bodies(const prs::FullModel& model) {
  const Eigen::Index threads = model.threads();
  const auto decaying = [&](double compliance) {
    Eigen::MatrixXd c(threads, threads);
    for (Eigen::Index i = 0; i < threads; ++i)
      for (Eigen::Index k = 0; k < threads; ++k)
        c(i, k) = compliance * std::exp(-0.3 * static_cast<double>(std::abs(i - k)));
    return c;
  };
  prs::FullBodies b;
  for (int m = 0; m <= model.rollers / 2; ++m) {
    b.screw.modes.push_back(decaying(3e-9 / (1 + m)));
    b.nut.modes.push_back(decaying(2e-9 / (1 + m)));
  }
  const auto add_sections = [&](prs::FlexibilityAround& body, const std::vector<double>& places) {
    const auto columns = 2 * static_cast<Eigen::Index>(places.size());
    body.coupling = Eigen::MatrixXd::Constant(threads, columns, 1e-11);
    body.sections = 1e-10 * Eigen::MatrixXd::Identity(columns, columns);
  };
  add_sections(b.screw, prs::screw_stations(model));
  add_sections(b.nut, prs::nut_stations(model));
  b.roller = Eigen::MatrixXd::Zero(2 * threads, 2 * threads);
  b.roller.topLeftCorner(threads, threads) = b.roller.bottomRightCorner(threads, threads) = decaying(1e-9);
  return b;
}

/// A load on cached matrices of `bodies: influence`.
void FullInfluenceLoad(benchmark::State& state) {
  const prs::FullModel model = model_of();
  const prs::FullBodies bodies = made_up_bodies(model);
  int solves = 0;
  for (auto _ : state) solves = prs::solve(model, bodies).solve.iterations();
  state.counters["linear_solves"] = solves;
}
BENCHMARK(FullInfluenceLoad);

void FullDesignOfUnequalRollers(benchmark::State& state) {
  std::mt19937_64 random(1);
  prs::FullSolver solver;
  for (auto _ : state)
    benchmark::DoNotOptimize(solver.solve(model_of(0.0, &random), prs::Detail::numbers).axial_displacement);
}
BENCHMARK(FullDesignOfUnequalRollers);

void FullOrbitOfEightPositions(benchmark::State& state) {
  for (auto _ : state) {
    prs::FullSolver solver;
    benchmark::DoNotOptimize(
        prs::orbit([](double angle) { return model_of(angle); },
                   [&](const prs::FullModel& model) { return solver.solve(model, prs::Detail::numbers); }, {8, 3.0},
                   0.0, {.alike = true}));
  }
}
BENCHMARK(FullOrbitOfEightPositions);

/// 1,000 positions with unequal errors of all rollers, stiffness and reactions included: at most 3
/// s.
void FullTravel(benchmark::State& state) {
  test::SectorCase c = test::abevi();
  c.mechanism.centre_distance = 14e-3;
  c.deviations.turning.thread.screw.wobble = {1.5e-4, -1.0};
  for (int j = 0; j < c.mechanism.rollers; ++j) {
    c.deviations.turning.rollers.eccentricity.amount.many.push_back(1e-6 * (j % 4));
    c.deviations.turning.rollers.eccentricity.angle.many.push_back(0.6 * j);
  }
  prs::LoadCase load;
  load.axial_force = 45e3;
  load.direction = c.direction;
  load.position = c.position;
  prs::Travel wanted;
  wanted.turns = 27;
  wanted.steps = 37;
  const auto turn = [&](double theta) { return prs::turn_of(c.mechanism, wanted, theta); };
  const prs::TravelModel model{[&](double theta) {
                                 return prs::full_model(c.mechanism, c.structure, c.materials, c.options, c.laws, load,
                                                        c.deviations, turn(theta));
                               },
                               [&](double theta) { return turn(theta).carrier; },
                               [] {
                                 return [solver = std::make_shared<prs::FullSolver>(prs::FullStart::onwards)](
                                            const prs::FullModel& f) { return solver->solve(f); };
                               }};
  for (auto _ : state) benchmark::DoNotOptimize(prs::travel(model, c.mechanism, wanted).mean_displacement);
}
BENCHMARK(FullTravel)->Unit(benchmark::kMillisecond);

/// 30 modes: at most 0.2 s.
void FullModes(benchmark::State& state) {
  test::SectorCase c = test::abevi();
  c.mechanism.centre_distance = 14e-3;
  for (const prs::Part p : prs::kParts) c.materials[p].density = 7810.0;
  const prs::FullModel model = model_of();
  const prs::FullDistribution loads = prs::solve(model);
  prs::Modes wanted;
  wanted.count = 30;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        prs::modes({model, loads, c.mechanism, c.structure, c.materials, 0.375}, wanted).modes.size());
}
BENCHMARK(FullModes)->Unit(benchmark::kMillisecond);

}  // namespace
