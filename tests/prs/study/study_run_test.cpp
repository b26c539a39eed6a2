#include "prs/study/study_run.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <memory>
#include <random>
#include <system_error>

#include "support/small_files.h"
#include "synthetic_study.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::folder_error_of;
using test::synthetic_header;
using test::synthetic_rows;
using testing::HasSubstr;
using Use = StudyFolder::Use;

constexpr std::size_t kDesigns = 5000;
constexpr std::size_t kChunk = 16;

/// A run on `threads` threads that counts what it evaluates.
struct Computer {
  std::size_t threads = 2;
  std::atomic<std::size_t> evaluated = 0;

  RunDesigns run() {
    return [this](const NextRange& next, const TakeRecord& take) {
      const auto evaluate = [this](std::size_t first, std::size_t count) {
        evaluated += count;
        return synthetic_rows(first, count);
      };
      run_schedule(threads, kChunk, next, evaluate, take);
    };
  }
};

/// Stops a run after this many designs were given away.
StudyRunOptions stopped_after(std::size_t blocks) {
  auto asked = std::make_shared<std::size_t>(0);
  return {.interrupted = [=] { return ++*asked > blocks; }};
}

void expect_all_rows(const StoredRows& rows, std::size_t designs = kDesigns) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < rows.block_count(); ++k) {
    const RowBlock block = rows.block(k);
    ASSERT_EQ(block.first, next);
    ASSERT_TRUE(test::same_rows(block, synthetic_rows(next, block.rows)));
    next += block.rows;
  }
  EXPECT_EQ(next, designs);
}

TEST(StudyRun, MissingShardsAreNamedHoweverManyThereAre) {
  const test::TemporaryDirectory temporary;
  const Shard shard{kMostShards - 1, kMostShards};
  Journal::append_to(journal_path(temporary.path(), shard), synthetic_header(kDesigns, shard))
      .append(encode(synthetic_rows(1, 2)));
  const std::string error = folder_error_of([&] { gather_rows({temporary.path()}); });
  EXPECT_THAT(error, HasSubstr("4998 of 5000 designs are missing"));
  EXPECT_THAT(error, HasSubstr("shard 1/1000000: 1 of 1 designs are missing"));
  EXPECT_THAT(error, testing::Not(HasSubstr("shard 2/1000000:")));
  EXPECT_THAT(error, testing::Not(HasSubstr("shard 3/1000000:")));
  EXPECT_THAT(error, HasSubstr("shard 4/1000000:"));
  EXPECT_THAT(error, HasSubstr("and 4978 more"));
}

TEST(StudyRun, GivesAllRowsOnAnyNumberOfThreads) {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    Computer computer{threads};
    expect_all_rows(run_study(synthetic_header(kDesigns), nullptr, computer.run(), {}));
    EXPECT_EQ(computer.evaluated, kDesigns);
  }
}

TEST(StudyRun, ContinuesWithWhatIsMissing) {
  const test::TemporaryDirectory temporary;
  Computer computer;
  for (const std::size_t blocks : {0, 1, 10, 50, 100, 1000}) {
    const StudyFolder folder(temporary.path(), Use::alone);
    std::vector<StudyProgress> told;
    StudyRunOptions options = stopped_after(blocks);
    options.progress = [&](const StudyProgress& progress) { told.push_back(progress); };
    const std::size_t before = computer.evaluated;
    const StoredRows rows = run_study(synthetic_header(kDesigns), &folder, computer.run(), options);
    EXPECT_EQ(count(rows.missing({0, kDesigns})), kDesigns - computer.evaluated);
    for (const StudyProgress& progress : told) {
      EXPECT_EQ(progress.found, before);
      EXPECT_EQ(progress.total, kDesigns);
    }
    EXPECT_EQ(told.empty() ? before : told.back().done, computer.evaluated);
  }
  EXPECT_EQ(computer.evaluated, kDesigns);
  const StudyFolder folder(temporary.path(), Use::alone);
  expect_all_rows(run_study(synthetic_header(kDesigns), &folder, computer.run(), {}));
  EXPECT_EQ(computer.evaluated, kDesigns);  // Nothing remained to be done.
  folder.remove_journals();
  EXPECT_TRUE(journal_paths(temporary.path()).empty());
}

