#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "prs/losses/slip_parts.h"
#include "prs/losses/slip_record.h"
#include "prs/record/figure_parts.h"

namespace prs {
namespace {

/// A curve of the figure, in the order of drawing: the sum lies on top.
struct MomentCurve {
  std::string_view title;
  Style style;
  double (*value)(const RollerMoments&);
};

constexpr MomentCurve kCurves[] = {
    {"carrier", line_of(Colour::orange), [](const RollerMoments& m) { return m.carrier; }},
    {"gears", line_of(Colour::green, Dash::dotted), [](const RollerMoments& m) { return m.gears; }},
    {"spin", line_of(Colour::vermillion, Dash::dashed),
     [](const RollerMoments& m) { return m.spin; }},
    {"contacts", line_of(Colour::blue, Dash::dash_dotted),
     [](const RollerMoments& m) { return m.contacts; }},
    {"sum", line_of(Colour::ink, Dash::solid, Weight::strong),
     [](const RollerMoments& m) { return m.residue(); }},
};
/// Of the styles after those of the curves.
constexpr std::size_t kIdeal = std::size(kCurves), kRoot = kIdeal + 1, kZero = kIdeal + 2;

/// How a panel shows slip ratios: (slip ratio - from) * factor.
struct SlipAxis {
  std::string label = "Slip ratio";
  std::string unit = {};
  double from = 0.0;
  double factor = 1.0;

  double operator()(double slip_ratio) const { return (slip_ratio - from) * factor; }
};

/// The distance from the ideal slip ratio, in the power of a thousand that needs few digits.
SlipAxis around_ideal(const ResidueCurve& residue, double ideal) {
  double largest = 0.0;
  for (const double slip_ratio : residue.slip_ratio)
    largest = std::max(largest, std::abs(slip_ratio - ideal));
  constexpr std::string_view kPowers[] = {"", "10⁻³", "10⁻⁶", "10⁻⁹", "10⁻¹²"};
  const double thousands = largest > 0.0 ? std::ceil(-std::log10(largest) / 3.0) : 0.0;
  const auto power = static_cast<std::size_t>(std::clamp(thousands, 0.0, 4.0));
  return {"Slip ratio less the ideal one", std::string(kPowers[power]), ideal,
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
Axis moment_axis(const std::vector<Series>& curves) {
  Range range = range_of_y(curves);
  range.include(0.0);
  return fitted({"Moment on a roller", "N mm"}, range);
}

/// The shown slip ratios from one end to the other, with a share of their range on both sides.
Axis slip_ratio_axis(const ResidueCurve& residue, const SlipAxis& shown, double margin) {
  Axis axis{shown.label, shown.unit};
  if (residue.slip_ratio.empty()) return axis;
  const auto [least, largest] =
      std::minmax({shown(residue.slip_ratio.front()), shown(residue.slip_ratio.back())});
  axis.from = least;
  axis.to = largest;
  const double widened = axis.to > axis.from ? margin * (axis.to - axis.from) : 1e-3 * shown.factor;
  axis.from -= widened;
  axis.to += widened;
  return axis;
}

Panel residue_panel(std::string title, const ResidueCurve& residue, const SlipResult& slip,
                    const SlipAxis& shown, double margin) {
  Panel panel;
  panel.title = std::move(title);
  for (std::size_t k = 0; k < std::size(kCurves); ++k)
    panel.series.push_back({k, {curve(residue, kCurves[k], shown)}});
  panel.references = {{kZero, 0.0},
                      {kIdeal, shown(slip.ideal_slip_ratio), true},
                      {kRoot, shown(slip.slip_ratio), true}};
  panel.x = slip_ratio_axis(residue, shown, margin);
  panel.y = moment_axis(panel.series);
  return panel;
}

}  // namespace

/// Moment on a roller about its axis against the slip ratio: its contributions and their sum over
/// the whole range and, against the distance from the ideal slip ratio, around the root (Sandu
/// 2018, fig. 3.6).
Figure slip_residue_figure(const LoadCaseResult& result, const SlipPictures& pictures) {
  const SlipResult& slip = *result.slip;
  Figure figure{"slip_residue", "Moment on a roller about its axis, load case " +
                                    shown_name(result.load_case.name)};
  figure.columns = 2;
  for (const MomentCurve& c : kCurves) figure.add(std::string(c.title), c.style);
  std::ranges::reverse(figure.legend);
  figure.add(fmt::format("ideal slip ratio {:.6f}", slip.ideal_slip_ratio), line_of(Colour::sky));
  figure.add(fmt::format("{} {:.6f}",
                         slip.status == SlipStatus::imposed ? "imposed slip ratio" : "slip ratio",
                         slip.slip_ratio),
             line_of(Colour::muted));
  figure.add(kZeroStyle);
  const ResidueCurve& near_root = pictures.residue_near_root;
  figure.panels = {residue_panel("Whole range", pictures.residue, slip, SlipAxis{}, 0.04),
                   residue_panel("Around the slip ratio", near_root, slip,
                                 around_ideal(near_root, slip.ideal_slip_ratio), 0.08)};
  return figure;
}

}  // namespace prs
