#include "prs/output/files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>

#include "prs/sha256.h"
#include "prs/study/journal.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RunFilesTest : public testing::Test {
 protected:
  RunFilesTest() {
    write(one, "case: 1\n");
    write(two, "case: 2\n");
  }
  static void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
  /// A run that writes files with their names as content.
  std::vector<std::string> run(const std::string& command, const fs::path& case_file,
                               const std::vector<std::string>& names,
                               const std::vector<std::string>& overrides = {}) const {
    RunFiles files(folder, command, case_file, overrides);
    for (const std::string& name : names)
      write_files((folder / name).parent_path(), {{fs::path(name).filename().string(), name}});
    return files.finish();
  }
  /// Writes a list of files as if of a former run.
  void list(const std::map<std::string, std::string>& files) const {
    const nlohmann::json json{{"runs", {{{"command", "solve"}, {"case", "of another"}, {"files", files}}}}};
    write(folder / kFileList, json.dump());
  }
  /// Files below the folder except the list.
  std::vector<std::string> present() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (!entry.is_directory() && entry.path().filename() != kFileList)
        names.push_back(entry.path().lexically_relative(folder).string());
    std::ranges::sort(names);
    return names;
  }

  const test::TemporaryDirectory temporary;
  const fs::path folder = temporary.path() / "output";
  const fs::path one = temporary.path() / "one.yaml", two = temporary.path() / "two.yaml";
};

TEST_F(RunFilesTest, ResultsOfAnotherCaseGoAndOwnFilesStay) {
  EXPECT_THAT(run("solve", one, {"a.csv", "plots/a.svg", "plots/old/b.svg"}), IsEmpty());
  EXPECT_THAT(run("contact", one, {"contact.json"}), IsEmpty());
  write(folder / "notes.txt", "mine");
  EXPECT_THAT(run("slip", two, {"plots/a.svg", "slip.csv"}), ElementsAre(HasSubstr("3 files of earlier runs removed")));
  EXPECT_THAT(present(), ElementsAre("notes.txt", "plots/a.svg", "slip.csv"));
  EXPECT_FALSE(fs::exists(folder / "plots/old"));
}

TEST_F(RunFilesTest, CommandsOfOneCaseKeepEachOthersFiles) {
  run("check", one, {"check.json"});
  run("solve", one, {"shared.csv", "result.json", "plots/a.svg"});
  run("slip", one, {"shared.csv", "slip.csv"});
  EXPECT_THAT(run("solve", one, {"result.json"}), ElementsAre(HasSubstr("1 file of earlier runs removed")));
  EXPECT_THAT(present(), ElementsAre("check.json", "result.json", "shared.csv", "slip.csv"));
}

TEST_F(RunFilesTest, WhatCommandsWithoutACaseWroteIsTheirOwn) {
  run("solve", one, {"result.json"});
  run("validate", "", {"validation.json", "yao/a.csv"});
  run("solve", two, {"other.json"});
  EXPECT_THAT(present(), ElementsAre("other.json", "validation.json", "yao/a.csv"));
  run("validate", "", {"validation.json"});
  EXPECT_THAT(present(), ElementsAre("other.json", "validation.json"));
}

TEST_F(RunFilesTest, ChangedFilesStayAndAreNamed) {
  run("solve", one, {"a.csv", "b.csv"});
  write(folder / "a.csv", "A.csv");  // With the same length as before.
  EXPECT_THAT(run("solve", two, {"c.csv"}),
              ElementsAre(HasSubstr("1 file of earlier runs removed"), HasSubstr("a.csv")));
  EXPECT_THAT(present(), ElementsAre("a.csv", "c.csv"));
  EXPECT_THAT(run("solve", one, {"c.csv"}), IsEmpty());
  EXPECT_THAT(present(), ElementsAre("a.csv", "c.csv"));
}

TEST_F(RunFilesTest, TheRunThatACaseComesFromKeepsItsFiles) {
  run("optimize", one, {"best.yaml", "front.csv"});
  run("solve", one, {"result.json"});
  run("solve", folder / "best.yaml", {"result.json"});
  run("slip", folder / "best.yaml", {"slip.csv"});
  EXPECT_THAT(present(), ElementsAre("best.yaml", "front.csv", "result.json", "slip.csv"));
  EXPECT_THAT(run("solve", two, {"result.json"}),
              ElementsAre(HasSubstr("an optimization of another case"), HasSubstr("removed")));
  EXPECT_THAT(present(), ElementsAre("best.yaml", "front.csv", "result.json"));
}

TEST_F(RunFilesTest, OverridesMakeAnotherCaseAndCommentsDoNot) {
  run("slip", one, {"slip.csv"});
  write(one, "# Another comment.\n" + content_of(one));
  run("contact", one, {"contact.json"});
  EXPECT_THAT(present(), ElementsAre("contact.json", "slip.csv"));
  run("contact", one, {"contact.json"}, {"mechanism.rollers=7"});
  EXPECT_THAT(present(), ElementsAre("contact.json"));
}

TEST_F(RunFilesTest, AFolderTakesOneRunAtATime) {
  {
    RunFiles first(folder, "slip", one);
    write_files(folder, {{"slip.csv", "slip"}});
    try {
      RunFiles(folder, "solve", two);
      FAIL() << "two runs at once";
    } catch (const StudyFolderError& error) {
      EXPECT_THAT(error.what(), HasSubstr(fmt::format("(prs slip, number {})", ::getpid())));
    }
    EXPECT_THAT(first.finish(), IsEmpty());
  }
  EXPECT_THAT(present(), ElementsAre("slip.csv"));
}

