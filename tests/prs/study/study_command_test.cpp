#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "prs/study/study_run.h"
#include "study_file.h"
#include "support/count.h"
#include "support/folder_watch.h"
#include "support/processes.h"
#include "tests/support/parsed_csv.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using test::Outcome;

namespace fs = std::filesystem;
using test::content_of;
using test::files_in;
using testing::HasSubstr;

class StudyCommand : public testing::Test {
 protected:
  Outcome prs(const std::string& arguments, const std::string& before = "") const {
    return test::run_prs(arguments, ".", before);
  }
  /// `study FILE --output DIR` with more arguments.
  std::string into(const fs::path& output, const std::string& more = "") const {
    return "study '" + file.string() + "' --quiet --output '" + output.string() + "' " + more;
  }

  /// Starts a study of this many designs, stops it while it computes, checks that its folder is refused to another
  /// process, and interrupts it. Returns false if it was done before it stopped.
  bool interrupts(int designs) const {
    fs::remove_all(folder);
    test::write_study_file(file, static_cast<std::size_t>(designs));
    test::Process process({test::program(), "study", file.string(), "--output", folder.string()});
    if (!test::wait_for_size(journal_path(folder, {}), 30'000)) return false;
    process.signal(SIGSTOP);
    const Outcome second = prs(into(folder));
    process.signal(SIGINT);
    process.signal(SIGCONT);
    const int status = process.wait();
    if (status == 0) return false;
    EXPECT_EQ(status, 130);
    EXPECT_EQ(second.status, 2);
    EXPECT_THAT(second.err, HasSubstr(folder.string() + ": error: another process"));
    return true;
  }

  const test::TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "study.yaml";
  const fs::path alone = temporary.path() / "alone";
  const fs::path folder = temporary.path() / "folder";
};

TEST_F(StudyCommand, EnvelopeComesWithItsGridAndIsThatOfItsShards) {
  std::ifstream lesson(PRS_SOURCE_DIR "/configs/01_config_1_to_3.yaml");
  std::string text(std::istreambuf_iterator<char>(lesson), {});
  text += R"(
study:
  command: solve
  plan: grid
  factors:
    - {path: structure.nut.outer_diameter, values: {from: 44 mm, to: 50 mm, steps: 30}}
    - path: structure.screw.bore
      values: {from: 1 mm, to: 8 mm, steps: 30}
      with: [{path: structure.screw.free_length, values: {from: 10 mm, to: 20 mm, steps: 30}}]
  envelope:
    measures: [{response: axial_stiffness_N_per_um}, {response: screw.load_rate_percent.max, weight: -2}]
    points: [{name: best, wanted: best}, {name: given, at: [45 mm, 3.1 mm]}]
)";
  std::ofstream(file) << text;
  ASSERT_EQ(prs(into(alone, "--threads 1 --csv-digits 17")).status, 0);
  const auto expected = files_in(alone);
  ASSERT_THAT(expected, testing::Contains(testing::Key("envelope.csv")));
  const auto rows = test::parse(content_of(alone / "envelope.csv"));
  ASSERT_EQ(rows.size(), 902U);
  double largest = 0.0;
  for (std::size_t k = 0; k < 900; ++k) {
    EXPECT_EQ(rows[k].at("design"), std::to_string(k + 1));
    const double stiffness = std::stod(rows[k].at("normalised.axial_stiffness_N_per_um"));
    const double share = std::stod(rows[k].at("normalised.screw.load_rate_percent.max"));
    const double envelope = std::stod(rows[k].at("envelope"));
    EXPECT_NEAR(envelope * share * share / stiffness, 1.0, 1e-12);
    largest = std::max(largest, envelope);
  }
  EXPECT_EQ(rows[900].at("point"), "best");
  EXPECT_EQ(std::stod(rows[900].at("envelope")), largest);
  EXPECT_NEAR(std::stod(rows[901].at("structure.screw.free_length_mm")), 13.0, 1e-9);

  const fs::path parts = temporary.path() / "parts", whole = temporary.path() / "whole";
  EXPECT_EQ(prs(into(parts, "--shard 1/2")).status, 0);
  EXPECT_EQ(prs(into(parts, "--shard 2/2")).status, 0);
  EXPECT_EQ(
      prs("study merge '" + parts.string() + "' --quiet --csv-digits 17 --output '" + whole.string() + "'").status, 0);
  EXPECT_TRUE(files_in(whole) == expected);

  // Between designs the error falls with the square of the step, here 0.24 mm of a bore in 21 mm.
  const Outcome direct = prs("solve '" + file.string() +
                             "' --json --set 'structure.nut.outer_diameter=45 mm' --set 'structure.screw.bore=3.1 mm' "
                             "--set 'structure.screw.free_length=13 mm'");
  ASSERT_EQ(direct.status, 0) << direct.err;
  const auto document = nlohmann::json::parse(direct.out);
  EXPECT_NEAR(std::stod(rows[901].at("axial_stiffness_N_per_um")) /
                  document["load_cases"][0]["axial_stiffness_N_per_um"].get<double>(),
              1.0, std::pow(0.24 / 21.0, 2));
}

TEST_F(StudyCommand, WritesTheSameFilesOnAnyNumberOfThreadsAndInShards) {
  test::write_study_file(file, 1500);
  ASSERT_EQ(prs(into(alone, "--threads 1")).status, 0);
  const auto expected = files_in(alone);
  EXPECT_THAT(expected, testing::Contains(testing::Key("study.csv")));
  EXPECT_THAT(expected, testing::Contains(testing::Key("study.json")));
  ASSERT_EQ(prs(into(folder, "--threads 3")).status, 0);
  EXPECT_TRUE(files_in(folder) == expected);

  const fs::path one = temporary.path() / "one", two = temporary.path() / "two";
  EXPECT_EQ(prs(into(one, "--shard 1/3")).status, 0);
  EXPECT_EQ(prs(into(two, "--shard 3/3")).status, 0);
  const std::string merge = "study merge '" + one.string() + "' '" + two.string() + "' --quiet --output ";
  const Outcome incomplete = prs(merge + (temporary.path() / "m").string());
  EXPECT_EQ(incomplete.status, 2);
  EXPECT_EQ(incomplete.out, "");
  EXPECT_THAT(incomplete.err, HasSubstr("shard 2/3: 500 of 500 designs are missing"));
  EXPECT_EQ(prs(into(two, "--shard 2/3 --threads 1")).status, 0);
  fs::remove(file);  // Journals are sufficient.
  ASSERT_EQ(prs(merge + (temporary.path() / "m").string()).status, 0);
  EXPECT_TRUE(files_in(temporary.path() / "m") == expected);
}

TEST_F(StudyCommand, SaysWhichFactorsOverridesMakeVoidAndWhichMovedNothing) {
  const std::string lesson = "study '" PRS_SOURCE_DIR "/configs/01_config_1_to_3.yaml' ";
  const std::string factors =
      "factors: [{path: mechanism.flank_angle, values: [44 deg, 46 deg]}, {path: materials."
      "youngs_modulus, values: [205 GPa, 210 GPa]}], ";
  const std::string is_void =
      "mechanism.flank_angle: moves no load or stiffness (axial_stiffness_N_per_um): overridden by "
      "contact.hertz_constant and contact.normal_angle; delete the overrides to compute all from "
      "the geometry";
  const std::string is_idle =
      "mechanism.flank_angle: moved no response: all stay the same to the last digit; add a "
      "response "
      "that follows it, or delete the factor";
  for (const char* plan : {"one_at_a_time", "grid", "latin_hypercube, samples: 20", "sobol_indices, samples: 8"}) {
    const std::string study = "--set 'study={command: solve, plan: " + std::string(plan) + ", " + factors +
                              "responses: [axial_stiffness_N_per_um]}' ";
    const Outcome run = prs(lesson + study + "--json");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("warning: " + is_void)) << plan;
    const auto document = nlohmann::json::parse(run.out);
    EXPECT_THAT(document["warnings"].get<std::vector<std::string>>(), testing::ElementsAre(is_void, is_idle)) << plan;
    EXPECT_THAT(prs(lesson + study).out, HasSubstr("moved no response")) << plan;
  }
  // Pressures change, on loads that do not.
  const Outcome pressures = prs(lesson + "--json --set 'study={command: solve, plan: grid, " + factors +
                                "responses: [screw.peak_pressure_MPa.max]}'");
  EXPECT_THAT(nlohmann::json::parse(pressures.out)["warnings"].get<std::vector<std::string>>(),
              testing::ElementsAre(testing::HasSubstr("flank_angle: moves no load or stiffness:")));
  // Without overrides all of it changes.
  const Outcome free = prs("study '" PRS_SOURCE_DIR
                           "/configs/04_contacts_from_geometry.yaml' --json --set "
                           "'study={command: solve, plan: grid, " +
                           factors + "responses: [axial_stiffness_N_per_um]}'");
  ASSERT_EQ(free.status, 0) << free.err;
  EXPECT_TRUE(nlohmann::json::parse(free.out)["warnings"].empty());
}

