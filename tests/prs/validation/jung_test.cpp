// Jung's printed tables: their origin, and the results of the right formulas.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "prs/life/rating_life.h"
#include "prs/validation/validate.h"
#include "tests/support/temporary_directory.h"
#include "validation/extensions.h"
#include "validation/jung_2017/tables.h"

namespace prs::jung_2017 {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Stiffness of table 7.1 [N/mm] and half a unit of its last digit.
constexpr double kStiffness[10][2] = {{10672.1, 0.05},  {9353.2, 0.005},  {8170.23, 0.005}, {7112.49, 0.005},
                                      {6168.84, 0.005}, {5328.19, 0.005}, {4579.96, 0.005}, {3914.25, 0.005},
                                      {3321.97, 0.005}, {2794.88, 0.005}};

SourceReport report() { return validate(PRS_SOURCE_DIR "/validation/jung_2017", {extension()}).front(); }

Reference thesis() { return read_reference(PRS_SOURCE_DIR "/validation/jung_2017/reference.yaml"); }

TEST(JungTables, EveryDigitOfTable71) {
  int of_table_7_1 = 0;
  for (const Comparison& c : report().comparisons) {
    if (!c.reference.where.starts_with("table 7.1")) continue;
    ++of_table_7_1;
    EXPECT_EQ(c.outcome(), Outcome::reproduces)
        << c.reference.where << ' ' << c.reference.printed.text << ' ' << c.computed.value_or(0.0);
  }
  EXPECT_EQ(of_table_7_1, 60);
}

/// Table A1: one wrong number and five that belong to a neighbouring F(rho). Misprints of 66.68 and
/// 18.2. Table 7.2: nine force densities, and eight stiffnesses that differ by at most 0.004 N/mm. Table 3.1: an angle
/// that was cut off.
TEST(JungTables, OnlyTwentySixPrintedNumbersDiffer) {
  std::map<Outcome, int> count;
  for (const Comparison& c : report().comparisons) {
    ++count[c.outcome()];
    if (c.reference.where.starts_with("table 7.2, k")) {
      EXPECT_NEAR(*c.computed, c.reference.printed.value(), 0.0045) << c.reference.where;
    }
  }
  EXPECT_EQ(count[Outcome::differs], 8 + 9 + 8 + 1);
  EXPECT_EQ(count[Outcome::unexpected] + count[Outcome::missing], 0);
  EXPECT_EQ(count[Outcome::reproduces], 209 + 60 - 9 - 8 + 1);
}

/// Table 7.2 divides the capacities of table 7.1 by its own weights, to the last digit.
TEST(JungTables, ForceDensitiesOfTable72AreOfTwoTables) {
  std::vector<double> printed;
  for (const Comparison& c : report().comparisons)
    if (c.reference.where.starts_with("table 7.2, F_D")) printed.push_back(c.reference.printed.value());
  ASSERT_THAT(printed, SizeIs(10));
  for (std::size_t k = 0; k < printed.size(); ++k)
    EXPECT_NEAR(1e-3 * as_printed(case_1()[k]).load_capacity / as_printed(case_2()[k]).weight, printed[k], 0.0005) << k;
}

/// Teeth of 5.579603 in place of 5.579502, in E times compliance on 1 mm of thread, and a thread load of 2370 N in
/// place of 1500 N give all twenty stiffnesses to the last digit.
TEST(JungTables, OneStiffnessOfTheTeethAndOneLoadGiveBothTables) {
  const double teeth = 5.579603 / (2.1e11 * 1e-3), hertz = std::cbrt(1500.0 / 2370.0);
  int missed = 0, compared = 0;
  for (const Comparison& c : report().comparisons) {
    const bool first = c.reference.where.starts_with("table 7.1, k"),
               second = c.reference.where.starts_with("table 7.2, k");
    if (!first && !second) continue;
    const std::size_t row = static_cast<std::size_t>(compared++ % 10);
    const ThreadCompliance t = compliance_as_printed(first ? case_1()[row] : case_2()[row]);
    const double total = teeth + t.screw_radial + t.nut_radial + hertz * t.hertz;
    if (std::abs(1e-3 / total - c.reference.printed.value()) > c.reference.printed.half_unit()) ++missed;
  }
  EXPECT_EQ(compared, 20);
  EXPECT_EQ(missed, 0);
}

/// Without any recipe: E/k less (3.8) and (3.17) with the lead as pitch and tan 45 deg is the same
/// number for all ten printed stiffnesses, within their rounding and the 1.5e-4 by which Hertz's
/// term changes.
TEST(JungTables, PrintedStiffnessesHoldTheRadialTermsWithTheLead) {
  constexpr double kModulus = 2.1e5, kPoisson = 0.3, kLead = 10.0;  // MPa, mm
  const std::array<Diameters, 10> rows = case_1();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double outer = 1e3 * rows[k].nut_outer, screw = 1e3 * rows[k].screw;
    const double inner = 1e3 * rows[k].nut_inner();
    const double ring = (outer * outer + inner * inner) / (outer * outer - inner * inner);
    const double rest = kModulus / kStiffness[k][0] - (ring + kPoisson) * inner / (2.0 * kLead) -
                        (1.0 - kPoisson) * screw / (2.0 * kLead);
    const double rounding = kModulus / std::pow(kStiffness[k][0], 2) * kStiffness[k][1];
    EXPECT_NEAR(rest, 5.5802, 7e-5 + rounding) << outer;
  }
}

