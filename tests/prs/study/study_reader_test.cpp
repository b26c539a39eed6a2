#include "prs/input/study_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/prs/input/abevi.h"

namespace prs::input {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr int kLine = 30;  // Of the first factor.

Source source_of(const std::string& study) { return {"case.yaml", kAbevi + study, {}}; }

/// A study with one factor, which stands on the line after `factors:`.
Source with_factor(const std::string& factor) {
  return source_of("study:\n  command: solve\n  factors:\n    - {" + factor + "}\n");
}

Factor read(const std::string& factor) {
  return read_study_input(with_factor(factor)).study.factors.at(0);
}

std::string error_of(const Source& source) {
  try {
    read_study_input(source);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}
std::string error_of(const std::string& factor) { return error_of(with_factor(factor)); }

std::vector<std::string> texts(const Factor& factor) {
  std::vector<std::string> all;
  for (const Level& level : factor.levels) all.push_back(level.text);
  return all;
}

std::vector<double> numbers(const Factor& factor) {
  std::vector<double> all;
  for (const Level& level : factor.levels) all.push_back(level.number.value_or(NAN));
  return all;
}

TEST(StudyReader, ListKeepsTextsAndHasNumbersInTheUnitOfTheFirst) {
  const Factor f = read("path: mechanism.lead, values: [5 mm, 6000 um], label: the lead");
  EXPECT_EQ(f.label, "the lead");
  EXPECT_EQ(f.unit, "mm");
  EXPECT_THAT(texts(f), ElementsAre("5 mm", "6000 um"));
  EXPECT_THAT(numbers(f), ElementsAre(5.0, 6.0));
  EXPECT_EQ(f.base->text, "5 mm");
}

TEST(StudyReader, RangeHasItsEndsAsWritten) {
  const Factor f = read("path: mechanism.lead, values: {from: 5.0 mm, to: 6 mm, steps: 3}");
  EXPECT_THAT(texts(f), ElementsAre("5.0 mm", "5.5 mm", "6 mm"));
  EXPECT_FALSE(f.logarithmic);
  EXPECT_EQ(f.label, "mechanism.lead");
}

TEST(StudyReader, LogarithmicRangeIsGeometric) {
  const Factor f = read(
      "path: mechanism.lead, values: {from: 1 mm, to: 100 mm, steps: 3, spacing: logarithmic}");
  EXPECT_THAT(texts(f), ElementsAre("1 mm", "10 mm", "100 mm"));
  EXPECT_TRUE(f.logarithmic);
}

TEST(StudyReader, ProfilesHaveTheirCurvatureForNumber) {
  const Factor f =
      read("path: mechanism.profile.nut, values: [{concave: 50 mm}, straight, {convex: 2 cm}]");
  EXPECT_EQ(f.unit, "1/mm");
  EXPECT_THAT(texts(f), ElementsAre("{concave: 50 mm}", "straight", "{convex: 2 cm}"));
  EXPECT_THAT(numbers(f), ElementsAre(-0.02, 0.0, 0.05));
  EXPECT_EQ(f.base->number, 0.0);
}

TEST(StudyReader, WordsHaveNoNumber) {
  const Factor f = read("path: model.roller, values: [flexible, rigid_bending]");
  EXPECT_FALSE(f.is_numeric());
  EXPECT_EQ(f.base->text, "flexible");  // The default.
}

TEST(StudyReader, WrongValueIsReportedWhereItStands) {
  const std::string line = "case.yaml:" + std::to_string(kLine);
  EXPECT_THAT(error_of("path: mechanism.rollers, values: [9, 0]"),
              StartsWith(line + ":45: error: mechanism.rollers: got 0; expected a whole number"));
  EXPECT_THAT(error_of("path: mechanism.lead, values: [5 kN]"),
              HasSubstr("`kN` is the unit of a force"));
  EXPECT_THAT(error_of("path: mechanism.lead, values: {from: 5 kN, to: 6 kN, steps: 2}"),
              StartsWith(line + ":45: error: mechanism.lead: got 5 kN"));
  EXPECT_THAT(error_of("path: mechanism.geometry, values: [design]"),
              StartsWith(line + ":43: error: mechanism."));
}

TEST(StudyReader, UnknownPathIsReportedOnceWhereItStands) {
  const std::string error = error_of("path: mechanism.rolers, values: [9, 10]");
  EXPECT_THAT(error, StartsWith("case.yaml:" + std::to_string(kLine) + ":14: error: "));
  EXPECT_THAT(error, HasSubstr("did you mean `rollers`?"));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(StudyReader, RefusesWhatIsNoStudy) {
  EXPECT_THAT(error_of(Source{"case.yaml", kAbevi, {}}), HasSubstr("study: missing; expected"));
  const std::pair<const char*, const char*> wrong[] = {
      {"path: mechanism.lead, values: []", "got a list of 0"},
      {"path: mechanism.lead, values: 5 mm", "expected a list of at least 1 value, or a range"},
      {"path: mechanism.lead, values: [~]", "got nothing"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 1 cm, steps: 2}", "the unit of `from`, mm"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 1 mm, steps: 2}", "another value"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 2 mm, steps: 1}", "from 2 to 100000"},
      {"path: mechanism.lead, values: {from: a, to: 2 mm, steps: 2}", "got a; expected a number"},
      {"path: mechanism.lead, values: {from: -1 mm, to: 2 mm, steps: 2, spacing: logarithmic}",
       "neither of them 0"},
      {"path: mechanism.rollers, values: {from: 8, to: 9, steps: 3}", "got 8.5"},
      {"path: study.command, values: [slip]", "a value outside the study"},
      {"path: mechanism..lead, values: [5 mm]", "got no path"},
      {"path: \"load_cases[7].position\", values: [5 mm]", "expected one below 2"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 2 mm, steps: 100000}",
       "got 100000 values; expected fewer than 100000"},
  };
  for (const auto& [factor, message] : wrong)
    EXPECT_THAT(error_of(std::string(factor)), HasSubstr(message)) << factor;
  EXPECT_THAT(
      error_of(
          "path: mechanism.lead, values: [5 mm]}\n    - {path: mechanism.lead, values: [6 mm]"),
      HasSubstr("a second time"));
}

TEST(StudyReader, BaseCaseMustMeetItsCommand) {
  const std::string study =
      "study: {command: slip, factors: [{path: mechanism.rollers, values: [9]}]}\n";
  EXPECT_THAT(error_of(source_of(study)), HasSubstr("operation"));
}

TEST(StudyReader, DesignIsTheFileWithItsOverrides) {
  const StudyInput in = read_study_input(with_factor("path: mechanism.rollers, values: [9]"));
  EXPECT_EQ(read_design(in, {}).mechanism.rollers, 11);
  EXPECT_EQ(read_design(in, {"mechanism.rollers=9"}).mechanism.rollers, 9);
  EXPECT_THROW(read_design(in, {"structure.nut.length=5 mm"}), InputError);
}

TEST(StudyReader, OverridesOfTheCommandLineReachFileAndStudy) {
  Source source = with_factor("path: mechanism.rollers, values: [9]");
  source.overrides = {"mechanism.rollers=10", "study.factors[0].values=[7, 8]"};
  const StudyInput in = read_study_input(source);
  EXPECT_EQ(read_design(in, {"mechanism.lead=5 mm"}).mechanism.rollers, 10);
  EXPECT_THAT(texts(in.study.factors[0]), ElementsAre("7", "8"));
  EXPECT_EQ(in.study.factors[0].base->text, "10");
}

TEST(FlowText, ReadsBackAsTheSameValue) {
  for (const char* text : {"5 mm", "\"5\"", "straight", "{convex: 6 mm}", "[a, {b: \"c, d\"}]",
                           "\"say \\\"x\\\"\"", "~"}) {
    const Source source{"case.yaml", "a: ~\n", {std::string("a=") + text}};
    ErrorList errors(source);
    const Node root = read_document(source, errors);
    EXPECT_EQ(flow_text(*find(root, "a")), text);
  }
}

}  // namespace
}  // namespace prs::input
