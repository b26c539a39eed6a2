#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "prs/bodies/body_models.h"
#include "prs/compare/compare_analysis.h"
#include "prs/compare/compare_models.h"
#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/sector/influence/matrix_cache.h"
#include "support/sanitized.h"

namespace prs {
namespace {

using testing::ElementsAre;
using Bodies = ModelOptions::Bodies;

Case compared_lesson(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return input::read_case(PRS_SOURCE_DIR "/configs/" + name, overrides, Command::compare);
}

std::vector<Bodies> models_of(const ModelComparison& c) {
  std::vector<Bodies> models;
  for (const Result& model : c.models) models.push_back(model.model.bodies);
  return models;
}

TEST(CompareModels, EachIsWhatSolveFinds) {
  const Case c = compared_lesson("04_contacts_from_geometry.yaml");
  const ModelComparison comparison = compare_models(c);
  EXPECT_THAT(models_of(comparison), ElementsAre(&kBars, &kRefined));
  for (const Result& model : comparison.models) {
    Case alone = c;
    alone.model.bodies = model.model.bodies;
    const Result result = analyze(alone);
    ASSERT_EQ(model.load_cases.size(), result.load_cases.size());
    for (std::size_t k = 0; k < result.load_cases.size(); ++k)
      EXPECT_EQ(model.load_cases[k].axial_displacement, result.load_cases[k].axial_displacement);
  }
}

/// docs/refined.md: bars are 17 to 32 % stiffer than finite elements at full load, refined bodies
/// at most 3.4 %.
TEST(CompareModels, BarsAreTooStiffForLessonOne) {
  const ModelComparison c = compare_models(compared_lesson("01_config_1_to_3.yaml"));
  for (std::size_t k = 0; k < c.load_cases(); ++k) {
    const double over = *c.models[0].load_cases[k].axial_stiffness / *c.best().load_cases[k].axial_stiffness;
    EXPECT_GT(over, 1.17 / 1.034);
    EXPECT_LT(over, 1.32);
  }
}

TEST(CompareModels, WhatOneModelCannotTakeLeavesItOutWithTheReason) {
  const ModelComparison c =
      compare_models(compared_lesson("04_contacts_from_geometry.yaml", {"structure.nut.outer_diameter=35.2 mm"}));
  EXPECT_THAT(models_of(c), ElementsAre(&kBars));
  EXPECT_THAT(
      sentences(c.warnings),
      testing::Contains(testing::StartsWith("structure.nut.outer_diameter: without `bodies: refined`: got 35.2")));
}

TEST(CompareModels, ShearOfTheRollerIsOfBarsAlone) {
  EXPECT_THAT(models_of(compare_models(compared_lesson("04_contacts_from_geometry.yaml", {"model.roller_shear=true"}))),
              ElementsAre(&kBars, &kRefined));
}

TEST(CompareModels, TellsWhatIsUnusualAboutALoadAsSolveDoes) {
  const Case c = compared_lesson("01_config_1_to_3.yaml", {"load_cases=[{name: heavy, axial_force: 90 kN, direction: "
                                                           "tension, position: 10 mm}]"});
  const ModelComparison comparison = compare_models(c);
  const std::vector<std::string> expected = sentences(comparison.best().load_cases[0].warnings);
  ASSERT_THAT(expected, testing::Contains(testing::HasSubstr("exceeds")));
  const nlohmann::ordered_json load = document_of(compare_analysis(), comparison, {})["comparison"]["load_cases"][0];
  EXPECT_EQ(load["warnings"], nlohmann::ordered_json(expected));
  EXPECT_THAT(comparison_table(comparison), testing::HasSubstr("exceeds"));
}

TEST(CompareModels, EqualSharesAreLeftOut) {
  Case c = compared_lesson("04_contacts_from_geometry.yaml");
  LoadCase equal = c.load_cases.front();
  equal.share = LoadCase::Share::equal;
  c.load_cases.insert(c.load_cases.begin(), equal);
  const ModelComparison comparison = compare_models(c);
  EXPECT_EQ(comparison.load_cases(), c.load_cases.size() - 1);
  EXPECT_THROW(compared_lesson("04_contacts_from_geometry.yaml", {"load_cases=[{axial_force: 1 kN, share: equal}]"}),
               input::InputError);
}

/// No other test has matrices of this case in the cache before it requests them.
TEST(CompareModels, InfluenceIsThereWhereItsMatricesAre) {
  SKIP_UNDER_SANITIZERS();
  const std::vector<std::string> fewer = {"mechanism.contacts_per_roller=3",
                                          "load_cases=[{axial_force: 5 kN, direction: tension, "
                                          "position: 40 mm}]"};
  const Case c = compared_lesson("04_contacts_from_geometry.yaml", fewer);
  EXPECT_THAT(models_of(compare_models(c)), ElementsAre(&kBars, &kRefined));
  Case stated = c;
  stated.model.bodies = &kInfluence;
  EXPECT_THAT(models_of(compare_models(stated)), ElementsAre(&kBars, &kRefined, &kInfluence));
  const int computed = shared_matrix_cache().computed();
  const ModelComparison now = compare_models(c);
  EXPECT_THAT(models_of(now), ElementsAre(&kBars, &kRefined, &kInfluence));
  EXPECT_EQ(shared_matrix_cache().computed(), computed);
}

/// A sector has neither tilt nor bearing: it is the screw under its axial force.
TEST(CompareModels, AFullMechanismStandsNextToASector) {
  const ModelComparison c = compare_models(compared_lesson("24_misalignment.yaml"));
  ASSERT_EQ(c.models.size(), 2u);
  EXPECT_EQ(name_of_model(c.models[0].model), "bars");
  EXPECT_EQ(name_of_model(c.models[1].model), "full");
  const auto largest = [&](std::size_t model, std::size_t load_case) {
    return std::ranges::max(c.models[model].load_cases[load_case].threads->screw.normal_load);
  };
  EXPECT_NEAR(largest(0, 0) / largest(1, 0), 1.0, 1e-8);
  EXPECT_EQ(largest(0, 0), largest(0, 1));
  EXPECT_NEAR(largest(1, 1) / largest(0, 1), c.best().load_cases[1].threads->screw.rollers->overload_factor, 1e-8);
}

}  // namespace
}  // namespace prs
