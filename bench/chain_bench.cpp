// The chain kernel: one sector against the sparse solver, studies of random designs and sweeps of
// loads, with the processor's multiply-add peak in the same run. Compare ratios, not times.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <numbers>
#include <random>
#include <vector>

#include "bench/multiply_add_kernel.h"
#include "fe/chain.h"
#include "fe/newton.h"
#include "prs/sector/chain/bar_designs.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/load_distribution.h"
#include "support/allocations.h"
#include "support/sectors.h"

namespace {

using prs::InstructionSet;

constexpr double kForce = 45e3;

/// Newton from equal shares to 1e-12 on the sector of the Abevi screw, 20 threads.
void SingleSectorSparse(benchmark::State& state) {
  prs::SectorSolver solver(test::abevi().build());
  fe::NewtonSolver newton(solver.equations());
  const Eigen::VectorXd load = kForce / 11 * solver.unit_load();
  const fe::NewtonOptions options = solver.newton_options(kForce);
  const fe::State start = solver.equal_shares(kForce);
  int solves = 0;
  for (auto _ : state) {
    fe::State q = start;
    solves = newton.solve(load, options, q).iterations();
    benchmark::DoNotOptimize(q.head.data());
  }
  state.counters["linear_solves"] = solves;
}
BENCHMARK(SingleSectorSparse);

/// The same to thread loads and displacement.
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

/// Random designs of 20 threads, geometry, constants and load drawn for each, as columns; with
/// several loads the one drawn is the last of as many equal steps.
class Study {
 public:
  Study(std::uint64_t seed, std::size_t designs, std::size_t loads = 1) : solves_(designs * loads) {
    std::mt19937_64 random(seed);
    std::vector<prs::SectorModel> sectors;
    for (std::size_t k = 0; k < designs; ++k) {
      sectors.push_back(draw(random));
      const double force = draw_force(sectors.back(), random);
      for (std::size_t i = 1; i <= loads; ++i)
        forces_.push_back(force * static_cast<double>(i) / static_cast<double>(loads));
    }
    fill(sectors);
    designs_.loads = loads;
  }

  const prs::BarDesigns& designs() const { return designs_; }

  prs::ThreadLoads results() {
    prs::ThreadLoads r;
    r.normal_load = {screw_, nut_};
    r.stride = 20;
    r.axial_displacement = displacement_;
    r.status = status_;
    r.iterations = iterations_;
    r.relative_residual = residual_;
    return r;
  }

  double mean_iterations() const {
    double sum = 0.0;
    for (const int i : iterations_) sum += i;
    return sum / static_cast<double>(solves_);
  }

  /// Iterations of the batches: those of their slowest design. One load a design.
  double lock_step_iterations(int batch) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < solves_; k += static_cast<std::size_t>(batch))
      sum += *std::max_element(iterations_.begin() + static_cast<std::ptrdiff_t>(k),
                               iterations_.begin() + static_cast<std::ptrdiff_t>(k) + batch);
    return sum * batch / static_cast<double>(solves_);
  }

  double largest_residual() const { return *std::max_element(residual_.begin(), residual_.end()); }

  bool all_converged() const {
    return std::all_of(status_.begin(), status_.end(),
                       [](auto s) { return s == fe::NewtonStatus::converged; });
  }

 private:
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
    c.direction = std::bernoulli_distribution(0.5)(random) ? prs::Direction::tension
                                                           : prs::Direction::compression;
    return c.model();
  }

  /// Log-uniform over 1 to 100 % of the load whose mean thread has a pressure of 2.5 GPa at the
  /// screw, in a contact of the same constant with equal curvatures: p^3 = 6 N E*^2/(pi^3 R^2),
  /// k_0 = 4/3 E* R^(1/2).
  static double draw_force(const prs::SectorModel& s, std::mt19937_64& random) {
    const double modulus = 209e9 / (2.0 * (1.0 - 0.09)), pressure = 2.5e9;
    const double root = 0.75 * s.hertz_constant.screw / modulus;  // R^(1/2)
    const double thread =
        std::pow(std::numbers::pi * pressure, 3) * std::pow(root, 4) / (6.0 * modulus * modulus);
    const double share =
        std::exp(std::uniform_real_distribution<double>(std::log(0.01), 0.0)(random));
    return share * thread * s.cosine.screw * s.rollers * s.contacts();
  }

  void fill(const std::vector<prs::SectorModel>& sectors) {
    const auto column = [&](auto value) -> std::span<const double> {
      std::vector<double>& c = columns_.emplace_back();
      for (const prs::SectorModel& s : sectors) c.push_back(value(s));
      return c;
    };
    using S = const prs::SectorModel;
    prs::BarDesigns& d = designs_;
    d.contacts = 20;
    d.axial_force = forces_;
    prs::SectorNumbers<std::vector<double>>& n = columns_of_numbers_;
    for (S& s : sectors)
      prs::for_each_number(
          [](std::vector<double>& values, const double& number) { values.push_back(number); }, n,
          s);
    prs::for_each_number(
        [](prs::BarDesigns::Values& view, const std::vector<double>& values) { view = values; }, d,
        n);
    d.compliance = {};
    for (std::size_t f = 0; f < 2; ++f)
      flanges_.push_back({column([f](S& s) { return s.flanges[f].from; }),
                          column([f](S& s) { return s.flanges[f].to; }),
                          column([f](S& s) { return s.flanges[f].axial_rigidity; })});
    d.flanges = flanges_;
  }

  std::size_t solves_;
  std::vector<double> forces_;
  std::deque<std::vector<double>> columns_;
  prs::SectorNumbers<std::vector<double>> columns_of_numbers_;
  std::vector<prs::BarDesigns::Flange> flanges_;
  prs::BarDesigns designs_;
  std::vector<double> screw_ = std::vector<double>(20 * solves_);
  std::vector<double> nut_ = std::vector<double>(20 * solves_);
  std::vector<double> displacement_ = std::vector<double>(solves_);
  std::vector<double> residual_ = std::vector<double>(solves_);
  std::vector<fe::NewtonStatus> status_ = std::vector<fe::NewtonStatus>(solves_);
  std::vector<int> iterations_ = std::vector<int>(solves_);
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

