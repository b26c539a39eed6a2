#include <gtest/gtest.h>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

#include "prs/study/study_files.h"
#include "prs/study/study_run.h"
#include "study_file.h"
#include "support/count.h"
#include "support/folder_watch.h"
#include "support/processes.h"
#include "support/program.h"
#include "synthetic_study.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const auto kKilledDesigns = static_cast<std::size_t>(test::samples(100'000, 100'000));
constexpr const char* kFolder = "PRS_KILL_TEST_FOLDER";

/// All steps of `prs study --output`, on a cheap evaluator.
void run_whole_study(const fs::path& path) {
  const StudyFolder folder(path, StudyFolder::Use::alone);
  const RunDesigns run = [](const NextRange& next, const TakeRecord& take) {
    run_schedule(2, 200, next, test::synthetic_rows, take);
  };
  const StoredRows rows = run_study(test::synthetic_header(kKilledDesigns), &folder, run, {});
  write_rows(rows, test::synthetic_study(kKilledDesigns), &path, 2, [](const RowBlock&, std::span<const double>) {});
  folder.remove_journals();
}

/// The other process of the test below, not a separate test.
TEST(KilledStudy, DISABLED_Process) {
  const char* folder = std::getenv(kFolder);
  ASSERT_NE(folder, nullptr);
  run_whole_study(folder);
}

/// Whether a program has ended, by the result of `Process::end`.
bool has_ended(int end) {
  pollfd file{end, POLLIN, 0};
  return ::poll(&file, 1, 0) > 0;
}

/// Largest size of a folder while a program writes into it, until it ends.
std::uintmax_t most_bytes(const test::Process& process, const fs::path& folder) {
  const test::FolderWatch watch;
  watch.add(folder);
  const int end = process.end();
  std::uintmax_t most = 0;
  do most = std::max(most, test::bytes_in(folder));
  while (!has_ended(end) && watch.wait(end));
  ::close(end);
  return most;
}

/// Waits until a folder holds this many bytes, or until the program has ended.
void wait_for_bytes(const test::Process& process, const fs::path& folder, std::uintmax_t bytes) {
  const test::FolderWatch watch;
  watch.add(folder);
  const int end = process.end();
  while (test::bytes_in(folder) < bytes && !has_ended(end) && watch.wait(end)) {
  }
  ::close(end);
}

/// Runs a program into fresh folders and kills it after it has written a random number of bytes, until `kills` of them
/// hit, at least one after its journal has begun, and restarts it until it ends by itself; its files must be those of
/// an undisturbed run.
void expect_kills_do_no_harm(const std::function<Words(const fs::path&)>& command, int kills) {
  const test::TemporaryDirectory undisturbed;
  std::uintmax_t all_bytes = 0;
  {
    test::Process process(command(undisturbed.path()));
    all_bytes = most_bytes(process, undisturbed.path());
    ASSERT_EQ(process.wait(), 0);
  }
  const auto expected = test::files_in(undisturbed.path());
  ASSERT_TRUE(expected.contains("study.csv"));

  std::mt19937 random(11);
  // Share of the remaining bytes; below 0 at once, above 1 never.
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  int hits = 0;
  int with_journal = 0;
  int studies = 0;
  const auto enough = [&] { return hits >= kills && with_journal > 0; };
  for (; !enough() && studies < 100 + kills; ++studies) {
    const test::TemporaryDirectory folder;
    for (bool complete = false; !complete;) {
      const std::uintmax_t done = test::bytes_in(folder.path());  // Bytes of earlier runs.
      const double rest = static_cast<double>(all_bytes - std::min(done, all_bytes));
      const double moment = enough() ? 2.0 : share(random);
      test::Process process(command(folder.path()));
      if (moment <= 1.0) {
        if (moment > 0.0) wait_for_bytes(process, folder.path(), done + static_cast<std::uintmax_t>(moment * rest));
        process.kill();
      }
      const int status = process.wait();
      complete = status == 0;
      ASSERT_TRUE(complete || status == -SIGKILL) << status;
      hits += complete ? 0 : 1;
      with_journal += !complete && !journal_paths(folder.path()).empty() ? 1 : 0;
    }
    ASSERT_TRUE(test::files_in(folder.path()) == expected) << "after " << hits << " kills";
  }
  EXPECT_GT(with_journal, 0) << hits << " kills hit, in " << studies << " studies of " << all_bytes << " bytes";
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
  // Without the search for leaks, which other runs of the program have: LeakSanitizer itself fails
  // ("Tracer caught signal 11") in some of many runs whose threads are just ending.
  const auto program = [&](const fs::path& folder) -> Words {
    return {"/usr/bin/env",  "ASAN_OPTIONS=detect_leaks=0",
            test::program(), "study",
            file.string(),   "--output",
            folder.string(), "--quiet"};
  };
  expect_kills_do_no_harm(program, test::count(2, 100));
}

}  // namespace
}  // namespace prs
