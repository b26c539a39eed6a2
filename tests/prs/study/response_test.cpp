#include "prs/study/response.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace prs {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::ordered_json;

const Json kDocument = Json::parse(R"({
  "contact": {"nut": {"backlash_mm": 0.5}},
  "load_cases": [
    {"name": "a", "axial_force_N": 1.5, "screw": {"axial_load_N": [3, 1, 2]}, "slip": {"efficiency": 0.8}},
    {"name": "b", "axial_force_N": 2.5}]})");

TEST(Response, IsANumberOfTheFirstLoadCaseOrOfTheDocument) {
  EXPECT_EQ(response(kDocument, "axial_force_N"), 1.5);
  EXPECT_EQ(response(kDocument, "slip.efficiency"), 0.8);
  EXPECT_EQ(response(kDocument, "contact.nut.backlash_mm"), 0.5);
  EXPECT_EQ(response(kDocument, "load_cases[1].axial_force_N"), 2.5);
}

TEST(Response, SummarisesArrays) {
  EXPECT_EQ(response(kDocument, "screw.axial_load_N[1]"), 1.0);
  EXPECT_EQ(response(kDocument, "screw.axial_load_N.max"), 3.0);
  EXPECT_EQ(response(kDocument, "screw.axial_load_N.min"), 1.0);
  EXPECT_EQ(response(kDocument, "screw.axial_load_N.mean"), 2.0);
}

TEST(Response, SummarisesRowsByRollerAndThread) {
  const Json document = Json::parse(R"({"load_cases": [{"screw": {"normal_load_N": [[3, 1], [2, 6]]}}]})");
  EXPECT_EQ(response(document, "screw.normal_load_N[1][0]"), 2.0);
  EXPECT_EQ(response(document, "screw.normal_load_N[0].max"), 3.0);
  EXPECT_EQ(response(document, "screw.normal_load_N.max"), 6.0);
  EXPECT_EQ(response(document, "screw.normal_load_N.mean"), 3.0);
  EXPECT_FALSE(response(document, "screw.normal_load_N[1]"));
  EXPECT_THAT(response_paths(document), ElementsAre("screw.normal_load_N.max"));
}

TEST(Response, IsAbsentWhereThePathLeadsNowhere) {
  for (const char* path : {"", ".", "name", "slip", "slip.", "slip..efficiency", "slip.efficienc", "screw.axial_load_N",
                           "screw.axial_load_N[3]", "screw.axial_load_N[", "screw.axial_load_N[x]",
                           "screw.axial_load_N.max.max", "load_cases[9].name", "[0]"})
    EXPECT_FALSE(response(kDocument, path)) << path;
  EXPECT_FALSE(response(nullptr, "x"));
}

TEST(Response, KnowsItsPaths) {
  EXPECT_THAT(response_paths(kDocument),
              ElementsAre("axial_force_N", "screw.axial_load_N.max", "slip.efficiency", "contact.nut.backlash_mm"));
}

}  // namespace
}  // namespace prs
