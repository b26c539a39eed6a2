#include "prs/cli/interruption.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

namespace prs::cli {
namespace {

TEST(InterruptionDeathTest, EndsARunThatDoesNotStopInTime) {
  EXPECT_EXIT(
      {
        const Interruption long_run({std::chrono::milliseconds(1), "prs: interrupted; too long\n"});
        ::raise(SIGTERM);
        for (;;) ::pause();
      },
      testing::ExitedWithCode(143), "prs: interrupted; too long");
}

TEST(InterruptionDeathTest, LeavesARunThatStoppedInTime) {
  EXPECT_EXIT(
      {
        {
          const Interruption run({std::chrono::hours(1), "too long"});
          ::raise(SIGINT);
        }
        ::_exit(Interruption::asked() ? Interruption::status() : 1);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace prs::cli
