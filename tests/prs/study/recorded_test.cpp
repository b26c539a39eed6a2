#include "prs/study/recorded.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "prs/input/reader.h"
#include "prs/run/analyses.h"
#include "prs/study/design_engine.h"
#include "prs/study/study_figures.h"
#include "prs/study/study_json.h"
#include "prs/study/study_table.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/program.h"
#include "tests/support/sample_study.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

input::StudyInput study_of(const std::string& study) {
  return input::read_study_input({"case.yaml", input::kAbevi + "study: " + study + "\n", {}});
}

/// A study of the threads of a case over their number, 18 to 22 with 20 in the file.
input::StudyInput over_threads(const std::string& responses, const std::string& bodies = "bars") {
  input::StudyInput in = study_of(
      "{command: solve, plan: grid, factors: [{path: mechanism.contacts_per_roller, values: [18, 22]}], responses: [" +
      responses + "]}");
  in = input::read_study_input({"case.yaml", in.source.text + "model: {bodies: " + bodies + "}\n", {}});
  return in;
}

TEST(Recorded, AnArrayHasAColumnForEachThreadOfTheLongestRoller) {
  for (const char* bodies : {"bars", "refined"}) {
    const input::StudyInput in = over_threads("screw.load_rate_percent.max, screw.load_rate_percent", bodies);
    const DesignEngine engine(in);
    const std::vector<std::string>& columns = engine.study().responses;
    ASSERT_EQ(columns.size(), 23U);
    EXPECT_EQ(columns[1], "screw.load_rate_percent[0]");
    EXPECT_EQ(columns[22], "screw.load_rate_percent[21]");
    const RowBlock block = engine.evaluate(0, 3);
    for (const auto& [row, threads] : {std::pair{0U, 20U}, {1U, 18U}, {2U, 22U}}) {
      const double* all = &block.responses[row * columns.size()];
      EXPECT_NEAR(std::accumulate(all + 1, all + 1 + threads, 0.0), 100.0, 1e-6) << bodies;
      EXPECT_EQ(*std::max_element(all + 1, all + 1 + threads), all[0]);
      for (std::size_t k = threads; k < 22; ++k) EXPECT_TRUE(std::isnan(all[1 + k])) << k;
    }
  }
}

TEST(Recorded, ColumnsOfEntriesInARowAreAnArray) {
  const std::vector<std::string> columns{"a",       "b.c[0]",  "b.c[1]",  "b.c[2]", "d[1]", "e[0]",
                                         "f[0][0]", "f[0][1]", "f[0][2]", "g[0]",   "g[1]"};
  const std::vector<Recorded> all = recorded(columns);
  ASSERT_EQ(all.size(), 7U);
  EXPECT_EQ(all[1].path, "b.c");
  EXPECT_EQ(all[1].first, 1U);
  EXPECT_EQ(all[1].count, 3U);
  EXPECT_EQ(all[2].path, "d[1]");
  EXPECT_FALSE(all[3].is_array());
  EXPECT_EQ(all[4].path, "f[0]");
  EXPECT_EQ(all[5].path, "g[0]");
  EXPECT_TRUE(are_columns_of({"a", "b.c", "d[1]", "e[0]", "f[0]", "g"}, columns));
  EXPECT_TRUE(are_columns_of(columns, columns));
  EXPECT_FALSE(are_columns_of({"a", "d[1]", "e[0]", "f[0]", "g"}, columns));
  EXPECT_FALSE(are_columns_of({"a", "b.c"}, columns));
  EXPECT_FALSE(are_columns_of({"a", "b", "b.c", "d[1]", "e[0]", "f[0]", "g"}, columns));
}

/// Error by which a study of these responses is refused.
std::string refusal(const std::string& study, const std::string& more = "") {
  try {
    const input::StudyInput in =
        input::read_study_input({"case.yaml", input::kAbevi + "study: " + study + "\n" + more, {}});
    const DesignEngine engine(in);
  } catch (const UnknownResponse& error) {
    return fmt::format("{}: {}", error.index(), error.what());
  }
  return "";
}

TEST(Recorded, WhatIsNoNumberIsRefused) {
  const auto of = [](const std::string& responses, const std::string& more = "") {
    return refusal(
        "{command: solve, factors: [{path: mechanism.rollers, values: [9]}], responses: [" + responses + "]}", more);
  };
  EXPECT_THAT(of("axial_displacement_um, 'screw.load_rate_percent[20]'"),
              HasSubstr("1: got screw.load_rate_percent[20]; expected an entry of an array of 20; write "
                        "`screw.load_rate_percent[0]` to `screw.load_rate_percent[19]`"));
  EXPECT_THAT(of("screw.load_rate_percent, 'screw.load_rate_percent[3]'"),
              HasSubstr("1: got screw.load_rate_percent[3] a second time, with its array"));
  EXPECT_THAT(of("screw.load_rate_percent", "model: {mechanism: full}\n"),
              HasSubstr("a row for each roller; expected a number or one row; write for example "
                        "`screw.load_rate_percent[0]`"));
  EXPECT_THAT(of("'references[0].models[0].rms_deviation'"), HasSubstr("of a case with `references`"));
  EXPECT_THAT(refusal("{command: solve, plan: grid, factors: [{path: structure.nut.outer_diameter, values: [46 mm, 50 "
                      "mm]}, {path: structure.screw.bore, values: [5 mm, 6 mm]}], envelope: {measures: [{response: "
                      "screw.load_rate_percent}]}}"),
              HasSubstr("got screw.load_rate_percent, an array of 20 numbers; expected one number; write for example "
                        "`screw.load_rate_percent.max`"));
}

