#include "prs/input/force_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "tests/support/temporary_directory.h"

namespace prs::input {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const Source kSource = {"dir/case.yaml",
                        "life:\n"
                        "  history:\n"
                        "    file: flight.csv\n"
                        "    force: {column: load, unit: kN}\n"
                        "    time: {column: t, unit: ms}\n"
                        "    speed: {column: n, unit: rpm}\n",
                        {}};

HistorySource wanted() {
  HistorySource h;
  h.file = "flight.csv";
  h.force = {"load", "kN"};
  h.time = CsvColumn{"t", "ms"};
  h.speed = CsvColumn{"n", "rpm"};
  return h;
}

LoadHistory parse(const std::string& text, const HistorySource& history = wanted()) {
  return parse_force_history(text, "dir/flight.csv", history, kSource);
}

std::string error_of(const std::string& text, const HistorySource& history = wanted()) {
  try {
    parse(text, history);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The text that the resolved input shows before the name is refused with its place.
TEST(ForceHistory, WithoutANameStandsNowhere) { EXPECT_EQ(place_of_file("", source_of_text("case.yaml", "", {})), ""); }

TEST(ForceHistory, ReadsColumnsByNameInSiUnits) {
  const LoadHistory h = parse("t,n,other,load\n0,60,x,1.5\n250,-30,,-2e1\n");
  EXPECT_THAT(h.force, ElementsAre(1500.0, -20e3));
  EXPECT_THAT(h.time, ElementsAre(0.0, 0.25));
  EXPECT_THAT(h.speed, ElementsAre(testing::DoubleEq(2 * std::numbers::pi), testing::DoubleEq(-std::numbers::pi)));
  EXPECT_TRUE(h.position.empty());
}

TEST(ForceHistory, SpeedMayBeAlongTheAxis) {
  HistorySource history = wanted();
  history.speed->unit = "mm/s";
  const LoadHistory h = parse("t,n,load\n0,60,1.5\n250,-30,2\n", history);
  EXPECT_TRUE(h.speed_along_axis);
  EXPECT_THAT(h.speed, ElementsAre(testing::DoubleEq(60e-3), testing::DoubleEq(-30e-3)));
  EXPECT_FALSE(parse("t,n,load\n0,60,1.5\n250,-30,2\n").speed_along_axis);
}

TEST(ForceHistory, ReadsWhatSpreadsheetsWrite) {
  const LoadHistory h = parse(
      "\xEF\xBB\xBF# made by a test\r\n\r\n\"t\";\"load\"; n \r\n0; +1 ;\"60\"\r\n# half time\r\n"
      "1;2;60\r\n  \r\n");
  EXPECT_THAT(h.force, ElementsAre(1e3, 2e3));
  EXPECT_THAT(parse("load\tn\tt\n1\t2\t3\n4\t5\t6").force, ElementsAre(1e3, 4e3));
}

TEST(ForceHistory, NamesFileLineAndValueOfWhatIsNoNumber) {
  const std::string head = "# comment\nt,load,n\n0,1,2\n";
  EXPECT_THAT(error_of(head + "1,abc,2\n"),
              StartsWith("dir/flight.csv:4:3: error: load: got abc; expected a finite number"));
  for (const char* value : {"nan", "inf", "-inf", "1e400", "1e31", "1 kN", "0x10", "--1", "1.2.3"})
    EXPECT_THAT(error_of(head + "1," + value + ",2\n"),
                StartsWith(std::string("dir/flight.csv:4:3: error: load: got ") + value + ";"));
  EXPECT_THAT(error_of(head + "1,,2\n"), HasSubstr(":4:3: error: load: got nothing"));
  EXPECT_THAT(error_of(head + "1,5\n"), HasSubstr(":4:4: error: n: got nothing"));
  EXPECT_THAT(error_of("t\tload\tn\n0\t1,500\t2\n"),
              AllOf(HasSubstr("flight.csv:2:3: error: load: got 1,500"), HasSubstr("as a point")));
}

TEST(ForceHistory, SeparatorsInQuotesSeparateNothing) {
  const LoadHistory h = parse("\"place, date\",load,t,n\n\"1, 2\",10,0,60\n\"a \"\"b\"\",\n4, 5\",20,1,60\n");
  EXPECT_THAT(h.force, ElementsAre(10e3, 20e3));
  EXPECT_THAT(h.time, ElementsAre(0.0, 1e-3));
  EXPECT_THAT(parse("\"x;y\",load,t,n\n0,10,0,60\n0,20,1,60\n").force, ElementsAre(10e3, 20e3));
  EXPECT_THAT(error_of("t,load,n\n0,\"1,5\",2\n"),
              AllOf(HasSubstr("flight.csv:2:3: error: load: got 1,5"), HasSubstr("as a point")));
}

TEST(ForceHistory, NamesTheLineOfWrongQuotes) {
  EXPECT_THAT(error_of("t,load,n,x\n0,1,2,\"a\n\"\n1,3\"5,2,x\n"),
              StartsWith("dir/flight.csv:4:4: error: got a quote within a field;"));
  EXPECT_THAT(error_of("t,load,n,x\n0,1,2,\"a\n1,2,2,b\n"),
              StartsWith("dir/flight.csv:2:1: error: got a quote that never closes;"));
}

TEST(ForceHistory, RefusesRowsWiderThanTheHeading) {
  EXPECT_THAT(error_of("t,load,n\n0,1,2\n1,5,2,0\n"),
              AllOf(StartsWith("dir/flight.csv:3:1: error: row: got 4 fields; expected at most 3"),
                    HasSubstr("decimal marks as points")));
  EXPECT_THAT(parse("t,load,n,more\n0,1,2\n1,5,2,\n").force, ElementsAre(1e3, 5e3));
}

/// Same history, as German spreadsheets write it.
TEST(ForceHistory, ReadsDecimalCommas) {
  EXPECT_THAT(parse("t;load;n\r\n0;1.000,5;2,5\r\n1;2;3\r\n").force, ElementsAre(1000.5e3, 2e3));
}

TEST(ForceHistory, RefusesAColumnThatStandsTwice) {
  EXPECT_THAT(error_of("t,load,n,load\n0,1,2,3\n"),
              HasSubstr("life.history.force.column: got load, which occurs twice"));
}

TEST(ForceHistory, RefusesTimeThatRunsBackwards) {
  EXPECT_THAT(error_of("load,n,t\n1,1,5\n1,1,5\n1,1,4\n"),
              StartsWith("dir/flight.csv:4:5: error: t: got 4 ms; expected a time not before that "
                         "of the sample above, 5 ms"));
}

TEST(ForceHistory, NamesTheInputWhereAColumnIsMissing) {
  EXPECT_THAT(error_of("t,laod,n\n0,1,2\n"),
              AllOf(StartsWith("dir/case.yaml:4:21: error: life.history.force.column: got load;"),
                    HasSubstr("t, laod, n"), HasSubstr("did you mean `laod`?")));
  EXPECT_THAT(error_of(""), StartsWith("dir/case.yaml:3:11: error: life.history.file:"));
  EXPECT_THAT(error_of("load,t,n\n1,2,3\n"), HasSubstr("got 1 row of numbers in dir/flight.csv"));
  EXPECT_THAT(error_of("load,t,n\n"), HasSubstr("got 0 rows of numbers"));
}

TEST(ForceHistory, NamesTheInputWhereAUnitDoesNotFit) {
  HistorySource h = wanted();
  h.force.unit = "mm";
  EXPECT_THAT(error_of("t,load,n\n0,1,2\n", h),
              AllOf(StartsWith("dir/case.yaml:4:33: error: life.history.force.unit: got mm;"), HasSubstr("N, kN, MN")));
}

TEST(ForceHistory, StandsBesideTheInput) {
  const test::TemporaryDirectory directory;
  std::ofstream(directory.path() / "flight.csv") << "t,load,n\n0,1,2\n1,2,2\n";
  Source source = kSource;
  source.name = directory.path() / "case.yaml";
  EXPECT_THAT(read_force_history(wanted(), source).force, ElementsAre(1e3, 2e3));

  for (const char* file : {"missing.csv", ".", "\x01"}) {
    HistorySource h = wanted();
    h.file = file;
    try {
      read_force_history(h, source);
      ADD_FAILURE() << file;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("case.yaml:3:11: error: life.history.file: got "));
    }
  }
}

TEST(ForceHistory, LiesInTheFolderOfTheInputUnlessAnOverrideNamesIt) {
  const test::TemporaryDirectory elsewhere, directory;
  const std::string text = "t,load,n\n0,1,2\n1,2,2\n";
  std::filesystem::create_directory(directory.path() / "data");
  std::ofstream(directory.path() / "data" / "flight.csv") << text;
  const std::filesystem::path outside = elsewhere.path() / "flight.csv";
  std::ofstream(outside) << text;
  std::filesystem::create_symlink(outside, directory.path() / "link.csv");
  const auto read = [&](const std::string& file, std::vector<std::string> overrides) {
    Source source = kSource;
    source.name = directory.path() / "case.yaml";
    source.overrides = std::move(overrides);
    HistorySource h = wanted();
    h.file = file;
    return read_force_history(h, source).force;
  };
  for (const std::string& inside : {std::string("data/flight.csv"), std::string("./data/../data/flight.csv"),
                                    (directory.path() / "data" / "flight.csv").string()})
    EXPECT_THAT(read(inside, {}), ElementsAre(1e3, 2e3)) << inside;

  const std::string relative = std::filesystem::relative(outside, directory.path()).string();
  for (const std::string& file :
       {outside.string(), relative, std::string("link.csv"), (elsewhere.path() / "missing.csv").string()}) {
    try {
      read(file, {});
      ADD_FAILURE() << file;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr("case.yaml:3:11: error: life.history.file: got "),
                        HasSubstr("expected a file in the folder of the case"), HasSubstr("--set life.history.file=")));
    }
  }
  for (const std::string& file : {outside.string(), relative, std::string("link.csv")})
    EXPECT_THAT(read(file, {"life.history.file=" + file}), ElementsAre(1e3, 2e3)) << file;
}

}  // namespace
}  // namespace prs::input
