#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "prs/run/commands.h"
#include "prs/size/size.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Names of `size` under which `check` has another one.
std::string name_in_check(const std::string& name) {
  if (name == "buckling") return "buckling_safety";
  return name == "critical_speed" ? "critical_speed_share" : name;
}

std::map<std::string, Json> criteria_of(const input::Source& source) {
  const Json document = run(analysis_of(Command::check), source).document(document_info(source, Command::check));
  std::map<std::string, Json> criteria;
  for (const Json& c : document["verdict"]["criteria"]) criteria[c["name"]] = c;
  return criteria;
}

/// A candidate, written as a case, has in `check` the numbers, units and limits that the list gives it. What needs a
/// motor or a duty of heat the case does not have.
void expect_one_set_of_numbers(const std::string& text) {
  const SizeResult result = size_screws(read_requirement(input::source_of_text("need.yaml", text, {})));
  ASSERT_FALSE(result.candidates.empty());
  for (const SizedCandidate& candidate : result.candidates) {
    const auto found =
        criteria_of(input::source_of_text("written.yaml", written_candidate(result.input, candidate), {}));
    std::size_t compared = 0;
    for (const SizeCriterion& c : candidate.criteria) {
      const auto own = found.find(name_in_check(std::string(c.name)));
      if (own == found.end() || !c.value || c.name == "temperature") continue;
      ++compared;
      EXPECT_NEAR(own->second["value"].get<double>() / *c.value, 1.0, 1e-9) << candidate.name << ": " << c.name;
      EXPECT_EQ(own->second["unit"], c.unit) << c.name;
      const double limit = c.limit.value_or(NAN);
      EXPECT_NEAR(own->second["limit"].get<double>() / limit, 1.0, 1e-9) << c.name;
      EXPECT_EQ(own->second["state"] == "green", c.status == CriterionStatus::pass) << c.name;
    }
    EXPECT_GE(compared, 7u) << candidate.name;
  }
}

const std::string kLimits =
    "limits: {stiffness: 100 N/um, efficiency: 70 %, weight: 9 kg, nut_length: 100 mm, nut_diameter: 90 mm}\n";
const std::string kPress =
    "motion:\n  segments:\n"
    "    - {name: down, duration: 0.5 s, end_speed: 200 mm/s}\n"
    "    - {name: press, duration: 1.4 s, end_speed: 30 mm/s, force: 30 kN}\n"
    "    - {name: stop, duration: 0.1 s, end_speed: 0 mm/s, force: 30 kN}\n"
    "    - {name: up, duration: 0.5 s, end_speed: -250 mm/s}\n"
    "    - {name: end, duration: 0.5 s, end_speed: 0 mm/s}\n"
    "    - {name: rest, duration: 1.5 s, end_speed: 0 mm/s}\n"
    "load: {moved_mass: 80 kg, inclination: -90 deg, resistance: 100 N, positive_force: compression}\n";

TEST(WrittenCandidate, HasOneSetOfNumbersInHours) {
  expect_one_set_of_numbers(kPress + kLimits + "life: {hours: 20000 h, reliability: 95 %}\n");
}

TEST(WrittenCandidate, HasOneSetOfNumbersInKilometresByThreads) {
  expect_one_set_of_numbers(kPress + kLimits + "life: {distance: 900 km, basis: threads}\n");
}

TEST(WrittenCandidate, OfAShaftShorterThanStrokeAndNutIsRefused) {
  const SizeResult result = size_screws(read_requirement(input::source_of_text("need.yaml", kPress, {})));
  const std::string text = written_candidate(result.input, result.candidates.front());
  EXPECT_THROW(criteria_of(input::source_of_text("written.yaml", text, {"measures.shaft.length=150 mm"})),
               input::InputError);
}

}  // namespace
}  // namespace prs
