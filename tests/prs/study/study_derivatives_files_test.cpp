#include "prs/study/study_files.h"
#include "prs/study/study_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "prs/record/pictures.h"
#include "prs/record/table_units.h"

namespace prs {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

Factor factor(const std::string& path, const std::string& unit, double at) {
  Factor f;
  f.path = f.label = path;
  f.unit = unit;
  f.base = Level{"", at};
  return f;
}

/// A stiffness of 800 N/um: twice the diameter's change, opposite to a bore's, independent of a length.
CaseDerivatives sample_derivatives() {
  CaseDerivatives d;
  d.study.responses = {"axial_stiffness_N_per_um"};
  d.study.factors = {factor("bore", "mm", 6.0), factor("diameter", "mm", 20.0), factor("length", "mm", 90.0)};
  d.values = {800.0};
  d.factors = {{{Derivative{-10.0, -0.075, 1e-9}}, ""},
               {{Derivative{80.0, 2.0, 1e-8}}, ""},
               {{std::nullopt}, "two sections meet"}};
  return d;
}

TEST(DerivativesFiles, DocumentHasAnEntryAFactorOrItsReason) {
  const auto json = derivatives_json(sample_derivatives(), {"1", "2", "", {}})["derivatives"];
  ASSERT_THAT(json, SizeIs(1));
  EXPECT_EQ(json[0]["value"], 800.0);
  EXPECT_EQ(json[0]["by"][1]["derivative"], 80.0);
  EXPECT_EQ(json[0]["by"][1]["percent_per_percent"], 2.0);
  EXPECT_EQ(json[0]["by"][1]["unit"], "mm");
  EXPECT_EQ(json[0]["by"][2]["reason"], "two sections meet");
  EXPECT_FALSE(json[0]["by"][2].contains("derivative"));
}

TEST(DerivativesFiles, CsvHasARowAResponseAndFactor) {
  EXPECT_EQ(derivatives_csv(sample_derivatives()),
            "response,value,factor,label,at,unit,derivative,percent_per_percent,error,reason\n"
            "axial_stiffness_N_per_um,800,bore,bore,6,mm,-10,-0.075,1e-09,\n"
            "axial_stiffness_N_per_um,800,diameter,diameter,20,mm,80,2,1e-08,\n"
            "axial_stiffness_N_per_um,800,length,length,90,mm,,,,two sections meet\n");
}

TEST(DerivativesFiles, TableHasTheUnitsOfTables) {
  const TableUnits units(UnitSystem::us);
  const std::string table = derivatives_table(sample_derivatives());
  // 1 lbf/in = 175.126835 N/m (NIST SP 811, appendix B.8, with the digits of its factors).
  EXPECT_THAT(table, HasSubstr("axial stiffness: 4.56812 lbf/µin"));
  EXPECT_THAT(table, HasSubstr(" 0.4568118 "));  // Per mm of the diameter, the unit in the file.
}

TEST(DerivativesFiles, TableHasTheStrongestFirst) {
  const std::string table = derivatives_table(sample_derivatives());
  EXPECT_LT(table.find("  diameter "), table.find("  bore "));
  EXPECT_THAT(table, HasSubstr("axial stiffness: 800 N/µm"));
  EXPECT_THAT(table, HasSubstr("length: no derivative of axial stiffness: two sections meet"));
}

TEST(DerivativesFiles, TableNamesTheResponsesThatHaveNoDerivative) {
  CaseDerivatives d = sample_derivatives();
  d.study.responses.push_back("axial_displacement_um");
  d.values.push_back(50.0);
  for (FactorDerivatives& f : d.factors) f.responses.push_back(Derivative{1.0, 0.1, 1e-9});
  EXPECT_THAT(derivatives_table(d), HasSubstr("length: no derivative of axial stiffness: two"));
  d.factors[2].responses[1].reset();
  EXPECT_THAT(derivatives_table(d), HasSubstr("length: no derivative of any response: two"));
}

TEST(DerivativesFiles, FigureHasABarAFactor) {
  const CaseDerivatives derivatives = sample_derivatives();
  const Figures shown = figures(derivatives_pictures(derivatives));
  ASSERT_THAT(shown, SizeIs(1));
  const Panel& panel = shown[0].panels.at(0);
  EXPECT_THAT(panel.labels, SizeIs(2));
  EXPECT_THAT(panel.series.at(0).parts, SizeIs(1));
  EXPECT_THAT(panel.series.at(1).parts, SizeIs(1));
  EXPECT_LT(shown[0].x.from, -0.075);
  EXPECT_GT(shown[0].x.to, 2.0);
}

}  // namespace
}  // namespace prs
