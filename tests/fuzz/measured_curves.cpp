#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "modules/module.h"
#include "prs/run/commands.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/targets.h"
#include "tests/prs/input/abevi.h"

namespace prs::fuzz {
namespace {

using Json = nlohmann::ordered_json;

const std::string kOnTheBench = input::kShortAbevi + R"(load_cases: [{name: run, axial_force: 12 kN, share: equal}]
operation: {speed: 600 rpm}
friction: {coulomb: 0.1}
carrier: {screw_torque: 0.1 N m}
fit:
  parameters:
    - {path: friction.coulomb, from: 0.02, to: 0.4}
    - {path: carrier.screw_torque, from: 0 N m, to: 3 N m}
  curves:
    - file: bench.csv
      response: slip.torque_screw_Nm
      measured: {column: M_Nm, unit: N m}
      conditions: [{path: "load_cases[0].axial_force", column: F_kN, unit: kN}]
)";

std::optional<Json> fitted_to(const std::string& readings) {
  input::Source source = input::source_of_text("case.yaml", kOnTheBench, {});
  source.files.emplace().emplace("bench.csv", readings);
  try {
    const Delivery delivery = run(analysis_of(Command::fit), source);
    delivery.table();
    delivery.files({});
    return delivery.document(document_info(source, Command::fit)).at("fit");
  } catch (const input::InputError& error) {
    expect(std::string_view(error.what()).find(": error: ") != std::string_view::npos, error.what());
    return std::nullopt;
  }
}

}  // namespace

bool measured_curves(std::string_view input) {
  if (input.size() > 2'000) return false;
  std::string text(input);
  const std::optional<Json> fit = fitted_to(text);
  if (!fit) return false;
  expect_finite(*fit, "fit");
  expect_fitted(*fit);
  if (!fit->at("converged").get<bool>() || text.find('"') != std::string::npos) return true;

  // The rows in another order.
  std::vector<std::string> lines;
  for (std::size_t from = 0, to = 0; to != text.npos; from = to + 1) {
    to = text.find('\n', from);
    lines.push_back(text.substr(from, to == text.npos ? to : to - from));
  }
  if (!lines.back().empty() || text.find('#') != std::string::npos || text.find('\r') != std::string::npos) return true;
  lines.pop_back();
  const auto heading =
      std::ranges::find_if(lines, [](const std::string& line) { return line.find("M_Nm") != line.npos; });
  if (heading == lines.end()) return true;
  std::reverse(heading + 1, lines.end());
  std::string turned;
  for (const std::string& line : lines) turned += line + '\n';
  const std::optional<Json> again = fitted_to(turned);
  expect(again && again->at("status") == fit->at("status"), "rows in another order have another status");
  for (std::size_t k = 0; k < fit->at("parameters").size(); ++k) {
    const Json& one = fit->at("parameters")[k];
    const Json& other = again->at("parameters")[k];
    expect(one.contains("standard_deviation") == other.contains("standard_deviation"), "rows decide what is held");
    if (one.contains("standard_deviation"))
      expect(std::abs(one["value"].get<double>() - other["value"].get<double>()) <=
                 1e-2 * one["standard_deviation"].get<double>(),
             "the order of rows moves a value: " + one.dump() + other.dump());
  }
  return true;
}

}  // namespace prs::fuzz
