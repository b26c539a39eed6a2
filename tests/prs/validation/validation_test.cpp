#include "prs/validation/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "prs/input/source.h"
#include "prs/model/problems.h"
#include "prs/sha256.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"
#include "validation/extensions.h"

namespace prs {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kSources = PRS_SOURCE_DIR "/validation";

/// All sources except Abevi's statements, which take longer and have a separate test.
std::vector<SourceReport> all_reports() {
  return validate(
      kSources, {jung_2017::extension(), sandu_2018::extension(), standard_screws::extension(), yao_2023::extension()});
}

/// Results of the printed values of a source, by verdict.
std::map<Outcome, int> outcomes(const SourceReport& report) {
  std::map<Outcome, int> count;
  for (const Comparison& c : report.comparisons) ++count[c.outcome()];
  return count;
}

/// A separate source with one case and these values, a block of YAML.
SourceReport report_of(const std::string& values) {
  const test::TemporaryDirectory folder;
  std::filesystem::copy(kSources / "sandu_2018/example_1.yaml", folder.path() / "case.yaml");
  std::ofstream(folder.path() / "reference.yaml")
      << "source: a test\ncases:\n  - case: case.yaml\n    command: contact\n    values:\n"
      << values;
  return validate(folder.path(), {}).front();
}

/// Outcome for one printed centre distance, 20 mm in truth.
Outcome outcome_of(const std::string& keys) {
  return report_of("      - {quantity: contact.centre_distance_mm, where: here, " + keys + "}\n")
      .comparisons.front()
      .outcome();
}

std::string error_of(const std::string& values) {
  try {
    report_of(values);
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "no error";
}

PrintedNumber printed(const std::string& text) { return {text, {}}; }

TEST(Validation, NothingUnexpectedAndNothingMissingInAnySource) {
  for (const SourceReport& report : all_reports()) {
    EXPECT_FALSE(report.comparisons.empty()) << report.name;
    for (const Comparison& c : report.comparisons)
      EXPECT_FALSE(c.unexpected()) << report.name << ' ' << c.case_name << ' ' << c.reference.quantity << ": "
                                   << name(c.outcome());
  }
}

/// Each number that is recorded, printed or corrected, changed by ten times its precision.
TEST(Validation, EveryNumberThatChangesIsSeen) {
  for (const SourceReport& report : all_reports())
    for (const Comparison& c : report.comparisons)
      for (const double ten : {-10.0, 10.0}) {
        Comparison moved = c;
        PrintedNumber& printed = moved.reference.printed;
        printed = {fmt::format("{:.17g}", printed.value() + 2.0 * ten * printed.half_unit()), -printed.last_place()};
        EXPECT_TRUE(moved.unexpected()) << report.name << ' ' << c.reference.where;
        if (!c.reference.corrected) continue;
        moved = c;
        PrintedNumber& corrected = *moved.reference.corrected;
        corrected = {fmt::format("{:.17g}", corrected.value() + 2.0 * ten * corrected.half_unit()),
                     -corrected.last_place()};
        EXPECT_TRUE(moved.unexpected()) << report.name << ' ' << c.reference.where;
      }
}

/// Each recorded verdict in words, and each file of data, one byte of it changed.
TEST(Validation, EveryStatementAndEveryFileOfDataThatChangesIsSeen) {
  for (const SourceReport& report : all_reports())
    for (ComparedStatement s : report.statements) {
      EXPECT_FALSE(s.unexpected()) << s.text;
      using enum Verdict::Kind;
      s.verdict.kind = s.verdict.kind == holds ? does_not_hold : holds;
      EXPECT_TRUE(s.unexpected()) << s.text;
    }
  for (const auto& entry : std::filesystem::directory_iterator(kSources)) {
    if (!std::filesystem::exists(entry.path() / "reference.yaml")) continue;
    const Reference reference = read_reference(entry.path() / "reference.yaml");
    for (const auto& file : std::filesystem::recursive_directory_iterator(entry.path()))
      if (file.path().extension() == ".csv" || file.path().extension() == ".json") {
        const std::string path = std::filesystem::relative(file.path(), entry.path()).generic_string();
        ASSERT_TRUE(reference.data.contains(path)) << entry.path() << ": " << path;
        std::string text = test::content_of(file.path());
        EXPECT_EQ(sha256(text), reference.data.at(path)) << path;
        ++text.back();
        EXPECT_NE(sha256(text), reference.data.at(path)) << path;
      }
  }
}

/// Counts that a reader can check by hand.
TEST(Validation, TheSummaryCountsWhatHoldsAndWhatChanged) {
  SourceReport report = report_of(
      "      - {quantity: contact.centre_distance_mm, where: a, printed: '20'}\n"
      "      - {quantity: contact.centre_distance_mm, where: b, printed: '21'}\n"
      "      - {quantity: contact.centre_distance_mm, where: c, printed: '21', off: -1, "
      "differs: a slip}\n");
  report.statements = {{"1", "true", {Verdict::Kind::holds}}, {"2", "not true", {}, Verdict::Kind::does_not_hold}};
  EXPECT_EQ(summary({report}).text(),
            "Compared 5 numbers, statements and files: 2 hold, 2 are known not to, 1 changed.");
}

TEST(Validation, ANumberThatChangesMakesTheCommandFail) {
  const test::TemporaryDirectory folder;
  std::filesystem::copy(kSources / "standard_screws", folder.path() / "standard_screws");
  const std::string command = "validate --quiet " + folder.path().string();
  EXPECT_EQ(test::run_prs(command).status, 0);
  std::ofstream(folder.path() / "standard_screws/screws.csv", std::ios::app) << "#\n";
  EXPECT_EQ(test::run_prs(command).status, 1);
}

TEST(Validation, EverySourceFolderHasItsReferenceAndSource) {
  std::size_t references = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSources)) {
    if (!entry.is_directory()) continue;
    const bool has_reference = std::filesystem::exists(entry.path() / "reference.yaml");
    references += has_reference ? 1 : 0;
    EXPECT_TRUE(has_reference || std::filesystem::is_directory(entry.path() / "data")) << entry.path();
    EXPECT_TRUE(std::filesystem::exists(entry.path() / "SOURCE.md")) << entry.path();
  }
  EXPECT_EQ(all_reports().size(), references);
}

