#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "prs/quantities/slip_quantities.h"
#include "prs/figures/figure_style.h"
#include "prs/figures/slip_figures.h"
#include "prs/text.h"

namespace prs {
namespace {

/// A curve of the figure, in the order of drawing: the sum lies on top.
struct MomentCurve {
  std::string_view title;
  LineStyle style;
  double (*value)(const RollerMoments&);
};

constexpr MomentCurve kCurves[] = {
    {"carrier", {"#ddaa33", 1, 0, 1.8}, [](const RollerMoments& m) { return m.carrier; }},
    {"gears", {"#117733", 5, 0, 1.8}, [](const RollerMoments& m) { return m.gears; }},
    {"spin", {"#bb5566", 2, 0, 1.8}, [](const RollerMoments& m) { return m.spin; }},
    {"contacts", {"#004488", 4, 0, 1.8}, [](const RollerMoments& m) { return m.contacts; }},
    {"sum", {"#000000", 1, 0, 2.4}, [](const RollerMoments& m) { return m.residue(); }},
};
/// Of the styles after those of the curves.
constexpr std::size_t kIdeal = std::size(kCurves), kRoot = kIdeal + 1, kZero = kIdeal + 2;

/// How a panel shows slip ratios: (slip ratio - from) * factor.
struct SlipAxis {
  std::string label = "Slip ratio";
  double from = 0.0;
  double factor = 1.0;

  double operator()(double slip_ratio) const { return (slip_ratio - from) * factor; }
};

/// The distance from the ideal slip ratio, in the power of a thousand that needs few digits.
SlipAxis around_ideal(const ResidueCurve& residue, double ideal) {
  double largest = 0.0;
  for (const double slip_ratio : residue.slip_ratio)
    largest = std::max(largest, std::abs(slip_ratio - ideal));
  constexpr std::string_view kPowers[] = {"", " (10⁻³)", " (10⁻⁶)", " (10⁻⁹)", " (10⁻¹²)"};
  const double thousands = largest > 0.0 ? std::ceil(-std::log10(largest) / 3.0) : 0.0;
  const auto power = static_cast<std::size_t>(std::clamp(thousands, 0.0, 4.0));
  return {fmt::format("Slip ratio less the ideal one{}", kPowers[power]), ideal,
          std::pow(1e3, static_cast<double>(power))};
}

Polyline curve(const ResidueCurve& residue, const MomentCurve& of, const SlipAxis& axis) {
  Polyline points;
  for (std::size_t k = 0; k < residue.slip_ratio.size(); ++k)
    points.push_back(
        {axis(residue.slip_ratio[k]), of.value(residue.moments[k]) * per_si::newton_millimetre});
  return points;
}

/// Range of the values of all curves and zero, with a margin.
Axis moment_axis(const std::vector<Line>& curves) {
  double least = 0.0, largest = 0.0;
  for (const Line& line : curves)
    for (const Polyline& part : line.parts)
      for (const auto& [x, y] : part) {
        least = std::min(least, y);
        largest = std::max(largest, y);
      }
  const double margin = largest > least ? 0.06 * (largest - least) : 1.0;
  return {"Moment on a roller (N mm)", least - margin, largest + margin};
}

/// At most five whole numbers, steps of 1, 2 or 5 times a power of ten.
std::vector<int> few_tics(double from, double to) {
  int step = 1;
  for (int k = 0; (to - from) / step > 5.0; ++k) step = k % 3 == 1 ? step / 2 * 5 : step * 2;
  std::vector<int> tics;
  for (int tic = static_cast<int>(std::ceil(from / step)) * step; tic <= to; tic += step)
    tics.push_back(tic);
  return tics;
}

/// The shown slip ratios from one end to the other, with a share of their range on both sides.
Axis slip_ratio_axis(const ResidueCurve& residue, const SlipAxis& shown, double margin) {
  Axis axis{shown.label};
  if (residue.slip_ratio.empty()) return axis;
  const auto [least, largest] =
      std::minmax({shown(residue.slip_ratio.front()), shown(residue.slip_ratio.back())});
  axis.from = least;
  axis.to = largest;
  const double widened = axis.to > axis.from ? margin * (axis.to - axis.from) : 1e-3 * shown.factor;
  axis.from -= widened;
  axis.to += widened;
  if (shown.factor > 1.0) axis.tics = few_tics(axis.from, axis.to);
  return axis;
}

Panel residue_panel(std::string title, const ResidueCurve& residue, const SlipResult& slip,
                    const SlipAxis& shown, double margin) {
  Panel panel;
  panel.title = std::move(title);
  for (std::size_t k = 0; k < std::size(kCurves); ++k)
    panel.lines.push_back({k, {curve(residue, kCurves[k], shown)}});
  const Axis x = slip_ratio_axis(residue, shown, margin);
  const Axis y = moment_axis(panel.lines);
  const auto upright = [&](double slip_ratio) -> Polyline {
    return {{shown(slip_ratio), y.from}, {shown(slip_ratio), y.to}};
  };
  const std::vector<Line> behind = {{kZero, {{{x.from, 0.0}, {x.to, 0.0}}}},
                                    {kIdeal, {upright(slip.ideal_slip_ratio)}},
                                    {kRoot, {upright(slip.slip_ratio)}}};
  panel.lines.insert(panel.lines.begin(), behind.begin(), behind.end());
  panel.x = x;
  panel.y = y;
  return panel;
}

}  // namespace

Figure slip_residue_figure(const LoadCaseResult& result, const SlipPictures& pictures) {
  const SlipResult& slip = *result.slip;
  Figure figure;
  figure.name = "slip_residue";
  figure.title = "Moment on a roller about its axis, load case " +
                 shortened(printable(result.load_case.name), kMaxCaseName);
  figure.columns = 2;
  figure.panel_height = 330;
  for (const MomentCurve& c : kCurves) add_to_legend(figure, std::string(c.title), c.style);
  std::reverse(figure.legend.begin(), figure.legend.end());
  add_to_legend(figure, fmt::format("ideal slip ratio {:.6f}", slip.ideal_slip_ratio),
                {"#88ccee", 1, 0, 2.0});
  add_to_legend(
      figure,
      fmt::format("{} {:.6f}",
                  slip.status == SlipStatus::imposed ? "imposed slip ratio" : "slip ratio",
                  slip.slip_ratio),
      {"#aaaaaa", 1, 0, 2.0});
  figure.styles.push_back({"#777777", 1, 0, 0.7});
  const ResidueCurve& whole = pictures.residue;
  const ResidueCurve& near_root = pictures.residue_near_root;
  figure.panels.push_back(residue_panel("Whole range", whole, slip, SlipAxis{}, 0.04));
  figure.panels.push_back(residue_panel("Around the slip ratio", near_root, slip,
                                        around_ideal(near_root, slip.ideal_slip_ratio), 0.08));
  return figure;
}

}  // namespace prs
