#include "prs/run/compare_cases.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "prs/run/commands.h"
#include "tests/support/program.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

input::Source slip_lesson(std::vector<std::string> overrides = {}) {
  return input::load_source(PRS_SOURCE_DIR "/configs/09_slip_and_dissipation.yaml", std::move(overrides));
}

Json compared(const input::Source& a, const input::Source& b) {
  return compare_cases(a, b).document(document_info(a, Command::compare));
}

Json solved(const input::Source& source) {
  return run(analysis_of(Command::solve), source).document(document_info(source, Command::solve));
}

const Json& row(const Json& rows, const std::string& path, const std::string& load_case = "") {
  const auto found = std::ranges::find_if(
      rows, [&](const Json& r) { return r["path"] == path && (load_case.empty() || r["load_case"] == load_case); });
  if (found == rows.end()) throw std::runtime_error("no row " + path);
  return *found;
}

TEST(CompareCases, TellsTheInputsThatDifferAndEachResultAsItsCommandHasIt) {
  const input::Source a = slip_lesson(), b = slip_lesson({"mechanism.lead=6 mm", "load_cases[0].speed=300 rpm"});
  const Json both = compared(a, b), first = solved(a), second = solved(b);
  ASSERT_EQ(both["inputs"].size(), 2u) << both["inputs"];
  EXPECT_EQ(row(both["inputs"], "mechanism.lead")["other_value"], "6 mm");
  EXPECT_NEAR(row(both["inputs"], "mechanism.lead")["change_percent"].get<double>(), 20.0, 1e-9);
  for (std::size_t k = 0; k < first["load_cases"].size(); ++k) {
    const std::string key = "axial_stiffness_N_per_um";
    if (!first["load_cases"][k].contains(key)) continue;  // Keys of equal shares.
    const double before = first["load_cases"][k][key], after = second["load_cases"][k][key];
    const Json& found = row(both["results"], key, first["load_cases"][k]["name"]);
    EXPECT_EQ(found["value"], before);
    EXPECT_EQ(found["other_value"], after);
    EXPECT_NEAR(found["change_percent"].get<double>(), 100.0 * (after / before - 1.0), 1e-9);
  }
  EXPECT_NO_THROW(row(both["results"], "slip.efficiency"));
}

TEST(CompareCases, ACaseDoesNotDifferFromItself) {
  const Json both = compared(slip_lesson(), slip_lesson());
  EXPECT_THAT(both["inputs"], IsEmpty());
  ASSERT_GT(both["results"].size(), 5u);
  for (const Json& result : both["results"]) {
    EXPECT_EQ(result["value"], result["other_value"]) << result;
    EXPECT_EQ(result.value("change_percent", 0.0), 0.0) << result;
  }
}

TEST(CompareCases, CurvesOfTheSecondStandBehindThoseOfTheFirst) {
  const input::Source a = slip_lesson(), b = slip_lesson({"structure.nut.outer_diameter=60 mm"});
  const auto drawn = [](const input::Source& source) {
    return figures(run(analysis_of(Command::solve), source).pictures());
  };
  const Figures overlaid = figures(compare_cases(a, b).pictures()), own = drawn(a), other = drawn(b);
  ASSERT_FALSE(own.empty());
  ASSERT_FALSE(overlaid.empty());
  for (std::size_t f = 0; f < own.size(); ++f) {
    const auto both = std::ranges::find(overlaid, own[f].name, &Figure::name);
    if (both == overlaid.end()) continue;
    EXPECT_EQ(both->legend.back().title, b.name);
    for (std::size_t p = 0; p < own[f].panels.size(); ++p) {
      const auto& series = both->panels[p].series;
      ASSERT_EQ(series.size(), own[f].panels[p].series.size() + other[f].panels[p].series.size());
      EXPECT_EQ(series.front().parts, other[f].panels[p].series.front().parts);
      EXPECT_EQ(series.back().parts, own[f].panels[p].series.back().parts);
    }
  }
  EXPECT_THAT(overlaid, Contains(testing::Field(&Figure::name, HasSubstr("load_distribution"))));
  EXPECT_THAT(overlaid, testing::Not(Contains(testing::Field(&Figure::name, "power_by_source"))));
}

TEST(CompareCases, TheProgramTakesTwoFilesAndNamesTheOneThatIsWrong) {
  const std::string one = "configs/09_slip_and_dissipation.yaml";
  const test::Outcome both = test::run_prs("compare " + one + " configs/04_contacts_from_geometry.yaml");
  EXPECT_EQ(both.status, 0) << both.err;
  EXPECT_THAT(both.out, AllOf(HasSubstr("Inputs that differ"), HasSubstr("axial stiffness (N/µm)"),
                              HasSubstr("slip: " + one + " alone has all for it")));
  EXPECT_THAT(test::run_prs("compare " + one).out, HasSubstr("refined"));
  const test::Outcome missing = test::run_prs("compare " + one + " none.yaml");
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, HasSubstr("none.yaml:1:1: error: got no such file"));
  EXPECT_EQ(test::run_prs("compare " + one + " -").status, 2);
}

}  // namespace
}  // namespace prs
