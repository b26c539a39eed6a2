#include "prs/study/study_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/sample_study.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

const DocumentInfo kStudyInfo{"1", "2", "", {}};

TEST(StudyJson, DocumentLeavesOutWhatIsNotDefined) {
  const Json json = study_json(sample::counting(), kStudyInfo);
  EXPECT_EQ(json["study"]["command"], "solve");
  EXPECT_EQ(json["study"]["plan"], "one_at_a_time");
  EXPECT_FALSE(json["study"].contains("samples"));
  EXPECT_EQ(json["study"]["factors"][0]["base"]["value"], "2");
  ASSERT_EQ(json["designs"].size(), 4U);
  EXPECT_FALSE(json.contains("designs_shown"));
  EXPECT_TRUE(json["designs"][0]["settings"].empty());
  EXPECT_EQ(json["designs"][1]["settings"]["x"]["value"], "1");
  EXPECT_EQ(json["designs"][1]["responses"]["y"], 10.0);
  EXPECT_FALSE(json["designs"][2]["converged"]);
  EXPECT_TRUE(json["designs"][2]["responses"].empty());
  const Json& summary = json["summary"];
  EXPECT_EQ(summary["designs"], 4U);
  EXPECT_EQ(summary["refused"], 1U);
  EXPECT_EQ(summary["not_converged"], 0U);
  EXPECT_EQ(summary["statistics"]["y"]["count"], 2U);
  EXPECT_EQ(summary["statistics"]["y"]["mean"], 25.0);
  EXPECT_EQ(summary["statistics"]["y"]["quantiles"]["0.5"], 25.0);
  EXPECT_FALSE(summary.contains("response_surface"));
  EXPECT_FALSE(summary.contains("sobol_indices"));
}

TEST(StudyJson, SettingsNameTheCompanions) {
  Study study;
  study.command = Command::solve;
  study.factors = {sample::counted("x", {1.0, 3.0})};
  study.factors[0].companions = {sample::counted("z", {5.0, 7.0})};
  study.responses = {"y"};
  const auto answer = [](const std::vector<double>& x) { return std::vector{x[0]}; };
  const Json json = study_json(sample::run(study, answer), kStudyInfo);
  EXPECT_EQ(json["study"]["factors"][0]["with"][0]["path"], "z");
  EXPECT_EQ(json["designs"][2]["settings"]["x"]["number"], 3.0);
  EXPECT_EQ(json["designs"][2]["settings"]["z"]["number"], 7.0);
}

TEST(StudyJson, GivesTheEnvelopeWithItsMapsAndPoints) {
  Study study;
  study.command = Command::solve;
  study.plan = Plan::grid;
  study.factors = {sample::counted("a", {1.0, 2.0}), sample::counted("b", {1.0, 3.0, 5.0})};
  for (Factor& factor : study.factors) factor.continuous = true;
  study.responses = {"y", "z"};
  study.envelope = Envelope{.combine = Envelope::Combine::sum,
                            .normalise = Envelope::Normalise::max,
                            .measures = {{"y", 1.0}, {"z", 2.0}},
                            .points = {{"A", {{1.5, 2.0}}, {}}, {"B", {}, {{"y", 11.0}}}}};
  const auto answer = [](const std::vector<double>& x) {
    return x[0] == 2.0 && x[1] == 5.0 ? std::vector<double>{} : std::vector{x[0] * x[1], x[1]};
  };
  const Json json = study_json(sample::run(study, answer), kStudyInfo)["envelope"];
  EXPECT_EQ(json["combine"], "sum");
  EXPECT_EQ(json["normalise"], "max");
  EXPECT_EQ(json["axes"][1]["numbers"], Json({1.0, 3.0, 5.0}));
  EXPECT_EQ(json["measures"][1]["normalised_by"], 5.0);
  EXPECT_EQ(json["measures"][0]["normalised"][0][1], 0.5);
  EXPECT_TRUE(json["values"][1][2].is_null());
  EXPECT_EQ(json["designs_without"], 1U);
  EXPECT_EQ(json["values"][1][1], 1.0 + 2.0 * 3.0 / 5.0);
  EXPECT_EQ(json["max_design"], 3U);
  const Json& a = json["points"][0];
  EXPECT_FALSE(a.contains("design"));
  EXPECT_EQ(a["settings"]["b"]["number"], 2.0);
  EXPECT_EQ(a["responses"]["y"], 3.0);
  EXPECT_EQ(a["envelope"], 3.0 / 6.0 + 2.0 * 2.0 / 5.0);
  EXPECT_EQ(json["points"][1]["reason"], "y lies between 1 and 6 in the grid, 11 is wanted");
}

