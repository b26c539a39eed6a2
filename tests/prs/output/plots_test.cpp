#include "prs/loads/load_pictures.h"
#include "prs/output/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <system_error>

#include "prs/record/pictures.h"
#include "prs/svg/panel.h"
#include "support/drawn.h"
#include "support/sample_result.h"
#include "support/shown.h"
#include "support/temporary_directory.h"

// Fontconfig, by which librsvg finds the letters of PNG files, keeps the data that it read.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::add_sweep;
using test::content_of;
using test::equal_share_case;
using test::expect_drawn;
using test::failed_case;
using test::solved_case;
using test::TemporaryDirectory;

Result sweeps() { return test::sweeps({"config1", "config2"}); }

std::optional<Figure> picture(const Result& result, const char* name, const FigureOptions& options = {}) {
  return test::shown(solve_pictures(result), name, options);
}

Figure figure_of(const Result& result, const char* name, const FigureOptions& options) {
  return figure(solve_pictures(result), name, options);
}

Result single_case(std::string name) {
  Result result;
  result.load_cases = {solved_case(std::move(name), 45e3, Direction::tension)};
  return result;
}

TEST(Figures, DirectionsOfOneConfigurationShareALine) {
  const auto figure = picture(sweeps(), "load_distribution");
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->panels.size(), 4);
  EXPECT_EQ(figure->panels[0].title, "Roller-screw, tension");
  EXPECT_EQ(figure->panels[3].title, "Roller-nut, compression");
  ASSERT_EQ(figure->legend.size(), 3);
  EXPECT_EQ(figure->legend[0].title, "config1");
  EXPECT_EQ(figure->legend[1].title, "config2");
}

TEST(Figures, RangeIsRepresentedByItsFullLoad) {
  const Result result = sweeps();
  const auto figure = picture(result, "load_distribution");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->title, "Load distribution, 45 kN, at rest");
  const Polyline& drawn = figure->panels[0].series[0].parts[0];
  const auto& rates = result.load_cases[8].threads->screw.load_rate;
  ASSERT_EQ(drawn.size(), rates.size());
  EXPECT_EQ(drawn[0][0], 1.0);
  EXPECT_DOUBLE_EQ(drawn[0][1], 100 * rates[0]);
}

TEST(Figures, ButterflyHasTensionOnThePositiveSideAndSharesOfTheMean) {
  const auto figure = picture(sweeps(), "butterfly");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->panels.size(), 4);
  EXPECT_DOUBLE_EQ(figure->x.from, -45.0);
  EXPECT_DOUBLE_EQ(figure->x.to, 45.0);
  EXPECT_EQ(figure->x.label, "Axial force, tension >\u00a00");
  EXPECT_EQ(figure->y.unit, "% of the mean");
  const Result result = sweeps();
  const auto& rates = result.load_cases[8].threads->screw.load_rate;
  const Polyline& first = figure->panels[0].series[3].parts[0];  // In tension.
  EXPECT_DOUBLE_EQ(first.back()[0], 45.0);
  EXPECT_DOUBLE_EQ(first.back()[1], 100.0 * rates[0] * static_cast<double>(rates.size()));
  FigureOptions nut;
  nut.interface = Interface::nut;
  EXPECT_EQ(picture(sweeps(), "butterfly", nut)->panels.size(), 2);
}

TEST(Figures, PressuresStandBelowTheirLimit) {
  const auto figure = picture(sweeps(), "peak_pressure");
  ASSERT_TRUE(figure);
  for (const Panel& panel : figure->panels) EXPECT_DOUBLE_EQ(panel.references.at(0).at, 4.0);  // ISO 76
  EXPECT_EQ(figure->legend.back().title, "static limit 4.0 GPa, ISO 76");
  EXPECT_EQ(figure->y.unit, "GPa");
  EXPECT_GT(figure->y.to, 4.0);
}

TEST(Figures, OfThreadsBeginAtZero) {
  for (const char* name : {"load_distribution", "peak_pressure", "stiffness", "displacement"})
    EXPECT_EQ(picture(sweeps(), name)->y.from, 0.0) << name;
}

