// The load distribution of the Abevi screw (CONFIG 2, tension, 45 kN, 20 threads): its parts, and
// whole solves, of the refined model too, in the same run. Compare ratios,
// not times.

#include <benchmark/benchmark.h>

#include "fe/cholesky.h"
#include "fe/cholmod.h"
#include "fe/newton.h"
#include "prs/sector/sector.h"
#include "support/sectors.h"
#include "support/tangent.h"

namespace {

constexpr double kForce = 45e3;

using Contacts = prs::ModelOptions::RollerContacts;

test::SectorCase refined(Contacts contacts = Contacts::opposite) {
  test::SectorCase c = test::abevi();
  c.options.bodies = &prs::kRefined;
  c.options.roller_contacts = contacts;
  return c;
}

/// The equations of the sector with a state near equilibrium.
struct Loaded {
  prs::SectorSolver solver;
  const fe::Equations& equations = solver.equations();
  Eigen::VectorXd load = kForce / 11 * solver.unit_load();
  fe::NewtonOptions options = solver.newton_options(kForce);
  fe::State start = solver.equal_shares(kForce);
  fe::SparseSymmetric tangent = equations.linear_stiffness();
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(equations.size());

  explicit Loaded(const test::SectorCase& c = test::abevi()) : solver(c.build()) {
    test::set_tangent(equations, start, tangent);
    equations.energy_and_residual(start, load, residual);
  }
};

void Assembly(benchmark::State& state) {
  Loaded l;
  for (auto _ : state) {
    benchmark::DoNotOptimize(l.equations.energy_and_residual(l.start, l.load, l.residual));
    test::set_tangent(l.equations, l.start, l.tangent);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(Assembly);

void Factorize(benchmark::State& state) {
  Loaded l;
  fe::Cholesky cholesky(l.tangent);
  for (auto _ : state) benchmark::DoNotOptimize(cholesky.factorize(l.tangent));
}
BENCHMARK(Factorize);

void FactorizeSupernodal(benchmark::State& state) {
  Loaded l;
  const auto cholesky = fe::supernodal_factorization(l.tangent);
  for (auto _ : state) benchmark::DoNotOptimize(cholesky->factorize(l.tangent));
}
BENCHMARK(FactorizeSupernodal);

void Solve(benchmark::State& state) {
  Loaded l;
  fe::Cholesky cholesky(l.tangent);
  cholesky.factorize(l.tangent);
  Eigen::VectorXd x(l.residual.size());
  for (auto _ : state) {
    cholesky.solve(l.residual, x);
    benchmark::DoNotOptimize(x.data());
  }
}
BENCHMARK(Solve);

/// Newton's method from equal shares to 1e-12, assembly included, set-up excluded.
void converged_solve(benchmark::State& state, const test::SectorCase& c) {
  Loaded l(c);
  fe::NewtonSolver newton(l.equations);
  int solves = 0;
  for (auto _ : state) {
    fe::State q = l.start;
    solves = newton.solve(l.load, l.options, q).iterations();
    benchmark::DoNotOptimize(q.head.data());
  }
  state.counters["linear_solves"] = solves;
}

void ConvergedSolve(benchmark::State& state) { converged_solve(state, test::abevi()); }
BENCHMARK(ConvergedSolve);

void ConvergedSolveRefined(benchmark::State& state) { converged_solve(state, refined()); }
BENCHMARK(ConvergedSolveRefined);

void ConvergedSolveRefinedHalfPitchApart(benchmark::State& state) {
  converged_solve(state, refined(Contacts::half_pitch_apart));
}
BENCHMARK(ConvergedSolveRefinedHalfPitchApart);

/// All steps from the description of the screw: sector, numbering, symbolic analysis, solve, thread loads.
void case_cold(benchmark::State& state, const test::SectorCase& c) {
  for (auto _ : state) {
    prs::SectorSolver solver(c.build());
    benchmark::DoNotOptimize(solver.solve(kForce).axial_displacement);
  }
}

void CaseCold(benchmark::State& state) { case_cold(state, test::abevi()); }
BENCHMARK(CaseCold);

void CaseColdRefined(benchmark::State& state) { case_cold(state, refined()); }
BENCHMARK(CaseColdRefined);

void SweepOf100Loads(benchmark::State& state) {
  prs::SectorSolver solver(test::abevi().build());
  for (auto _ : state)
    for (int k = 1; k <= 100; ++k) benchmark::DoNotOptimize(solver.solve(kForce * k / 100.0).axial_displacement);
  state.SetItemsProcessed(state.iterations() * 100);
}
BENCHMARK(SweepOf100Loads)->Unit(benchmark::kMicrosecond);

}  // namespace
