#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/function_kernel.h"
#include "contact/patch.h"
#include "prs/input/reader.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_equilibrium.h"
#include "prs/slip/slip_model.h"
#include "simd/dispatch.h"
#include "tests/support/slips.h"

namespace {

using namespace prs;

/// The reference example of Sandu 2018 (table 3.2), its loads made unequal for 20 threads.
Case reference() {
  Case c = test::sandu_reference();
  c.mechanism.contacts_per_roller = 20;
  return c;
}

Result unequal_loads(const Case& c) {
  Result result = analyze_slip(c);
  LoadCaseResult& loaded = result.load_cases[0];
  loaded.load_case.share = LoadCase::Share::solved;
  for (const Interface i : kInterfaces) {
    std::vector<double>& load = (*loaded.threads)[i].axial_load;
    for (std::size_t k = 0; k < load.size(); ++k) load[k] *= 1.0 + 0.5 * (static_cast<double>(k) / 9.5 - 1.0);
  }
  return result;
}

/// Equilibrium of 20 threads x 2 interfaces x 441 points, patches built from the loads.
void SlipEquilibriumPerThread(benchmark::State& state) {
  Case c = reference();
  c.model.roller = ModelOptions::Roller::rigid_bending;  // Guides, which the reference lacks, then carry nothing.
  const Result result = unequal_loads(c);
  const SlipModels models(c, result.contacts);
  for (auto _ : state) benchmark::DoNotOptimize(find_slip_equilibrium(models.of(result.load_cases[0])));
  const SlipEquilibrium found = find_slip_equilibrium(models.of(result.load_cases[0]));
  state.counters["evaluations"] = found.evaluations;
}
BENCHMARK(SlipEquilibriumPerThread)->Unit(benchmark::kMicrosecond);

void SlipEquilibriumEqualShares(benchmark::State& state) {
  const Case c = reference();
  const Result result = analyze_slip(c);
  const SlipModels models(c, result.contacts);
  for (auto _ : state) benchmark::DoNotOptimize(find_slip_equilibrium(models.of(result.load_cases[0])));
}
BENCHMARK(SlipEquilibriumEqualShares)->Unit(benchmark::kMicrosecond);

/// Friction at the 349 points of one patch inside its ellipse, for one slip ratio.
void FrictionOfOnePatch(benchmark::State& state) {
  const Case c = reference();
  const Result result = analyze_slip(c);
  const SlipModels models(c, result.contacts);
  const SlipModel model = models.of(result.load_cases[0]);
  const contact::Patch& patch = model.threads.screw.patches[0];
  contact::PatchMotion motion{0.05, 0.07, 40.0, 0.5};
  for (auto _ : state) {
    motion.sliding_major += 1e-12;
    benchmark::DoNotOptimize(patch.friction(motion));
  }
}
BENCHMARK(FrictionOfOnePatch);

/// Equally many asinh at the same width and nothing else: the minimum time of the friction.
void AsinhOfOnePatch(benchmark::State& state) {
  std::vector<double> x(352);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 1e3 * static_cast<double>(i);
  for (auto _ : state) {
    x[0] += 1e-6;
    benchmark::DoNotOptimize(
        simd::run_kernel(simd::InstructionSet::best, FunctionKernel{}, Function::asinh, x.data(), x.size()));
  }
}
BENCHMARK(AsinhOfOnePatch);

/// Slip of 120 loads on a sector of 20 threads, static and running.
void SlipOfManyLoads(benchmark::State& state, ModelOptions::Loads loads) {
  Case c = input::read_case_input(input::load_source("configs/09_slip_and_dissipation.yaml", {}), Command::slip).values;
  LoadCase load = *std::ranges::find_if(c.load_cases, &LoadCase::is_solved);
  c.load_cases.clear();
  c.model.loads = loads;
  for (int k = 1; k <= 120; ++k) {
    load.axial_force = 200.0 * k;
    c.load_cases.push_back(load);
  }
  for (auto _ : state) benchmark::DoNotOptimize(analyze_slip(c));
}
BENCHMARK_CAPTURE(SlipOfManyLoads, at_rest, ModelOptions::Loads::at_rest)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SlipOfManyLoads, running, ModelOptions::Loads::running)->Unit(benchmark::kMillisecond);

}  // namespace
