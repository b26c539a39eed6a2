// A fit of 4 unknowns to 3 curves of 40 rows on one thread: torque, lost power and travel of lesson
// 37's screw, file and evaluation included.

#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>

#include "modules/fit/fit.h"

namespace {

prs::input::Source three_curves() {
  std::ifstream in(PRS_SOURCE_DIR "/configs/37_bench.yaml");
  prs::input::Source source{.name = "bench.yaml", .text = {std::istreambuf_iterator<char>(in), {}}, .overrides = {}};
  std::string torque = "force_kN,torque_Nm\n", loss = "force_kN,speed,power\n", travel = "force_kN,travel_um\n";
  for (int k = 0; k < 40; ++k) {
    const double force = 1.0 + 0.5 * k, noise = (k * 7919 % 13) / 13.0 - 0.5;
    torque += fmt::format("{},{}\n", force, 0.18 + 0.96 * force + 0.1 * noise);
    loss += fmt::format("{},{},{}\n", force, 400 + 400 * (k % 2), (7.2 * force + 14.0) * (1 + k % 2) + 4.0 * noise);
    travel += fmt::format("{},{}\n", force - 10.4, 4.0 + (force > 10.4 ? 17.0 : -17.0) + 1.65 * (force - 10.4) + noise);
  }
  source.files = {{"37_torque.csv", torque}, {"loss.csv", loss}, {"37_travel.csv", travel}};
  source.overrides = {
      "fit.bands=[]", "fit.profile=false",
      "fit.curves[0]={name: loss, file: loss.csv, response: slip.power_loss_W, measured: {column: power, unit: W}, "
      "loss: huber, conditions: [{path: 'load_cases[0].axial_force', column: force_kN, unit: kN}, {path: "
      "operation.speed, column: speed, unit: rpm}]}"};
  const std::string text =
      "    - {name: torque, file: 37_torque.csv, response: slip.torque_screw_Nm, measured: {column: "
      "torque_Nm, unit: N m}, conditions: [{path: 'load_cases[0].axial_force', column: force_kN, "
      "unit: kN}]}\n";
  const std::string head = "  curves:\n";
  source.text.insert(source.text.find(head) + head.size(), text);
  source.overrides.back().replace(0, std::string("fit.curves[0]").size(), "fit.curves[1]");
  return source;
}

void fit(benchmark::State& state, const std::vector<std::string>& overrides) {
  prs::input::Source source = three_curves();
  source.overrides.insert(source.overrides.end(), overrides.begin(), overrides.end());
  for (auto _ : state) {
    const prs::FitResult result = prs::fit_case(source, {.threads = 1});
    if (!result.converged()) state.SkipWithError("no fit");
    state.counters["iterations"] = static_cast<double>(result.found.iterations);
    state.counters["rows"] = static_cast<double>(result.evaluations);
  }
}

BENCHMARK_CAPTURE(fit, equal_shares, {})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, static_loads,
                  {"load_cases[0]={name: run, axial_force: 12 kN, direction: tension, position: 31 mm}",
                   "model.loads=static"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