TEST(Recorded, ArraysNeedADesignThatHasAnAnswer) {
  Study study;
  study.command = Command::solve;
  study.responses = {"axial_displacement_um", "iterations", "screw.load_rate_percent.max"};
  EXPECT_EQ(recorded_columns(study, nullptr, 0, Arrays::recorded), study.responses);
  study.responses.emplace_back("screw.load_rate_percent");
  try {
    recorded_columns(study, nullptr, 0, Arrays::recorded);
    FAIL();
  } catch (const UnknownResponse& error) {
    EXPECT_EQ(error.index(), 3U);
    EXPECT_THAT(error.what(), HasSubstr("an array; expected a file whose own design has an answer"));
  }
}

/// y = x + k in thread k of 3, of which x = 4 has two.
StudyResult threads_over_x() {
  Study study;
  study.command = Command::solve;
  study.factors = {sample::counted("x", {1.0, 3.0, 4.0}), sample::counted("z", {5.0, 6.0})};
  study.responses = {"w", "screw.load_rate_percent[0]", "screw.load_rate_percent[1]", "screw.load_rate_percent[2]"};
  return sample::run(study, [](const std::vector<double>& x) {
    return std::vector{7.0, x[0] + 1.0, x[0] + 2.0, x[0] == 4.0 ? kNoResponse : x[0] + 3.0};
  });
}

TEST(Recorded, DocumentsHaveArraysAsLongAsInTheDesign) {
  const Json json = study_json(threads_over_x(), {"1", "2", "", {}});
  EXPECT_EQ(json["designs"][1]["responses"], (Json{{"w", 7.0}}));
  EXPECT_EQ(json["designs"][1]["arrays"], (Json{{"screw.load_rate_percent", {2.0, 3.0, 4.0}}}));
  EXPECT_EQ(json["designs"][3]["arrays"], (Json{{"screw.load_rate_percent", {5.0, 6.0}}}));
}

TEST(Recorded, TablesShowTheLargestEntry) {
  const std::string table = study_table(threads_over_x());
  EXPECT_THAT(table, HasSubstr("largest"));
  EXPECT_THAT(table, testing::ContainsRegex(" 3 +7 +6\n"));
}

TEST(Recorded, ArraysAreDrawnOverEachFactor) {
  const StudyResult result = threads_over_x();
  const Figures figures = prs::figures(study_pictures(result));
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.push_back(figure.name);
  EXPECT_THAT(names, ElementsAre("02_screw_load_rate_percent_x", "02_screw_load_rate_percent_z", "01_w"));
  const GridData& grid = figures[0].panels.at(0).map.grid;
  EXPECT_THAT(grid.x, ElementsAre(1.0, 3.0, 4.0));
  EXPECT_THAT(grid.y, ElementsAre(1.0, 2.0, 3.0));
  EXPECT_EQ(grid.at(1, 2), 6.0);
  EXPECT_TRUE(std::isnan(grid.at(2, 2)));
  EXPECT_TRUE(figures[0].panels.at(1).surface);
  EXPECT_EQ(figures[0].y.label, "Thread");
}

TEST(Recorded, AGridIsDrawnOverItsLongestFactorWithTheOthersHeld) {
  StudyResult of = threads_over_x();
  Study study = of.study;
  study.plan = Plan::grid;
  study.factors[1].base = Level{"6", 6.0};
  const StudyResult result = sample::run(study, [](const std::vector<double>& x) {
    return std::vector{7.0, x[0] * x[1], x[0] + x[1], x[0] - x[1]};
  });
  const Figures figures = array_surfaces(result, {});
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].panels.at(0).map.grid.at(2, 0), 24.0);
  EXPECT_THAT(figures[0].title, HasSubstr("6"));
}