/// The rounding of the ten stiffnesses restricts the load of a thread to between 1476 and 1509 N, given the teeth; and
/// another tooth does not fit.
TEST(JungTables, TheLoadOfAThreadIsFixedByTheLastDigits) {
  const auto misses = [](double load, double teeth) {
    int missed = 0;
    const std::array<Diameters, 10> rows = case_1();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const ThreadCompliance c = compliance_as_printed(rows[k]);
      const double total = c.total() + c.hertz * (std::cbrt(1500.0 / load) - 1.0) + c.teeth * (teeth - 1.0);
      if (std::abs(1e-3 / total - kStiffness[k][0]) > kStiffness[k][1]) ++missed;
    }
    return missed;
  };
  EXPECT_EQ(misses(1480.0, 1.0), 0);
  EXPECT_EQ(misses(1505.0, 1.0), 0);
  EXPECT_GT(misses(1450.0, 1.0), 0);
  EXPECT_GT(misses(1530.0, 1.0), 0);
  EXPECT_GT(misses(1500.0, 1.0001), 0);
  EXPECT_GT(misses(1500.0, 0.9999), 0);
}

TEST(JungTables, RightColumnsAreThoseOfTheTheory) {
  for (const auto& rows : {case_1(), case_2()})
    for (const Diameters& d : rows) {
      const Measures m = corrected(d), printed = as_printed(d);
      EXPECT_DOUBLE_EQ(2.0 * m.nut_thickness, d.nut_outer - d.nut_inner());
      EXPECT_DOUBLE_EQ(m.weight, 7850.0 * m.volume);
      // Tube by its wall, rods by their number: (5.1), (5.2) with coefficients of 7850 kg/m^3.
      const double mm_outer = 1e3 * d.nut_outer, mm_wall = 1e3 * m.nut_thickness;
      const double tube = 0.02466 * (mm_outer - mm_wall) * mm_wall * kLength;
      const double rods = 0.006165 * std::pow(1e3 * d.roller, 2) * kRollers * kLength;
      EXPECT_NEAR(m.weight / (tube + rods), 1.0, 1e-4);
      const std::optional<LemorCapacity> lemor =
          lemor_capacity(LemorGeometry{.pitch = kPitch,
                                       .roller_diameter = d.roller,
                                       .nut_diameter = d.nut_inner(),
                                       .pitch_circle = d.screw + d.roller,
                                       .contact_angle = std::numbers::pi / 4.0,
                                       .helix_angle = Threads{}.helix_angle_at(d.screw),
                                       .contacts = 500});
      ASSERT_TRUE(lemor);
      EXPECT_NEAR(m.load_capacity / lemor->capacity, 1.0, 1e-14);
      EXPECT_NEAR(m.load_capacity / printed.load_capacity, 1.0, 1.1e-3);
      EXPECT_GT(printed.weight, 1.15 * m.weight);  // The nut is counted with twice its wall.
    }
}

/// Exact Hertz by Harris' parameters: delta = delta* (3 N Y*/(2 sum))^(2/3) sum/2 with the sum Y*
/// of both bodies (errata of (3.20)); the printed term has one body and Pa for N/mm^2.
TEST(JungTables, HertzTermIsTenThousandTimesTooSmall) {
  const double y = 2.0 * (1.0 - 0.09) / 2.1e11, angle = std::numbers::pi / 4.0;
  for (const Diameters& d : case_1()) {
    double axial_approach = 0.0;
    for (const auto& [radius, sign] : {std::pair{d.nut_inner() / 2.0, -1.0}, {d.screw / 2.0, 1.0}}) {
      const double ball = 2.0 * std::sin(angle) / d.roller;
      const double body = sign * std::cos(angle) / radius, sum = 2.0 * ball + body;
      const double axial = std::sin(angle) * std::cos(std::atan(1e-2 / (2.0 * std::numbers::pi * radius)));
      axial_approach += contact_parameters(std::abs(body) / sum).approach *
                        std::pow(1.5 * (1500.0 / axial) * y / sum, 2.0 / 3.0) * sum / 2.0 / axial;
    }
    const double right = right_compliance(d).hertz;
    EXPECT_NEAR(right * 1500.0 / axial_approach, 1.0, 1e-12);
    const double factor = right / compliance_as_printed(d).hertz;
    EXPECT_NEAR(factor / (1e4 * std::cbrt(4.0)), 1.0, 0.03);  // 2^(2/3) by the second body
  }
}