/// Rules of new cases assume contacts for one lead; a study over the lead names the assumptions that refuse designs.
TEST_F(StudyCommand, SaysWhichAssumedValuesRefuseDesigns) {
  const std::string own = (folder.parent_path() / "a.yaml").string();
  ASSERT_EQ(prs("new standard " + own + " --screw-diameter 25mm --lead 5mm").status, 0);
  std::ofstream(own, std::ios::app) << "study: {command: solve, factors: [{path: mechanism.lead, values: [5 mm, 8 mm, "
                                       "10 mm]}], responses: [axial_stiffness_N_per_um]}\n";
  EXPECT_THAT(
      prs("study " + own).out,
      testing::HasSubstr("mechanism.contacts_per_roller: assumed for the values of the file, it does not follow "
                         "the factors,\n  and refuses 2 designs"));
}

TEST_F(StudyCommand, ShardsWithoutSenseAreStatus2) {
  test::write_study_file(file, 10);
  for (const char* shard : {"0/3", "4/3", "1", "a/b", "1/0"}) {
    const Outcome run = prs(into(folder, std::string("--shard ") + shard));
    EXPECT_EQ(run.status, 2) << shard;
    EXPECT_THAT(run.err, HasSubstr(shard));
  }
  EXPECT_EQ(prs("study '" + file.string() + "' --shard 1/2").status, 2);
  EXPECT_EQ(prs("study").status, 2);
  EXPECT_EQ(prs("study merge").status, 2);
  EXPECT_EQ(prs(into(folder, "--threads 0")).status, 2);
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(StudyCommand, InterruptedItContinues) {
  // A busy machine may stop a study too late, at its end or among its files: then one of more designs is used.
  int designs = test::samples(40'000, 40'000);
  for (int tries = 1; !interrupts(designs) || files_in(folder).size() > 1; designs *= 4)
    ASSERT_LT(++tries, 5) << designs;
  EXPECT_EQ(files_in(folder).size(), 1u);

  const Outcome changed = prs(into(folder, "--set study.seed=4"));
  EXPECT_EQ(changed.status, 2);
  EXPECT_THAT(changed.err, HasSubstr(folder.string() + ": error: "));
  EXPECT_THAT(changed.err, HasSubstr("--restart"));

  const std::string loud = "study '" + file.string() + "' --output '";
  const Outcome resumed = prs(loud + folder.string() + "'");
  ASSERT_EQ(resumed.status, 0);
  int total = 0, found = 0, computed = 0;
  ASSERT_EQ(
      std::sscanf(resumed.err.c_str(), "%d designs: %d were in the journal, %d computed", &total, &found, &computed), 3)
      << resumed.err;
  EXPECT_GE(total, designs);  // Including the base case.
  EXPECT_GT(found, 0);
  EXPECT_EQ(found + computed, total);
  const Outcome whole = prs(loud + alone.string() + "'");
  ASSERT_EQ(whole.status, 0);
  EXPECT_EQ(whole.err, "");
  EXPECT_TRUE(files_in(folder) == files_in(alone));
}

TEST_F(StudyCommand, FullDiskIsToldAndNothingIsLost) {
  test::write_study_file(file, 3000);
  const Outcome full = prs(into(folder), "ulimit -f 60;");  // kB, or half of them
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("cannot write '" + journal_path(folder, {}).string() + "'"));
  EXPECT_THAT(full.err, HasSubstr("the same command continues"));
  // The journal fits, the files do not.
  const Outcome later = prs(into(folder), "ulimit -f 400;");
  EXPECT_EQ(later.status, 1);
  EXPECT_THAT(later.err, HasSubstr("study."));
  ASSERT_EQ(prs(into(folder)).status, 0);
  ASSERT_EQ(prs(into(alone)).status, 0);
  EXPECT_TRUE(files_in(folder) == files_in(alone));
}

