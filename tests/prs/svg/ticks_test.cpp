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