/// Hertz in its right size turns the fall of stiffness in case 2 into a rise.
TEST(JungTables, StiffnessOfCase2FallsByTheSlipsOnly) {
  const std::array<Diameters, 10> rows = case_2();
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_LT(as_printed(rows[k]).stiffness, as_printed(rows[k - 1]).stiffness);
    EXPECT_GT(corrected(rows[k]).stiffness, corrected(rows[k - 1]).stiffness);
  }
}

TEST(JungTables, RollersOfCase2AreAThirdOfTheScrew) {
  for (const Diameters& d : case_2()) {
    EXPECT_DOUBLE_EQ(3.0 * d.roller, d.screw);
    EXPECT_DOUBLE_EQ(2.0 * d.screw, d.nut_outer);
  }
  const Measures first_1 = as_printed(case_1()[0]), first_2 = as_printed(case_2()[0]);
  EXPECT_NEAR(first_2.stiffness / first_1.stiffness, 1.0, 1e-12);
}

/// (3.8) and (3.17) with the pitch do not depend on the starts, with the lead they go with 1/N_s; Hertz's axial
/// approach goes with cos(beta)^(-5/3).
TEST(JungThreads, StartsCountByTheSlipOnly) {
  const Diameters d = case_1()[0];
  const Threads one{.starts = 1}, four{.starts = 4};
  EXPECT_DOUBLE_EQ(right_compliance(d, one).nut_radial, right_compliance(d, four).nut_radial);
  EXPECT_DOUBLE_EQ(right_compliance(d, one).teeth, right_compliance(d, four).teeth);
  EXPECT_NEAR(compliance_as_printed(d, one).nut_radial / compliance_as_printed(d, four).nut_radial, 4.0, 1e-12);
  EXPECT_NEAR(compliance_as_printed(d, one).screw_radial / compliance_as_printed(d, four).screw_radial, 4.0, 1e-12);
  const Threads straight{.helix_angle = 0.0}, steep{.helix_angle = std::numbers::pi / 4.0};
  EXPECT_NEAR(right_compliance(d, steep).hertz / right_compliance(d, straight).hertz, std::pow(2.0, 5.0 / 6.0), 1e-12);
}

/// C_a goes with N_c^(2/3), N_c = N_r L/p, and D_c^1.8 with p^0.9; weights go with the length.
TEST(JungThreads, CapacityFollowsContactsAndPitch) {
  const Diameters d = case_1()[0];
  const Measures m = corrected(d);
  EXPECT_NEAR(corrected(d, {.length = 8.0 * kLength}).load_capacity / m.load_capacity, 4.0, 1e-12);
  EXPECT_NEAR(corrected(d, {.length = 8.0 * kLength}).weight / m.weight, 8.0, 1e-12);
  const Threads coarse{.pitch = 2.0 * kPitch, .helix_angle = Threads{}.helix_angle_at(d.screw)};
  EXPECT_NEAR(corrected(d, coarse).load_capacity / m.load_capacity, std::pow(2.0, 0.9 - 2.0 / 3.0), 1e-12);
}

/// Eight statements of the thesis follow from its slips alone, and five from neither: one of chapter 4, one of chapter
/// 5, three of Ma's rules.
TEST(JungStatements, ThirteenOfFortyOneDoNotHold) {
  std::map<Verdict::Kind, int> count;
  for (const ComparedStatement& s : report().statements) {
    ++count[s.verdict.kind];
    EXPECT_EQ(s.verdict.kind == Verdict::Kind::holds, s.verdict.why.empty()) << s.text;
  }
  EXPECT_EQ(count[Verdict::Kind::holds], 28);
  EXPECT_EQ(count[Verdict::Kind::holds_only_with], 8);
  EXPECT_EQ(count[Verdict::Kind::does_not_hold], 5);
}

/// The printed polynomials are least-squares fits to the recipe's own values, in case 2 too. (7.12) holds to the
/// rounding of its table.
TEST(JungFits, NewFitsGiveThePrintedCoefficients) {
  const std::map<std::string, double> tolerance = {{"(7.8)", 3e-5},  {"(7.9)", 3e-6},  {"(7.10)", 3e-5},
                                                   {"(7.11)", 4e-4}, {"(7.12)", 0.02}, {"(7.13)", 3e-6}};
  ASSERT_THAT(volume_fits(thesis()), SizeIs(tolerance.size()));
  for (const VolumeFit& fit : volume_fits(thesis())) {
    const std::array<double, 6> again = refitted(fit);
    for (std::size_t k = 0; k < again.size(); ++k)
      EXPECT_NEAR(again[k] / fit.coefficients[k], 1.0, tolerance.at(fit.equation)) << fit.equation << ' ' << k;
  }
}