TEST_F(StudyCommand, WaitsForAProcessThatIsAboutToEnd) {
  test::write_study_file(file, 10);
  fs::create_directory(folder);
  const fs::path lock = folder / "study.lock";
  FileDescriptor holder(::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  ASSERT_EQ(::flock(holder.get(), LOCK_EX | LOCK_NB), 0);
  // The lock is released after the study has requested it.
  const FileDescriptor opened(::inotify_init1(IN_CLOEXEC));
  ASSERT_GE(::inotify_add_watch(opened.get(), lock.c_str(), IN_OPEN), 0);
  test::Process study({test::program(), "study", file.string(), "--output", folder.string()});
  std::array<char, 4096> event;
  ASSERT_GT(::read(opened.get(), event.data(), event.size()), 0);
  holder.close();
  EXPECT_EQ(study.wait(), 0);
  EXPECT_TRUE(fs::exists(folder / "study.json"));
}

TEST_F(StudyCommand, ThatCannotBeDrawnWholeGoesOnWithItsPictures) {
  test::write_study_file(file, 200);
  fs::create_directory(folder);
  std::ofstream(folder / "plots") << "in the way";
  const Outcome half = prs(into(folder));
  EXPECT_EQ(half.status, 1);
  EXPECT_THAT(half.err, HasSubstr("prs: error: cannot write '" + (folder / "plots").string()));
  EXPECT_TRUE(fs::exists(journal_path(folder, {})));
  EXPECT_TRUE(fs::exists(folder / "study.json"));
  fs::remove(folder / "plots");
  ASSERT_EQ(prs(into(folder)).status, 0);
  ASSERT_EQ(prs(into(alone)).status, 0);
  EXPECT_TRUE(files_in(folder) == files_in(alone));
}

TEST_F(StudyCommand, RestartDiscardsWhatWasComputed) {
  test::write_study_file(file, 500);
  fs::create_directory(folder);
  std::ofstream(journal_path(folder, {})) << "no journal";
  EXPECT_EQ(prs(into(folder)).status, 2);
  EXPECT_EQ(prs(into(folder, "--restart")).status, 0);
  EXPECT_TRUE(fs::exists(folder / "study.csv"));
  EXPECT_FALSE(fs::exists(journal_path(folder, {})));
}

TEST_F(StudyCommand, WithoutAFolderOnlySpeaks) {
  test::write_study_file(file, 200);
  const Outcome run = prs("study '" + file.string() + "'", "TMPDIR='" + temporary.path().string() + "'");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out, "");
  EXPECT_EQ(files_in(temporary.path()).size(), 1u);  // study.yaml
}

}  // namespace
}  // namespace prs
