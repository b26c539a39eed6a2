#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "prs/input/reader.h"
#include "prs/preload/preloaded_mechanism.h"

namespace prs {
namespace {

Case solved_case() {
  const auto all = nlohmann::json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  return input::read_case_text(all["cases"][3]["input"].dump(), "case", {}, Command::preload);
}

TEST(WarmPreload, FitIsMadeAtTheReferenceTemperature) {
  const PreloadResult r = analyze_preload(solved_case());
  ASSERT_TRUE(r.converged());
  EXPECT_NEAR(r.reference_force, 2000.0, 2e-3);
  EXPECT_NEAR(*r.interference * 1e6, 3.194334366607, 1e-9);
  EXPECT_NEAR(r.force(), 4237.269153659, 4e-3);
}

TEST(WarmPreload, PartsThatWarmAlikeKeepIt) {
  Case c = solved_case();
  const double reference = c.deviations.reference_temperature;
  c.deviations.temperature = PerPart<double>{reference + 30, reference + 30, reference + 30};
  EXPECT_NEAR(analyze_preload(c).force(), 2000.0, 1e-6 * 2000.0);
  c.deviations.temperature = PerPart<double>{reference, reference, reference};
  EXPECT_NEAR(analyze_preload(c).force(), 2000.0, 1e-6 * 2000.0);
}

}  // namespace
}  // namespace prs