SourceReport sandu_report() { return validate(kSources / "sandu_2018", {sandu_2018::extension()}).front(); }

/// Two signs and one digit in chapter 1 and appendix B; chapters 2 and 3: (2.20), both films, the roller-nut speed, a
/// mass printed as roughly, and the efficiency, for which the bearing's table is missing. From other authors quoted in
/// the thesis: seven numbers of Jones, two of Fedosovsky, and three curvatures.
TEST(Validation, SandusNumbersReproduceButForNineAndThoseOfOthers) {
  const SourceReport report = sandu_report();
  const std::map<Outcome, int> count = outcomes(report);
  EXPECT_EQ(count.at(Outcome::differs), 9 + 12);
  EXPECT_EQ(count.at(Outcome::reproduces) + 9 + 12, static_cast<int>(report.comparisons.size()));
}

TEST(Validation, SandusStatementsHoldButForFive) {
  int not_held = 0;
  for (const ComparedStatement& s : sandu_report().statements) {
    if (s.verdict.kind == Verdict::Kind::holds) continue;
    ++not_held;
    EXPECT_FALSE(s.verdict.why.empty()) << s.text;
    const bool known =
        std::ranges::any_of(std::array{"increasing force", "reference [44]", "higher friction coefficients",
                                       "only increase slightly", "table 1.8"},
                            [&](const char* words) { return s.text.find(words) != std::string::npos; });
    EXPECT_TRUE(known) << s.text << ": " << s.verdict.evidence;
  }
  EXPECT_EQ(not_held, 5);
}

/// With the absolute values of table 1.4 and (2.36) as printed, the printed films and speed result.
TEST(Validation, SandusOwnFormulasGiveHisFilmsAndSpeeds) {
  const SourceReport report = sandu_report();
  const ValidationTable& table = report.tables.at(2);
  ASSERT_EQ(table.rows.at(1).label, "thesis");
  const std::vector<std::string> texts{"438", "107", "495", "9.3"};
  for (std::size_t k = 0; k < texts.size(); ++k) {
    EXPECT_DOUBLE_EQ(table.rows[0].values[k], printed(texts[k]).value());
    EXPECT_TRUE(printed(texts[k]).is_reproduced_by(table.rows[1].values[k])) << table.columns[k + 1];
  }
}

/// The thesis does not give the range over which B_1 and B_2 of (3.55) were fitted, so that no fit has to reproduce
/// them: they lie among those of five ranges, within the effect of the range.
TEST(Validation, SandusFitDependsOnItsRange) {
  const SourceReport report = sandu_report();
  const ValidationTable& fits = report.tables.at(4);
  ASSERT_EQ(fits.rows.size(), 6u);
  ASSERT_EQ(fits.rows.front().label, "printed");
  for (const std::size_t k : {0u, 1u}) {
    const auto constant = [k](const ValidationTable::Row& row) { return row.values[k]; };
    const auto [least, most] = std::ranges::minmax_element(fits.rows.begin() + 1, fits.rows.end(), {}, constant);
    EXPECT_LT(constant(*least), constant(fits.rows.front())) << k;
    EXPECT_GT(constant(*most), constant(fits.rows.front())) << k;
  }
}

