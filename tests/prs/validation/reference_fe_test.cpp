#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "prs/bodies/body_models.h"
#include "prs/input/reader.h"
#include "prs/model/problems.h"
#include "tests/support/count.h"
#include "tests/support/parsed_csv.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"
#include "validation/reference_fe/comparison.h"
#include "validation/reference_fe/extension.h"

namespace prs::reference_fe {
namespace {

using ::testing::HasSubstr;
using RollerContacts = ModelOptions::RollerContacts;

const std::filesystem::path kFolder = PRS_SOURCE_DIR "/validation/reference_fe";

const std::vector<Curve>& reference() {
  static const std::vector<Curve> curves = read_curves(kFolder / "data/curves.csv");
  return curves;
}

const Case& screw() {
  static const Case c = input::read_case((kFolder / "screw.yaml").string(), {}, Command::solve);
  return c;
}

const std::vector<Curve>& bar_curves() {
  static const std::vector<Curve> curves = computed_curves(screw(), &kBars, reference());
  return curves;
}

/// Keeps only the largest load of the curves whose setup passes.
template <class Keep>
std::vector<Curve> at_full_load(Keep keep) {
  std::vector<Curve> kept;
  for (const Curve& curve : reference())
    if (keep(curve.setup)) kept.push_back({curve.setup, {curve.points.back()}});
  return kept;
}

bool everywhere(const Setup&, double) { return true; }

const Setup kExample{2, Direction::tension, Guidance::Kind::both_end_nodes, RollerContacts::opposite};

// The file.

std::string lines_of_curves() { return test::content_of(kFolder / "data/curves.csv"); }

std::string read_error(const std::string& content) {
  const test::TemporaryDirectory folder;
  const std::filesystem::path file = folder.path() / "curves.csv";
  std::ofstream(file, std::ios::binary) << content;
  try {
    read_curves(file);
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The file with one field (line and field counted from 1, the names in line 1) replaced.
std::string with_field(std::size_t line, std::size_t field, const std::string& value) {
  std::string text = lines_of_curves();
  std::size_t at = 0;
  for (std::size_t k = 1; k < line; ++k) at = text.find('\n', at) + 1;
  for (std::size_t k = 1; k < field; ++k) at = text.find(',', at) + 1;
  return text.replace(at, text.find_first_of(",\n", at) - at, value);
}

std::string error_with_field(std::size_t line, std::size_t field, const std::string& value) {
  return read_error(with_field(line, field, value));
}

TEST(ReferenceCurves, AreTwentyFourOfTheSameLoads) {
  ASSERT_EQ(reference().size(), 24u);
  for (const Curve& curve : reference()) {
    EXPECT_DOUBLE_EQ(curve.points.front().load, 1e3);
    EXPECT_DOUBLE_EQ(curve.points.back().load, 45e3);
    EXPECT_EQ(curve.points.size(), reference().front().points.size());
    for (const CurvePoint& point : curve.points) EXPECT_EQ(point.load_rate.nut.size(), 20u);
  }
}

TEST(ReferenceCurves, AnUntouchedCopyReads) { EXPECT_EQ(read_error(lines_of_curves()), "no error"); }

TEST(ReferenceCurves, ALoadRateThatBreaksTheSumIsFound) {
  EXPECT_THAT(error_with_field(3, 12, "7.00000"), HasSubstr("curves.csv:3:"));
  EXPECT_THAT(error_with_field(3, 12, "7.00000"), HasSubstr("screw load rates sum to"));
  EXPECT_THAT(error_with_field(5, 30, "7.00000"), HasSubstr("nut load rates sum to"));
}

TEST(ReferenceCurves, AStiffnessThatIsNotLoadOverDisplacementIsFound) {
  EXPECT_THAT(error_with_field(4, 6, "6.90057"), HasSubstr("curves.csv:4:"));
  EXPECT_THAT(error_with_field(4, 7, "446.0"), HasSubstr("stiffness_N_per_um: expected 444.2"));
}

TEST(ReferenceCurves, FieldsAreNumbersAndKnownWords) {
  EXPECT_THAT(error_with_field(3, 5, "two"), HasSubstr("load_kN: got two; expected a number"));
  EXPECT_THAT(error_with_field(3, 5, "2 kN"), HasSubstr("got 2 kN; expected a number"));
  EXPECT_THAT(error_with_field(3, 6, "nan"), HasSubstr("expected a number"));
  EXPECT_THAT(error_with_field(3, 6, "-4.9"), HasSubstr("expected a number above 0"));
  EXPECT_THAT(error_with_field(3, 6, ""), HasSubstr("empty field"));
  EXPECT_EQ(error_with_field(3, 6, "\"4.9\""), "no error");
  EXPECT_THAT(error_with_field(3, 6, "4\"9"), HasSubstr("got a quote within a field"));
  EXPECT_THAT(error_with_field(3, 1, "4"), HasSubstr("config: expected 1 to 3"));
  EXPECT_THAT(error_with_field(3, 2, "torsion"), HasSubstr("expected tension | compression"));
  EXPECT_THAT(error_with_field(3, 3, "ring"), HasSubstr("expected both_end_nodes | outer_node"));
  EXPECT_THAT(error_with_field(3, 4, "none"), HasSubstr("expected opposite | half_pitch"));
}

TEST(ReferenceCurves, TheTableIsWhole) {
  const std::string text = lines_of_curves();
  const std::size_t first = text.find('\n') + 1, second = text.find('\n', first) + 1;
  EXPECT_THAT(error_with_field(3, 5, "2,2"), HasSubstr("curves.csv:3:1: error: got 48 fields"));
  EXPECT_THAT(error_with_field(1, 5, "load_N"), HasSubstr("load_kN: missing"));
  EXPECT_THAT(error_with_field(1, 47, "nut_x_%"), HasSubstr("nut_20_%: missing"));
  EXPECT_THAT(read_error(text.substr(0, first)), HasSubstr("got no row of values"));
  EXPECT_THAT(read_error(""), HasSubstr("got no row of values"));
  EXPECT_THAT(read_error(text.substr(0, second)), HasSubstr("1 of 24 curves"));
  EXPECT_THAT(read_error(text + text.substr(first, second - first)), HasSubstr("ascending order"));
  std::string shorter = text;
  shorter.erase(first, second - first);
  EXPECT_THAT(read_error(shorter), HasSubstr("has 13 loads, others 12"));
  EXPECT_THROW(read_curves("/nonexistent/curves.csv"), input::InputError);
}

TEST(ReferenceCurves, WindowsLineEndsRead) {
  std::string text;
  for (const char c : lines_of_curves()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_error(text), "no error");
}

// Discrepancies.

TEST(Discrepancy, OfTwoThreads) {
  const CurvePoint point{10e3, 9e-6, {{0.6, 0.4}, {0.5, 0.5}}};
  const CurvePoint target{10e3, 10e-6, {{0.5, 0.5}, {0.4, 0.6}}};
  const std::optional<Discrepancy> d = discrepancy(point, target);
  ASSERT_TRUE(d);
  EXPECT_NEAR(d->stiffness, 1.0 / 9.0, 1e-15);
  EXPECT_NEAR(d->loads.screw.mean, 0.1, 1e-15);
  EXPECT_NEAR(d->loads.screw.largest, 0.1, 1e-15);
  EXPECT_NEAR(d->loads.screw.relative_mean, 0.0, 1e-15);
  EXPECT_NEAR(d->loads.nut.relative_highest, 0.25, 1e-15);
  EXPECT_NEAR(d->loads.nut.relative_lowest, -1.0 / 6.0, 1e-15);
  EXPECT_NEAR(d->loads.nut.relative_mean, 0.5 * (0.25 - 1.0 / 6.0), 1e-15);
}

TEST(Discrepancy, NeedsBothAnswers) {
  const CurvePoint solved{10e3, 9e-6, {{0.6, 0.4}, {0.5, 0.5}}}, unsolved{10e3, 0.0, {}};
  EXPECT_FALSE(discrepancy(solved, unsolved));
  EXPECT_FALSE(discrepancy(unsolved, solved));
}

TEST(Discrepancy, OfManyPointsNamesTheWorst) {
  std::vector<Curve> curves = reference();
  curves[5].points[2].displacement /= 1.1;
  curves[7].points[3].displacement /= 0.8;
  curves[9].points[4].load_rate.nut[6] += 0.03;
  const Summary s = summary(curves, reference(), everywhere);
  EXPECT_EQ(s.points, 24 * static_cast<int>(reference()[0].points.size()));
  EXPECT_NEAR(s.stiffest.value, 0.1, 1e-12);
  EXPECT_EQ(s.stiffest.setup, reference()[5].setup);
  EXPECT_NEAR(s.least_stiff.value, -0.2, 1e-12);
  EXPECT_EQ(s.least_stiff.load, reference()[7].points[3].load);
  EXPECT_EQ(&s.farthest_stiffness(), &s.least_stiff);
  EXPECT_NEAR(s.mean_stiffness, -0.1 / s.points, 1e-12);
  EXPECT_NEAR(s.worst_loads.value, 0.03, 1e-12);
  EXPECT_EQ(s.worst_loads.setup, reference()[9].setup);
  EXPECT_NEAR(s.mean_load.nut, 0.03 / 20 / s.points, 1e-12);
  EXPECT_EQ(s.largest_load.screw, 0.0);
}

TEST(ComputedCurves, StandAtTheSetupsAndLoadsOfTheReference) {
  for (std::size_t k = 0; k < reference().size(); ++k) {
    EXPECT_EQ(bar_curves()[k].setup, reference()[k].setup);
    for (std::size_t n = 0; n < reference()[k].points.size(); ++n) {
      const CurvePoint& point = bar_curves()[k].points[n];
      ASSERT_TRUE(point.is_solved());
      EXPECT_EQ(point.load, reference()[k].points[n].load);
    }
  }
}

/// The script's own bars, which it solves to check itself (summary.csv, four and three decimals).
TEST(ComputedCurves, OfBarsAreThoseOfTheScript) {
  std::map<std::string, double> displacement;
  for (const test::CsvRow& row : test::parse(test::content_of(kFolder / "data/summary.csv")))
    displacement[row.at("config") + ' ' + row.at("direction") + ' ' + row.at("guidance") + ' ' + row.at("lever")] =
        std::stod(row.at("bars_um"));
  ASSERT_EQ(displacement.size(), 24u);
  for (const Curve& curve : bar_curves())
    EXPECT_NEAR(curve.points.back().displacement * 1e6, displacement.at(name(curve.setup)), 0.5e-4)
        << name(curve.setup);
}

TEST(ComputedCurves, NeedAsManyThreadsAndTheCasesByTheirNames) {
  Case fewer = screw();
  fewer.mechanism.contacts_per_roller = 19;
  EXPECT_THROW(computed_curves(fewer, &kBars, reference()), CaseError);
  Case renamed = screw();
  renamed.load_cases[3].name = "compression";
  EXPECT_THROW(computed_curves(renamed, &kBars, reference()), CaseError);
}

// Statements.

/// Bars as computed; the other two models as good as the reference.
Fidelities ideal() { return {reference(), bar_curves(), reference(), reference()}; }

/// Whether each statement holds, in their order: bars' stiffness, bars' loads, refined against the
/// reference, refined against the influence model, influence against the reference.
std::vector<bool> holds(const Fidelities& f) {
  std::vector<bool> all;
  for (const ComparedStatement& s : compare_statements(f)) all.push_back(s.verdict.kind == Verdict::Kind::holds);
  return all;
}

/// Moves a share of the load from one thread to another, in one point.
std::vector<Curve> with_moved_load(std::vector<Curve> curves, double share) {
  curves[4].points[7].load_rate.nut[0] += share;
  curves[4].points[7].load_rate.nut[9] -= share;
  return curves;
}

std::vector<Curve> softened(std::vector<Curve> curves, double share) {
  for (Curve& curve : curves)
    for (CurvePoint& point : curve.points) point.displacement *= 1.0 + share;
  return curves;
}

TEST(FidelityStatements, HoldForBarsAndForModelsThatAreTheReference) {
  EXPECT_EQ(holds(ideal()), (std::vector{true, true, true, true, true}));
}

/// Largest difference between the influence model and the reference.
const ErrorBar kJoint{kReferenceError.stiffness + kInfluenceError.stiffness,
                      kReferenceError.load_rate + kInfluenceError.load_rate};

TEST(FidelityStatements, NoticeAReferenceWithOtherLoads) {
  Fidelities f = ideal();
  f.reference = with_moved_load(reference(), 0.99 * kJoint.load_rate);
  EXPECT_EQ(holds(f), (std::vector{true, true, true, true, true}));
  f.reference = with_moved_load(reference(), 1.01 * kJoint.load_rate);
  EXPECT_EQ(holds(f), (std::vector{true, true, true, true, false}));
  f.reference = with_moved_load(reference(), 1.01 * kRefinedError.load_rate);
  EXPECT_EQ(holds(f), (std::vector{true, true, false, true, false}));
}

TEST(FidelityStatements, NoticeAReferenceWithOtherStiffness) {
  Fidelities f = ideal();
  f.reference = softened(reference(), 0.99 * kJoint.stiffness);
  EXPECT_TRUE(holds(f)[4]);
  f.reference = softened(reference(), 1.01 * kJoint.stiffness);
  EXPECT_TRUE(holds(f)[2]);
  EXPECT_FALSE(holds(f)[4]);
  f.reference = softened(reference(), 1.01 * kRefinedError.stiffness);
  EXPECT_EQ(holds(f), (std::vector{false, true, false, true, false}));
}

TEST(FidelityStatements, NoticeBarsThatAreNoBars) {
  Fidelities f = ideal();
  f.bars = f.reference;
  EXPECT_EQ(holds(f), (std::vector{false, false, true, true, true}));
}

TEST(FidelityStatements, DoNotHoldWithoutAllAnswers) {
  Fidelities f = ideal();
  for (std::vector<Curve>* curves : {&f.bars, &f.refined, &f.influence}) curves->back().points.back().load_rate = {};
  EXPECT_EQ(holds(f), (std::vector{false, false, false, false, false}));
  EXPECT_THAT(compare_statements(f)[2].verdict.evidence, HasSubstr("1 of 312 points without"));
}

TEST(FidelityStatements, TheErrorBarIsThatOfTheDocument) {
  const std::string document = test::content_of(kFolder / "SOURCE.md");
  const std::string line = document.substr(document.find("**Curves**"));
  std::ostringstream stiffness, loads;
  stiffness << "**Curves**: stiffness +-" << 100 * kReferenceError.stiffness << " %";
  loads << "loads +-" << 100 * kReferenceError.load_rate << " % of the sector load";
  EXPECT_THAT(line, HasSubstr(stiffness.str()));
  EXPECT_THAT(line.substr(0, line.find("\n-")), HasSubstr(loads.str()));
}

// Models.

TEST(Fidelities, RefinedStaysWithinItsPromise) {
  const auto curves = computed_curves(screw(), &kRefined, reference());
  const Summary s = summary(curves, reference(), everywhere);
  EXPECT_EQ(s.unsolved, 0);
  EXPECT_LE(std::abs(s.farthest_stiffness().value), kRefinedError.stiffness) << name(s.farthest_stiffness().setup);
  EXPECT_LE(s.worst_loads.value, kRefinedError.load_rate) << name(s.worst_loads.setup);
}

/// CONFIG 2 in tension; all cases in the thorough run.
TEST(Fidelities, InfluenceIsWithinBothErrorBarsOfTheReference) {
  SKIP_UNDER_SANITIZERS();
  const auto curves = at_full_load([](const auto& setup) { return test::count(0, 1) == 1 || setup == kExample; });
  const Summary s = summary(computed_curves(screw(), &kInfluence, curves), curves, everywhere);
  EXPECT_EQ(s.unsolved, 0);
  EXPECT_LE(std::abs(s.farthest_stiffness().value), kJoint.stiffness) << name(s.farthest_stiffness().setup);
  EXPECT_LE(s.worst_loads.value, kJoint.load_rate) << name(s.worst_loads.setup);
}

// Tables, files and pictures.

std::vector<Model> models() { return {{"bars", bar_curves()}, {"truth", reference()}}; }

TEST(FidelityTables, GiveTheDiscrepanciesCaseByCase) {
  const std::vector<ValidationTable> all = tables(models(), reference());
  ASSERT_EQ(all.size(), 4u);
  for (const ValidationTable& table : all)
    for (const ValidationTable::Row& row : table.rows)
      EXPECT_EQ(row.values.size() + 1, table.columns.size()) << table.title;
  const ValidationTable& stiffness = all[0];
  ASSERT_EQ(stiffness.rows.size(), 24u);
  for (std::size_t k = 0; k < 24; ++k) {
    const CurvePoint &point = bar_curves()[k].points.back(), &full = reference()[k].points.back();
    EXPECT_NEAR(stiffness.rows[k].values[1], 100 * (full.displacement / point.displacement - 1), 1e-9);
    EXPECT_EQ(stiffness.rows[k].values[2], 0.0);
  }
}

TEST(FidelityFiles, HoldEveryThreadOfEveryPoint) {
  std::map<std::string, std::string> content;
  for (const OutputFile& file : files(models(), reference())) content[file.name] = file.content;
  const auto threads = test::parse(content.at("load_rates.csv"));
  ASSERT_EQ(threads.size(), 24u * 13 * 2 * 20);
  const test::CsvRow& row = threads[(13 * 3 + 12) * 40 + 25];  // fourth curve, 45 kN, nut thread 6
  EXPECT_EQ(row.at("interface"), "nut");
  EXPECT_EQ(row.at("thread"), "6");
  EXPECT_DOUBLE_EQ(std::stod(row.at("load_kN")), 45.0);
  EXPECT_NEAR(std::stod(row.at("bars_percent")), 100 * bar_curves()[3].points.back().load_rate.nut[5], 1e-9);
  const auto points = test::parse(content.at("comparison.csv"));
  ASSERT_EQ(points.size(), 2u * 24 * 13);
  EXPECT_NEAR(std::stod(points[12].at("stiffness_discrepancy_percent")),
              100 * discrepancy(bar_curves()[0].points[12], reference()[0].points[12])->stiffness,
              1e-8);  // Ten digits.
  EXPECT_THAT(content.at("load_rates.md"), HasSubstr("## 3 compression outer_node half_pitch, 45 kN"));
}

TEST(FidelityFiles, LeaveWhatHasNoAnswerEmpty) {
  std::vector<Model> all = models();
  all[0].curves[0].points[0] = {1e3, 0.0, {}};
  const auto points = test::parse(files(all, reference())[0].content);
  EXPECT_EQ(points[0].at("stiffness_N_per_um"), "");
  EXPECT_EQ(points[0].at("screw_largest_discrepancy_percent"), "");
  EXPECT_NE(points[1].at("stiffness_N_per_um"), "");
}

TEST(FidelityFigures, ShowEveryCaseWithOppositeContacts) {
  std::set<std::string> names;
  for (const Figure& figure : load_rate_figures(models(), reference(), kReferenceError)) {
    names.insert(figure.name);
    ASSERT_EQ(figure.panels.size(), 4u);
    for (const Panel& panel : figure.panels) EXPECT_EQ(panel.series.size(), 4u);
  }
  EXPECT_EQ(names.size(), 12u);
  EXPECT_TRUE(names.contains("load_rate_config2_compression_outer_node"));
  const std::vector<Figure> displacement = displacement_figures(models(), reference(), kReferenceError);
  ASSERT_EQ(displacement.size(), 2u);
  EXPECT_EQ(displacement[0].panels.size(), 6u);
}

/// The reference's own panel of differences is zero, its bars are as long as its error.
TEST(FidelityFigures, DrawTheErrorBarAboutTheReference) {
  const Figure figure = load_rate_figures(models(), reference(), kReferenceError).front();
  const Panel& differences = figure.panels[3];
  const std::vector<Polyline>& strokes = differences.series[2].parts;
  ASSERT_EQ(strokes.size(), 20u);
  for (const Polyline& stroke : strokes) {
    EXPECT_DOUBLE_EQ(stroke[0][1], -100 * kReferenceError.load_rate);
    EXPECT_DOUBLE_EQ(stroke[1][1], 100 * kReferenceError.load_rate);
  }
  for (const auto& [x, y] : differences.series[3].parts.front()) EXPECT_EQ(y, 0.0);
  const double expected =
      100 * (bar_curves()[0].points.back().load_rate.nut[0] - reference()[0].points.back().load_rate.nut[0]);
  EXPECT_DOUBLE_EQ(differences.series[0].parts.front()[0][1], expected);
}

}  // namespace
}  // namespace prs::reference_fe
