#include <gmock/gmock.h>

#include <limits>

#include "prs/svg/elements.h"
#include "prs/svg/panel.h"

namespace prs {
namespace {

using ::testing::SizeIs;

constexpr double kLargest = std::numeric_limits<double>::max(), kSmallest = std::numeric_limits<double>::denorm_min();

/// Ends of axes: equal, one rounding apart, tiny, huge.
constexpr double kEnds[] = {0.0,       1.0,    1.0 + 1e-15, 1200.0,   1200.0000000000002,
                            kSmallest, 1e-300, 1e-308,      kLargest, -kLargest,
                            -1.0,      1e17,   1e300,       5e-324};

TEST(Ticks, AreFewWhateverTheRange) {
  for (const double from : kEnds)
    for (const double to : kEnds)
      for (const bool is_logarithmic : {false, true})
        for (const bool is_whole : {false, true})
          for (const bool is_horizontal : {false, true}) {
            Axis axis{"Force", "N", from, to};
            axis.logarithmic = is_logarithmic;
            axis.whole = is_whole;
            EXPECT_THAT(ticks_of(axis, 800, is_horizontal), SizeIs(::testing::Le(40))) << from << " to " << to;
          }
}

TEST(Ticks, OfAReversedAxisAreThoseOfTheAxis) {
  for (const bool is_logarithmic : {false, true}) {
    Axis axis{"Force", "N", 1.0, 900.0};
    axis.logarithmic = is_logarithmic;
    const std::vector<double> ticks = ticks_of(axis, 800, true);
    EXPECT_THAT(ticks, SizeIs(::testing::Ge(4)));
    std::swap(axis.from, axis.to);
    EXPECT_EQ(ticks_of(axis, 800, true), ticks);
  }
}

/// Line of `points` circles, of which there are as many as marks in the picture.
std::size_t marks_of_line(int points) {
  Figure figure;
  figure.x = {"Thread", "", 0.0, 101.0};
  figure.y = {"Load", "N", 0.0, 2.0};
  figure.styles.push_back(line_of(Colour::blue));
  figure.styles.back().mark = Mark::circle;
  Series& series = figure.panels.emplace_back().series.emplace_back();
  for (int k = 1; k <= points; ++k) series.add(k, k == points ? 2.0 : 1.0);
  const std::string drawn = svg_file(figure);
  std::size_t count = 0;
  constexpr std::string_view kHalf = "a3.8 3.8 0 1 0 7.5";  // First half of a circle.
  for (std::size_t at = drawn.find(kHalf); at != std::string::npos; at = drawn.find(kHalf, at + 1)) ++count;
  return count;
}

TEST(Marks, EachThreadHasOneAndTheLastOfALongLineToo) {
  for (const int points : {1, 12, 20, 29, 40}) EXPECT_EQ(marks_of_line(points), static_cast<std::size_t>(points));
  EXPECT_EQ(marks_of_line(49), 13u);   // Every fourth, of which the last is one.
  EXPECT_EQ(marks_of_line(100), 14u);  // Every eighth, and the last.
}

TEST(Ticks, APictureOfWhatRoundingAloneMovesIsDrawn) {
  Figure figure;
  figure.x = {"Time", "s", 0.0, 1.0};
  figure.y = {"Force", "N"};
  figure.styles.emplace_back();
  Series& series = figure.panels.emplace_back().series.emplace_back();
  series.add(0.0, 1200.0);
  series.add(1.0, 1200.0000000000002);
  EXPECT_LT(svg_file(figure).size(), 20000u);
}

}  // namespace
}  // namespace prs
