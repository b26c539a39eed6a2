#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "prs/run/commands.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/targets.h"
#include "tests/prs/input/abevi.h"

namespace prs::fuzz {
namespace {

using Json = nlohmann::ordered_json;

const std::string kFlownCase = input::kShortAbevi + R"(life:
  position: 10 mm
  history:
    file: flight.csv
    force: {column: force_kN, unit: kN}
    time: {column: time_s, unit: s}
    position: {column: position_mm, unit: mm}
)";

/// The document of the case under a history; none if that is refused.
std::optional<Json> life_under(const std::string& history) {
  input::Source source = input::source_of_text("case.yaml", kFlownCase, {});
  source.files.emplace().emplace("flight.csv", history);
  try {
    const Delivery delivery = run(analysis_of(Command::life), source);
    delivery.table();
    delivery.files({});
    return delivery.document(document_info(source, Command::life));
  } catch (const input::InputError& error) {
    expect(std::string_view(error.what()).find(": error: ") != std::string_view::npos, error.what());
    return std::nullopt;
  }
}

void expect_same(const Json& a, const Json& b, const char* what) {
  const Json::json_pointer at(what);
  expect(a.contains(at) == b.contains(at) && (!a.contains(at) || std::abs(a[at].get<double>() - b[at].get<double>()) <=
                                                                     1e-6 * std::abs(a[at].get<double>())),
         fmt::format("{} moves with a sample that says nothing new", what));
}

}  // namespace

bool force_history(std::string_view input) {
  if (input.size() > 4'000) return false;
  std::string history(input);
  const std::optional<Json> life = life_under(history);
  if (!life) return false;
  expect_finite(*life, "life");
  const Json& loads = life->at("life").at("loads");
  const double samples = loads.at("samples").get<double>();
  expect(loads.value("mean_load_N", 0.0) <= loads.value("largest_force_N", 0.0) * (1.0 + 1e-12),
         "a mean above the largest force");
  if (life->at("life").contains("cycles"))
    expect(life->at("life").at("cycles").value("count", 0.0) <= 0.5 * samples, "more cycles than two samples give");

  // Repeats the last sample: no time passes, nothing moves.
  while (history.ends_with('\n') || history.ends_with('\r')) history.pop_back();
  const std::string last = history.substr(history.find_last_of("\r\n") + 1);
  if (history.find('"') != std::string::npos) return true;
  const std::optional<Json> longer = life_under(history + '\n' + last + '\n');
  expect(longer.has_value(), "refused with a sample once more");
  for (const char* what :
       {"/life/system/l10_revolutions", "/life/cycles/count", "/life/loads/mean_load_N", "/life/static_safety"})
    expect_same(*life, *longer, what);
  return true;
}

}  // namespace prs::fuzz
