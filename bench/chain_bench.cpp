// The chain kernel: one sector and studies of random designs, with the processor's multiply-add
// peak in the same run. Compare ratios, not times.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "bench/function_kernel.h"
#include "bench/multiply_add_kernel.h"
#include "fe/chain.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/chain/design_solvers.h"
#include "simd/dispatch.h"
#include "support/allocations.h"
#include "support/sectors.h"

namespace {

using prs::InstructionSet;

constexpr double kForce = 45e3;

/// The sector of the Abevi screw, 20 threads, from equal shares to 1e-12; ConvergedSolve is the same with the sparse
/// solver.
void SingleSectorChain(benchmark::State& state) {
  prs::ChainSolver solver(test::abevi().model());
  prs::LoadDistribution result;
  solver.options.residual_tolerance = 1e-12;
  solver.solve(kForce, result);
  const std::size_t before = test::allocations();
  for (auto _ : state) {
    solver.solve(kForce, result);
    benchmark::DoNotOptimize(result.normal_load.screw.data());
    benchmark::ClobberMemory();
  }
  state.counters["allocations"] = static_cast<double>(test::allocations() - before);
  state.counters["linear_solves"] = result.solve.iterations();
}
BENCHMARK(SingleSectorChain);

/// Random designs of 20 threads: geometry, constants and load drawn for each.
struct Study {
  std::vector<prs::SectorModel> sectors;
  std::vector<double> forces;
  std::vector<prs::LoadDistribution> results;

  Study(std::uint64_t seed, std::size_t designs) : results(designs) {
    std::mt19937_64 random(seed);
    for (std::size_t k = 0; k < designs; ++k) {
      sectors.push_back(draw(random));
      forces.push_back(draw_force(sectors.back(), random));
    }
  }
  double mean_iterations() const { return lock_step_iterations(1); }
  /// Iterations of the batches, each that of its slowest design.
  double lock_step_iterations(int batch) const {
    double sum = 0.0;
    for (auto first = results.begin(); first != results.end(); first += batch)
      sum += std::max_element(first, first + batch, [](const auto& a, const auto& b) {
               return a.solve.iterations() < b.solve.iterations();
             })->solve.iterations();
    return sum * batch / static_cast<double>(results.size());
  }
  bool all_converged() const {
    return std::ranges::all_of(results,
                               [](const auto& r) { return r.solve.converged() && r.solve.relative_residual <= 1e-10; });
  }

  static prs::SectorModel draw(std::mt19937_64& random) {
    const auto about = [&](double value, double share) {
      return value * std::uniform_real_distribution<double>(1.0 - share, 1.0 + share)(random);
    };
    test::SectorCase c = test::abevi();
    c.mechanism.lead = about(5e-3, 0.2);
    const double pitch = axial_pitch(c.mechanism), roller = about(7e-3, 0.2);
    const double screw = about(3.0, 0.2) * roller, nut = screw + 2.0 * roller;
    c.mechanism.pitch_diameter = {screw, roller, nut};
    c.structure.screw = {about(0.3, 0.3) * screw, about(10e-3, 0.5)};
    c.structure.roller.end_length = about(5e-3, 0.3);
    c.structure.roller.end_diameter = about(0.7, 0.2) * roller;
    const double length = 20.0 * pitch + about(40e-3, 0.5), outer = about(1.3, 0.1) * nut;
    const double flange = about(9e-3, 0.3);
    c.structure.nut = {length,
                       outer,
                       {{0.0, flange, 1.3 * outer}, {length - flange, length, 1.3 * outer}},
                       {.tension = flange, .compression = length - flange}};
    c.position = about(0.5, 0.9) * (length - 19.0 * pitch);
    for (const prs::Interface i : prs::kInterfaces) {
      c.laws[i].hertz_constant = about(c.laws[i].hertz_constant, 0.3);
      c.laws[i].normal_angle = about(c.laws[i].normal_angle, 0.2);
    }
    c.direction = std::bernoulli_distribution(0.5)(random) ? prs::Direction::tension : prs::Direction::compression;
    return c.model();
  }

