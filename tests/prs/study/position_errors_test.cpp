#include <gtest/gtest.h>

#include "prs/input/reader.h"
#include "prs/input/study_reader.h"
#include "prs/study/design_engine.h"
#include "prs/study/study_result.h"

namespace prs {
namespace {

StudySummary studied(const std::vector<std::string>& overrides) {
  const input::StudyInput in = input::read_study_input(
      input::load_source(PRS_SOURCE_DIR "/validation/fu_2022/data/position_errors.yaml", overrides));
  const DesignEngine engine(in);
  StudyAnalysis analysis(engine.study());
  analysis.add(engine.evaluate(0, design_count(engine.study())));
  return analysis.summary();
}

// Fu et al. 2022, abstract: sensitive to positions of screw and nut, hardly to those of rollers.
TEST(PositionErrors, OfScrewAndNutMoveTheLoadSharingThoseOfRollersHardly) {
  const StudySummary study = studied({});
  const std::vector<FactorIndices>& factors = study.indices.at(0).factors;
  ASSERT_EQ(factors.size(), 3u);
  EXPECT_GT(factors[0].total.value, 0.5);
  EXPECT_GT(factors[1].total.value, 0.5);
  EXPECT_LT(factors[2].total.value, 0.01);
}

// A screw without supports centres itself: the assumption behind that order.
TEST(PositionErrors, OfAFreeScrewMoveHardlyAnything) {
  const auto deviation = [](const std::vector<std::string>& overrides) {
    return *studied(overrides).statistics.at(0).standard_deviation;
  };
  EXPECT_LT(deviation({"structure.screw.bearings=[]"}), 0.05 * deviation({}));
}

}  // namespace
}  // namespace prs
