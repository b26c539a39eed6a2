#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "prs/input/echo.h"
#include "prs/run/commands.h"
#include "tests/fuzz/bounds.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/targets.h"
#include "tests/prs/input/abevi.h"

namespace prs::fuzz {
namespace {

using Json = nlohmann::ordered_json;

const std::string kWholeCase = "# A screw with most blocks.\n" + input::kAbeviThreads + R"(  rollers: 11  # all equal
  contacts_per_roller: 4
structure:
  screw: {bore: 6 mm, free_length: 10 mm}
  roller: {end_length: 5 mm, end_diameter: 5 mm, guidance: both_end_nodes}
  nut:
    length: 40 mm
    outer_diameter: 46 mm
    flanges:
      - {from: 0 mm, to: 10 mm, outer_diameter: 62 mm}
    thrust: {tension: 10 mm, compression: 40 mm}
materials: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}
deviations: {crowning: 1 um, pitch_error: {nut: {list: [0 um, 1 um, 0 um, -1 um]}}}
load_cases:
  - {name: "pull", axial_force: 19.7 kN, direction: tension, position: 10 mm}
  - name: push
    axial_force: {from: 1 kN, to: 9 kN, steps: 3}
    direction: compression
    position: 10 mm
lubricant: {viscosity: 100 mPa s, eyring_stress: 5 MPa, pressure_viscosity: 20 1/GPa}
friction: {model: {coulomb: 0.11}}
operation: {speed: 600 rpm}
)";

std::optional<Json> resolved(const input::Source& source) {
  try {
    input::read_case_input(source, Command::check);
    return input::resolved_input(source);
  } catch (const input::InputError& error) {
    const std::string_view what = error.what();
    expect(what.find(": error: ") != std::string_view::npos, std::string(what));
    return std::nullopt;
  }
}

}  // namespace

bool overrides(std::string_view input) {
  std::vector<std::string> arguments;
  while (!input.empty() && arguments.size() < 8) {
    arguments.emplace_back(input.substr(0, input.find('\n')));
    input.remove_prefix(std::min(arguments.back().size() + 1, input.size()));
  }
  const input::Source source = input::source_of_text("case.yaml", kWholeCase, std::move(arguments));
  const std::optional<Json> set = resolved(source);
  if (!set) return false;

  // Written into the file they must give the same case, and so must the stated input of the program.
  const std::optional<Json> again = resolved(input::source_of_text("case.yaml", set->dump(), {}));
  expect(again == set, "the echo of the echo is another one");
  if (const std::optional<std::string> text = input::written_case(source)) {
    const std::optional<Json> written = resolved(input::source_of_text("case.yaml", *text, {}));
    expect(written.has_value(), "the written case is refused:\n" + *text);
    expect(written == set, "the written case is another one:\n" + *text);
  }
  if (asks_for_much(source)) return true;
  try {
    const Delivery delivery = run(analysis_of(Command::check), source);
    expect_finite(delivery.document(document_info(source, Command::check)), "check");
    delivery.table();
  } catch (const input::InputError&) {  // Contradiction between values.
  }
  return true;
}

}  // namespace prs::fuzz
