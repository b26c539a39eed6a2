#include <benchmark/benchmark.h>

#include "modules/response/response.h"
#include "prs/input/reader.h"

namespace {

using namespace prs;

ResponseResult run(const char* lesson, const std::vector<std::string>& overrides) {
  const input::Source source = input::load_source(std::string(PRS_SOURCE_DIR "/configs/").append(lesson), overrides);
  return analyze_response(input::read_case_input(source, Command::response).values, source);
}

/// Lesson 36 over some seconds of a slow sine: the difference of both benchmarks is one second, without the curves.
void SmoothServo(benchmark::State& state) {
  const std::vector<std::string> overrides = {
      fmt::format("response.duration={} s", state.range(0)), "response.sample_interval=1 ms",
      "response.motor.controller.position={sine: {amplitude: 5 mm, frequency: 2 Hz}}"};
  for (auto _ : state) benchmark::DoNotOptimize(run("36_servo_axis.yaml", overrides));
}
BENCHMARK(SmoothServo)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

/// Lesson 34 complete: curves, impacts, threads under the largest force.
void ReversalThroughPlay(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(run("34_reversal.yaml", {}));
}
BENCHMARK(ReversalThroughPlay)->Unit(benchmark::kMillisecond);

}  // namespace
