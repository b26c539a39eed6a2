// Studies of the whole chain (contact points, load distribution, pressures) on 2 threads: computed
// alone, and with the journal and study.csv written as `prs study --output` does.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <atomic>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "prs/input/optimize_reader.h"
#include "prs/run/study.h"
#include "prs/study/design_engine.h"
#include "prs/study/study_files.h"
#include "prs/study/study_result.h"
#include "prs/study/study_run.h"
#include "tests/prs/input/abevi.h"

namespace {

constexpr std::size_t kThreads = 2;

prs::input::StudyInput study_of(std::size_t samples, const std::string& model = "") {
  return prs::input::read_study_input(
      {"bench.yaml",
       prs::input::kAbevi + model + "study: {command: solve, plan: monte_carlo, samples: " + std::to_string(samples) +
           ", factors: [{path: mechanism.flank_angle, within: 3 %}, {path: "
           "mechanism.profile.roller.convex, within: 3 %}, {path: structure.nut.outer_diameter, "
           "within: 3 %}, {path: structure.screw.bore, within: 3 %}, {path: "
           "materials.youngs_modulus, within: 3 %}, {path: 'load_cases[0].axial_force', "
           "log_uniform: {from: 0.45 kN, to: 45 kN}}], responses: [axial_displacement_um, "
           "axial_stiffness_N_per_um, screw.load_rate_percent.max, nut.load_rate_percent.max, "
           "screw.peak_pressure_MPa.max, nut.peak_pressure_MPa.max]}\n",
       {}});
}

void compute(benchmark::State& state, const prs::input::StudyInput& in) {
  const auto designs = static_cast<std::size_t>(state.range(0));
  const prs::DesignEngine engine(in);
  const auto evaluate = [&](std::size_t first, std::size_t count) { return engine.evaluate(first, count); };
  for (auto _ : state) {
    std::atomic<std::size_t> next = 1;
    prs::run_schedule(
        kThreads, engine.chunk(),
        [&](std::size_t most) -> std::optional<prs::DesignRange> {
          const std::size_t first = next.fetch_add(most);
          if (first > designs) return std::nullopt;
          return prs::DesignRange{first, std::min(most, designs + 1 - first)};
        },
        evaluate, [](const std::string& record) { benchmark::DoNotOptimize(record.data()); });
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(designs));
}

void FullChainComputed(benchmark::State& state) { compute(state, study_of(static_cast<std::size_t>(state.range(0)))); }
BENCHMARK(FullChainComputed)->Arg(200'000)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// Compared with `FullChainComputed`: additional time of refined bodies over bars.
void RefinedChainComputed(benchmark::State& state) {
  compute(state, study_of(static_cast<std::size_t>(state.range(0)), "model: {bodies: refined}\n"));
}
BENCHMARK(RefinedChainComputed)->Arg(200'000)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// Lesson 1 as `case.function` of Python compiles it: its force and a modulus, two responses.
prs::input::StudyInput function_of_lesson() {
  return prs::input::read_study_input(
      prs::input::load_source(PRS_SOURCE_DIR "/configs/01_config_1_to_3.yaml",
                              {"study={command: solve, plan: monte_carlo, samples: 10000, factors: [{path: "
                               "'load_cases[0].axial_force', uniform: {from: 40000 N, to: 50000 N}}, {path: "
                               "materials.youngs_modulus, uniform: {from: 200000 MPa, to: 220000 MPa}}], responses: "
                               "[axial_stiffness_N_per_um, screw.peak_pressure_MPa.max]}"}));
}

/// The solve inside `f(x)`: one design by its values, in this thread.
void FunctionOfOneDesign(benchmark::State& state) {
  const prs::input::StudyInput in = function_of_lesson();
  const prs::DesignEngine engine(in);
  const std::vector<std::vector<prs::Draw>> design = {
      {{prs::Draw::Kind::number, 0, 45e3}, {prs::Draw::Kind::number, 0, 209e3}}};
  for (auto _ : state) benchmark::DoNotOptimize(engine.evaluate(design));
}
BENCHMARK(FunctionOfOneDesign)->Unit(benchmark::kMicrosecond);

/// Time of the study engine for the designs of `f(x)` in one call.
void FunctionAsStudy(benchmark::State& state) { compute(state, function_of_lesson()); }
BENCHMARK(FunctionAsStudy)->Arg(10'000)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

void FullChainWithFiles(benchmark::State& state) {
  const auto designs = static_cast<std::size_t>(state.range(0));
  const prs::input::StudyInput in = study_of(designs);
  const prs::DesignEngine engine(in);
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "prs_study_bench";
  for (auto _ : state) {
    state.PauseTiming();
    std::filesystem::remove_all(path);
    state.ResumeTiming();
    const prs::StudyFolder folder(path, prs::StudyFolder::Use::alone);
    const prs::JournalHeader header{
        "bench", in.source, engine.study().responses, prs::design_count(engine.study()), {}};
    const prs::StoredRows rows =
        prs::run_study(header, &folder,
                       [&](const prs::NextRange& next, const prs::TakeRecord& take) {
                         prs::run_schedule(
                             kThreads, engine.chunk(), next,
                             [&](std::size_t first, std::size_t count) { return engine.evaluate(first, count); }, take);
                       },
                       {});
    prs::StudyAnalysis analysis(engine.study());
    prs::write_rows(rows, engine.study(), &path, kThreads,
                    [&](const prs::RowBlock& block, std::span<const double> inputs) { analysis.add(block, inputs); });
    folder.remove_journals();
  }
  std::filesystem::remove_all(path);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["largest_MiB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(designs));
}
BENCHMARK(FullChainWithFiles)
    ->Arg(200'000)
    ->Arg(1'000'000)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Lesson 23: designs of 8 load cases, measured, in generations of 40.
void Optimization(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(0));
  const prs::input::OptimizeInput in =
      prs::input::read_optimize_input(prs::input::load_source(PRS_SOURCE_DIR "/configs/23_crowning.yaml", {}));
  for (auto _ : state) benchmark::DoNotOptimize(prs::run_optimization(in, threads, prs::Journal::temporary, {}));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(prs::design_count(in.optimization)));
}
BENCHMARK(Optimization)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
