#include "modules/module.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../study/study_file.h"
#include "support/program.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The program in a folder without its modules.
class WithoutModules : public testing::Test {
 protected:
  WithoutModules() {
    fs::create_directories(alone.parent_path());
    fs::copy_file(test::program(), alone);
    test::write_study_file(file, 20);
  }
  test::Outcome run(const std::string& arguments, const std::string& before = "") const {
    return test::run_prs(arguments, PRS_SOURCE_DIR, before, alone.string());
  }
  test::Outcome study(const std::string& options, const std::string& before = "") const {
    return run("study '" + file.string() + "' --quiet --output '" + folder.string() + "' " + options, before);
  }

  const test::TemporaryDirectory temporary;
  const fs::path alone = temporary.path() / "some/bin/prs";
  const fs::path file = temporary.path() / "study.yaml";
  const fs::path folder = temporary.path() / "out";
};

TEST_F(WithoutModules, CasesAreSolved) {
  EXPECT_EQ(run("solve configs/01_config_1_to_3.yaml").out, test::run_prs("solve configs/01_config_1_to_3.yaml").out);
}

/// CHOLMOD is part of the program; documents say so.
TEST_F(WithoutModules, SparseMatricesAreCholmods) {
  for (const std::string lesson : {"01_config_1_to_3", "26_unequal_rollers"}) {
    const std::string written = run("solve configs/" + lesson + ".yaml --json --quiet").out;
    EXPECT_THAT(written.substr(std::min(written.size(), written.find("\"factorization\"")), 70),
                testing::ContainsRegex("^\"factorization\": \"CHOLMOD [0-9.]+, simplicial LDL'\""));
  }
}

TEST_F(WithoutModules, OneThreadIsTheDefaultWithoutTbb) {
  const test::Outcome outcome = study("");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "study.csv"));
}

TEST_F(WithoutModules, WhatCannotDoWithoutThemSaysSo) {
  const test::Outcome threads = study("--threads 2");
  EXPECT_EQ(threads.status, 1);
  EXPECT_EQ(threads.err,
            "prs: error: this needs TBB, and prs_tbb.so is not next to the program; install "
            "libtbb-dev and build prs again, or take --threads 1\n");
  const test::Outcome optimum = run("optimize configs/23_crowning.yaml --threads 1 --quiet");
  EXPECT_EQ(optimum.status, 1);
  EXPECT_EQ(optimum.err,
            "prs: error: this needs pagmo, and prs_pagmo.so is not next to the program; install "
            "libpagmo-dev and build prs again\n");
  const test::Outcome fit = run("fit configs/37_bench.yaml --threads 1 --quiet");
  EXPECT_EQ(fit.status, 1);
  EXPECT_EQ(fit.err,
            "prs: error: this needs Ceres Solver, and prs_fit.so is not next to the program; install "
            "libceres-dev and build prs again\n");
}

TEST_F(WithoutModules, FoundBesideTheProgramOrBelowLib) {
  for (const fs::path below : {"some/bin", "some/bin/lib/prs", "some/lib/prs", "lib/prs"}) {
    const fs::path module = temporary.path() / below / "prs_tbb.so";
    fs::create_directories(module.parent_path());
    std::ofstream(module) << "no library";
    EXPECT_THAT(study("--threads 2").err,
                AllOf(HasSubstr("this needs TBB, and prs_tbb.so does not load"),
                      HasSubstr((temporary.path() / below).string()), HasSubstr("or take --threads 1")))
        << below;
    fs::remove(module);
  }
}

TEST_F(WithoutModules, NamesTheLibraryThatAModuleLacks) {
  std::string module = test::content_of(fs::path(test::program()).parent_path() / "../../lib/prs/prs_tbb.so");
  const std::size_t name = module.find("libtbb.so");
  ASSERT_NE(name, std::string::npos);
  module.replace(name, 6, "libxyz");
  const fs::path modules = temporary.path() / "some/lib/prs";
  fs::create_directories(modules);
  std::ofstream(modules / "prs_tbb.so") << module;
  EXPECT_THAT(study("--threads 2").err, AllOf(HasSubstr("prs: error: this needs TBB, and libxyz.so"),
                                              HasSubstr(" is not installed; install TBB, on Debian by `apt install "
                                                        "libtbb-dev`, or take --threads 1\n")));
}

/// Names of all libraries that a run loads.
std::string libraries(const std::string& arguments) {
  return test::run_prs(arguments, PRS_SOURCE_DIR, "LD_DEBUG=files").err;
}

TEST(Modules, AreLoadedByRunsThatNeedThemOnly) {
  const std::string loaded = libraries("solve configs/01_config_1_to_3.yaml");
  EXPECT_THAT(loaded, HasSubstr("libstdc++"));
  for (const char* name : {"libpagmo", "libceres", "libtbb", "libboost"}) EXPECT_THAT(loaded, Not(HasSubstr(name)));
}

}  // namespace
}  // namespace prs
