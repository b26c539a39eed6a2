#include "prs/loads/load_analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "prs/loads/load_record.h"
#include "prs/record/csv_rows.h"

#include "support/parsed_csv.h"
#include "support/sample_result.h"

namespace prs {
namespace {

using test::equal_share_case;
using test::failed_case;
using test::parse;
using test::solved_case;

Result result_of(std::vector<LoadCaseResult> load_cases) {
  Result result;
  result.load_cases = std::move(load_cases);
  return result;
}

TEST(Csv, OneRowALoadCase) {
  const auto rows = parse(
      load_cases_csv(result_of({solved_case("a", 45e3, Direction::tension), failed_case("b"), equal_share_case("c")})));
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].at("case"), "a");
  EXPECT_EQ(std::stod(rows[0].at("axial_stiffness_N_per_um")), 800.0);
  EXPECT_EQ(rows[0].at("screw_most_loaded_thread"), "1");
  EXPECT_EQ(rows[0].at("converged"), "true");
  EXPECT_EQ(rows[1].at("status"), "line_search_failed");
  EXPECT_EQ(rows[1].at("axial_stiffness_N_per_um"), "");
  EXPECT_EQ(rows[1].at("nut_most_loaded_thread"), "");
  EXPECT_EQ(rows[2].at("axial_force_N"), "20000");
  EXPECT_EQ(rows[2].at("direction"), "");
  EXPECT_EQ(rows[2].at("iterations"), "");
  EXPECT_EQ(rows[2].at("nut_largest_peak_pressure_MPa"), "");
}

TEST(Csv, OneRowAThreadOfEveryAnswer) {
  LoadCaseResult load_case = solved_case("a", 45e3, Direction::tension);
  load_case.loads = ModelOptions::Loads::running;
  const auto rows = parse(load_distribution_csv(result_of({load_case, failed_case("b"), equal_share_case("c")})));
  ASSERT_EQ(rows.size(), 20 + 4);
  EXPECT_EQ(rows[19].at("thread"), "20");
  EXPECT_EQ(rows[19].at("loads"), "running");
  EXPECT_EQ(rows[20].at("loads"), "static");
  EXPECT_EQ(rows[20].at("case"), "c");
  EXPECT_EQ(rows[20].at("screw_semi_major_mm"), "");
}

TEST(Csv, FilesWithoutRowsHaveTheirHeader) {
  const std::string none = load_distribution_csv(result_of({failed_case("a")}));
  const std::string some = load_distribution_csv(result_of({solved_case("a", 45e3, Direction::tension)}));
  EXPECT_EQ(none, some.substr(0, some.find('\n') + 1));
}

TEST(Csv, NamesOfTheFirstRowAreTheHeaderAndHaveTheUnitsOfItsNumbers) {
  CsvRows csv(CsvStyle{});
  for (const double force : {1500.0, -20.0}) {
    csv("axial_force_kN", force);
    csv("share", 0.5);
    csv("at_um", std::optional<double>());
    csv.record("temperature_degC", PartNumbers{20.0, 30.0, 40.0}, "rollers");
    csv.record("mean_", std::optional<PartNumbers>(), "", "rollers");
    csv.end_row();
  }
  EXPECT_EQ(csv.take(),
            "axial_force_kN,share,at_um,temperature_rollers_degC,temperature_nut_degC,mean_screw\n"
            "1.5,0.5,,30,40,\n"
            "-0.02,0.5,,30,40,\n");
}

TEST(Csv, ALaterRowWithOtherFieldsIsAnError) {
  const auto write = [](std::initializer_list<const char*> second) {
    CsvRows csv(CsvStyle{});
    csv("force_kN", 1e3);
    csv.record("mean_", PartNumbers{20.0, 30.0, 40.0}, "", "rollers");
    csv.end_row();
    for (const char* name : second) csv(name, 1.0);
    csv.end_row();
  };
  EXPECT_NO_THROW(write({"force_kN", "mean_screw"}));
  EXPECT_THROW(write({"force_kN", "mean_nut"}), std::logic_error);
  EXPECT_THROW(write({"mean_screw", "force_kN"}), std::logic_error);
  EXPECT_THROW(write({"force_kN"}), std::logic_error);
  EXPECT_THROW(write({"force_kN", "mean_screw", "share"}), std::logic_error);
}