/// Cold start of every design, its set-up included, residual below 1e-10. `kernel flop/s` counts
/// the iterations' operations over the time that they take more than no iteration, which is the
/// set-up, the start, the residual of the state and the results.
void StudyOfRandomDesigns(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(0));
  if (!available(set)) return state.SkipWithError("not on this processor");
  constexpr std::size_t kDesigns = 4096;
  Study study(static_cast<std::uint64_t>(state.thread_index()) + 1, kDesigns);
  prs::BarDesignSolver solver(set), set_up(set);
  solver.options.residual_tolerance = 1e-10;
  set_up.options.max_iterations = 0;
  const prs::ThreadLoads results = study.results();
  double seconds = 0.0, set_up_seconds = 0.0;
  for (auto _ : state) {
    const auto time = [&](prs::BarDesignSolver& s) {
      const auto start = std::chrono::steady_clock::now();
      s.solve(study.designs(), results);
      benchmark::ClobberMemory();
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    set_up_seconds += time(set_up);
    const double solve = time(solver);
    seconds += solve;
    state.SetIterationTime(solve);
  }
  if (!study.all_converged() || study.largest_residual() > 1e-10)
    return state.SkipWithError("not converged");
  // Counters are summed over the threads, rates are per time of one of them.
  const double designs = static_cast<double>(state.iterations()) * kDesigns;
  const double flops =
      designs * study.lock_step_iterations(batch_size(set)) * 20.0 * flops_per_station();
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

template <class Arch>
void multiply_adds(benchmark::State& state, int lanes) {
  if (xsimd::available_architectures().best < Arch::version())
    return state.SkipWithError("not on this processor");
  constexpr int kRounds = 10000;
  for (auto _ : state) benchmark::DoNotOptimize(MultiplyAddKernel{}(Arch{}, kRounds));
  const double flops = 2.0 * MultiplyAddKernel::kIndependent * lanes * kRounds *
                       static_cast<double>(state.iterations());
  state.counters["flop/s"] = benchmark::Counter(flops, benchmark::Counter::kIsRate);
}

#if defined(__x86_64__)
void MultiplyAddAvx2(benchmark::State& state) { multiply_adds<simd::Avx2>(state, 4); }
BENCHMARK(MultiplyAddAvx2)->ThreadRange(1, 2)->UseRealTime();

void MultiplyAddAvx512(benchmark::State& state) { multiply_adds<simd::Avx512>(state, 8); }
BENCHMARK(MultiplyAddAvx512)->ThreadRange(1, 2)->UseRealTime();
#endif

/// 100 ascending loads on each of 64 random designs, one design a lane, to thread loads and
/// displacements.
void SweepsOfRandomDesigns(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(0));
  if (!available(set)) return state.SkipWithError("not on this processor");
  constexpr std::size_t kDesigns = 64, kLoads = 100;
  Study study(1, kDesigns, kLoads);
  prs::BarDesignSolver solver(set);
  solver.options.residual_tolerance = 1e-10;
  const prs::ThreadLoads results = study.results();
  for (auto _ : state) {
    solver.solve(study.designs(), results);
    benchmark::ClobberMemory();
  }
  if (!study.all_converged() || study.largest_residual() > 1e-10)
    return state.SkipWithError("not converged");
  state.counters["iterations"] = study.mean_iterations();
  state.counters["time/load"] =
      benchmark::Counter(static_cast<double>(kDesigns * kLoads * state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(SweepsOfRandomDesigns)
    ->ArgName("set")
    ->Arg(static_cast<int>(InstructionSet::scalar))
    ->Arg(static_cast<int>(InstructionSet::avx2))
    ->Arg(static_cast<int>(InstructionSet::avx512))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
