#include <gtest/gtest.h>

#include <limits>

#include "prs/losses/solve_analysis.h"
#include "prs/record/delivery.h"
#include "tests/support/sample_result.h"

namespace prs {
namespace {

using test::equal_share_case;
using test::failed_case;
using test::solved_case;

const DocumentInfo kInfo{"1.2.3", "1", "abc"};

nlohmann::ordered_json case_json(LoadCaseResult load_case) {
  Result result;
  result.load_cases = {std::move(load_case)};
  return document_of(solve_analysis(), result, kInfo).at("load_cases").at(0);
}

TEST(Json, EveryDocumentSaysItsOrigin) {
  Result result;
  result.warnings = {Warning{"", "", "negative backlash"}};
  const auto json = document_of(solve_analysis(), result, kInfo);
  EXPECT_EQ(json.at("prs_version"), "1.2.3");
  EXPECT_EQ(json.at("schema_version"), "1");
  EXPECT_EQ(json.at("input_sha256"), "abc");
  EXPECT_EQ(json.at("warnings").at(0), "negative backlash");
  EXPECT_TRUE(json.at("load_cases").empty());
  EXPECT_FALSE(json.contains("contact"));
}

TEST(Json, InterfaceOfTheGeometryWithoutContactIsAbsent) {
  Result result;
  result.contacts.threads.centre_distance = 14e-3;
  InterfaceContact& nut = result.contacts.interfaces.nut;
  nut.geometry.point.status = contact::ContactPointStatus::ok;
  nut.geometry.relative.first = 100.0;
  nut.geometry.relative.second = 300.0;
  nut.geometry.point.normal = {std::numbers::sqrt2 / 2, 0.0, std::numbers::sqrt2 / 2};
  nut.hertz.status = contact::HertzStatus::ok;
  nut.hertz.hertz_constant = 1e10;
  const auto json = document_of(solve_analysis(), result, kInfo).at("contact");
  EXPECT_FALSE(json.contains("screw"));
  EXPECT_DOUBLE_EQ(json.at("nut").at("relative_curvatures_per_mm").at(1), 0.3);
  EXPECT_DOUBLE_EQ(json.at("nut").at("curvature_sum_per_mm"), 0.4);
  EXPECT_NEAR(json.at("nut").at("normal_angle_deg"), 45.0, 1e-12);
  EXPECT_DOUBLE_EQ(json.at("nut").at("hertz_constant_N_per_mm1_5"), 1e10 / std::pow(1e3, 1.5));
}

TEST(Json, ValuesHaveTheUnitOfTheirKey) {
  const LoadCaseResult load_case = solved_case("a", 45e3, Direction::tension);
  const auto json = case_json(load_case);
  EXPECT_EQ(json.at("name"), "a");
  EXPECT_EQ(json.at("axial_force_N"), 45e3);
  EXPECT_EQ(json.at("direction"), "tension");
  EXPECT_DOUBLE_EQ(json.at("position_mm"), 4.0);
  EXPECT_EQ(json.at("converged"), true);
  EXPECT_EQ(json.at("status"), "converged");
  EXPECT_EQ(json.at("iterations"), 2);
  EXPECT_EQ(json.at("relative_residual"), 2.5e-13);
  EXPECT_DOUBLE_EQ(json.at("axial_displacement_um"), 56.25);
  EXPECT_DOUBLE_EQ(json.at("axial_stiffness_N_per_um"), 800.0);
  EXPECT_DOUBLE_EQ(json.at("tangent_stiffness_N_per_um"), 1200.0);
  EXPECT_TRUE(json.at("warnings").empty());
  EXPECT_EQ(json.at("newton_history").size(), 2);
  EXPECT_EQ(json.at("newton_history").at(0).at("energy_J"), -1.0);

  const InterfaceLoads& loads = load_case.threads->nut;
  const auto& nut = json.at("nut");
  EXPECT_NEAR(nut.at("hertz_constant_N_per_mm1_5"), 1.14e10 / std::pow(1e3, 1.5), 1e-6);
  EXPECT_DOUBLE_EQ(nut.at("normal_angle_deg"), 45.0);
  EXPECT_EQ(nut.at("axial_load_N").size(), 20);
  EXPECT_DOUBLE_EQ(nut.at("axial_load_N")[1], loads.axial_load[1]);
  EXPECT_DOUBLE_EQ(nut.at("normal_load_N")[1], loads.normal_load[1]);
  EXPECT_DOUBLE_EQ(nut.at("load_rate_percent")[1], loads.load_rate[1] * 100);
  EXPECT_DOUBLE_EQ(nut.at("approach_um")[1], loads.approach[1] * 1e6);
  EXPECT_DOUBLE_EQ(nut.at("semi_major_mm")[1], loads.semi_major[1] * 1e3);
  EXPECT_DOUBLE_EQ(nut.at("semi_minor_mm")[1], loads.semi_minor[1] * 1e3);
  EXPECT_DOUBLE_EQ(nut.at("peak_pressure_MPa")[1], loads.peak_pressure[1] * 1e-6);
}

TEST(Json, FailedCaseSaysWhyAndHasNoAnswer) {
  const auto json = case_json(failed_case("hopeless"));
  EXPECT_EQ(json.at("converged"), false);
  EXPECT_EQ(json.at("status"), "line_search_failed");
  EXPECT_EQ(json.at("iterations"), 1);
  EXPECT_EQ(json.at("relative_residual"), 3.25e-5);
  for (const char* key : {"name", "axial_force_N", "direction", "position_mm", "warnings"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"screw", "nut", "axial_stiffness_N_per_um", "axial_displacement_um"})
    EXPECT_FALSE(json.contains(key)) << key;
}

TEST(Json, EqualSharesConvergeWithoutASolve) {
  const auto json = case_json(equal_share_case("equal"));
  EXPECT_EQ(json.at("converged"), true);
  EXPECT_EQ(json.at("status"), "converged");
  for (const char* key :
       {"direction", "position_mm", "iterations", "relative_residual", "axial_stiffness_N_per_um", "newton_history"})
    EXPECT_FALSE(json.contains(key)) << key;
  EXPECT_EQ(json.at("screw").at("axial_load_N").size(), 4);
  EXPECT_FALSE(json.at("screw").contains("peak_pressure_MPa"));
}

TEST(Json, NumbersThatAreNotFiniteAreAbsent) {
  LoadCaseResult load_case = failed_case("nan");
  load_case.solve->relative_residual = std::numeric_limits<double>::quiet_NaN();
  const auto json = case_json(load_case);
  EXPECT_FALSE(json.contains("relative_residual"));
  EXPECT_EQ(json_text(json).find("null"), std::string::npos);
}

TEST(Json, TextReadsBackToTheSameNumbers) {
  const auto json = case_json(solved_case("a", 12345.678, Direction::compression));
  EXPECT_EQ(nlohmann::ordered_json::parse(json_text(json)), json);
}

TEST(Json, TextSurvivesMalformedNames) {
  const std::string text = json_text(case_json(failed_case("\xff\"\n")));
  EXPECT_EQ(nlohmann::json::parse(text).at("name"), "\uFFFD\"\n");
}

/// Text of a document that is written load case by load case.
std::string written(const Result& result) {
  std::string text;
  write_with_list(
      document_of(solve_analysis(), result, kInfo, false), "load_cases",
      [&](std::size_t k) { return load_case_json(result, k); }, [&](std::string_view piece) { text += piece; });
  return text;
}

TEST(Json, WrittenLoadCaseByLoadCaseIsTheSameText) {
  Result result;
  result.warnings = {Warning{"", "", "\"load_cases\": []\n"}};
  EXPECT_EQ(written(result), json_text(document_of(solve_analysis(), result, kInfo)));
  result.load_cases = {solved_case("a", 12345.678, Direction::compression), failed_case("\xff\"\n\u202e"),
                       equal_share_case("equal")};
  result.heat_cycle.emplace();
  EXPECT_EQ(written(result), json_text(document_of(solve_analysis(), result, kInfo)));
  result.load_cases.resize(101, failed_case("many"));
  EXPECT_EQ(written(result), json_text(document_of(solve_analysis(), result, kInfo)));
}

}  // namespace
}  // namespace prs
