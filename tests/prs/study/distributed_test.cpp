#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "prs/study/study_run.h"
#include "study_file.h"
#include "support/count.h"
#include "support/folder_watch.h"
#include "support/processes.h"
#include "support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words study(const fs::path& file, const fs::path& folder) {
  return {test::program(), "study", file.string(), "--output", folder.string(), "--quiet"};
}

Words on_ranks(int ranks, const Words& command) {
  Words words{"mpirun", "--oversubscribe", "--allow-run-as-root", "-n", std::to_string(ranks)};
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

class Distributed : public testing::Test {
 protected:
  void SetUp() override {
    if (test::sanitized()) GTEST_SKIP() << "Open MPI's own leaks would be found";
    if (test::Process({"mpirun", "--version"}).wait() != 0) GTEST_SKIP() << "no mpirun";
  }

  const test::TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "study.yaml";
};

TEST_F(Distributed, FilesAreThoseOfOneProcess) {
  test::write_study_file(file, 2000);
  const fs::path alone = temporary.path() / "alone";
  ASSERT_EQ(test::Process(study(file, alone)).wait(), 0);
  const auto expected = test::files_in(alone);
  for (const char* name : {"study.csv", "study.nc", "study.json"}) EXPECT_TRUE(expected.contains(name)) << name;
  for (int ranks = 4; ranks >= 1; ranks -= test::count(2, 1)) {
    const fs::path folder = temporary.path() / std::to_string(ranks);
    ASSERT_EQ(test::Process(on_ranks(ranks, study(file, folder))).wait(), 0);
    EXPECT_TRUE(test::files_in(folder) == expected) << ranks;
  }
}

TEST_F(Distributed, KilledRankEndsTheJobAndAnyNumberOfRanksContinues) {
  test::write_study_file(file, 150'000);
  const fs::path folder = temporary.path() / "killed";
  const fs::path ids = temporary.path() / "rank";
  Words ranks{"sh", "-c", "echo $$ > '" + ids.string() + "'.$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\""};
  for (const std::string& word : study(file, folder)) ranks.push_back(word);
  test::Process job(on_ranks(4, ranks));
  const fs::path journal = journal_path(folder, {});
  ASSERT_TRUE(test::wait_for_size(journal, 100'000));
  pid_t rank = 0;
  std::ifstream(ids.string() + ".2") >> rank;
  ASSERT_GT(rank, 0);
  ::kill(rank, SIGKILL);
  EXPECT_NE(job.wait(), 0);
  ASSERT_TRUE(fs::exists(journal));  // The study was not done yet.
  EXPECT_FALSE(fs::exists(folder / "study.csv"));

  ASSERT_EQ(test::Process(on_ranks(3, study(file, folder))).wait(), 0);
  const fs::path alone = temporary.path() / "alone";
  ASSERT_EQ(test::Process(study(file, alone)).wait(), 0);
  EXPECT_TRUE(test::files_in(folder) == test::files_in(alone));
}

TEST_F(Distributed, WrongInputEndsAllRanksWithItsStatus) {
  test::write_study_file(file, 100);
  std::ofstream(file, std::ios::app) << "nonsense: 1\n";
  const fs::path folder = temporary.path() / "none";
  EXPECT_EQ(test::Process(on_ranks(3, study(file, folder))).wait(), 2);
  EXPECT_EQ(test::Process(on_ranks(3, study(file.string() + ".missing", folder))).wait(), 2);
}

TEST_F(Distributed, RanksWithDifferentArgumentsAreRefused) {
  test::write_study_file(file, 100);
  const Words ranks{"sh", "-c",
                    std::string("exec '") + test::program() + "' study '" + file.string() + "' --output '" +
                        temporary.path().string() + "'/$OMPI_COMM_WORLD_RANK"};
  EXPECT_EQ(test::Process(on_ranks(2, ranks)).wait(), 2);
}

}  // namespace
}  // namespace prs
