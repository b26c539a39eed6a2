#include "prs/model/units.h"
#include "prs/record/figure_parts.h"
#include "prs/size/size_analysis.h"

namespace prs {
namespace {

constexpr std::size_t kCompared = 5;  ///< Candidates whose margins stand side by side.

/// Passing candidates over diameter and lead in the colour of what limits them, failing ones grey.
Figures map(const SizeResult& r) {
  Figure figure{"size_map", "Candidates"};
  figure.x = {"Screw diameter", "mm"};
  figure.y = {"Lead", "mm"};
  figure.aspect = 0.7;
  Panel panel;
  const auto add = [&](std::string title, const Style& style, auto belongs) {
    Series points{figure.styles.size()};
    for (const SizedCandidate& c : r.candidates)
      if (belongs(c)) points.add(1e3 * c.screw.screw_diameter, 1e3 * std::abs(c.screw.lead));
    if (points.parts.empty()) return;
    figure.add(std::move(title), style);
    panel.series.push_back(std::move(points));
  };
  add("fails", points_of(Colour::muted, Mark::cross),
      [](const SizedCandidate& c) { return !c.passes; });
  std::vector<std::string_view> limits;
  for (const SizedCandidate& c : r.candidates)
    if (c.passes && std::ranges::find(limits, c.limited_by) == limits.end())
      limits.push_back(c.limited_by);
  for (std::size_t k = 0; k < limits.size(); ++k)
    add("passes, limited by " + (limits[k].empty() ? "nothing" : words_of(limits[k])),
        points_of(palette(k), Mark::circle),
        [&](const SizedCandidate& c) { return c.passes && c.limited_by == limits[k]; });
  const Range range = range_of_y(panel.series);
  panel.y = fitted(figure.y, range, true);
  figure.panels = {std::move(panel)};
  return {std::move(figure)};
}

/// Forces that a candidate carries on and on over the speed.
Figures curve(const SizeResult& r) {
  if (!r.curve) return {};
  const SizeCurve& c = *r.curve;
  const SizedCandidate& chosen = r.candidates[static_cast<std::size_t>(c.rank) - 1];
  Figure figure{"size_curve", shown_name(chosen.name) + ": force over speed"};
  figure.x = {"Speed", "mm/s"};
  figure.aspect = 0.7;
  Panel panel;
  Range range;
  for (const auto& [limit, forces] : c.force) {
    const bool all = limit == "envelope";
    Series line{figure.add(all ? "on and on" : words_of(limit),
                           all ? line_of(Colour::ink, Dash::solid, Weight::strong)
                               : line_of(palette(figure.styles.size()), Dash::dashed))};
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const double kilonewtons = forces[k] * per_si::kilonewton;
      line.add(1e3 * c.speed[k],
               std::isfinite(kilonewtons) ? std::optional(kilonewtons) : std::nullopt);
      if (all) range.include(2.5 * kilonewtons);  // Far limits would press what matters together.
    }
    panel.series.push_back(std::move(line));
  }
  if (range.empty()) range = range_of_y(panel.series);
  panel.y = fitted({"Axial force", "kN"}, {0.0, range.to}, true);
  figure.panels = {std::move(panel)};
  return {std::move(figure)};
}

/// Margins of the first candidates, criterion by criterion; below 1 it is missed.
Figures margins(const SizeResult& r) {
  Figure figure{"size_margins", "Margins"};
  std::vector<std::string> names;
  std::vector<std::string_view> keys;
  const std::size_t count = std::min(kCompared, r.candidates.size());
  for (std::size_t k = 0; k < count; ++k)
    for (const SizeCriterion& c : r.candidates[k].criteria)
      if (c.margin && std::ranges::find(keys, c.name) == keys.end()) {
        keys.push_back(c.name);
        names.push_back(words_of(c.name));
      }
  if (keys.empty()) return {};
  Range range{1.0, 1.0};
  Panel panel;
  for (std::size_t k = 0; k < count; ++k) {
    Series bars{figure.add(shown_name(r.candidates[k].name), area_of(palette(k)))};
    const double height = 0.8 / static_cast<double>(count);
    for (const SizeCriterion& c : r.candidates[k].criteria) {
      if (!c.margin || !(*c.margin > 0.0)) continue;
      const auto row = static_cast<std::size_t>(std::ranges::find(keys, c.name) - keys.begin());
      const double top = rank_position(row, keys.size()) + 0.4 - static_cast<double>(k) * height;
      bars.parts.push_back(
          rectangle(std::min(1.0, *c.margin), std::max(1.0, *c.margin), top - height, top));
      range.include(*c.margin);
    }
    panel.series.push_back(std::move(bars));
  }
  figure.x = {
      .label = "Margin", .from = 0.9 * range.from, .to = 1.1 * range.to, .logarithmic = true};
  panel.y = ranked_axis(names);
  panel.references.push_back({figure.add(kZeroStyle), 1.0, true});
  figure.panels = {std::move(panel)};
  figure.aspect = 0.9;
  return {std::move(figure)};
}

}  // namespace

Pictures size_pictures(const SizeResult& r) {
  return {{"size_map", "candidates", of_result(r, map)},
          {"size_curve", "a mean load and a limit of speed", of_result(r, curve)},
          {"size_margins", "criteria with margins", of_result(r, margins)}};
}

}  // namespace prs
