// A day of flight data, 1 million samples with about 50,000 cycles, on the Abevi screw (CONFIG 2):
// each step of `prs life` alone, and together without files. Compare ratios, not times.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/life/analyze_life.h"
#include "tests/prs/input/abevi.h"

namespace {

constexpr std::size_t kSamples = 1'000'000;

const std::string kLife = R"(life:
  position: 29.1666667 mm
  history:
    file: day.csv
    force: {column: force, unit: kN}
    position: {column: position, unit: mm}
    interval: 86.4 ms
)";

/// Swings of 20 samples on the slow course of a flight, with a tenth of noise.
const prs::LoadHistory& day() {
  static const prs::LoadHistory history = [] {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 1.0);
    prs::LoadHistory h;
    h.interval = 86.4e-3;
    for (std::size_t k = 0; k < kSamples; ++k) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(k);
      const double swing = (3.0 + noise(random) * 1e-3) * std::sin(turn / 20.0);
      h.force.push_back(1e3 * (12.0 * std::sin(turn / 83333.0) + 2.0 + swing));
      h.position.push_back(40e-3 * std::sin(turn / 10417.0) + 4e-3 * std::sin(turn / 20.0));
    }
    return h;
  }();
  return history;
}

void Rainflow(benchmark::State& state) {
  const prs::LoadHistory& h = day();
  std::size_t cycles = 0;
  for (auto _ : state) cycles = prs::rainflow(h.force, 50.0).size();
  state.counters["cycles"] = static_cast<double>(cycles);
}
BENCHMARK(Rainflow)->Unit(benchmark::kMillisecond);

void ReadCsv(benchmark::State& state) {
  const prs::LoadHistory& h = day();
  std::string text = "force,position\n";
  for (std::size_t k = 0; k < kSamples; ++k)
    text += fmt::format("{:.5f},{:.4f}\n", 1e-3 * h.force[k], 1e3 * h.position[k]);
  const prs::input::Source source{"case.yaml", prs::input::kAbevi + kLife, {}};
  const prs::Case c = prs::input::read_case_text(source.text, source.name, {}, prs::Command::life);
  for (auto _ : state)
    benchmark::DoNotOptimize(prs::input::parse_force_history(text, "day.csv", *c.life->history, source));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}
BENCHMARK(ReadCsv)->Unit(benchmark::kMillisecond);

void AnalyzeLife(benchmark::State& state) {
  const prs::Case c = prs::input::read_case_text(prs::input::kAbevi + kLife, "case.yaml", {}, prs::Command::life);
  for (auto _ : state) {
    const prs::LifeResult r = prs::analyze_life(c, day());
    state.counters["equilibria"] = r.flanks.tension->solves + r.flanks.compression->solves;
  }
}
BENCHMARK(AnalyzeLife)->Unit(benchmark::kMillisecond);

}  // namespace
