// `prs size` of a thousand designs with five segments on two threads, and a study that solves as
// many load cases of one of them.

#include <benchmark/benchmark.h>

#include <atomic>
#include <string>

#include "prs/input/study_reader.h"
#include "prs/size/size.h"
#include "prs/study/design_engine.h"
#include "prs/study/study_run.h"

namespace {

using namespace prs;

constexpr std::size_t kDesigns = 1000, kThreads = 2;

SizeInput requirement(const char* loads) {
  return read_requirement(input::source_of_text(
      "bench.yaml",
      std::string("motion: {segments: [{duration: 0.2 s, end_speed: 200 mm/s, force: 8 kN}, {duration: 2 "
                  "s, end_speed: 200 mm/s, force: 8 kN}, {duration: 0.2 s, end_speed: 0 mm/s, force: 8 "
                  "kN}, {duration: 0.2 s, end_speed: -200 mm/s, force: 2 kN}, {duration: 0.2 s, end_speed: "
                  "0 mm/s, force: 2 kN}]}\nload: {moved_mass: 50 kg, inclination: 90 deg}\n"
                  "life: {hours: 10000 h}\nlimits: {temperature: 80 degC}\n"
                  "motor: {rated_torque: 15 N m, peak_torque: 40 N m}\n"
                  "candidates: {designs: {screw_diameter: {from: 20 mm, to: 60 mm, steps: 40}, lead: "
                  "{from: 5 mm, to: 15 mm, steps: 25}}}\nmodel: {loads: ") +
          loads + "}\n",
      {}));
}

void size_of_a_thousand(benchmark::State& state, const char* loads) {
  const SizeInput in = requirement(loads);
  for (auto _ : state) {
    const SizeResult r = size_screws(in, {.threads = kThreads});
    benchmark::DoNotOptimize(r.candidates.data());
    state.counters["candidates"] = static_cast<double>(r.candidates.size());
  }
}

void study_of_as_many(benchmark::State& state, const char* loads) {
  const SizeInput in = requirement(loads);
  const SizeResult r = size_screws(in, {.threads = kThreads});
  const input::StudyInput study = input::read_study_input(
      input::source_of_text("bench.yaml",
                            written_candidate(in, r.candidates.front()) +
                                "study: {command: slip, plan: monte_carlo, samples: 1000, factors: [{path: "
                                "materials.youngs_modulus, within: 3 %}], responses: [slip.efficiency]}\n",
                            {}));
  const DesignEngine engine(study);
  for (auto _ : state) {
    std::atomic<std::size_t> next = 1;
    run_schedule(
        kThreads, engine.chunk(),
        [&](std::size_t most) -> std::optional<DesignRange> {
          const std::size_t first = next.fetch_add(most);
          if (first > kDesigns) return std::nullopt;
          return DesignRange{first, std::min(most, kDesigns + 1 - first)};
        },
        [&](std::size_t first, std::size_t count) { return engine.evaluate(first, count); },
        [](const std::string& record) { benchmark::DoNotOptimize(record.data()); });
  }
}

BENCHMARK_CAPTURE(size_of_a_thousand, at_rest, "static")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(size_of_a_thousand, running, "running")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(study_of_as_many, at_rest, "static")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(study_of_as_many, running, "running")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
