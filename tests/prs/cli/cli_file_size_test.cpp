// Every command that writes files, with a limit on their size: `ulimit -f`.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "prs/output/files.h"
#include "tests/prs/optimize/yao_file.h"
#include "tests/prs/study/study_file.h"
#include "tests/support/processes.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace {

namespace fs = std::filesystem;
using test::files_in;
using testing::HasSubstr;

/// Files by their names, in order of size.
using Files = std::map<std::string, std::string>;

class FileSizeLimit : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    test::write_study_file(input.path() / "study.yaml", 100);
    std::ofstream(input.path() / "optimize.yaml")
        << test::yao_mechanism()
        << test::yao_optimize(
               "  objectives:\n"
               "    - {minimize: screw.peak_pressure_MPa.max}\n"
               "    - {minimize: nut.peak_pressure_MPa.max}\n"
               "  thread_constraints: true\n  population: 20\n  generations: 2");
    if (std::string_view(GetParam()).find("SHARD") == std::string_view::npos) return;
    const test::Outcome shard =
        test::run_prs("study '" + (input.path() / "study.yaml").string() + "' --quiet --shard 1/1 --output '" +
                      (input.path() / "shard").string() + "'");
    ASSERT_EQ(shard.status, 0) << shard.err;
  }

  /// Runs the command with a limit on the size of its files.
  test::Outcome run(const fs::path& folder, std::size_t bytes) const {
    std::string arguments = GetParam();
    const auto put = [&](const std::string& word, const fs::path& path) {
      if (const std::size_t at = arguments.find(word); at != std::string::npos)
        arguments.replace(at, word.size(), "'" + path.string() + "'");
    };
    put("STUDY", input.path() / "study.yaml");
    put("OPTIMIZE", input.path() / "optimize.yaml");
    put("SHARD", input.path() / "shard");
    fs::create_directory(folder);
    if (arguments.find("NEW") == std::string::npos) arguments += " --output '" + folder.string() + "'";
    put("NEW", folder / "case.yaml");
    return test::run_prs(arguments + " --quiet", PRS_SOURCE_DIR, "prlimit --fsize=" + std::to_string(bytes));
  }

  const test::TemporaryDirectory input;
};

TEST_P(FileSizeLimit, IsToldAndLeavesWholeFilesOnly) {
  const test::TemporaryDirectory temporary;
  constexpr std::size_t kMuch = 1u << 30;
  ASSERT_EQ(run(temporary.path() / "unlimited", kMuch).status, 0);
  const Files expected = files_in(temporary.path() / "unlimited");
  std::size_t largest = 0;
  for (const auto& [name, content] : expected) largest = std::max(largest, content.size());
  // The message must fit as well. The largest file is a picture in many of the commands; an SVG is complete without the
  // two line breaks at its end.
  std::vector<std::size_t> limits{largest / 2};
  if (!test::sanitized()) limits.insert(limits.end(), {400, largest - 3});
  for (const std::size_t bytes : limits) {
    SCOPED_TRACE(bytes);
    const fs::path folder = temporary.path() / std::to_string(bytes);
    const test::Outcome limited = run(folder, bytes);
    EXPECT_EQ(limited.status, 1);
    EXPECT_THAT(limited.err, HasSubstr("cannot write '"));
    for (const auto& [name, content] : files_in(folder)) {
      if (name.ends_with(".journal")) continue;  // Another run of the command continues it.
      if (name == prs::kFileList) {              // The list names the written files.
        EXPECT_TRUE(nlohmann::json::accept(content)) << content;
        continue;
      }
      ASSERT_TRUE(expected.contains(name)) << name;
      EXPECT_TRUE(content == expected.at(name)) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryCommand, FileSizeLimit,
    testing::Values("check configs/05_standard_screw.yaml", "contact configs/05_standard_screw.yaml",
                    "solve configs/01_config_1_to_3.yaml", "slip configs/09_slip_and_dissipation.yaml",
                    "preload configs/12_preload.yaml", "life configs/14_flight_spectrum.yaml",
                    "measures configs/18_design_measures.yaml", "study configs/17_derivatives.yaml", "study STUDY",
                    "study merge SHARD", "optimize OPTIMIZE",
                    "configurations --screw-diameter '24 mm' --lead '8 mm' --starts 4",
                    "validate validation/sandu_2018", "schema", "new standard NEW"));

}  // namespace