TEST(Figures, WhatTheirAxesDoNotReachIsNotInTheLegend) {
  Figure figure{"lines", "Lines", {"x", "", 0.0, 2.0}, {"y", "", 0.0, 1.0}};
  Panel& panel = figure.panels.emplace_back();
  panel.series = {{figure.add("above", line_of(Colour::blue)), {{{0.0, 5.0}, {2.0, 4.0}}}},
                  {figure.add("across", line_of(Colour::green)), {{{0.0, -5.0}, {2.0, 4.0}}}},
                  {figure.add("beside", points_of(Colour::sky, Mark::circle)), {{{3.0, 0.5}}}},
                  {figure.add("at the end", points_of(Colour::ink, Mark::circle)), {{{2.0, 1.0}}}}};
  figure.add("meaning", {});
  const auto titles = [](const Figure& of) {
    std::vector<std::string> all;
    for (const LegendEntry& entry : of.legend) all.push_back(entry.title);
    return all;
  };
  EXPECT_THAT(titles(with_true_legend(figure)), ::testing::ElementsAre("across", "at the end", "meaning"));
}

TEST(Figures, LinesUnderOthersAreNamed) {
  Figure figure{"lines", "Lines"};
  Panel& panel = figure.panels.emplace_back();
  const Polyline line{{1.0, 1.0}, {2.0, 3.0}}, other{{1.0, 1.1}, {2.0, 3.0}};
  panel.series = {{figure.add("a", line_of(Colour::blue)), {line}},
                  {figure.add("b", line_of(Colour::green)), {line}},
                  {figure.add("c", line_of(Colour::orange)), {other}},
                  {figure.add("none", points_of(Colour::ink, Mark::circle)), {{}}}};
  const Figure named = with_true_legend(figure);
  ASSERT_EQ(named.legend.size(), 3u);
  EXPECT_EQ(named.legend[0].title, "a, under b");
  EXPECT_EQ(named.legend[1].title, "b");
  EXPECT_EQ(named.legend[2].title, "c");
  EXPECT_NE(svg_file(figure).find(">a, under b<"), std::string::npos);
}

TEST(Figures, OfStiffnessNeedRangesOfLoads) {
  Result result;
  add_sweep(result, "short", Direction::tension, 2);
  EXPECT_FALSE(picture(result, "stiffness"));  // Two dots are not a curve.
  EXPECT_FALSE(picture(result, "displacement"));
  add_sweep(result, "long", Direction::tension, 3);
  const auto figure = picture(result, "stiffness");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->legend[0].title, "long");
  EXPECT_EQ(figure->panels.size(), 1);
}

TEST(Figures, EqualSharesAreTheMean) {
  Result result;
  result.load_cases = {equal_share_case("equal")};
  const auto figure = picture(result, "load_distribution");
  ASSERT_TRUE(figure);
  for (const auto& [thread, share] : figure->panels[0].series[0].parts[0])
    EXPECT_NEAR(share, figure->panels[0].references[0].at, 1e-9);
  EXPECT_FALSE(picture(result, "butterfly"));
}

TEST(Figures, OptionsChooseLoadCasesAndPanels) {
  FigureOptions options;
  options.load_cases = {3, 12};
  const auto figure = picture(sweeps(), "load_distribution", options);
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->legend[0].title, "config1-tension[3]");
  options.one_panel = true;
  const auto folded = picture(sweeps(), "load_distribution", options);
  ASSERT_EQ(folded->panels.size(), 1);
  EXPECT_EQ(folded->panels[0].series.size(), 4);
  options.load_cases = {99};
  EXPECT_THROW(figure_of(sweeps(), "load_distribution", options), NoFigure);
  EXPECT_THROW(figure_of(sweeps(), "no such", {}), NoFigure);
}

TEST(Figures, DescriptionsStateUnitsAndLeaveOutDefaults) {
  const nlohmann::ordered_json json = to_json(*picture(sweeps(), "stiffness"));
  EXPECT_EQ(json["y"]["label"], "Axial stiffness");
  EXPECT_EQ(json["y"]["unit"], "N/µm");
  EXPECT_EQ(json["x"]["unit"], "kN");
  EXPECT_FALSE(json["x"].contains("logarithmic"));
  EXPECT_EQ(json["panels"].size(), 2);
  EXPECT_EQ(json["styles"][0]["colour"], "ink");
  EXPECT_TRUE(to_json(*picture(sweeps(), "convergence"))["y"]["logarithmic"]);
  const nlohmann::ordered_json schema = figure_schema();
  for (const auto& [key, value] : json.items()) EXPECT_TRUE(schema["properties"].contains(key));
  for (const auto& [key, value] : json["panels"][0].items())
    EXPECT_TRUE(schema["$defs"]["panel"]["properties"].contains(key)) << key;
}

