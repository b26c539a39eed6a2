#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "known_problems.h"
#include "prs/optimize/optimize_pictures.h"
#include "prs/record/pictures.h"
#include "prs/record/table_units.h"
#include "prs/text.h"
#include "tests/support/text_lines.h"

namespace prs {
namespace {

using test::lines;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// Binh & Korn with a check; a corner of the square has no result.
test::Problem problem() {
  test::Problem problem = test::binh_korn();
  problem.optimization.population = 20;
  problem.optimization.generations = 10;
  problem.optimization.check = Algorithm::nspso;
  problem.optimization.study.factors[0].unit = "mm";
  const auto answer = problem.answer;
  problem.answer = [answer](const std::vector<double>& x) {
    return x[0] < 1.0 && x[1] > 2.0 ? std::vector<double>{} : answer(x);
  };
  return problem;
}

TEST(OptimizeCsv, HasARowForEachDesign) {
  const OptimizationResult result = problem().run();
  const std::vector<std::string> history = lines(history_csv(result));
  ASSERT_THAT(history, SizeIs(1 + 1 + 2 * 200));
  EXPECT_EQ(history[0], "design,algorithm,generation,feasible,violation,status,reason,x_mm,y,f,g,c,d");
  EXPECT_THAT(history[1], StartsWith("0,initial,,"));
  EXPECT_THAT(history[2], StartsWith("1,nsga2,1,"));
  EXPECT_THAT(history[201], StartsWith("200,nsga2,10,"));
  EXPECT_THAT(history[202], StartsWith("201,nspso,1,"));
  std::size_t feasible = 0, refused = 0;
  for (const std::string& line : history) {
    feasible += line.find(",true,0,converged,,") != std::string::npos;
    refused += line.find(",false,,refused,") != std::string::npos;
  }
  const auto count = [&](auto is_one) {
    return static_cast<std::size_t>(std::ranges::count_if(result.search.designs, is_one) +
                                    std::ranges::count_if(result.check->designs, is_one)) +
           is_one(result.initial);
  };
  EXPECT_EQ(feasible, count([](const EvaluatedDesign& d) { return d.is_feasible(); }));
  EXPECT_EQ(refused, count([](const EvaluatedDesign& d) { return !d.status.converged(); }));
  EXPECT_GT(refused, 0);

  const std::vector<std::string> front = lines(front_csv(result));
  ASSERT_THAT(front, SizeIs(1 + result.front.size()));
  EXPECT_EQ(front[0], "design,compromise,x_mm,y,f,g,c,d");
  EXPECT_EQ(
      std::ranges::count_if(front, [](const std::string& line) { return line.find(",true,") != std::string::npos; }),
      1);
}

TEST(OptimizeJson, CompromiseIsOneOfTheFront) {
  const OptimizationResult result = problem().run();
  const auto document = optimize_json(result, {});
  const auto& chosen = document["compromise"];
  EXPECT_THAT(document["front"], testing::Contains(chosen["design"]));
  for (const auto& number : document["front"]) {
    const bool of_search = number <= result.search.designs.size();
    const auto& search = document[of_search ? "search" : "check"];
    const auto& front = search["front"];
    const auto found = std::ranges::find_if(front, [&](const auto& design) { return design["design"] == number; });
    ASSERT_NE(found, front.end());
    if (number != chosen["design"]) continue;
    EXPECT_EQ((*found)["responses"], chosen["responses"]);
    EXPECT_EQ(search["algorithm"], chosen["algorithm"]);
  }
  EXPECT_THAT(chosen["constraints"], SizeIs(2));
  EXPECT_THAT(chosen["set"], SizeIs(2));
  EXPECT_EQ(document["comparison"]["best"].size(), 2);
}

TEST(OptimizeFigures, HistoryAndFrontShowEveryDesignOnce) {
  const OptimizationResult result = problem().run();
  const Figures figures = prs::figures(optimization_pictures(result));
  ASSERT_THAT(figures, SizeIs(2));
  EXPECT_EQ(figures[0].name, "history");
  EXPECT_EQ(figures[1].name, "front");
  ASSERT_THAT(figures[0].panels, SizeIs(2));
  const std::vector<Series>& lines = figures[0].panels[0].series;
  const auto feasible_of = [](const Search& search) {
    return static_cast<std::size_t>(std::ranges::count_if(search.designs, &EvaluatedDesign::is_feasible));
  };
  const std::size_t feasible = feasible_of(result.search);
  EXPECT_THAT(lines[1].parts.at(0), SizeIs(feasible + feasible_of(*result.check)));
  // The best so far falls from the first to the best feasible design.
  const Polyline& best = lines[2].parts.at(0);
  EXPECT_TRUE(std::ranges::is_sorted(best, std::ranges::greater{}, [](auto& p) { return p[1]; }));
  EXPECT_EQ(best.back()[1], result.design(result.front[0]).responses[0]);
  EXPECT_EQ(best.back()[0], 400.0);
  const std::vector<Series>& front = figures[1].panels.at(0).series;
  EXPECT_THAT(front[0].parts.at(0), SizeIs(feasible));
  EXPECT_THAT(front.end()[-2].parts.at(0), SizeIs(result.check->front.size()));
  EXPECT_THAT(front.end()[-1].parts.at(0), SizeIs(result.search.front.size()));
}

TEST(OptimizeTable, FitsIts110Columns) {
  const OptimizationResult result = problem().run();
  const std::string table = optimize_table(result);
  for (const std::string& line : lines(table)) EXPECT_LE(width(line), 110) << line;
  EXPECT_THAT(table, HasSubstr("nsga2: 10 generations of 20 designs, seed 1"));
  EXPECT_THAT(table, HasSubstr("2 of 2 constraints are kept"));
  EXPECT_THAT(table, HasSubstr("Check by nspso"));
  EXPECT_THAT(table, HasSubstr("without an answer, the first: x: got one that no mechanism has"));
}

TEST(OptimizeTable, RefusedDesignsAreCountedByTheirKeys) {
  test::Problem refusing = problem();
  OptimizationResult result = refusing.run();
  std::size_t by_x = 0;
  for (EvaluatedDesign& design : result.search.designs) {
    if (design.status.name != "refused") continue;
    constexpr const char* kPlaces[] = {"case.yaml:3:7: error: ", "case.yaml:9:2: error: ", ""};
    design.status.reason = fmt::format("{}mechanism.lead: got 1 mm; expected more", kPlaces[by_x++ % 3]);
  }
  ASSERT_GT(by_x, 2);
  const auto kept = std::ranges::find_if(result.search.designs, [](auto& d) { return d.status.converged(); });
  kept->status = DesignStatus{"refused", "case.yaml:4:7: error: mechanism.rollers: got 1; expected 3"};
  const std::string table = optimize_table(result);
  EXPECT_THAT(table, HasSubstr(fmt::format("{} without an answer, the first: ", by_x)));
  EXPECT_THAT(table, HasSubstr("1 without an answer, the first: case.yaml:4:7: error: mechanism.rollers"));
}

TEST(OptimizeTable, ResponsesHaveTheUnitsOfTables) {
  OptimizationResult result = problem().run();
  result.optimization.study.responses[0] = "f_N";
  const double least = result.design(*result.compromise).responses[0];
  EXPECT_THAT(optimize_table(result), HasSubstr("min. f (N)"));
  const TableUnits units(UnitSystem::us);
  EXPECT_THAT(optimize_table(result), HasSubstr("min. f (lbf)"));
  // 1 lbf = 4.448221615 N (NIST SP 811, appendix B.8).
  EXPECT_THAT(optimize_table(result), HasSubstr(fmt::format(" {:.6g} ", least / 4.448221615)));
}

}  // namespace
}  // namespace prs