TEST(StudyRun, CountsOverlapsOnce) {
  const test::TemporaryDirectory temporary;
  std::mt19937 random(3);
  for (std::size_t shard = 0; shard < 3; ++shard) {
    Journal journal =
        Journal::append_to(journal_path(temporary.path(), {shard, 4}), synthetic_header(kDesigns, {shard, 4}));
    for (int k = 0; k < 40; ++k) journal.append(encode(synthetic_rows(random() % 4900, 1 + random() % 100)));
  }
  const StudyFolder folder(temporary.path(), Use::alone);
  Computer computer;
  expect_all_rows(run_study(synthetic_header(kDesigns), &folder, computer.run(), {}));
  EXPECT_LT(computer.evaluated, kDesigns);
}

TEST(StudyRun, RefusesTheJournalOfAnotherStudyUntilItIsDiscarded) {
  const test::TemporaryDirectory temporary;
  Computer computer;
  {
    const StudyFolder folder(temporary.path(), Use::alone);
    run_study(synthetic_header(kDesigns), &folder, computer.run(), stopped_after(3));
  }
  JournalHeader changed = synthetic_header(kDesigns);
  changed.key = "changed";
  const StudyFolder folder(temporary.path(), Use::alone);
  EXPECT_THAT(folder_error_of([&] { run_study(changed, &folder, computer.run(), {}); }), HasSubstr("of another study"));
  computer.evaluated = 0;
  expect_all_rows(run_study(changed, &folder, computer.run(), {.restart = true}));
  EXPECT_EQ(computer.evaluated, kDesigns);
}

TEST(StudyRun, DamageIsToldAndComputedAgain) {
  const test::TemporaryDirectory temporary;
  Computer computer;
  const StudyFolder folder(temporary.path(), Use::alone);
  run_study(synthetic_header(kDesigns), &folder, computer.run(), {});
  const fs::path path = journal_path(temporary.path(), {});
  std::string bytes = test::content_of(path);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  std::ofstream(path, std::ios::binary) << bytes;
  std::string warning;
  StudyRunOptions options;
  options.warn = [&](const std::string& text) { warning = text; };
  expect_all_rows(run_study(synthetic_header(kDesigns), &folder, computer.run(), options));
  EXPECT_THAT(warning, HasSubstr(path.string() + ": warning: damaged"));
  EXPECT_GT(computer.evaluated, kDesigns + kDesigns / 4);
}

TEST(StudyRun, FullDiskLosesNothing) {
  const test::TemporaryDirectory temporary;
  Computer computer;
  const StudyFolder folder(temporary.path(), Use::alone);
  {
    const test::SmallFilesOnly full_disk(40'000);
    EXPECT_THROW(run_study(synthetic_header(kDesigns), &folder, computer.run(), {}), std::system_error);
  }
  const std::size_t before = computer.evaluated;
  EXPECT_GT(before, 0u);
  const Journal journal = Journal::read(journal_path(folder.path(), {}));
  std::size_t kept = 0;
  for (const Journal::Record& record : journal.records()) kept += record.designs.count;
  EXPECT_GT(kept, 500u);
  expect_all_rows(run_study(synthetic_header(kDesigns), &folder, computer.run(), {}));
  EXPECT_EQ(computer.evaluated - before, kDesigns - kept);
}

TEST(StudyFolder, IsOfOneStudyOrOfShards) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "a" / "b";
  {
    const StudyFolder folder(path, Use::alone);
    for (const Use use : {Use::alone, Use::among_shards})
      EXPECT_THAT(folder_error_of([&] { StudyFolder(path, use); }), HasSubstr("another process"));
  }
  EXPECT_TRUE(fs::is_empty(path));
  {
    const StudyFolder one(path, Use::among_shards);
    { const StudyFolder two(path, Use::among_shards); }
    EXPECT_THAT(folder_error_of([&] { StudyFolder(path, Use::alone); }), HasSubstr("another process"));
  }
  EXPECT_TRUE(fs::is_empty(path));
  const StudyFolder again(path, Use::alone);
}

