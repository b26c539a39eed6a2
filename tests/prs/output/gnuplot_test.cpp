#include "prs/output/gnuplot.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "prs/output/gnuplot_parts.h"
#include "prs/output/gnuplot_script.h"
#include "prs/output/plots.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

TEST(GnuplotProcess, EndsItsScriptWhereTheTerminalInterruptsIt) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "s.gp") << "x = system('kill -INT $PPID')\n"
                                        << "set print 'done'\nprint 'drawn'\n";
  EXPECT_EQ(GnuplotProcess(folder.path(), "s.gp").wait(), "");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "done"));
}

TEST(GnuplotProcess, SaysWhatIsWrongWithAScript) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "s.gp") << "plot no such thing\n";
  EXPECT_NE(GnuplotProcess(folder.path(), "s.gp").wait(), "");
}

/// gnuplot takes these for formats of the number at the tick.
TEST(GnuplotTicks, KeepPercentSigns) {
  Axis axis;
  axis.ticks = {{1.0, "pull 50 %"}};
  EXPECT_EQ(gnuplot_ticks(axis, 100, true), "(\"pull 50 %%\" 1)");
}

/// A fine map is an image where all its nodes have a value; else polygons, as gnuplot moves pixels
/// into a gap.
TEST(GnuplotMap, OfManyNodesIsSmallAndQuiet) {
  const test::TemporaryDirectory folder;
  constexpr std::size_t kNodes = 100;
  Figure figure{"whole", "A map", {"x", "", 0.0, 99.0}, {"y", "", 0.0, 99.0}};
  figure.colours = ColourScale{"value", "", 0.0, 198.0, {0.0, 66.0, 132.0, 198.0}};
  GridData& grid = figure.panels.emplace_back().map.grid;
  for (std::size_t k = 0; k < kNodes; ++k) {
    grid.x.push_back(static_cast<double>(k));
    grid.y.push_back(static_cast<double>(k));
  }
  for (std::size_t k = 0; k < kNodes * kNodes; ++k)
    grid.values.push_back(grid.x[k / kNodes] + grid.y[k % kNodes]);
  Figure again = figure;  // Drawn as SVG, then as PNG: a surface must not limit the next map.
  again.panels.emplace_back().surface = Surface{grid, {"z", "", 1.0, 198.0}};
  const std::string script = gnuplot_script(again);
  EXPECT_LT(script.find("set zrange [*:*]"), script.find("with image"));
  EXPECT_LT(script.find("with image"), script.find("set zrange [1:198]"));
  Figure gap = figure;
  gap.name = "gap";
  gap.panels[0].map.grid.values[5050] = kFree;
  const Undrawn undrawn = draw_figures({figure, gap}, folder.path());
  EXPECT_THAT(undrawn.notes, testing::IsEmpty());
  EXPECT_THAT(undrawn.errors, testing::IsEmpty());
  const auto size = [&](const std::string& name) {
    return std::filesystem::file_size(folder.path() / "plots" / (name + ".svg"));
  };
  EXPECT_LT(size("whole"), 200'000u);
  EXPECT_GT(size("gap"), 1'000'000u);
}

}  // namespace
}  // namespace prs
