#include <benchmark/benchmark.h>

#include "prs/heat/analyze_heat.h"
#include "prs/input/reader.h"
#include "prs/slip/slip_equilibrium.h"
#include "prs/slip/slip_model.h"

namespace {

using namespace prs;

/// Lesson 30 with these shares and loads of its threads.
Case actuator(LoadCase::Share share, ModelOptions::Loads loads) {
  Case c = input::read_case(PRS_SOURCE_DIR "/configs/30_duty_cycle.yaml", {}, Command::slip);
  c.model.loads = loads;
  for (LoadCase& load : c.load_cases) load.share = share;
  return c;
}

Case one_load(LoadCase::Share share, ModelOptions::Loads loads) {
  Case c = actuator(share, loads);
  c.load_cases.resize(1);
  c.heat->duty.clear();
  return c;
}

/// Time limit: a heat balance of equal shares may take ten of these.
void SlipEquilibriumOfTheActuator(benchmark::State& state) {
  const Case c = one_load(LoadCase::Share::equal, ModelOptions::Loads::at_rest);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  const SlipModels models(c, contacts, oils_at(*c.lubricant, {330.0, 330.0}));
  for (auto _ : state) benchmark::DoNotOptimize(find_slip_equilibrium(models.equal_shares(c.load_cases[0])));
}
BENCHMARK(SlipEquilibriumOfTheActuator)->Unit(benchmark::kMicrosecond);

void HeatBalance(benchmark::State& state, LoadCase::Share share, ModelOptions::Loads loads) {
  const Case c = one_load(share, loads);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  int evaluations = 0;
  for (auto _ : state) evaluations = analyze_heat(c, contacts, kManyDesigns).load_cases[0].heat->evaluations;
  state.counters["evaluations"] = evaluations;
}
BENCHMARK_CAPTURE(HeatBalance, equal_shares, LoadCase::Share::equal, ModelOptions::Loads::at_rest)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(HeatBalance, at_rest, LoadCase::Share::solved, ModelOptions::Loads::at_rest)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(HeatBalance, running, LoadCase::Share::solved, ModelOptions::Loads::running)
    ->Unit(benchmark::kMicrosecond);

/// One hour of 3600 steps of 1 s.
void DutyOfAnHour(benchmark::State& state, LoadCase::Share share, ModelOptions::Loads loads) {
  Case c = actuator(share, loads);
  c.heat->duty.clear();
  for (int k = 0; k < 3600; ++k) c.heat->duty.push_back({c.load_cases[k % 3 == 0 ? 0 : 1].name, 1.0, {}});
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  std::vector<Warning> warnings;
  for (auto _ : state) benchmark::DoNotOptimize(duty_cycle(c, contacts, warnings));
}
BENCHMARK_CAPTURE(DutyOfAnHour, equal_shares, LoadCase::Share::equal, ModelOptions::Loads::at_rest)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DutyOfAnHour, at_rest, LoadCase::Share::solved, ModelOptions::Loads::at_rest)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(DutyOfAnHour, running, LoadCase::Share::solved, ModelOptions::Loads::running)
    ->Unit(benchmark::kMillisecond);

}  // namespace