TEST(Figures, AreReadBackFromTheirFile) {
  Figure figure{"all", "All", {"Force", "kN", 0.0, kFree}, {"Share", "", kFree, kFree, true}, 2};
  figure.colours = ColourScale{"z", "um", 1.0, 3.0, {1.0, 2.0, 3.0}, true, true};
  figure.x.ticks = {{1.0, "one"}, {2.0}};
  figure.to_scale = true;
  Panel& panel = figure.panels.emplace_back();
  panel.series.push_back({figure.add("arrows", arrows_of(Colour::bad)),
                          {{{0.1, 1.0 / 3.0}, {kFree, 2.0}}, {{1e-30, -2.5}}},
                          {1.0, kFree}});
  panel.references.push_back({figure.add(line_of(Colour::reference, Dash::dotted)), 2.0, true});
  panel.labels.push_back({"here", 0.5, 0.25, true, Label::Anchor::right});
  panel.y = Axis{"own"};
  panel.map = {{{0, 1}, {0, 1, 2}, {1, 2, 3, 4, 5, kFree}}, true};
  figure.panels.emplace_back().surface = Surface{panel.map.grid, {"z"}, {{"top", 1, 2, 3}}};
  const std::string text = figures_text({figure});
  const Figures again = figures_of(text);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(figures_text(again), text);
  EXPECT_EQ(to_json(again)[0]["panels"][0]["labels"], to_json(figure)["panels"][0]["labels"]);
  EXPECT_TRUE(std::isnan(again[0].panels[0].map.grid.at(1, 2)));
  EXPECT_EQ(again[0].panels[0].series[0].parts[0][0][1], 0.3333333);
  for (const std::string wrong : {"", "{}", "[{}]", "[1]"}) EXPECT_TRUE(figures_of(wrong).empty());
  EXPECT_TRUE(figures_of(std::regex_replace(text, std::regex("\"style\":1"), "\"style\":9")).empty());
  for (const std::string columns : {"0", "4000000000", "-1"})
    EXPECT_TRUE(
        figures_of(std::regex_replace(text, std::regex("\"columns\":[0-9]+"), "\"columns\":" + columns)).empty())
        << columns;
}

TEST(Figures, MoreConfigurationsThanStylesAreLimited) {
  Result result;
  for (int k = 0; k < 12; ++k)
    result.load_cases.push_back(solved_case("case " + std::to_string(k), 45e3, Direction::tension));
  const auto figure = picture(result, "load_distribution");
  ASSERT_TRUE(figure);
  EXPECT_NE(figure->title.find("first 8 of 12"), std::string::npos);
}

/// Butterflies as Abevi prints them: tension to the left, and a share of 1/n stands at 100/n %.
TEST(Plots, AButterflyOfTheLoadIsThatOfTheMeanMirrored) {
  const Result result = sweeps();
  const Figure mean = figure(solve_pictures(result), "butterfly", {});
  const Figure load = figure(solve_pictures(result, true), "butterfly", {});
  const auto threads = static_cast<double>(result.load_cases[0].threads->screw.load_rate.size());
  EXPECT_EQ(load.y.unit, "% of the load");
  EXPECT_EQ(load.x.from, -mean.x.to);
  EXPECT_EQ(load.x.to, -mean.x.from);
  for (std::size_t p = 0; p < mean.panels.size(); ++p) {
    EXPECT_DOUBLE_EQ(load.panels[p].references[0].at, 100.0 / threads);
    for (std::size_t s = 0; s < mean.panels[p].series.size(); ++s)
      for (std::size_t k = 0; k < mean.panels[p].series[s].parts.size(); ++k)
        for (std::size_t i = 0; i < mean.panels[p].series[s].parts[k].size(); ++i) {
          const auto [x, y] = mean.panels[p].series[s].parts[k][i];
          EXPECT_DOUBLE_EQ(load.panels[p].series[s].parts[k][i][0], -x);
          EXPECT_DOUBLE_EQ(load.panels[p].series[s].parts[k][i][1], y / threads);
        }
  }
}

