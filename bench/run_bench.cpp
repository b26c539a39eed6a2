// What commands compute from a case that was read: the engine's part of a call from Python. To be
// run from the top of the repository, by bench/python_bench.py.

#include <benchmark/benchmark.h>

#include "prs/input/reader.h"
#include "prs/input/source.h"
#include "prs/run/analyses.h"

namespace {

template <auto run>
void measure(benchmark::State& state, prs::Command command, const char* file) {
  const prs::input::Source source = prs::input::load_source(file, {});
  const prs::Case c = prs::input::read_case_input(source, command).values;
  for (auto _ : state) benchmark::DoNotOptimize(run(source, c));
}

void RunContact(benchmark::State& state) {
  measure<prs::run_contact>(state, prs::Command::contact, "configs/08_design_by_backlash.yaml");
}
BENCHMARK(RunContact);

void RunSolve(benchmark::State& state) {
  measure<prs::run_solve>(state, prs::Command::solve, "configs/05_standard_screw.yaml");
}
BENCHMARK(RunSolve);

}  // namespace