TEST(StudyFolder, RemovesWhatDeadProcessesLeft) {
  const test::TemporaryDirectory temporary;
  fs::create_directory(temporary.path() / "plots");
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  siginfo_t ended;
  ::waitid(P_PID, static_cast<id_t>(dead), &ended, WEXITED | WNOWAIT);  // A zombie until the end.
  const std::vector<fs::path> left{"study.csv.123-0.tmp", "study.json.77-1.tmp", fmt::format("slip.csv.{}-3.tmp", dead),
                                   "plots/01_screw.svg.9-12.tmp", "plots/01_screw.png.9-0.tmp"};
  const std::vector<fs::path> others{"study.csv", "my-1.tmp", "my.csv.1-0.tmp", "plots/01.svg",
                                     fmt::format("slip.csv.{}-0.tmp", ::getpid())};
  for (const auto& names : {left, others})
    for (const fs::path& name : names) std::ofstream(temporary.path() / name) << "x";
  const StudyFolder folder(temporary.path(), Use::alone);
  for (const fs::path& name : left) EXPECT_FALSE(fs::exists(temporary.path() / name)) << name;
  for (const fs::path& name : others) EXPECT_TRUE(fs::exists(temporary.path() / name)) << name;
  ::waitpid(dead, nullptr, 0);
}

TEST(Shards, TogetherAreTheStudy) {
  const test::TemporaryDirectory here, there;
  Computer computer;
  const auto run_shard = [&](const fs::path& path, std::size_t shard, StudyRunOptions options) {
    const StudyFolder folder(path, Use::among_shards);
    run_study(synthetic_header(kDesigns, {shard, 3}), &folder, computer.run(), options);
  };
  run_shard(here.path(), 2, {});
  run_shard(there.path(), 0, stopped_after(20));
  const std::string error = folder_error_of([&] { gather_rows({here.path(), there.path()}); });
  EXPECT_THAT(error, HasSubstr("shard 1/3: 1347 of 1667 designs are missing"));
  EXPECT_THAT(error, HasSubstr("shard 2/3: 1667 of 1667 designs are missing"));
  EXPECT_THAT(error, testing::Not(HasSubstr("shard 3/3")));
  run_shard(there.path(), 0, {});
  run_shard(here.path(), 1, {});
  expect_all_rows(gather_rows({here.path(), there.path()}));
  EXPECT_EQ(computer.evaluated, kDesigns);
}

TEST(Shards, OfAnEarlierStudyDoNotHinderTheirSuccessors) {
  const test::TemporaryDirectory temporary;
  Computer computer;
  JournalHeader old = synthetic_header(kDesigns, {0, 2});
  old.key = "old";
  const StudyFolder folder(temporary.path(), Use::among_shards);
  run_study(old, &folder, computer.run(), {});
  run_study(synthetic_header(kDesigns, {1, 2}), &folder, computer.run(), {});
  const JournalHeader fresh = synthetic_header(kDesigns, {0, 2});
  EXPECT_THAT(folder_error_of([&] { run_study(fresh, &folder, computer.run(), {}); }), HasSubstr("--restart"));
  EXPECT_THAT(folder_error_of([&] { gather_rows({temporary.path()}); }), HasSubstr("of another study"));
  run_study(fresh, &folder, computer.run(), {.restart = true});
  expect_all_rows(gather_rows({temporary.path()}));
}

TEST(Shards, AreLookedForWhereTheyCanBe) {
  const test::TemporaryDirectory temporary;
  EXPECT_THAT(folder_error_of([&] { gather_rows({temporary.path()}); }), HasSubstr("no journal"));
  EXPECT_THAT(folder_error_of([&] { gather_rows({temporary.path() / "none"}); }), HasSubstr("no such"));
}

}  // namespace
}  // namespace prs