TEST_F(RunFilesTest, AFolderThatARunMadeForNothingGoesAgain) {
  { const RunFiles nothing(folder / "deeper", "solve", one); }
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(RunFilesTest, WhatIsNoFileStays) {
  fs::create_directories(folder);
  fs::create_symlink(one, folder / "link");
  write(folder / kFileList, R"({"about": "", "runs": [{"command": "solve", "case": "x", "files": {"link": ""}}]})");
  run("solve", one, {"a.csv"});
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
}

TEST_F(RunFilesTest, ARunThatWritesNothingOrFailsRemovesNothing) {
  run("solve", one, {"a.csv", "b.csv"});
  EXPECT_THAT(run("solve", two, {}), IsEmpty());
  {
    RunFiles files(folder, "solve", two);
    write_files(folder, {{"a.csv", "new"}, {"c.csv", "new"}});
  }
  EXPECT_THAT(present(), ElementsAre("a.csv", "b.csv", "c.csv"));
  run("solve", two, {"a.csv"});
  EXPECT_THAT(present(), ElementsAre("a.csv"));
}

TEST_F(RunFilesTest, JournalsStayWhateverIsListed) {
  const std::string journal = "study.1-of-1.journal";
  write(folder / journal, "rows");
  list({{journal, sha256("rows")}, {"study.lock", sha256("")}});
  run("solve", two, {"a.csv"});
  EXPECT_THAT(present(), ElementsAre("a.csv", journal));
}

TEST_F(RunFilesTest, NoListReachesOutOfItsFolder) {
  const fs::path outside = temporary.path() / "outside";
  for (const char* name : {"x", "linked/x"}) write(outside / name, "precious");
  fs::create_directory(folder);
  fs::create_directory_symlink(outside / "linked", folder / "folder");
  fs::create_symlink(outside / "x", folder / "file");
  const std::vector<std::string> crafted{"../outside/x",
                                         outside / "x",
                                         "folder/x",
                                         "file",
                                         "folder/../../outside/x",
                                         "./../outside/x",
                                         "folder//x",
                                         "",
                                         ".",
                                         "..",
                                         "plots/",
                                         std::string("../outside/x\0y", 14)};
  std::map<std::string, std::string> files;
  for (const std::string& path : crafted) files[path] = sha256("precious");
  list(files);
  EXPECT_THAT(run("solve", two, {"a.csv"}), testing::SizeIs(testing::Le(1U)));
  EXPECT_EQ(content_of(outside / "x"), "precious");
  EXPECT_EQ(content_of(outside / "linked/x"), "precious");
  EXPECT_TRUE(fs::is_symlink(folder / "file"));
  EXPECT_TRUE(fs::is_symlink(folder / "folder"));
}

TEST_F(RunFilesTest, DamagedOrPlantedListsAreReplacedAndNothingIsRemoved) {
  for (const char* text : {"", "{", "[]", R"({"runs": 1})", R"({"runs": [{"command": 1}]})",
                           R"({"runs": [{"command": "solve", "case": "", "files": {"a": 1}}]})"}) {
    fs::remove_all(folder);
    write(folder / kFileList, text);
    write(folder / "a", "");
    EXPECT_THAT(run("solve", one, {"b"}), ElementsAre(HasSubstr("no list of what prs wrote")));
    EXPECT_THAT(present(), ElementsAre("a", "b"));
    EXPECT_TRUE(nlohmann::json::accept(content_of(folder / kFileList)));
  }
  fs::remove(folder / kFileList);
  write(temporary.path() / "target", "precious");
  fs::create_symlink(temporary.path() / "target", folder / kFileList);
  EXPECT_THROW(run("solve", one, {"b"}), std::runtime_error);
  EXPECT_TRUE(fs::is_symlink(folder / kFileList));
  EXPECT_EQ(content_of(temporary.path() / "target"), "precious");
}

TEST_F(RunFilesTest, CasesForTheUserAreNotListed) {
  RunFiles files(folder, "configurations", "");
  write_files(folder, {{"configurations.json", ""}});
  write_case(folder / "mine.yaml", "case");
  files.finish();
  EXPECT_EQ(content_of(folder / kFileList).find("mine.yaml"), std::string::npos);
  EXPECT_NE(content_of(folder / kFileList).find("configurations.json"), std::string::npos);
}

/// A later run would remove what is listed.
TEST_F(RunFilesTest, AnOriginalIsNoCopyOfItself) {
  const auto fit_of = [&](const fs::path& original) {
    RunFiles files(folder, "fit", one);
    write_files(folder, {{"fit.json", ""}, {"readings.csv", "readings", original}});
    files.finish();
  };
  write(folder / "readings.csv", "readings");
  fit_of(folder / "readings.csv");
  run("solve", two, {"result.json"});
  EXPECT_THAT(present(), ElementsAre("readings.csv", "result.json"));
  write(temporary.path() / "far" / "readings.csv", "readings");
  fit_of(temporary.path() / "far" / "readings.csv");
  run("solve", two, {"result.json"});
  EXPECT_THAT(present(), ElementsAre("result.json"));
}

}  // namespace
}  // namespace prs