/// At the unrounded volumes (7.8) to (7.10) meet their table to 5e-5, 2e-5 and 8e-6 of it; at the
/// printed ones (7.8) misses by up to 6.5 N/mm.
TEST(JungFits, MeetTheirTableAtUnroundedVolumesOnly) {
  const ValidationTable deviations = fit_tables(thesis()).front();
  EXPECT_LT(deviations.rows[0].values[0], 0.54);
  EXPECT_GT(deviations.rows[0].values[1], 6.0);
  EXPECT_LT(deviations.rows[1].values[0], 0.0035);
  EXPECT_LT(deviations.rows[2].values[0], 1.2e-5);
  EXPECT_LT(deviations.rows[3].values[1], 1.9);
  EXPECT_LT(deviations.rows[4].values[1], 0.041);
  EXPECT_LT(deviations.rows[5].values[1], 7.5e-4);
}

/// F(rho) = ((k^2 + 1) E - 2 K)/((k^2 - 1) E), k = a*/b*, delta* = 2 K/(pi a*), with K and E by
/// quadrature; the trapezoidal rule converges exponentially on periodic integrands.
TEST(JungContactParameters, AreExact) {
  for (const double f : {0.1, 0.4795, 0.9, 0.9989156}) {
    const ContactParameters p = contact_parameters(f);
    const double k = p.semi_major / p.semi_minor, m = 1.0 - 1.0 / (k * k);
    double first = 0.0, second = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double s = std::sin((i + 0.5) * std::numbers::pi / (2 * kSteps));
      const double w = std::sqrt(1.0 - m * s * s);
      first += std::numbers::pi / (2 * kSteps) / w;
      second += std::numbers::pi / (2 * kSteps) * w;
    }
    EXPECT_NEAR(((k * k + 1.0) * second - 2.0 * first) / ((k * k - 1.0) * second), f, 1e-11);
    EXPECT_NEAR(std::pow(p.semi_major, 3) * std::numbers::pi / (2.0 * k * k * second), 1.0, 1e-11);
    EXPECT_NEAR(p.approach * p.semi_major * std::numbers::pi / (2.0 * first), 1.0, 1e-11);
  }
  const ContactParameters round = contact_parameters(0.0);
  EXPECT_DOUBLE_EQ(round.semi_major, 1.0);
  EXPECT_DOUBLE_EQ(round.semi_minor, 1.0);
  EXPECT_DOUBLE_EQ(round.approach, 1.0);
}

TEST(JungContactParameters, OneNumberOfTableA1IsWrong) {
  std::vector<std::string> wrong;
  for (const PrintedParameters& line : table_a1(thesis())) {
    const PrintedNumber& f = line.curvature_difference;
    for (const auto& [printed, parameter] : {std::pair{&line.semi_major, &ContactParameters::semi_major},
                                             {&line.semi_minor, &ContactParameters::semi_minor},
                                             {&line.approach, &ContactParameters::approach}})
      if (unexplained(*printed, f, parameter) > 0.0) wrong.push_back(printed->text);
  }
  EXPECT_THAT(wrong, testing::ElementsAre("0.9429"));
}

TEST(JungScaleChart, IsThatOfTheNutWhoseMeanSquareIs1) {
  double sum = 0.0;
  for (const ScaleLine& line : scale_chart()) sum += line.scale * line.scale;
  EXPECT_NEAR(sum / 10.0, 1.0, 1e-15);
  EXPECT_NEAR(scale_chart()[0].nut_outer, 0.04, 1e-15);
}

std::vector<SourceReport> report_of(const std::string& item) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "reference.yaml") << "source: a test\ncases:\n  - " << item << '\n';
  return validate(folder.path(), {});
}

/// Formulas need no case; without the code that gives them their numbers are missing.
TEST(JungFormulas, AreMissingWithoutTheirCode) {
  const std::vector<SourceReport> reports =
      report_of("{formulas: table 1, values: [{quantity: a, where: here, printed: '1'}]}");
  ASSERT_THAT(reports, SizeIs(1));
  EXPECT_EQ(reports[0].comparisons.at(0).outcome(), Outcome::missing);
  EXPECT_EQ(reports[0].comparisons.at(0).case_name, "table 1");
}

TEST(JungFormulas, AreNoCase) {
  try {
    report_of("{formulas: table 1, case: a.yaml, values: [{quantity: a, where: b, printed: '1'}]}");
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("case: unknown key; expected one of formulas, values"));
  }
}

}  // namespace
}  // namespace prs::jung_2017
