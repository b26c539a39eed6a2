#include "prs/output/study_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/prs/output/sample_study.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

const DocumentInfo kInfo{"1", "2", "", {}};

TEST(StudyJson, DocumentLeavesOutWhatIsNotDefined) {
  const Json json = study_json(sample::counting(), kInfo);
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

TEST(StudyJson, RanksContributions) {
  const Json json = study_json(sample::sampled(Plan::latin_hypercube), kInfo);
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
  const Json json = study_json(sample::sampled(Plan::sobol_indices, 1024), kInfo);
  const Json& indices = json["summary"]["sobol_indices"]["screw.peak_pressure_MPa.max"];
  EXPECT_EQ(indices["samples"], 1024U);
  EXPECT_EQ(indices["samples_left_out"], 0U);
  EXPECT_EQ(indices["factors"][0]["path"], "a");
  EXPECT_NEAR(indices["factors"][0]["first"]["value"], 0.9, 0.02);
  EXPECT_GT(indices["factors"][0]["first"]["half_width_95"], 0.0);
  EXPECT_NEAR(indices["factors"][2]["total"]["value"], 0.0, 1e-12);
}

TEST(StudyJson, SaysHowManyDesignsItShows) {
  const Json json = study_json(sample::sampled(Plan::monte_carlo, kMostRowsShown + 5), kInfo);
  EXPECT_EQ(json["designs_shown"], kMostRowsShown);
  EXPECT_EQ(json["designs"].size(), kMostRowsShown);
  EXPECT_EQ(json["summary"]["designs"], kMostRowsShown + 6);
  EXPECT_EQ(json["summary"]["statistics"]["nut.peak_pressure_MPa.max"]["count"],
            kMostRowsShown + 5);
}

}  // namespace
}  // namespace prs
