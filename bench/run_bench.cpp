// Computations of commands on a case that was read: the engine's part of a call from Python. Run it from the top of the
// repository, by bench/python_bench.py.

#include <benchmark/benchmark.h>

#include "prs/input/reader.h"
#include "prs/input/source.h"
#include "prs/run/commands.h"

namespace {

void measure(benchmark::State& state, prs::Command command, const char* file) {
  const prs::AnyAnalysis& row = prs::analysis_of(command);
  const prs::input::Source source = prs::input::load_source(file, {});
  const prs::input::CaseInput in = prs::input::read_case_input(source, command);
  for (auto _ : state) benchmark::DoNotOptimize(row.run(source, in));
}

void RunContact(benchmark::State& state) {
  measure(state, prs::Command::contact, "configs/08_design_by_backlash.yaml");
}
BENCHMARK(RunContact);

void RunSolve(benchmark::State& state) { measure(state, prs::Command::solve, "configs/05_standard_screw.yaml"); }
BENCHMARK(RunSolve);

}  // namespace
