#include "prs/study/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "prs/analyze.h"
#include "prs/input/reader.h"
#include "prs/output/response_title.h"
#include "prs/output/study_figures.h"
#include "prs/output/study_files.h"
#include "prs/output/study_table.h"
#include "tests/prs/input/abevi.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// A design without a solver: y = number of the override's value.
Answer echo_number(const std::vector<std::string>& overrides) {
  const double x =
      overrides.empty() ? 2.0 : std::stod(overrides[0].substr(overrides[0].find('=') + 1));
  if (x == 3.0) return {{"refused", "mechanism.rollers: got 3; expected, say, 4"}};
  return {{}, {{"load_cases", {{{"y", 10.0 * x}, {"z", {x, 1.0}}}}}}};
}

Study counting_study() {
  Study study;
  study.command = Command::solve;
  Factor factor;
  factor.path = "x";
  factor.label = "the x";
  factor.levels = {{"1", 1.0}, {"3", 3.0}, {"4", 4.0}};
  factor.base = Level{"2", 2.0};
  study.factors = {factor};
  study.responses = {"y", "z.max"};
  return study;
}

TEST(StudyRun, RecordsTheResponsesOfEveryDesign) {
  std::vector<std::size_t> progress;
  const StudyResult result =
      run_study(counting_study(), echo_number,
                [&](std::size_t done, std::size_t) { progress.push_back(done); });
  ASSERT_THAT(result.rows, SizeIs(4));
  EXPECT_THAT(result.base().responses, ElementsAre(20.0, 2.0));
  EXPECT_THAT(result.rows[3].responses, ElementsAre(40.0, 4.0));
  EXPECT_THAT(progress, ElementsAre(1, 2, 3, 4));
}

TEST(StudyRun, FailedDesignIsARowWithItsReason) {
  const StudyRow row = run_study(counting_study(), echo_number).rows[2];
  EXPECT_EQ(row.status.name, "refused");
  EXPECT_THAT(row.status.reason, HasSubstr("got 3"));
  EXPECT_THAT(row.responses, ElementsAre(std::nullopt, std::nullopt));
}

TEST(StudyRun, UnknownResponseNamesTheNearest) {
  Study study = counting_study();
  study.responses = {"y", "z.mx"};
  try {
    run_study(study, echo_number);
    FAIL();
  } catch (const UnknownResponse& error) {
    EXPECT_EQ(error.index(), 1U);
    EXPECT_THAT(error.what(), HasSubstr("did you mean `z.max`?"));
  }
}

TEST(StudyRun, DesignGivesWhatTheCommandGives) {
  const std::string study =
      "study: {command: solve, factors: [{path: mechanism.rollers, values: [9, 60]}], responses: "
      "[axial_displacement_um]}\n";
  const input::StudyInput in = input::read_study_input({"case.yaml", input::kAbevi + study, {}});
  const StudyResult result =
      run_study(in.study, [&](const auto& overrides) { return solve_design(in, overrides); });
  const Result direct = analyze(
      input::read_case_text(input::kAbevi, "case.yaml", {"mechanism.rollers=9"}, Command::solve));
  EXPECT_EQ(result.rows[1].responses[0], *direct.load_cases[0].axial_displacement * 1e6);
  EXPECT_EQ(result.rows[2].status.name, "refused");
  EXPECT_THAT(result.rows[2].status.reason, testing::StartsWith("mechanism.rollers: got 60"));
}

/// The lesson, on what the thesis says of it.
class ParametricStudy : public testing::Test {
 protected:
  static StudyResult run(const std::vector<std::string>& overrides = {}) {
    const input::StudyInput in = input::read_study_input(
        input::load_source(PRS_SOURCE_DIR "/configs/10_parametric_study.yaml", overrides));
    return run_study(in.study, [&](const auto& design) { return solve_design(in, design); });
  }
  static std::vector<const StudyRow*> rows(const StudyResult& result, const std::string& path) {
    std::vector<const StudyRow*> found;
    for (const StudyRow& row : result.rows)
      if (!row.design.settings.empty() && row.status.converged() &&
          result.study.factors[row.design.settings[0].factor].path == path)
        found.push_back(&row);
    return found;
  }
};

TEST_F(ParametricStudy, ReproducesSandu) {
  const StudyResult result = run();
  const SlipResult& base = *result.base().slip;
  EXPECT_NEAR(*base.efficiency, 0.786, 0.002);  // Sandu 2018, section 3.3.
  EXPECT_GT(base.power.screw, 0.9 * base.power.total());
  const auto spread = [&](const std::string& path) {
    double least = 1.0, largest = 0.0;
    for (const StudyRow* row : rows(result, path)) {
      least = std::min(least, *row->slip->efficiency);
      largest = std::max(largest, *row->slip->efficiency);
    }
    return largest - least;
  };
  for (const char* path : {"mechanism.pitch_diameter.screw", "mechanism.lead", "mechanism.rollers",
                           "mechanism.profile.screw", "mechanism.profile.roller"})
    EXPECT_LT(spread(path), 0.012) << path;
  EXPECT_GT(spread("lubricant.viscosity"), 0.15);
  EXPECT_GT(spread("lubricant.eyring_stress"), 0.25);

  // Power grows with the speed in proportion, within what the film changes.
  for (const StudyRow* row : rows(result, "operation.speed"))
    EXPECT_NEAR(row->slip->power.total() / row->slip->speed, base.power.total() / base.speed,
                0.03 * base.power.total() / base.speed);
  // The fit (3.55) lies near.
  for (const StudyRow* row : rows(result, "lubricant.viscosity"))
    EXPECT_NEAR(*row->slip->efficiency_fit, *row->slip->efficiency, 0.006);
}

