#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/input/study_reader.h"
#include "prs/model/check_case.h"
#include "prs/study/design_engine.h"
#include "prs/study/study_result.h"
#include "prs/threads/threads.h"
#include "validation/yao_2023/sensitivity.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Case initial(const std::vector<std::string>& overrides = {}) {
  return input::read_case_input(input::load_source(PRS_SOURCE_DIR "/validation/yao_2023/initial.yaml", overrides),
                                Command::contact)
      .values;
}

Supplement sensitivity(const std::vector<std::string>& overrides = {}) {
  return yao_2023::sensitivity(initial(overrides),
                               read_reference(PRS_SOURCE_DIR "/validation/yao_2023/reference.yaml"));
}

// Statements of the text on figures 8 and 9 hold except for the load of (27) and two signs.
TEST(YaoSensitivity, ReproducesTheTextButForTheLoadAndTwoSigns) {
  const Supplement found = sensitivity();
  ASSERT_EQ(found.statements.size(), 12U);
  std::vector<std::string> not_held;
  for (const ComparedStatement& s : found.statements) {
    if (s.verdict.kind == Verdict::Kind::holds) continue;
    EXPECT_FALSE(s.verdict.why.empty()) << s.text;
    const bool by_load = s.text.find("sigma_HSR") != std::string::npos;
    const bool by_sign = s.text.find("of the negative effects") != std::string::npos;
    EXPECT_TRUE(by_load || by_sign) << s.text << ": " << s.verdict.evidence;
    EXPECT_EQ(s.verdict.kind, by_load ? Verdict::Kind::holds_only_with : Verdict::Kind::does_not_hold) << s.text;
    not_held.push_back(s.text);
  }
  EXPECT_EQ(not_held.size(), 3U);
}

TEST(YaoSensitivity, PrintedPercentagesOfTheCurvatureSumsAreMetToAPoint) {
  const ValidationTable table = sensitivity().tables.at(0);
  for (const ValidationTable::Row& row : table.rows) {
    EXPECT_NEAR(row.values.at(1), row.values.at(0), 1.0) << row.label;
    EXPECT_NEAR(row.values.at(3), row.values.at(2), 1.0) << row.label;
  }
}

// The lesson is the same study, drawn from the file.
TEST(YaoSensitivity, LessonRanksAsTheValidationDoes) {
  const input::StudyInput in =
      input::read_study_input(input::load_source(PRS_SOURCE_DIR "/configs/15_sensitivity.yaml", {}));
  const DesignEngine engine(in);
  const std::size_t designs = design_count(engine.study());
  ASSERT_EQ(designs, 2001U);
  StudyAnalysis analysis(engine.study());
  analysis.add(engine.evaluate(0, designs));
  const StudySummary summary = analysis.summary();
  ASSERT_TRUE(summary.surfaces);
  const auto ranked = [&](std::size_t response) {
    std::vector<std::string> labels;
    for (const FactorEffect& effect : summary.surfaces->fits.at(response)->effects) {
      const std::string& label = engine.study().factors[effect.factor].label;
      labels.push_back(label.substr(0, label.find(' ')));
    }
    labels.resize(3);
    return labels;
  };
  EXPECT_THAT(ranked(0), ElementsAre("d_R0", "β_R", "β_S"));
  EXPECT_THAT(ranked(2), ElementsAre("d_R0", "β_R", "β_S"));
  EXPECT_THAT(ranked(3), ElementsAre("d_R0", "β_R", "β_N"));
  for (const auto& fit : summary.surfaces->fits) EXPECT_GT(fit->r_squared, 0.998);
  const ValidationTable table = sensitivity().tables.at(0);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(summary.surfaces->fits[2]->effects[k].contribution_percent, table.rows[k].values[1], 0.1);
}

TEST(CentredProfile, IsAnArcAboutTheAxis) {
  const contact::MechanismGeometry given = threads_of(initial().mechanism);
  const contact::MechanismGeometry centred = threads_of(initial({"mechanism.profile.roller=centred"}).mechanism);
  EXPECT_NEAR(centred.roller.profile_curvature, given.roller.profile_curvature, 1e-15 * given.roller.profile_curvature);
  const contact::MechanismGeometry thicker =
      threads_of(initial({"mechanism.profile.roller=centred", "mechanism.rollers=6", "mechanism.flank_angle=30 deg",
                          "mechanism.pitch_diameter.roller=20 mm"})
                     .mechanism);
  EXPECT_NEAR(1.0 / thicker.roller.profile_curvature, 20e-3, 1e-16);
}

TEST(CentredProfile, IsRefusedWhereThereIsNoSuchArc) {
  Case c = initial();
  c.mechanism.profile.nut = {Profile::Shape::centred};
  std::vector<Problem> problems = check_case(c);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].path, "mechanism.profile.nut");
  EXPECT_THAT(problems[0].message, HasSubstr("expected it of screw or roller"));
  c = initial();
  c.mechanism.profile.roller = {Profile::Shape::centred};
  c.mechanism.geometry = Mechanism::Geometry::design;
  c.mechanism.pitch_diameter.roller = std::nullopt;
  c.mechanism.pitch_diameter.nut = std::nullopt;
  c.mechanism.centre_distance = std::nullopt;
  problems = check_case(c);
  EXPECT_TRUE(std::ranges::any_of(problems, [](const Problem& p) { return p.path == "mechanism.profile.roller"; }));
}

}  // namespace
}  // namespace prs
