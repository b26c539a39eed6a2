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

TEST(InterruptionDeathTest, EndsAProgramWhoseTerminalClosesExceptUnderNohup) {
  EXPECT_EXIT(
      {
        ::signal(SIGHUP, SIG_DFL);
        end_on_interrupt();
        ::raise(SIGHUP);
      },
      testing::ExitedWithCode(129), "prs: interrupted");
  EXPECT_EXIT(
      {
        ::signal(SIGHUP, SIG_IGN);
        end_on_interrupt();
        const Interruption run;
        ::raise(SIGHUP);
        ::_exit(Interruption::asked() ? 1 : 0);
      },
      testing::ExitedWithCode(0), "");
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
