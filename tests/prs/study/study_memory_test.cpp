#include <gtest/gtest.h>
#include <sys/resource.h>

#include <string>

#include "support/processes.h"
#include "support/program.h"
#include "support/sanitized.h"

namespace {

/// Beyond the designs that are kept for the document and the quantiles. 1.5 MB is 4 bytes for each additional design;
/// the heap grows by 1 MB at a time.
TEST(StudyMemory, IsTheSameForMoreDesigns) {
  SKIP_UNDER_SANITIZERS();
  const auto peak = [](const std::string& samples) {
    test::Process run({test::program(), "study", PRS_SOURCE_DIR "/configs/15_sensitivity.yaml", "--set",
                       "study.samples=" + samples, "--threads", "1", "--quiet"});
    rusage use{};
    EXPECT_EQ(run.wait(&use), 0);
    return use.ru_maxrss;  // [kB]
  };
  EXPECT_NEAR(static_cast<double>(peak("600000")), static_cast<double>(peak("200000")), 1500.0);
}

}  // namespace
