#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>
#include <thread>

#include "../output/temporary_directory.h"
#include "prs/output/study_files.h"
#include "prs/study/study_run.h"
#include "study_file.h"
#include "support/count.h"
#include "support/processes.h"
#include "support/program.h"
#include "synthetic_study.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr std::size_t kKilledDesigns = 100'000;
constexpr const char* kFolder = "PRS_KILL_TEST_FOLDER";

/// All that `prs study --output` does, on a cheap evaluator.
void run_whole_study(const fs::path& path) {
  const StudyFolder folder(path, StudyFolder::Use::alone);
  const RunDesigns run = [](const NextRange& next, const TakeRecord& take) {
    run_schedule(2, 200, next, test::synthetic_rows, take);
  };
  const StoredRows rows = run_study(test::synthetic_header(kKilledDesigns), &folder, run, {});
  write_rows(rows, test::synthetic_study(kKilledDesigns), {"1", "1", "abc"}, &path, 2,
             [](const RowBlock&) {});
  folder.remove_journals();
}

/// The other process of the test below, not a test of its own.
TEST(KilledStudy, DISABLED_Process) {
  const char* folder = std::getenv(kFolder);
  ASSERT_NE(folder, nullptr);
  run_whole_study(folder);
}

/// Runs a program into fresh folders and kills it at random moments until `kills` of them hit, one
/// of them at least what has begun its journal, starting it again and again until it ends by
/// itself; its files are then those of a run that nothing disturbed. Later in each folder the
/// moments come later, so that a slow machine ends too.
void expect_kills_do_no_harm(const std::function<Words(const fs::path&)>& command, int kills) {
  const test::TemporaryDirectory undisturbed;
  const Clock::time_point begin = Clock::now();
  ASSERT_EQ(test::Process(command(undisturbed.path())).wait(), 0);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  const auto expected = test::files_in(undisturbed.path());
  ASSERT_TRUE(expected.contains("study.csv"));

  std::mt19937 random(11);
  std::uniform_real_distribution<double> moment(0.0, seconds);
  int hits = 0;
  int with_journal = 0;
  int studies = 0;
  const auto enough = [&] { return hits >= kills && with_journal > 0; };
  for (; !enough() && studies < 100 + kills; ++studies) {
    const test::TemporaryDirectory folder;
    double stretch = 1.0;
    for (bool complete = false; !complete; stretch *= 1.1) {
      test::Process process(command(folder.path()));
      std::this_thread::sleep_for(std::chrono::duration<double>(stretch * moment(random)));
      if (!enough()) process.kill();
      const int status = process.wait();
      complete = status == 0;
      ASSERT_TRUE(complete || status == -SIGKILL) << status;
      hits += complete ? 0 : 1;
      with_journal += !complete && !journal_paths(folder.path()).empty() ? 1 : 0;
    }
    ASSERT_TRUE(test::files_in(folder.path()) == expected) << "after " << hits << " kills";
  }
  std::printf("%d kills hit, %d of them with a journal, in %d studies of %.2f s\n", hits,
              with_journal, studies, seconds);
  EXPECT_GT(with_journal, 0);
}

TEST(KilledStudy, EndsWithTheFilesOfAnUndisturbedOne) {
  const auto this_program = [](const fs::path& folder) -> Words {
    return {"/usr/bin/env",
            "-u",
            "GTEST_OUTPUT",
            "-u",
            "GTEST_TOTAL_SHARDS",
            "-u",
            "GTEST_SHARD_INDEX",
            std::string(kFolder) + "=" + folder.string(),
            fs::read_symlink("/proc/self/exe").string(),
            "--gtest_filter=KilledStudy.DISABLED_Process",
            "--gtest_also_run_disabled_tests"};
  };
  expect_kills_do_no_harm(this_program, test::count(5, 1000));
}

TEST(KilledStudy, OfTheProgramItselfToo) {
  const test::TemporaryDirectory input;
  const fs::path file = input.path() / "study.yaml";
  test::write_study_file(file, 3000);
  const auto program = [&](const fs::path& folder) -> Words {
    return {test::program(), "study", file.string(), "--output", folder.string(), "--quiet"};
  };
  expect_kills_do_no_harm(program, test::count(2, 100));
}

}  // namespace
}  // namespace prs
