#include <gtest/gtest.h>

#include "prs/compare/compare_analysis.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/record/table_layout.h"
#include "prs/record/table_units.h"
#include "support/sample_result.h"
#include "support/text_lines.h"

namespace prs {
namespace {

using test::add_sweep;
using test::contains;
using test::equal_share_case;
using test::failed_case;
using test::lines;
using test::solved_case;
using test::widest_line;

TEST(LoadCaseTable, RowHoldsWhatADesignerAsksFirst) {
  Result result;
  result.load_cases = {solved_case("config1-tension", 45e3, Direction::tension)};
  const std::string row = lines(load_case_table(result)).at(4);
  for (const char* part : {"config1-tension", "45.000", "tension", "800.0", "56.25", "1:  7.7"})
    EXPECT_TRUE(contains(row, part)) << part << " in " << row;
}

TEST(LoadCaseTable, FailedCaseStandsOut) {
  Result result;
  result.load_cases = {failed_case("hopeless")};
  EXPECT_TRUE(contains(load_case_table(result), "NOT CONVERGED (line_search_failed), residual 3.2e-05"));
}

TEST(LoadCaseTable, AbsentQuantitiesAreDashes) {
  Result result;
  result.load_cases = {equal_share_case("equal")};
  EXPECT_TRUE(contains(lines(load_case_table(result)).at(2), "–"));
}

TEST(LoadCaseTable, ColumnsLineUpAndFit) {
  Result result;
  result.load_cases = {solved_case("µ-Hülse", 45e3, Direction::compression),
                       solved_case(std::string(200, 'x'), 45e6, Direction::compression)};
  const std::string table = load_case_table(result);
  EXPECT_LE(widest_line(table), 100);
  const auto rows = lines(table);
  const auto before = [](const std::string& row) { return width(row.substr(0, row.find("compression"))); };
  EXPECT_EQ(before(rows.at(4)), before(rows.at(5)));
}

TEST(ComparisonTable, HasTheUnitsOfTables) {
  Result result;
  result.load_cases = {solved_case("pull", 45e3, Direction::tension)};  // 800 N/µm
  ModelComparison comparison;
  comparison.models = {result};
  const TableUnits units(UnitSystem::us);
  const std::vector<std::string> table = lines(comparison_table(comparison));
  for (const char* unit : {"lbf/µin", "µin", "max. ksi"}) EXPECT_TRUE(contains(table.at(1), unit)) << table.at(1);
  EXPECT_TRUE(contains(table.at(2), " 4.5681 ")) << table.at(2);  // 175.126835 N/m each.
}

TEST(Tables, NumbersHaveFourDigitsAndNoExponent) {
  for (const auto& [value, shown] : {std::pair{10'500.4, "10500"},
                                     {1'189.31, "1189"},
                                     {3'766'754.0, "3767000"},
                                     {80.9934, "80.99"},
                                     {-0.0123449, "-0.01234"},
                                     {99'996.0, "100000"},
                                     {45.0, "45"}})
    EXPECT_EQ(significant(value), shown);
  EXPECT_EQ(significant(std::nullopt), kAbsent);
}

TEST(Tables, CellsOfRowsLineUpAndNoBlanksEndALine) {
  constexpr TableRows rows{6, 5, 1};
  EXPECT_EQ(rows("", {"kN", "µm"}, " "), "          kN    µm\n");
  EXPECT_EQ(rows("load", {"1.5", "–"}), "load     1.5     –\n");
  EXPECT_EQ(hanging("  what", 9, "a value"), "  what   a value\n");
}

TEST(LoadCaseTable, ManyPointsOfARangeFold) {
  Result result;
  add_sweep(result, "sweep-tension", Direction::tension, 45);
  result.load_cases[7] = failed_case("sweep-tension[7]");
  result.load_cases[7].load_case.direction = Direction::tension;
  const std::string table = load_case_table(result);
  EXPECT_EQ(lines(table).size(), 2 + 2 + 3 + 1);
  for (const char* part : {"sweep-tension[0]", "sweep-tension[22]", "sweep-tension[44]", "3 of 45 points",
                           "NOT CONVERGED: sweep-tension[7]"})
    EXPECT_TRUE(contains(table, part)) << part;
}

TEST(LoadCaseTable, WarningsThatDifferInNumbersOnlyAppearOnce) {
  Result result;
  result.warnings = {Warning{"", "backlash", "negative backlash"}};
  add_sweep(result, "sweep", Direction::tension, 45);
  for (std::size_t k = 30; k < 45; ++k)
    result.load_cases[k].warnings = {Warning{"", "pressure", "peak pressure {value} is high"}.with(
        (4.0 + 0.01 * static_cast<double>(k)) * 1e9, {}, "GPa"_unit)};
  const std::string table = load_case_table(result);
  EXPECT_TRUE(contains(table, "Warnings\n  negative backlash\n"));
  EXPECT_TRUE(contains(table, "  peak pressure 4.44 GPa is high\n"));
  EXPECT_TRUE(contains(table, "worst in sweep[44], and 14 other load cases\n"));
  EXPECT_LE(widest_line(table), 100);
}

TEST(LoadCaseTable, AWarningOnSeveralLoadsNamesTheirKeyOnce) {
  Result result;
  add_sweep(result, "sweep", Direction::tension, 3);
  const auto warn = [&](std::size_t k, const std::string& path) {
    result.load_cases[k].load_case.input_path = path;
    result.load_cases[k].warnings = {Warning{path + ".axial_force", "load", "high"}};
  };
  warn(0, "load_cases[4]");
  warn(1, "load_cases[4]");
  EXPECT_TRUE(contains(load_case_table(result), "  load_cases[4].axial_force: high\n"));
  warn(2, "load_cases[5]");
  EXPECT_TRUE(contains(load_case_table(result), "  load_cases[..].axial_force: high\n    in sweep[0–2]\n"));
}

TEST(LoadCaseTable, ControlCharactersDoNotReachTheTerminal) {
  Result result;
  result.load_cases = {failed_case("a\x1b[31m\nb")};
  const std::string table = load_case_table(result);
  EXPECT_FALSE(contains(table, "\x1b"));
  EXPECT_EQ(lines(table).size(), 5);
}

TEST(LoadDistributionChart, OneBarAThreadAndTheLargestIsLongest) {
  const std::string chart = load_distribution_chart(solved_case("a", 45e3, Direction::compression));
  EXPECT_EQ(lines(chart).size(), 2 + 20);
  EXPECT_TRUE(contains(chart, "mean 5.00 %"));
  EXPECT_TRUE(contains(lines(chart).at(2), "  1  ████████████████████████████████████ 7.7"));
  EXPECT_LE(widest_line(chart), 100);
}

TEST(LoadDistributionChart, FailedCaseSaysWhy) {
  EXPECT_EQ(load_distribution_chart(failed_case("b")), "b: no load distribution (line_search_failed)\n");
}

}  // namespace
}  // namespace prs