TEST(StudyJson, RanksContributions) {
  const Json json = study_json(sample::sampled(Plan::latin_hypercube), kStudyInfo);
  EXPECT_EQ(json["study"]["samples"], 500U);
  EXPECT_EQ(json["study"]["seed"], 7U);
  EXPECT_EQ(json["study"]["factors"][0]["distribution"]["uniform"]["from"], 1.0);
  const Json& surface = json["summary"]["response_surface"];
  EXPECT_EQ(surface["designs"], 500U);
  const Json& fit = surface["responses"]["screw.peak_pressure_MPa.max"];
  EXPECT_NEAR(fit["r_squared"], 1.0, 1e-12);
  EXPECT_NEAR(fit["intercept"], 5.0, 1e-12);
  EXPECT_EQ(fit["factors"][0]["path"], "a");
  EXPECT_NEAR(fit["factors"][0]["contribution_percent"], 75.0, 1e-9);
  EXPECT_NEAR(fit["factors"][1]["coefficient"], -1.0, 1e-12);
}

TEST(StudyJson, GivesIndicesWithTheirIntervals) {
  const Json json = study_json(sample::sampled(Plan::sobol_indices, 1024), kStudyInfo);
  const Json& indices = json["summary"]["sobol_indices"]["screw.peak_pressure_MPa.max"];
  EXPECT_EQ(indices["samples"], 1024U);
  EXPECT_EQ(indices["samples_left_out"], 0U);
  EXPECT_EQ(indices["factors"][0]["path"], "a");
  EXPECT_NEAR(indices["factors"][0]["first"]["value"], 0.9, 0.02);
  EXPECT_GT(indices["factors"][0]["first"]["half_width_95"], 0.0);
  EXPECT_NEAR(indices["factors"][2]["total"]["value"], 0.0, 1e-12);
}

TEST(StudyJson, SaysHowManyDesignsItShows) {
  const Json json = study_json(sample::sampled(Plan::monte_carlo, kMostRowsShown + 5), kStudyInfo);
  EXPECT_EQ(json["designs_shown"], kMostRowsShown);
  EXPECT_EQ(json["designs"].size(), kMostRowsShown);
  EXPECT_EQ(json["summary"]["designs"], kMostRowsShown + 6);
  EXPECT_EQ(json["summary"]["statistics"]["nut.peak_pressure_MPa.max"]["count"], kMostRowsShown + 5);
}

TEST(StudyJson, TextIsThatOfTheDocument) {
  const auto expect_same = [](const StudyResult& result) {
    std::string text;
    write_study(study_outline(result, kStudyInfo), result, [&](std::string_view piece) { text += piece; });
    EXPECT_EQ(text, json_text(study_json(result, kStudyInfo)));
  };
  expect_same(sample::counting());
  expect_same(sample::sampled(Plan::latin_hypercube));
  StudyResult odd = sample::counting();
  odd.study.responses.front() = "a \"key\" \\ \u00b5";
  ASSERT_GE(odd.rows.size(), 3U);
  odd.rows[0].responses.front() = -1.5e-300;
  odd.rows[1].responses.front() = std::nullopt;
  odd.rows[1].status = {"refused", "got \"x\"\n\x1b[1m; \u202e \xff"};
  odd.rows[2].responses.front() = 3.0;
  odd.rows[2].design.settings.clear();
  expect_same(odd);
  odd.rows.clear();
  expect_same(odd);
}

}  // namespace
}  // namespace prs
