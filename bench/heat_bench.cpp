#include <benchmark/benchmark.h>

#include "prs/heat/analyze_heat.h"
#include "prs/input/reader.h"
#include "prs/slip/slip_equilibrium.h"
#include "prs/slip/slip_model.h"

namespace {

using namespace prs;

/// Lesson 30, with the duty and the load cases that `keep` says.
Case actuator(LoadCase::Share share) {
  Case c = input::read_case(PRS_SOURCE_DIR "/configs/30_duty_cycle.yaml", {}, Command::slip);
  for (LoadCase& load : c.load_cases) load.share = share;
  return c;
}

Case one_load(LoadCase::Share share) {
  Case c = actuator(share);
  c.load_cases.resize(1);
  c.heat->duty.clear();
  return c;
}

/// What ten of are the most that a heat balance of equal shares may take.
void SlipEquilibriumOfTheActuator(benchmark::State& state) {
  const Case c = one_load(LoadCase::Share::equal);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  const SlipModels models(c, contacts, oils_at(*c.lubricant, {330.0, 330.0}));
  for (auto _ : state) benchmark::DoNotOptimize(find_slip_equilibrium(models.equal_shares(c.load_cases[0])));
}
BENCHMARK(SlipEquilibriumOfTheActuator)->Unit(benchmark::kMicrosecond);

void heat_balance(benchmark::State& state, LoadCase::Share share) {
  const Case c = one_load(share);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  int evaluations = 0;
  for (auto _ : state) evaluations = analyze_heat(c, contacts, kManyDesigns).load_cases[0].heat->evaluations;
  state.counters["evaluations"] = evaluations;
}
void HeatBalanceEqualShares(benchmark::State& state) { heat_balance(state, LoadCase::Share::equal); }
void HeatBalanceSolvedShares(benchmark::State& state) { heat_balance(state, LoadCase::Share::solved); }
BENCHMARK(HeatBalanceEqualShares)->Unit(benchmark::kMicrosecond);
BENCHMARK(HeatBalanceSolvedShares)->Unit(benchmark::kMicrosecond);

/// One hour of 3600 steps of 1 s.
void duty_of_an_hour(benchmark::State& state, LoadCase::Share share) {
  Case c = actuator(share);
  c.heat->duty.clear();
  for (int k = 0; k < 3600; ++k) c.heat->duty.push_back({c.load_cases[k % 3 == 0 ? 0 : 1].name, 1.0, {}});
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  std::vector<Warning> warnings;
  for (auto _ : state) benchmark::DoNotOptimize(periodic_heat_cycle(c, contacts, warnings));
}
void DutyOfAnHourEqualShares(benchmark::State& state) { duty_of_an_hour(state, LoadCase::Share::equal); }
void DutyOfAnHourSolvedShares(benchmark::State& state) { duty_of_an_hour(state, LoadCase::Share::solved); }
BENCHMARK(DutyOfAnHourEqualShares)->Unit(benchmark::kMillisecond);
BENCHMARK(DutyOfAnHourSolvedShares)->Unit(benchmark::kMillisecond);

}  // namespace