/// A folder of that name with other cases has no statements.
TEST(Validation, StatementsWithoutTheirCaseAreLeftOut) {
  const test::TemporaryDirectory parent;
  const std::filesystem::path folder = parent.path() / "sandu_2018";
  std::filesystem::create_directory(folder);
  std::filesystem::copy(kSources / "sandu_2018/example_1.yaml", folder / "case.yaml");
  std::ofstream(folder / "reference.yaml")
      << "source: a test\ncases:\n  - {case: case.yaml, command: contact, values: [{quantity: "
         "contact.centre_distance_mm, where: c, printed: '20'}]}\n";
  const SourceReport report = validate(folder, {sandu_2018::extension()}).front();
  EXPECT_TRUE(report.statements.empty());
  EXPECT_EQ(report.comparisons.size(), 1u);
}

TEST(Validation, QuantitiesOfASourceAreMissingWithoutItsCode) {
  const std::map<Outcome, int> count = outcomes(validate(kSources / "yao_2023", {})[0]);
  EXPECT_EQ(count.at(Outcome::missing), 10);
}

TEST(Validation, AWrongPrintedDigitIsUnexpected) {
  EXPECT_EQ(outcome_of("printed: '20.00'"), Outcome::reproduces);
  EXPECT_EQ(outcome_of("printed: '20.01'"), Outcome::unexpected);
  EXPECT_EQ(outcome_of("printed: '20'"), Outcome::reproduces);
  EXPECT_EQ(outcome_of("printed: '20.01', off: -1, differs: a slip"), Outcome::differs);
  EXPECT_EQ(outcome_of("printed: '20.01', off: -4, differs: a slip"), Outcome::unexpected);
  EXPECT_EQ(outcome_of("printed: '20.00', off: 1, differs: none"), Outcome::unexpected);
  EXPECT_EQ(report_of("      - {quantity: contact.lead_mm, where: here, printed: '1'}\n").comparisons[0].outcome(),
            Outcome::missing);
}

TEST(Validation, ACorrectedNumberIsHeldToItsDigitsToo) {
  EXPECT_EQ(outcome_of("printed: '21', off: -1, differs: a slip, corrected: '20.000'"), Outcome::differs);
  EXPECT_EQ(outcome_of("printed: '21', off: -1, differs: a slip, corrected: '20.001'"), Outcome::unexpected);
}

TEST(Validation, AStatedPrecisionReplacesThatOfTheLastDigit) {
  const std::string near = "quantity: contact.screw.radius_on_body_mm, where: r_IS, printed: '15'";
  EXPECT_EQ(report_of("      - {" + near + "}\n").comparisons[0].outcome(), Outcome::reproduces);
  EXPECT_EQ(report_of("      - {" + near + ", precision: {decimals: 4, because: zeros}}\n").comparisons[0].outcome(),
            Outcome::unexpected);
}

TEST(Validation, ReferenceFilesAreReadStrictly) {
  const std::string value = "      - {quantity: q, where: w, printed: '1'";
  EXPECT_THAT(error_of(value + ", tolerance: 2}\n"), HasSubstr("reference.yaml:6:47: error"));
  EXPECT_THAT(error_of(value + ", tolerance: 2}\n"), HasSubstr("unknown key"));
  EXPECT_THAT(error_of(value + ", precision: {decimals: 4}}\n"), HasSubstr("because"));
  EXPECT_THAT(error_of(value + ", precision: {decimals: 4.5, because: x}}\n"), HasSubstr("whole number"));
  EXPECT_THAT(error_of(value + ", corrected: '2'}\n"), HasSubstr("differs"));
  EXPECT_THAT(error_of("      - {quantity: q, where: w, printed: about 1}\n"), HasSubstr("expected a number"));
  EXPECT_THAT(error_of("      - {where: w, printed: '1'}\n"), HasSubstr("quantity"));
  EXPECT_THAT(error_of(value + "}\nyear: 2018\n"), HasSubstr("year"));
  EXPECT_THAT(error_of(value + "}\n    comand: contact\n"), HasSubstr("comand"));
  EXPECT_THAT(error_of("      []\n"), HasSubstr("expected a list"));
}

/// A separate source whose code gets its case and folder.
SourceReport report_with(const SourceExtension& code) {
  const test::TemporaryDirectory parent;
  const std::filesystem::path folder = parent.path() / code.folder;
  std::filesystem::create_directory(folder);
  std::filesystem::copy(kSources / "sandu_2018/example_1.yaml", folder / "case.yaml");
  std::ofstream(folder / "reference.yaml")
      << "source: a test\ncases:\n  - {case: case.yaml, command: contact, values: [{quantity: "
         "contact.centre_distance_mm, where: c, printed: '20'}]}\n";
  return validate(folder, {code}).front();
}