TEST_F(ParametricStudy, LevelOfTheFileGivesTheBaseCase) {
  const StudyResult result = run();
  int found = 0;
  for (const StudyRow& row : result.rows) {
    if (!is_base(result.study, row.design)) continue;
    ++found;
    EXPECT_NEAR(*row.slip->efficiency, *result.base().slip->efficiency, 1e-12);
  }
  EXPECT_GE(found, 9);
}

TEST_F(ParametricStudy, HasAFigureAFactorWithTheBaseCaseMarked) {
  const StudyResult result = run();
  const std::vector<Figure> figures = study_figures(result);
  ASSERT_EQ(figures.size(), result.study.factors.size());
  for (const Figure& figure : figures) {
    EXPECT_TRUE(std::ranges::any_of(figure.legend, [](const LegendEntry& entry) {
      return entry.title == "as in the file";
    })) << figure.name;
    EXPECT_LT(figure.x.from, figure.x.to);
  }
  EXPECT_THAT(gnuplot_script(figures[8]), HasSubstr("set logscale x"));
}

TEST(StudyOutput, CsvHasARowADesign) {
  const std::string csv = study_csv(run_study(counting_study(), echo_number));
  EXPECT_EQ(csv,
            "design,factor,label,value,number,unit,base,status,reason,y,z.max\n"
            "0,,,,,,true,converged,,20,2\n"
            "1,x,the x,1,1,,false,converged,,10,1\n"
            "2,x,the x,3,3,,false,refused,\"mechanism.rollers: got 3; expected, say, 4\",,\n"
            "3,x,the x,4,4,,false,converged,,40,4\n");
}

TEST(StudyOutput, DocumentLeavesOutWhatIsNotDefined) {
  const auto json = study_json(run_study(counting_study(), echo_number), {"1", "2", "", {}});
  EXPECT_EQ(json["study"]["command"], "solve");
  EXPECT_EQ(json["study"]["factors"][0]["base"]["value"], "2");
  ASSERT_EQ(json["designs"].size(), 4U);
  EXPECT_TRUE(json["designs"][0]["settings"].empty());
  EXPECT_EQ(json["designs"][1]["settings"]["x"]["value"], "1");
  EXPECT_EQ(json["designs"][1]["responses"]["y"], 10.0);
  EXPECT_FALSE(json["designs"][2]["converged"]);
  EXPECT_TRUE(json["designs"][2]["responses"].empty());
}

TEST(StudyOutput, TableMarksTheBaseCaseInItsPlaceAndGivesReasons) {
  const std::string table = study_table(run_study(counting_study(), echo_number));
  const std::size_t one = table.find("\n  1 "), base = table.find("\n* 2 "),
                    three = table.find("\n  3 ");
  ASSERT_NE(base, std::string::npos) << table;
  EXPECT_LT(one, base);
  EXPECT_LT(base, three);
  EXPECT_THAT(table, HasSubstr("1 of 4 designs without an answer\n  x=3 refused: mechanism"));
}

TEST(StudyOutput, FiguresOfResponsesLeaveGaps) {
  const std::vector<Figure> figures = study_figures(run_study(counting_study(), echo_number));
  ASSERT_THAT(figures, SizeIs(2));
  const std::vector<Line>& lines = figures[0].panels.at(0).lines;
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_THAT(lines[0].parts,
              ElementsAre(Polyline{{1.0, 10.0}, {2.0, 20.0}}, Polyline{{4.0, 40.0}}));
  EXPECT_THAT(lines[1].parts, ElementsAre(Polyline{{2.0, 20.0}}));
}

TEST(StudyOutput, TitlesAreForPeople) {
  const auto title = [](const char* path) {
    const ResponseTitle t = response_title(path);
    return t.name + "|" + t.unit;
  };
  EXPECT_EQ(title("screw.peak_pressure_MPa.max"), "max screw peak pressure|MPa");
  EXPECT_EQ(title("slip.share_percent.carrier_nut"), "carrier nut share|%");
  EXPECT_EQ(title("axial_stiffness_N_per_um"), "axial stiffness|N/µm");
  EXPECT_EQ(title("slip.efficiency"), "efficiency|");
}

TEST(StudyOutput, ProgressTellsRateAndTimeLeft) {
  EXPECT_EQ(progress_line(50, 100, 0.5), "50 of 100 designs, 100 a second, 0:01 left");
  EXPECT_EQ(progress_line(1, 1201, 1.0), "1 of 1201 designs, 1.0 a second, 20:00 left");
  EXPECT_EQ(progress_line(1, 7201, 1.0), "1 of 7201 designs, 1.0 a second, 2:00:00 left");
  EXPECT_EQ(progress_line(0, 5, 0.0), "0 of 5 designs");
}

}  // namespace
}  // namespace prs
