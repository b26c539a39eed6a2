// The program with a jumping clock: at every reading, back, ahead and to before 1970.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/prs/study/study_file.h"
#include "tests/support/count.h"
#include "tests/support/processes.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::string kJumps = test::preloaded(PRS_JUMPING_CLOCK);

class JumpingClock : public testing::Test {
 protected:
  JumpingClock() {
    test::write_study_file(folder / "study.yaml", 200);
    std::ofstream(folder / "optimize.yaml") << test::content_of(PRS_SOURCE_DIR "/configs/01_config_1_to_3.yaml") << R"(
optimize:
  command: solve
  seed: 1
  population: 8
  generations: 2
  variables:
    - {path: structure.nut.outer_diameter, from: 40 mm, to: 55 mm}
  objectives:
    - {minimize: screw.load_rate_percent.max}
)";
  }

  /// Runs `prs ARGUMENTS`.
  test::Outcome prs(const std::string& arguments, const std::string& environment) const {
    return test::run_prs(arguments, folder,
                         "env -u SOURCE_DATE_EPOCH PRS_CACHE_DIR='" + cache.string() + "' " + environment);
  }

  /// Checks that files and output are the same with and without jumps, except a journal, whose blocks depend on time.
  /// The result of `after` on it is the same again.
  void expect_same(const std::string& arguments, const std::string& after = {}) const {
    SCOPED_TRACE(arguments);
    const auto written = [&](const std::string& environment) {
      fs::remove_all(folder / "out");
      const test::Outcome run = prs(arguments, "SOURCE_DATE_EPOCH=86400 " + environment);
      EXPECT_EQ(run.status, 0) << run.err;
      if (!after.empty()) {
        EXPECT_EQ(prs(after, "SOURCE_DATE_EPOCH=86400 " + environment).status, 0);
      }
      auto files = test::files_in(folder / "out");
      std::erase_if(files, [](const auto& file) { return file.first.ends_with(".journal"); });
      EXPECT_FALSE(files.empty());
      files["printed"] = run.out;
      return files;
    };
    EXPECT_TRUE(written(kJumps) == written(""));
  }

  /// A lesson's file, as a word of a command.
  static std::string lesson(const std::string& name) { return "'" PRS_SOURCE_DIR "/configs/" + name + ".yaml' "; }

  const test::TemporaryDirectory temporary;
  const fs::path folder = temporary.path(), cache = folder / "cache";
};

TEST_F(JumpingClock, ShowsInTheDateOfAPageAndTheTimeThatIsLeft) {
  const auto dated = [&](const std::string& environment) {
    EXPECT_EQ(prs("report " + lesson("05_standard_screw") + "--output page.html", environment).status, 0);
    return test::content_of(folder / "page.html");
  };
  const auto far = testing::ContainsRegex("(1968|1969|1970|2039|2169|2170)-[0-9][0-9]-[0-9][0-9]");
  EXPECT_THAT(dated(""), Not(far));
  EXPECT_THAT(dated(kJumps), far);

  if (test::run_prs("--version\"", folder, "script -qec \"env ").status != 0)
    GTEST_SKIP() << "needs pseudo-terminals: `script` has none";
  // On a terminal, with some hours passing while 200 designs are computed.
  const test::Outcome run = test::run_prs("study study.yaml --output shown\"", folder, "script -qec \"env " + kJumps);
  EXPECT_EQ(run.status, 0) << run.out;
  EXPECT_THAT(run.out, HasSubstr("0.0 a second, 0:00 left"));
}

TEST_F(JumpingClock, LeavesWhatIsPrintedAndWritten) {
  expect_same("solve " + lesson("05_standard_screw") + "--output out");
  expect_same("report " + lesson("09_slip_and_dissipation") + "--output out/page.html");
  expect_same("export " + lesson("34_reversal") + "--fmu --output out/screw.fmu");
  expect_same("study study.yaml --threads 2 --output out");
  expect_same("study study.yaml --threads 2 --shard 1/1 --output out/shard",
              "study merge out/shard --output out/merged");
  expect_same("optimize optimize.yaml --threads 2 --output out");
}

TEST_F(JumpingClock, LeavesTheCacheOfMatrices) {
  if (test::count(0, 1) == 0) GTEST_SKIP() << "takes long; set PRS_THOROUGH=1";
  const std::string arguments = "solve " + lesson("13_three_models") + "--set model.bodies=influence " +
                                "--set mechanism.contacts_per_roller=2 --json --quiet";
  const std::string expected = prs(arguments, "").out;
  const auto kept = test::files_in(cache);
  ASSERT_FALSE(kept.empty());
  for (const int years : {-60, 60}) {  // The files are written before the clock is set.
    for (const auto& file : fs::directory_iterator(cache))
      fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::years(years));
    EXPECT_EQ(prs(arguments, kJumps).out, expected);
    EXPECT_TRUE(test::files_in(cache) == kept);
  }
  fs::remove_all(cache);
  EXPECT_EQ(prs(arguments, kJumps).out, expected);
  EXPECT_TRUE(test::files_in(cache) == kept);
}

}  // namespace