TEST(Plots, EveryFigureIsDrawn) { expect_drawn(figures(solve_pictures(sweeps()))); }

TEST(Plots, FewThreadsAndAbsentTangentsAreDrawn) {
  Result result;
  for (const int threads : {1, 2, 3}) {
    const std::string name = std::to_string(threads) + " threads";
    for (int k = 0; k < 4; ++k) {
      result.load_cases.push_back(
          solved_case(name + '[' + std::to_string(k) + ']', 1e3 * (k + 1), Direction::tension, threads));
      result.load_cases.back().tangent_stiffness.reset();
    }
  }
  expect_drawn(figures(solve_pictures(result)));
}

/// The text as an SVG file holds it.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&'    ? "&amp;"
              : c == '<'  ? "&lt;"
              : c == '>'  ? "&gt;"
              : c == '\'' ? "&#39;"
              : c == '"'  ? "&quot;"
                          : std::string(1, c);
  return result;
}

/// Each in a picture of its own, and several at a time in all of them.
TEST(Plots, NamesAreDrawnAsTheyStand) {
  std::vector<Result> together(2);
  for (const std::string name : {"'", "''", "\"", "`touch run`", "$(touch run) @x # {", "}", "\\", "%s %d", "pull 50 %",
                                 "<b>&amp;</b>", "a_{b}^c", "]]>"}) {
    std::vector<LoadCaseResult>& few = together[together[0].load_cases.size() < 6 ? 0 : 1].load_cases;
    few.push_back(solved_case(name, 45e3, Direction::tension));
    const auto figure = test::shown(solve_pictures(single_case(name)), "load_distribution");
    ASSERT_TRUE(figure);
    expect_drawn(*figure);
    EXPECT_NE(svg_file(*figure).find(escaped(name)), std::string::npos) << name;
  }
  for (const Result& result : together) expect_drawn(figures(solve_pictures(result)));
}

TEST(Plots, MalformedNamesAreDrawn) {
  for (const std::string name : {"\xff\x01 \xEF\xBF\xBF", "}\n!touch ../run\n", ""})
    expect_drawn(figures(solve_pictures(single_case(name))));
}

TEST(Plots, AreFilesOfTheirNames) {
  const TemporaryDirectory temporary;
  const Figures all = figures(solve_pictures(single_case("a")));
  draw_figures(all, temporary.path());
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(temporary.path() / "plots"))
    files += entry.path().extension() == ".svg" ? 1 : 0;
  EXPECT_EQ(files, all.size());
  EXPECT_FALSE(fs::exists(temporary.path() / "plots" / "load_distribution.png"));
  draw_figures(all, temporary.path(), true);
  EXPECT_EQ(content_of(temporary.path() / "plots" / "load_distribution.png").substr(1, 3), "PNG");
}

TEST(Plots, ThatCannotBeWrittenAreAnErrorAndLeaveNone) {
  const TemporaryDirectory temporary;
  const fs::path plots = temporary.path() / "plots";
  fs::create_directories(temporary.path());
  std::ofstream(plots) << "in the way";
  EXPECT_THROW(draw_figures(figures(solve_pictures(single_case("a"))), temporary.path()), std::system_error);
  EXPECT_TRUE(fs::is_regular_file(plots));
}

TEST(Plots, ConvergenceIsDrawnWhereItIsAskedForOrFailed) {
  const Result solved = single_case("a");
  EXPECT_THAT(test::names(figures(solve_pictures(solved))), testing::Not(testing::Contains("convergence")));
  EXPECT_THAT(test::names(figures(solve_pictures(solved), true)), testing::Contains("convergence"));
  Result failed;
  failed.load_cases = {failed_case("hopeless")};
  EXPECT_EQ(test::names(figures(solve_pictures(failed))), std::vector<std::string>{"convergence"});
}

TEST(Plots, NoPicturesMakeNoFolder) {
  const TemporaryDirectory temporary;
  draw_figures({}, temporary.path());
  EXPECT_FALSE(fs::exists(temporary.path() / "plots"));
}

}  // namespace
}  // namespace prs
