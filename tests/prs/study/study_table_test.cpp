#include "prs/study/study_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

#include "prs/record/table_units.h"
#include "prs/study/study_pictures.h"
#include "prs/text.h"
#include "tests/support/sample_study.h"

namespace prs {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

void expect_narrow(const std::string& table) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(width(line), 100U) << line;
}

TEST(StudyTable, MarksTheBaseCaseInItsPlaceAndGivesReasons) {
  const std::string table = study_table(sample::counting());
  const std::size_t one = table.find("\n  1 "), base = table.find("\n* 2 "), three = table.find("\n  3 ");
  ASSERT_NE(base, std::string::npos) << table;
  EXPECT_LT(one, base);
  EXPECT_LT(base, three);
  EXPECT_THAT(table, HasSubstr("1 of 4 designs, the base case included, without an answer\n  x=3 refused: mechanism"));
}

TEST(StudyTable, RankingComesFirst) {
  const std::string table = study_table(sample::sampled(Plan::latin_hypercube));
  EXPECT_THAT(table, testing::StartsWith("latin_hypercube: 500 designs, seed 7\n\n"
                                         "largest peak pressure, screw (MPa): contributions"));
  const std::size_t a = table.find("  1  flank angle"), b = table.find("  2  b "), mean = table.find("mean");
  ASSERT_NE(a, std::string::npos) << table;
  EXPECT_LT(a, b);
  EXPECT_LT(b, mean);
  EXPECT_THAT(table, AllOf(HasSubstr("+75.00 %"), HasSubstr("-25.00 %"), HasSubstr("R² = 1.0000")));
  // The other response is a product without a linear part.
  EXPECT_THAT(table, HasSubstr("little of it is linear"));
  EXPECT_THAT(table, Not(HasSubstr("without an answer")));
  expect_narrow(table);
}

/// Numbers after a label that begins a line, beside it or below it.
std::vector<double> numbers_of(const std::string& table, const std::string& label) {
  const std::size_t line = table.rfind("\n" + label);
  if (line == std::string::npos) return {};
  std::istringstream cells(table.substr(line + 1 + label.size()));
  return {std::istream_iterator<double>(cells), {}};
}

TEST(StudyTable, ResponsesHaveTheUnitsOfTables) {
  const StudyResult study = sample::sampled(Plan::latin_hypercube);
  const std::vector<double> si = numbers_of(study_table(study), "largest peak pressure, screw (MPa)\n");
  const TableUnits units(UnitSystem::us);
  const std::vector<double> us = numbers_of(study_table(study), "largest peak pressure, screw (ksi)\n");
  ASSERT_THAT(si, testing::SizeIs(7));
  ASSERT_THAT(us, testing::SizeIs(7));
  for (std::size_t k = 0; k < si.size(); ++k)  // NIST SP 811, appendix B.8; four digits are shown.
    EXPECT_NEAR(us[k] * 6.894757, si[k], 1e-3 * std::abs(si[k]));
}

TEST(StudyTable, SharesOfTheVarianceHaveTheirIntervals) {
  const std::string table = study_table(sample::sampled(Plan::sobol_indices, 512));
  EXPECT_THAT(table, AllOf(HasSubstr("largest peak pressure, nut (MPa): shares of the variance, 512"),
                           HasSubstr("with others"), HasSubstr("±")));
  EXPECT_THAT(table, Not(HasSubstr("linear response surface")));
  expect_narrow(table);
}

TEST(StudyTable, GridShowsItsExtremes) {
  Study study;
  study.plan = Plan::grid;
  study.factors = {sample::counted("x", {1.0, 3.0, 4.0}), sample::counted("y", {2.0, 5.0})};
  study.responses = {"sum"};
  const std::string table = study_table(sample::run(study, [](const std::vector<double>& x) {
    return x[0] == 3.0 ? std::vector<double>{} : std::vector{x[0] + x[1]};
  }));
  EXPECT_THAT(table,
              AllOf(HasSubstr("grid: 6 designs\n"), HasSubstr("min 3: x 1, y 2\n"), HasSubstr("max 9: x 4, y 5\n"),
                    HasSubstr("2 of 7 designs, the base case included, without an answer\n  x=3, y=2 refused")));
  expect_narrow(table);
}

TEST(StudyTable, SaysWhyThereIsNoRanking) {
  EXPECT_THAT(study_table(sample::sampled(Plan::monte_carlo, 3)),
              HasSubstr("no response surface: 3 designs with all responses do not determine 4"));
}

TEST(StudyTable, ProgressTellsRateAndTimeLeft) {
  EXPECT_EQ(progress_line(50, 100, 0.5), "50 of 100 designs, 100 a second, 0:01 left");
  EXPECT_EQ(progress_line(1, 1201, 1.0), "1 of 1201 designs, 1.0 a second, 20:00 left");
  EXPECT_EQ(progress_line(1, 7201, 1.0), "1 of 7201 designs, 1.0 a second, 2:00:00 left");
  EXPECT_EQ(progress_line(0, 5, 0.0), "0 of 5 designs");
  EXPECT_EQ(progress_line(60, 100, 0.5, 10), "60 of 100 designs (10 from the journal), 100 a second, 0:01 left");
}

TEST(StudyText, TitlesAreForPeople) {
  EXPECT_EQ(table_response("screw.peak_pressure_MPa.max").text(), "largest peak pressure, screw (MPa)");
  EXPECT_EQ(table_response("slip.share_percent.carrier_nut").text(), "share, carrier nut (%)");
  EXPECT_EQ(table_response("axial_stiffness_N_per_um").text(), "axial stiffness (N/µm)");
  EXPECT_EQ(table_response("slip.efficiency").text(), "efficiency");
  EXPECT_EQ(table_response("screw.load_rate_percent[0]").text(), "share of the load, screw, thread 1 (%)");
  EXPECT_EQ(table_response("contact.nut.body_curvatures_per_mm[1]").text(), "body curvatures[1], nut (1/mm)");
  EXPECT_EQ(level_text({"54.33333333333333 mm", 54.33333333333333}, "mm"), "54.3333 mm");
  EXPECT_EQ(level_text({"{convex: 6.25123456 mm}", 0.16}, "1/mm"), "{convex: 6.25123456 mm}");
  EXPECT_EQ(factor_title(sample::counted("mechanism.rollers", {})), "mechanism.rollers");
  EXPECT_EQ(factor_title(sample::counted("mechanism.rollers", {}, "number of rollers")), "Number of rollers");
  EXPECT_EQ(factor_title(sample::counted("mechanism.rollers", {}, "n_R")), "n_R");
}

}  // namespace
}  // namespace prs