/// Bars against the shares that finite elements find: with the same model the study records what `compare` reports.
TEST(Recorded, DeviationsOfReferencesAreThoseOfCompare) {
  const input::Source source = input::load_source(PRS_SOURCE_DIR "/configs/38_reference.yaml", {});
  input::Source with_study = source;
  with_study.text +=
      "study: {command: solve, factors: [{path: structure.nut.outer_diameter, values: [46 mm, 52 mm]}], responses: "
      "['references[0].models[0].rms_deviation', 'references[12].models[0].largest_deviation.percent_of_mean']}\n";
  const input::StudyInput in = input::read_study_input(with_study);
  const RowBlock block = DesignEngine(in).evaluate(0, 3);
  ASSERT_TRUE(block.failures.empty());
  for (const auto& [row, set] : {std::pair{1, "46 mm"}, {2, "52 mm"}}) {
    input::Source design = source;
    design.overrides = {fmt::format("structure.nut.outer_diameter={}", set)};
    for (const AnyAnalysis& analysis : analyses()) {
      if (analysis.command != Command::compare) continue;
      const Json references = run(analysis, design).document({})["references"];
      const double* found = &block.responses[static_cast<std::size_t>(2 * row)];
      EXPECT_NEAR(found[0], references[0]["models"][0]["rms_deviation"].get<double>(), 1e-9);
      EXPECT_NEAR(found[1], references[12]["models"][0]["largest_deviation"]["percent_of_mean"].get<double>(), 1e-9);
    }
  }
  EXPECT_NE(block.responses[2], block.responses[4]);
}

/// Jung 2017, figs. 4.1 and 4.6 with table 4.10: a thin nut and a long pitch load the first threads. Starts do not:
/// neighbouring contacts are a pitch apart.
TEST(Recorded, FirstThreadsOfJungsSweeps) {
  const input::StudyInput in =
      input::read_study_input(input::load_source(PRS_SOURCE_DIR "/configs/19_jung_sweeps.yaml", {}));
  const DesignEngine engine(in);
  const Study& study = engine.study();
  const RowBlock block = engine.evaluate(0, design_count(study));
  const auto first = static_cast<std::size_t>(std::ranges::find(study.responses, "nut.load_rate_percent[0]") -
                                              study.responses.begin());
  std::map<std::string, std::vector<double>> of;
  for (std::size_t k = 1; k < block.rows; ++k)
    if (const double share = block.responses[k * study.responses.size() + first]; std::isfinite(share))
      of[study.factors[design(study, k).settings.at(0).factor].label].push_back(share);
  EXPECT_TRUE(std::ranges::is_sorted(of.at("D_n"), std::greater<>()));
  EXPECT_TRUE(std::ranges::is_sorted(of.at("5 p, lead")));
  EXPECT_GT(of.at("5 p, lead").back(), 1.5 * of.at("5 p, lead").front());
  ASSERT_EQ(of.at("N_s, same pitch").size(), 15U);
  EXPECT_NEAR(of.at("N_s, same pitch").back(), of.at("N_s, same pitch").front(), 0.1);
}

TEST(Recorded, TheProgramRefusesArraysWhereTheyStand) {
  const test::TemporaryDirectory folder;
  const auto run = [&](const std::string& command, const std::string& block) {
    std::ofstream(folder.path() / "case.yaml") << input::kAbevi << block;
    return test::run_prs(command + " case.yaml --quiet", folder.path());
  };
  const test::Outcome objective = run("optimize", R"(
optimize:
  command: solve
  variables: [{path: structure.nut.outer_diameter, from: 44 mm, to: 48 mm}]
  objectives:
    - {minimize: screw.load_rate_percent}
)");
  EXPECT_EQ(objective.status, 2);
  EXPECT_THAT(objective.err, testing::ContainsRegex("case.yaml:[0-9]+:[0-9]+: error: optimize.objectives\\[0\\].*got "
                                                    "screw.load_rate_percent, an array of 20 numbers"));
  const test::Outcome entry = run("study", R"(
study:
  command: solve
  factors: [{path: mechanism.rollers, values: [9]}]
  responses:
    - screw.load_rate_percent[20]
)");
  EXPECT_EQ(entry.status, 2);
  EXPECT_THAT(entry.err, testing::ContainsRegex("case.yaml:[0-9]+:[0-9]+: error: study.responses\\[0\\].*expected an "
                                                "entry of an array of 20"));
}

TEST(Recorded, ShardsOfArraysMerge) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "case.yaml") << over_threads("nut.axial_load_N, axial_displacement_um").source.text;
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(
        test::run_prs(fmt::format("study case.yaml --quiet --output parts --shard {}", shard), folder.path()).status,
        0);
  ASSERT_EQ(test::run_prs("study merge parts --quiet --output whole", folder.path()).status, 0);
  ASSERT_EQ(test::run_prs("study case.yaml --quiet --output alone", folder.path()).status, 0);
  const std::string csv = test::content_of(folder.path() / "whole" / "study.csv");
  EXPECT_EQ(csv, test::content_of(folder.path() / "alone" / "study.csv"));
  EXPECT_THAT(csv, HasSubstr(",nut.axial_load_N[0],nut.axial_load_N[1],"));
  EXPECT_THAT(csv, HasSubstr(",nut.axial_load_N[21],axial_displacement_um\n"));
}

}  // namespace
}  // namespace prs