TEST(Validation, ASourcesCodeFindsTheFilesBesideItsCase) {
  const SourceReport report = report_with({.folder = "here",
                                           .tables =
                                               [](const Reference&) {
                                                 return std::vector{ValidationTable{"first", {"a"}, {}}};
                                               },
                                           .supplement =
                                               [](const Case& subject, const Reference& reference) {
                                                 EXPECT_EQ(subject.mechanism.rollers, 9);
                                                 EXPECT_TRUE(std::filesystem::exists(reference.folder / "case.yaml"));
                                                 Supplement s;
                                                 s.statements.push_back({"1", "a statement", {Verdict::Kind::holds}});
                                                 s.tables.push_back({"second", {"a"}, {}});
                                                 s.figures.emplace_back().name = "a figure";
                                                 s.files.push_back({"a.csv", "a"});
                                                 return s;
                                               }});
  ASSERT_EQ(report.tables.size(), 2u);
  EXPECT_EQ(report.tables[1].title, "second");
  EXPECT_EQ(report.statements.size(), 1u);
  EXPECT_EQ(report.figures.front().name, "a figure");
  EXPECT_EQ(report.files.front().content, "a");
}

TEST(Validation, WhatASourcesCodeFindsWrongWithItsCaseIsToldAtItsPlace) {
  try {
    report_with({.folder = "here", .supplement = [](const Case&, const Reference&) -> Supplement {
                   throw CaseError("mechanism.rollers", "expected fewer");
                 }});
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("case.yaml:14:12: error: mechanism.rollers"));
  }
}

TEST(Validation, TablesAreAsWideAsWhatTheyHold) {
  SourceReport report;
  report.tables.push_back({"title", {"case", "a long column"}, {{"x", {1.0 / 3.0}}}, 2});
  report.tables.push_back({"title", {"case", "b"}, {{"a long label", {1.0 / 3.0}}}});
  const std::string text = validation_text({report});
  EXPECT_THAT(text, HasSubstr("    case     a long column\n    x                 0.33\n"));
  EXPECT_THAT(text, HasSubstr("    case                 b\n    a long label  0.333333\n"));
}

TEST(Validation, UnknownCommandsAreErrors) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "reference.yaml")
      << "source: a test\ncases:\n  - {case: none.yaml, command: slide, values: [{quantity: q, "
         "where: w, printed: '1'}]}\n";
  try {
    validate(folder.path(), {});
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("got slide; expected solve | contact | slip"));
  }
}

TEST(Validation, CasesAreCheckedWhereTheyStand) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "reference.yaml")
      << "source: a test\ncases:\n  - {case: none.yaml, command: contact, values: [{quantity: q, "
         "where: w, printed: '1'}]}\n";
  EXPECT_THROW(validate(folder.path(), {}), input::InputError);
}

TEST(PrintedNumber, KnowsItsDigits) {
  EXPECT_EQ(printed("3.6062e5").digits(), 5);
  EXPECT_DOUBLE_EQ(printed("3.6062e5").half_unit(), 5.0);
  EXPECT_EQ(printed("-172.7935").digits(), 7);
  EXPECT_EQ(printed("0.0471").digits(), 3);
  EXPECT_EQ(printed("8.5970e-5").digits(), 5);
  EXPECT_EQ((PrintedNumber{"0", 4}).digits(), 4);
  EXPECT_EQ((PrintedNumber{"15", 4}).digits(), 6);
}

TEST(PrintedNumber, CountsAgreeingDigits) {
  const PrintedNumber number = printed("24.1710");
  EXPECT_EQ(number.agreeing_digits(24.17104), 6);
  EXPECT_EQ(number.agreeing_digits(24.1707), 5);
  EXPECT_EQ(number.agreeing_digits(24.18), 3);
  EXPECT_EQ(number.agreeing_digits(-24.1710), 0);
}

TEST(ValidationDocument, HoldsVerdictsDigitsAndTables) {
  const nlohmann::ordered_json document =
      validation_json(validate(kSources / "sandu_2018", {sandu_2018::extension()}), DocumentInfo{});
  const auto& source = document["sources"][0];
  EXPECT_EQ(source["name"], "sandu_2018");
  const auto& first = source["values"][0];
  EXPECT_EQ(first["case"], "example_1");
  EXPECT_EQ(first["verdict"], "reproduces");
  EXPECT_EQ(first["agreeing_digits"], first["printed_digits"]);
  const auto& rows = source["tables"][0]["rows"];
  EXPECT_EQ(rows.front()["label"], "1");
  EXPECT_EQ(rows.back()["label"], "1000");
  // Table 1.5: at q = 1000, q^(2/pi) misses the exact ellipticity by 20 %.
  EXPECT_NEAR(rows.back()["values"][2].get<double>(), 19.72, 0.005);
}

}  // namespace
}  // namespace prs