TEST(Csv, FieldsAreWrittenAsTheirTypesSay) {
  CsvWriter csv(CsvStyle{});
  csv.row("a,b", true, 3, std::optional<std::size_t>(), 0.5, scaled(std::nullopt, 1e3),
          std::vector<double>{1.5, std::nan("")}, std::vector<std::string>{"c", "d"});
  EXPECT_EQ(csv.take(), "\"a,b\",true,3,,0.5,,1.5,,c,d\n");
}

TEST(Csv, NumbersKeepAllDigits) {
  const LoadCaseResult load_case = solved_case("a", 12345.678, Direction::tension);
  const auto rows = parse(load_distribution_csv(result_of({load_case}), {.digits = CsvStyle::kAllDigits}));
  for (std::size_t k = 0; k < rows.size(); ++k)
    EXPECT_EQ(std::stod(rows[k].at("nut_axial_load_N")), load_case.threads->nut.axial_load[k]);
}

std::string field(double value, const CsvStyle& style) {
  CsvWriter csv(style, CsvWriter::Part::rows);
  csv.number(value);
  return csv.take();
}

TEST(Csv, NumbersHaveAsManySignificantDigitsAsAskedFor) {
  EXPECT_EQ(field(2.0 / 3.0, {}), "0.6666666667");
  EXPECT_EQ(field(-20e3, {}), "-20000");
  EXPECT_EQ(field(0.1, {}), "0.1");
  EXPECT_EQ(field(2e12 / 3.0, {}), "6.666666667e+11");
  EXPECT_EQ(field(2.0 / 3.0, {.digits = 3}), "0.667");
  EXPECT_EQ(field(0.1, {.digits = CsvStyle::kAllDigits}), "0.1");
  EXPECT_EQ(std::stod(field(2.0 / 3.0, {.digits = CsvStyle::kAllDigits})), 2.0 / 3.0);
}

/// A spreadsheet of a European locale reads `1.5` as a date.
TEST(Csv, EuropeanFilesHaveSemicolonsDecimalCommasAndTheMarkOfUtf8) {
  const CsvStyle european{.european = true};
  const LoadCaseResult load_case = solved_case("a; \"b\", c", 12345.5, Direction::tension);
  const std::string plain = load_distribution_csv(result_of({load_case}));
  const std::string csv = load_distribution_csv(result_of({load_case}), european);
  ASSERT_TRUE(csv.starts_with("\uFEFFcase;axial_force_N;"));
  auto fields = test::parse_fields(csv.substr(3), ';');
  EXPECT_EQ(fields[1][0], "a; \"b\", c");
  EXPECT_EQ(fields[1][1], "12345,5");
  for (auto& row : fields)
    for (std::size_t k = 1; k < row.size(); ++k) std::ranges::replace(row[k], ',', '.');
  EXPECT_EQ(fields, test::parse_fields(plain));

  CsvWriter rows(european, CsvWriter::Part::rows);
  for (const char* text : {"0.3", "0.3 mm", "a,b"}) rows.text(text);
  EXPECT_EQ(rows.take(), "0,3;0.3 mm;a,b");
}

TEST(Csv, NamesThatSpreadsheetsWouldComputeGetAnApostrophe) {
  for (const char* name : {"=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "-", "=\"x\"",
                           "-1 mm!A1", "- 5 mm"}) {
    const std::string csv = load_cases_csv(result_of({failed_case(name)}));
    EXPECT_NE(csv.find("\n\"'"), std::string::npos) << csv;
    EXPECT_EQ(parse(csv)[0].at("case"), std::string("'") + name);
  }
  for (const char* name : {"a=b", "-5", "+5.5e-3", "-0.02 mm", "-3 N/mm^1.5", "'=1", " =1"})
    EXPECT_EQ(parse(load_cases_csv(result_of({failed_case(name)})))[0].at("case"), name);
  const auto row = parse(load_cases_csv(result_of({solved_case("a", -45e3, Direction::tension)})))[0];
  EXPECT_EQ(row.at("axial_force_N"), "-45000");
}

TEST(Csv, NamesWithSeparatorsAreQuoted) {
  const std::string name = "45 kN, \"hot\"\nsecond line";
  const auto rows = parse(load_cases_csv(result_of({failed_case(name)})));
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].at("case"), name);
}

}  // namespace
}  // namespace prs
