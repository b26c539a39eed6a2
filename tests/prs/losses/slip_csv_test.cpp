#include "prs/losses/slip_table.h"

#include <gtest/gtest.h>

#include "support/parsed_csv.h"
#include "support/sample_slip.h"

namespace prs {
namespace {

using test::equal_share_case;
using test::failed_case;
using test::parse;
using test::solved_case;
using test::with_slip;
using test::without_equilibrium;

Result sample_cases() {
  Result result;
  result.load_cases = {with_slip(solved_case("a, \"b\"", 45e3, Direction::tension)),
                       without_equilibrium(equal_share_case("none")), failed_case("hopeless"),
                       with_slip(equal_share_case("equal"))};
  result.load_cases[3].slip->equal_shares.reset();
  return result;
}

TEST(SlipCsv, OneRowALoadCase) {
  const Result result = sample_cases();
  const SlipResult& slip = *result.load_cases[0].slip;
  const auto rows = parse(slip_csv(result, {.digits = CsvStyle::kAllDigits}));
  ASSERT_EQ(rows.size(), 4);
  EXPECT_EQ(rows[0].at("case"), "a, \"b\"");
  EXPECT_EQ(rows[0].at("direction"), "tension");
  EXPECT_EQ(rows[0].at("axial_force_N"), "45000");
  EXPECT_NEAR(std::stod(rows[0].at("speed_rpm")), 400.0, 1e-9);
  EXPECT_EQ(rows[0].at("status"), "converged");
  EXPECT_EQ(std::stod(rows[0].at("slip_ratio")), slip.slip_ratio);
  EXPECT_EQ(std::stod(rows[0].at("ideal_slip_ratio")), slip.ideal_slip_ratio);
  EXPECT_EQ(rows[0].at("optimality_percent"), "99.5");
  EXPECT_EQ(std::stod(rows[0].at("efficiency")), *slip.efficiency);
  EXPECT_EQ(std::stod(rows[0].at("power_loss_W")), slip.power.total());
  EXPECT_EQ(std::stod(rows[0].at("carrier_roller_power_W")), slip.power.carrier_roller);
  EXPECT_EQ(rows[0].at("torque_screw_Nm"), "12.5");
  EXPECT_EQ(rows[0].at("hottest_interface"), "screw");
  EXPECT_EQ(rows[0].at("hottest_thread"), "1");
  EXPECT_EQ(std::stod(rows[0].at("hottest_thread_power_W")), slip.threads.screw.power[0]);
  EXPECT_EQ(std::stod(rows[0].at("equal_shares_power_loss_W")), slip.equal_shares->power_loss);
}

TEST(SlipCsv, CasesWithoutAnAnswerSayWhy) {
  const auto rows = parse(slip_csv(sample_cases()));
  EXPECT_EQ(rows[1].at("converged"), "false");
  EXPECT_EQ(rows[1].at("status"), "no_equilibrium");
  EXPECT_EQ(rows[1].at("evaluations"), "2");
  EXPECT_EQ(rows[1].at("slip_ratio"), "");
  EXPECT_EQ(rows[1].at("screw_power_W"), "");
  EXPECT_EQ(rows[1].at("hottest_thread"), "");
  EXPECT_EQ(rows[2].at("status"), "line_search_failed");
  EXPECT_EQ(rows[2].at("evaluations"), "");
  EXPECT_EQ(rows[3].at("equal_shares_slip_ratio"), "");
}

TEST(SlipCsv, OneRowAThreadAndInterface) {
  const Result result = sample_cases();
  const auto rows = parse(slip_threads_csv(result, {.digits = CsvStyle::kAllDigits}));
  ASSERT_EQ(rows.size(), 2 * (20 + 4));
  EXPECT_EQ(rows[0].at("interface"), "screw");
  EXPECT_EQ(rows[19].at("thread"), "20");
  EXPECT_EQ(rows[20].at("interface"), "nut");
  EXPECT_EQ(rows[40].at("case"), "equal");
  const LoadCaseResult& first = result.load_cases[0];
  EXPECT_EQ(std::stod(rows[21].at("power_W")), first.slip->threads.nut.power[1]);
  EXPECT_EQ(std::stod(rows[21].at("axial_load_N")), first.threads->nut.axial_load[1]);
  EXPECT_DOUBLE_EQ(std::stod(rows[21].at("film_thickness_nm")), 310.0);
  EXPECT_DOUBLE_EQ(std::stod(rows[21].at("central_film_nm")), 260.0);
}

TEST(SlipCsv, AbsentFilmIsAnEmptyField) {
  Result result = sample_cases();
  for (const Interface i : kInterfaces) result.load_cases[0].slip->threads[i].film_thickness = {};
  EXPECT_EQ(parse(slip_threads_csv(result))[0].at("film_thickness_nm"), "");
}

}  // namespace
}  // namespace prs
