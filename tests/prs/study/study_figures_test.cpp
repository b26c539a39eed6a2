
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "prs/study/study_pictures.h"
#include "prs/svg/panel.h"
#include "support/shown.h"
#include "tests/support/sample_study.h"

namespace prs {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using test::names;

Figures study_figures(const StudyResult& result) { return figures(study_pictures(result)); }

TEST(StudyFigures, OfOneFactorAtATimeLeaveGaps) {
  const std::vector<Figure> figures = study_figures(sample::counting());
  EXPECT_THAT(names(figures), ElementsAre("01_y", "02_z_max"));
  const std::vector<Series>& lines = figures[0].panels.at(0).series;
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_THAT(lines[0].parts, ElementsAre(Polyline{{1.0, 10.0}, {2.0, 20.0}}, Polyline{{4.0, 40.0}}));
  EXPECT_THAT(lines[1].parts, ElementsAre(Polyline{{2.0, 20.0}}));
}

TEST(StudyFigures, ForcesOfAThousandNewtonsAreInKilonewtonsAndPressuresInGigapascals) {
  const auto drawn = [](double largest, const char* response) {
    Study study;
    study.plan = Plan::grid;
    std::vector<double> many;
    for (int k = 1; k <= 10; ++k) many.push_back(0.1 * k);
    study.factors = {sample::counted("x", many), sample::counted("y", many)};
    study.responses = {response};
    const StudyResult result =
        sample::run(study, [&](const std::vector<double>& x) { return std::vector{largest * x[0] * x[1]}; });
    return figure(study_pictures(result), "map", {});
  };
  const char* capacity = "measures.dynamic_capacity_N";
  const Figure large = drawn(2e4, capacity), small = drawn(900.0, capacity);
  EXPECT_EQ(large.colours->unit, "kN");
  EXPECT_EQ(large.colours->to, 20.0);
  EXPECT_DOUBLE_EQ(std::ranges::max(large.panels[0].map.grid.values), 20.0);
  EXPECT_EQ(small.colours->unit, "N");
  EXPECT_DOUBLE_EQ(std::ranges::max(small.panels[0].map.grid.values), 900.0);
  const Figure pressure = drawn(2500.0, "screw.peak_pressure_MPa.max");
  EXPECT_EQ(pressure.colours->unit, "GPa");
  EXPECT_DOUBLE_EQ(std::ranges::max(pressure.panels[0].map.grid.values), 2.5);
}

Study slip_study() {
  Study study;
  study.factors = {sample::counted("operation.speed", {1.0, 2.0, 4.0}, "speed")};
  study.responses = {"slip.efficiency",
                     "slip.efficiency_fit",
                     "slip.power_loss_W",
                     "slip.share_percent.screw",
                     "slip.share_percent.nut",
                     "slip.share_percent.carrier_roller",
                     "slip.share_percent.carrier_screw",
                     "slip.share_percent.carrier_nut"};
  return study;
}

TEST(StudyFigures, ShowPowerBySourceWhereItIsRecorded) {
  const auto answer = [](const std::vector<double>& x) {
    return std::vector{0.8, 0.79, 100.0 * x[0], 75.0, 25.0, 0.0, 0.0, 0.0};
  };
  const std::vector<Figure> figures = study_figures(sample::run(slip_study(), answer));
  ASSERT_THAT(names(figures), ElementsAre("01_speed"));
  const Figure& figure = figures[0];
  ASSERT_THAT(figure.panels, SizeIs(2));
  // The screw takes 3/4 of the 200 W in the file: 37.5, 75 and 150 % at 1, 2 and 4.
  const Polyline& screw = figure.panels[0].series.at(0).parts.at(0);
  EXPECT_THAT(screw, ElementsAre(ElementsAre(1.0, 0.0), ElementsAre(2.0, 0.0), ElementsAre(4.0, 0.0),
                                 ElementsAre(4.0, 150.0), ElementsAre(2.0, 75.0), ElementsAre(1.0, 37.5)));
  EXPECT_THAT(svg_file(figure), AllOf(HasSubstr(">as in the file<"), HasSubstr("(3.55)<")));

  Study less = slip_study();
  less.responses = {"slip.efficiency"};
  const auto efficiency = [](const std::vector<double>& x) { return std::vector{x[0]}; };
  EXPECT_THAT(names(study_figures(sample::run(less, efficiency))), ElementsAre("01_slip_efficiency"));
}

TEST(StudyFigures, ParetoGraphAddsUpTheRankedContributions) {
  const std::vector<Figure> figures = study_figures(sample::sampled(Plan::latin_hypercube));
  EXPECT_THAT(
      names(figures),
      ElementsAre("contributions_01_screw_peak_pressure_MPa_max", "contributions_02_nut_peak_pressure_MPa_max",
                  "designs_01_screw_peak_pressure_MPa_max", "designs_02_nut_peak_pressure_MPa_max", "histograms"));
  const Panel& panel = figures[0].panels.at(0);
  EXPECT_THAT(panel.labels, SizeIs(3));
  const std::vector<Tick>& ticks = figures[0].y.ticks;
  ASSERT_THAT(ticks, SizeIs(3));
  EXPECT_EQ(ticks[0].text, "Flank angle");
  EXPECT_EQ(ticks[0].at, 3.0);  // Counted from above.
  const Series &grows = panel.series.at(0), &falls = panel.series.at(1);
  EXPECT_NEAR(grows.parts.at(0).at(1)[0], 75.0, 1e-9);
  EXPECT_NEAR(falls.parts.at(0).at(0)[0], -25.0, 1e-9);
  // The surface passes through the designs' middle: 5 + 3 x_a.
  const Panel& cloud = figures[2].panels.at(0);
  EXPECT_THAT(cloud.series.at(0).parts.at(0), SizeIs(500));
  const Polyline& line = cloud.series.at(1).parts.at(0);
  EXPECT_NEAR(line[0][1], 1e-3 * (5.0 + 3.0 * (line[0][0] - 2.0)), 1e-12);  // In GPa.
  EXPECT_EQ(text_of(*figures[2].panels[0].x), "Flank angle (°)");
}

TEST(StudyFigures, HistogramHasAllDesigns) {
  const StudyResult result = sample::sampled(Plan::monte_carlo);
  const Figure histograms = study_figures(result).back();
  ASSERT_THAT(histograms.panels, SizeIs(2));
  double count = 0.0;
  for (const Polyline& bar : histograms.panels[0].series.at(0).parts) count += bar.at(2)[1];
  EXPECT_EQ(count, 500.0);
  EXPECT_EQ(histograms.panels[0].references.back().at, 5e-3);  // Value as in the file, in GPa.
}

TEST(StudyFigures, SharesOfTheVarianceCarryTheirIntervals) {
  const Figure figure = study_figures(sample::sampled(Plan::sobol_indices, 1024)).front();
  EXPECT_EQ(figure.name, "variance_01_screw_peak_pressure_MPa_max");
  const Panel& panel = figure.panels.at(0);
  EXPECT_NEAR(panel.series.at(0).parts.at(0).at(1)[0], 90.0, 2.0);
  // A line and two caps for each of two estimates of three factors.
  EXPECT_THAT(panel.series.at(2).parts, SizeIs(18));
}

Study grid(std::vector<Factor> factors) {
  Study study;
  study.plan = Plan::grid;
  study.factors = std::move(factors);
  study.responses = {"y"};
  return study;
}

Factor words(std::string path) {
  Factor factor;
  factor.path = factor.label = std::move(path);
  factor.levels = {{"tension", {}}, {"compression", {}}};
  return factor;
}

TEST(StudyFigures, GridHasALineForEachLevelAndAPanelForEachOther) {
  const Study study = grid({sample::counted("position", {1.0, 2.0, 3.0}), words("direction"),
                            sample::counted("force", {40.0, 10.0, 20.0, 30.0})});
  const auto answer = [](const std::vector<double>& x) {
    return x[2] == 20.0 && x[0] == 1.0 ? std::vector<double>{} : std::vector{100.0 * x[0] + 1000.0 * x[1] + x[2]};
  };
  const std::vector<Figure> figures = study_figures(sample::run(study, answer));
  ASSERT_THAT(figures, SizeIs(1));
  const Figure& figure = figures[0];
  EXPECT_EQ(figure.x.label, "Force");
  ASSERT_THAT(figure.panels, SizeIs(2));
  EXPECT_EQ(figure.panels[0].title, "Direction tension");
  EXPECT_EQ(figure.panels[1].title, "Direction compression");
  ASSERT_THAT(figure.legend, SizeIs(3));
  EXPECT_EQ(figure.legend[1].title, "Position 2");
  EXPECT_THAT(figure.panels[1].series.at(1).parts,
              ElementsAre(Polyline{{10.0, 1210.0}, {20.0, 1220.0}, {30.0, 1230.0}, {40.0, 1240.0}}));
  EXPECT_THAT(figure.panels[0].series.at(0).parts,
              ElementsAre(Polyline{{10.0, 110.0}}, Polyline{{30.0, 130.0}, {40.0, 140.0}}));
}

TEST(StudyFigures, GridOfTwoLongFactorsIsAMap) {
  std::vector<double> many;
  for (int k = 0; k < 12; ++k) many.push_back(1.0 + 0.5 * k);
  Study study = grid({sample::counted("x", many), sample::counted("y", many)});
  const auto product = [](const std::vector<double>& x) { return std::vector{x[0] * x[1]}; };
  const Figure map = study_figures(sample::run(study, product)).at(0);
  const GridData& nodes = map.panels.at(0).map.grid;
  ASSERT_THAT(nodes.values, SizeIs(144));
  EXPECT_EQ(nodes.at(1, 2), 1.5 * 2.0);
  EXPECT_FALSE(map.panels[0].map.cells);
  EXPECT_GE(map.colours->to, 6.5 * 6.5);
  EXPECT_EQ(map.colours->levels.front(), map.colours->from);
  EXPECT_EQ(map.x.from, 1.0);
  const Figure partly = study_figures(sample::run(study, [&](const std::vector<double>& x) {
                          return x[1] > 4.0 ? std::vector<double>() : product(x);
                        })).at(0);
  EXPECT_EQ(partly.y.to, 4.0);  // No design beyond has a result.
  EXPECT_EQ(partly.x.to, 6.5);
  // On request the same as lines: eight of the twelve.
  const StudyResult result = sample::run(study, product);
  const auto lines = test::shown(study_pictures(result), "lines");
  ASSERT_TRUE(lines);
  EXPECT_FALSE(lines->colours);
  EXPECT_THAT(lines->panels.at(0).series, SizeIs(8));
  EXPECT_EQ(lines->legend.back().title, "y 6.5");
}

TEST(StudyFigures, EnvelopeIsAMapAndASurfaceWithItsPoints) {
  std::vector<double> many;
  for (int k = 0; k < 12; ++k) many.push_back(1.0 + 0.5 * k);
  Study study = grid({sample::counted("x", many), sample::counted("y", many)});
  for (Factor& factor : study.factors) factor.continuous = true;
  study.envelope = Envelope{.measures = {{"y", 2.0}}, .points = {{"A", {{1.25, 3.0}}, {}}, {"B", {}, {{"y", 1e3}}}}};
  study.envelope->normalise = Envelope::Normalise::none;
  const auto product = [](const std::vector<double>& x) { return std::vector{x[0] * x[1]}; };
  const std::vector<Figure> figures = study_figures(sample::run(study, product));
  ASSERT_THAT(names(figures), ElementsAre("envelope", "01_y"));
  const Figure& y = figures[1];
  ASSERT_THAT(y.panels, SizeIs(2));
  EXPECT_EQ(y.x.from, 1.0);
  EXPECT_EQ(y.x.to, 6.5);
  ASSERT_TRUE(y.colours && y.panels[1].surface);
  EXPECT_LE(y.colours->from, 1.0);
  EXPECT_GE(y.colours->to, 6.5 * 6.5);
  EXPECT_THAT(y.panels[0].series.back().parts, ElementsAre(Polyline{{1.25, 3.0}}));
  ASSERT_THAT(y.panels[1].surface->points, SizeIs(1));  // B is missing.
  EXPECT_NEAR(y.panels[1].surface->points[0].z, 3.75, 1e-12);
  EXPECT_NEAR(figures[0].panels[1].surface->points[0].z, 3.75 * 3.75, 1e-12);
  EXPECT_EQ(y.panels[1].surface->grid.at(11, 0), 6.5);
  EXPECT_EQ(y.panels[1].surface->z.label, "y");
}

TEST(StudyFigures, NoneWithoutAnAnswer) {
  const auto none = [](const std::vector<double>&) { return std::vector<double>{}; };
  EXPECT_THAT(study_figures(sample::run(grid({words("a"), words("b")}), none)), IsEmpty());
  Study study = sample::sampled(Plan::monte_carlo, 10).study;
  EXPECT_THAT(study_figures(sample::run(study, none)), IsEmpty());
}

}  // namespace
}  // namespace prs
