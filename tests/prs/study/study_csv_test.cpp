#include "prs/study/study_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../study/synthetic_study.h"
#include "prs/study/designs.h"
#include "prs/study/study_run.h"
#include "support/parsed_csv.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

using testing::ElementsAre;

std::string csv_of(const Study& study, const RowBlock& block) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  const StudyCsv csv(study, columns, {.digits = CsvStyle::kAllDigits});
  return csv.header() + csv.rows(block, factor_values(study, columns, block.first, block.rows));
}

TEST(StudyCsv, HasAColumnAFactorAndAResponse) {
  const Study study = test::synthetic_study(100);
  const auto fields = test::parse_fields(csv_of(study, test::synthetic_rows(0, 100)));
  EXPECT_THAT(fields[0],
              ElementsAre("design", "mechanism.pitch_diameter.screw_mm", "mechanism.profile.nut", "status", "reason",
                          "axial_stiffness_N_per_um", "slip.efficiency", "screw.load_rate_percent.max"));
  ASSERT_EQ(fields.size(), 101u);
  EXPECT_THAT(fields[1], ElementsAre("0", "30", "{concave: 7 mm}", "converged", "", "0", testing::_, testing::_));
  EXPECT_THAT(fields[14], ElementsAre("13", testing::_, testing::_, "failed", "design 13, \"no\"", "", "", ""));
}

TEST(StudyCsv, CompanionsHaveColumnsBesideTheirFactor) {
  Study study = test::synthetic_study(7);
  study.plan = Plan::grid;
  study.factors[0].distribution = {};
  study.factors[0].levels = {{"30 mm", 30.0}, {"31 mm", 31.0}, {"32 mm", 32.0}};
  Factor rollers{"mechanism.rollers", "rollers", "", {{"9", 9.0}, {"10", 10.0}, {"11", 11.0}}, {}};
  rollers.base = Level{"12", 12.0};
  study.factors[0].companions = {rollers};
  const auto rows = test::parse(csv_of(study, test::synthetic_rows(0, 7)));
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[0].at("mechanism.rollers"), "12");
  EXPECT_EQ(rows[4].at("mechanism.pitch_diameter.screw_mm"), "31");
  EXPECT_EQ(rows[4].at("mechanism.rollers"), "10");
  EXPECT_EQ(rows[4].at("mechanism.profile.nut"), "{convex: 6 mm}");
}

TEST(StudyCsv, NumbersComeBackToTheLastBit) {
  const Study study = test::synthetic_study(300);
  const RowBlock block = test::synthetic_rows(40, 200);
  const auto rows = test::parse(csv_of(study, block));
  ASSERT_EQ(rows.size(), 200u);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(rows[row].at("design"), std::to_string(40 + row));
    const std::vector<Draw> drawn = draws(study, 40 + row);
    EXPECT_EQ(std::stod(rows[row].at("mechanism.pitch_diameter.screw_mm")), drawn[0].number);
    EXPECT_EQ(rows[row].at("mechanism.profile.nut"), study.factors[1].levels[drawn[1].level].text);
    for (std::size_t j = 0; j < test::kResponses; ++j) {
      const std::string& text = rows[row].at(study.responses[j]);
      const double value = block.responses[row * test::kResponses + j];
      EXPECT_TRUE(text.empty() ? std::isnan(value) : std::stod(text) == value) << text;
    }
  }
}

TEST(StudyCsv, OneAtATimeTellsTheValueThatDiffers) {
  Study study = test::synthetic_study(1);
  study.plan = Plan::one_at_a_time;
  study.factors[0].distribution = {};
  study.factors[0].levels = {{"30 mm", 30.0}, {"31 mm", 31.0}};
  const auto rows = test::parse(csv_of(study, test::synthetic_rows(0, 5)));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].at("factor"), "");
  EXPECT_EQ(rows[0].at("base"), "true");
  EXPECT_EQ(rows[1].at("base"), "true");  // The file's own value.
  EXPECT_EQ(rows[2].at("factor"), "mechanism.pitch_diameter.screw");
  EXPECT_EQ(rows[2].at("label"), "screw, \"d\"");
  EXPECT_EQ(rows[2].at("value"), "31 mm");
  EXPECT_EQ(rows[2].at("number"), "31");
  EXPECT_EQ(rows[2].at("unit"), "mm");
  EXPECT_EQ(rows[2].at("base"), "false");
  EXPECT_EQ(rows[4].at("value"), "{convex: 6 mm}");
  EXPECT_EQ(rows[4].at("number"), "");
  EXPECT_EQ(rows[4].at("unit"), "");
}

TEST(UnitKey, IsThatOfTheDocuments) {
  EXPECT_EQ(unit_key("mm"), "mm");
  EXPECT_EQ(unit_key("N/mm^1.5"), "N_per_mm1_5");
  EXPECT_EQ(unit_key("1/GPa"), "per_GPa");
  EXPECT_EQ(unit_key("kg/m^3"), "kg_per_m3");
  EXPECT_EQ(unit_key("mPa s"), "mPas");
  EXPECT_EQ(unit_key("%"), "percent");
}

TEST(FactorColumns, OfOnePathHaveDifferentNames) {
  Study study = test::synthetic_study(10);
  study.factors.push_back(study.factors[0]);
  study.factors[1].base.reset();
  const std::vector<FactorColumn> columns = factor_columns(study);
  EXPECT_EQ(columns[2].name, "mechanism.pitch_diameter.screw_mm_2");
  EXPECT_EQ(columns[0].base, 30.0);
  EXPECT_TRUE(std::isnan(columns[1].base));  // The file has no value.
}

TEST(WriteRows, GivesTheSameFilesForAnyBlocksAndThreads) {
  constexpr std::size_t kDesigns = 40'000;
  const Study study = test::synthetic_study(kDesigns);
  std::string csv;
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const test::TemporaryDirectory temporary;
    const RunDesigns run = [&](const NextRange& next, const TakeRecord& take) {
      run_schedule(threads, 100 * threads + 7, next, test::synthetic_rows, take);
    };
    const StoredRows rows = run_study(test::synthetic_header(kDesigns), nullptr, run, {});
    std::size_t told = 0;
    const auto tell = [&](const RowBlock& block, std::span<const double>) {
      EXPECT_EQ(block.first, told);
      told += block.rows;
    };
    write_rows(rows, study, &temporary.path(), threads, tell);
    EXPECT_EQ(told, kDesigns);
    if (threads == 1) csv = test::content_of(temporary.path() / "study.csv");
    EXPECT_TRUE(test::content_of(temporary.path() / "study.csv") == csv) << threads;
  }
}

}  // namespace
}  // namespace prs