  /// Log-uniform force over 1 to 100 % of the load whose mean thread has a pressure of 2.5 GPa at the screw, in a
  /// contact of the same constant with equal curvatures: p^3 = 6 N E*^2/(pi^3 R^2), k_0 = 4/3 E* R^(1/2).
  static double draw_force(const prs::SectorModel& s, std::mt19937_64& random) {
    const double modulus = 209e9 / (2.0 * (1.0 - 0.09)), pressure = 2.5e9;
    const double root = 0.75 * s.hertz_constant.screw / modulus;  // R^(1/2)
    const double thread = std::pow(std::numbers::pi * pressure, 3) * std::pow(root, 4) / (6.0 * modulus * modulus);
    const double share = std::exp(std::uniform_real_distribution<double>(std::log(0.01), 0.0)(random));
    return share * thread * s.cosine.screw * s.rollers * s.contacts();
  }
};

/// Additions, multiplications, divisions and roots of one iteration at one station: the pivots and
/// the right-hand side; tangents and residual of the contacts into the front; the linear elements;
/// the state; back substitution; the contacts at the new state with the sums of the line search.
constexpr double flops_per_station() {
  constexpr const auto& fill = fe::kChainFill<prs::BarStation<double>>;
  double pairs = 0.0;
  for (const auto& row : fill.meets) {
    int met = 0;
    for (const bool m : row) met += m;
    pairs += 0.5 * met * (met + 1);
  }
  const double factorize = 2.0 * 5 + 3.0 * fill.multipliers + 2.0 * pairs;
  const double assemble = 2 * (4 + 2 * 10 + 2 * 4) + 12;
  const double move = 7 * 5;
  const double substitute = 2.0 * fill.multipliers;
  const double contacts = 2 * (2 * 4 + 7 + 12);
  return factorize + assemble + move + substitute + contacts;
}

/// Cold start of every design, set-up included, residual below 1e-10. `kernel flop/s` counts the iterations' operations
/// over the additional time of the iterations, which excludes the set-up, the start, the residual of the state and the
/// results.
void StudyOfRandomDesigns(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(0));
  if (!available(set)) return state.SkipWithError("not on this processor");
  constexpr std::size_t kDesigns = 4096;
  Study study(static_cast<std::uint64_t>(state.thread_index()) + 1, kDesigns);
  prs::BarDesignSolver solver(set), set_up(set);
  solver.options.residual_tolerance = 1e-10;
  set_up.options.max_iterations = 0;
  double seconds = 0.0, set_up_seconds = 0.0;
  for (auto _ : state) {
    const auto time = [&](prs::BarDesignSolver& s) {
      const auto start = std::chrono::steady_clock::now();
      s.solve(study.sectors, study.forces, study.results);
      benchmark::ClobberMemory();
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    set_up_seconds += time(set_up);
    const double solve = time(solver);
    seconds += solve;
    state.SetIterationTime(solve);
  }
  if (!study.all_converged()) return state.SkipWithError("not converged");
  // Counters are summed over the threads, rates are per time of one of them.
  const double designs = static_cast<double>(state.iterations()) * kDesigns;
  const double flops = designs * study.lock_step_iterations(batch_size(set)) * 20.0 * flops_per_station();
  using benchmark::Counter;
  state.counters["designs"] = Counter(designs, Counter::kIsRate);
  state.counters["flop/s"] = Counter(flops, Counter::kIsRate);
  state.counters["kernel flop/s"] = flops / (seconds - set_up_seconds);
  state.counters["set-up share"] = Counter(set_up_seconds / seconds, Counter::kAvgThreads);
  state.counters["iterations"] = Counter(study.mean_iterations(), Counter::kAvgThreads);
}
BENCHMARK(StudyOfRandomDesigns)
    ->ArgName("set")
    ->Arg(static_cast<int>(InstructionSet::scalar))
    ->Arg(static_cast<int>(InstructionSet::avx2))
    ->Arg(static_cast<int>(InstructionSet::avx512))
    ->ThreadRange(1, 2)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// A function of as many numbers as the first-level cache holds, at the widest width.
void FunctionFloor(benchmark::State& state) {
  constexpr std::size_t kNumbers = 1024;
  std::vector<double> x(kNumbers);
  for (std::size_t i = 0; i < kNumbers; ++i) x[i] = 0.1 + 1e-3 * static_cast<double>(i);
  const auto function = static_cast<Function>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(simd::run_kernel(InstructionSet::best, FunctionKernel{}, function, x.data(), x.size()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kNumbers));
}
BENCHMARK(FunctionFloor)->ArgName("function")->DenseRange(0, static_cast<int>(Function::asinh));

template <class Arch>
void multiply_adds(benchmark::State& state, InstructionSet set, int lanes) {
  if (!simd::available(set)) return state.SkipWithError("not on this processor");
  constexpr int kRounds = 10000;
  for (auto _ : state) benchmark::DoNotOptimize(MultiplyAddKernel{}(Arch{}, kRounds));
  const double flops =
      2.0 * MultiplyAddKernel::kIndependent * lanes * kRounds * static_cast<double>(state.iterations());
  state.counters["flop/s"] = benchmark::Counter(flops, benchmark::Counter::kIsRate);
}

#if defined(__x86_64__)
void MultiplyAddAvx2(benchmark::State& state) { multiply_adds<simd::Avx2>(state, InstructionSet::avx2, 4); }
BENCHMARK(MultiplyAddAvx2)->ThreadRange(1, 2)->UseRealTime();

void MultiplyAddAvx512(benchmark::State& state) { multiply_adds<simd::Avx512>(state, InstructionSet::avx512, 8); }
BENCHMARK(MultiplyAddAvx512)->ThreadRange(1, 2)->UseRealTime();
#endif

}  // namespace
