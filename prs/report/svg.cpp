#include "prs/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "prs/record/figure_parts.h"
#include "prs/record/table_units.h"
#include "prs/svg/palette.h"
#include "prs/svg/panel.h"
#include "prs/svg/series.h"

namespace prs {
namespace {

constexpr int kTitleTop = 36;

/// As a list of the page, whose lines break where the screen ends.
std::string legend_html(const Figure& figure) {
  if (figure.legend.empty()) return {};
  std::string all = "<ul class=\"legend\">";
  for (const LegendEntry& entry : figure.legend)
    all += fmt::format("<li><svg viewBox=\"0 0 {} 16\" aria-hidden=\"true\">{}</svg>{}</li>",
                       kLegendSymbolWidth, legend_symbol(figure.styles[entry.style]),
                       html(entry.title));
  return all + "</ul>";
}

/// Whether a panel is drawn half as wide as the page: others are flat, or have words at their axes.
bool is_half(const Figure& figure, const Panel& panel) {
  constexpr double kWord = 50.0;  // Pixels.
  if (longest_text(x_axis(figure, panel)) > kWord || longest_text(y_axis(figure, panel)) > kWord)
    return false;
  return figure.columns > 1 || figure.aspect == 0.0 || figure.aspect >= 0.5;
}

/// One panel of the figure, which has no legend then.
Figure panel_alone(const Figure& figure, std::size_t index) {
  Figure one{figure.name, figure.title, figure.x, figure.y};
  one.panels.push_back(figure.panels[index]);
  one.styles = figure.styles;
  one.aspect = figure.aspect;
  one.to_scale = figure.to_scale;
  return one;
}

/// Over a panel whose points are threads: where they stand, for scripts.
std::string pick_svg(const Frame& f) {
  if (!f.x.label.starts_with("Thread,")) return {};
  return fmt::format(
      "<rect class=\"pick\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" data-threads=\"{} "
      "{}\"{}/>",
      f.box.left, f.box.top, f.box.width(), f.box.height(), f.x.from, f.x.to,
      f.y.label == "Roller" ? fmt::format(" data-rollers=\"{} {}\"", f.y.from, f.y.to) : "");
}

/// An image with one panel.
std::string image(const Figure& figure, std::size_t index, const std::string& id) {
  Figure one = panel_alone(figure, index);
  const bool half = is_half(figure, figure.panels[index]);
  const Layout layout(one, half ? kHalfWidth : kImageWidth);
  one.colours = figure.colours;
  const bool titled =
      std::ranges::any_of(figure.panels, [](const Panel& panel) { return !panel.title.empty(); });
  const int top = titled ? kTitleTop - 6 : kTitleTop + 20;  // The page has the title.
  const std::string& title = figure.panels[index].title;
  constexpr int kSecondLine = 26;  // Room below the axis that few labels need.
  const Axis& x = x_axis(one, one.panels[0]);
  const bool is_short =
      !one.panels[0].surface &&
      (x.hidden ||
       (longest_text(x) == 0.0 && fitted_lines(text_of(x), layout.panel(0).width()).size() < 2));
  const int height = layout.height() - top - (is_short && !x.hidden ? kSecondLine : 0);
  return fmt::format("<svg viewBox=\"0 {} {} {}\" class=\"{}\" role=\"img\" aria-label=\"{}\">",
                     top, layout.width(), height, half ? "half" : "whole",
                     html(title.empty() ? figure.title : figure.title + ": " + title)) +
         panel_svg(one, layout, 0, fmt::format("{}-{}", id, index)) +
         pick_svg(frame_of(one, layout, 0)) + "</svg>";
}

/// The scale of the colours, an image of its own.
std::string colour_bar(const ColourScale& scale) {
  return fmt::format(
      "<svg viewBox=\"0 0 {} 76\" class=\"half\" role=\"img\" aria-label=\"{}\">{}</svg>",
      kHalfWidth, html(text_of({scale.label, scale.unit})),
      colour_bar_svg(scale, {40, kHalfWidth - 40, 8, 22}));
}

/// Axes, colours and texts in the units of tables.
Figure with_table_units(Figure figure) {
  std::set<std::string> units = {figure.x.unit, figure.y.unit};
  if (figure.colours) units.insert(figure.colours->unit);
  figure.title = in_table_units(figure.title);
  for (Panel& panel : figure.panels) {
    for (const std::optional<Axis>& axis : {panel.x, panel.y})
      if (axis) units.insert(axis->unit);
    panel.title = in_table_units(panel.title);
    for (Label& label : panel.labels) label.text = in_table_units(label.text);
  }
  for (const std::string& unit : units)
    figure = in_unit(std::move(figure), {unit, with_table_unit(unit), table_factor(unit)});
  return figure;
}

}  // namespace

std::string svg(const Figure& drawn, const std::string& id) {
  const Figure figure = with_ranges(with_true_legend(
      table_system() == UnitSystem::us ? with_table_units(drawn) : in_page_units(drawn)));
  std::string all = "<div class=\"panels\">";
  for (std::size_t k = 0; k < figure.panels.size(); ++k) all += image(figure, k, id);
  all += "</div>";
  if (figure.colours) all += colour_bar(*figure.colours);
  return all + legend_html(figure);
}

std::string svg_style() {
  std::string light, dark;
  // On dark paper, what is black or blue must be lighter.
  constexpr std::string_view kOnDark[] = {"#56b4e9", "#ff8a3c", "#2fc79b", "#e6a3cb",
                                          "#f0b73c", "#9bd4f5", "#e8e8e6", "#a5a5a5",
                                          "#b5b5b5", "#6b6b6b", "#ff6b4a"};
  for (std::size_t k = 0; k < std::size(kColours); ++k) {
    light += fmt::format("--c{}:{};", k, kColours[k]);
    dark += fmt::format("--c{}:{};", k, kOnDark[k]);
  }
  return fmt::format(
             ":root{{{}}}\n@media screen and (prefers-color-scheme:dark){{:root{{{}}}}}\n"
             "svg "
             ".pick{{fill:transparent}}svg{{display:block;width:100%;height:auto;font-family:"
             "inherit}}\n",
             light, dark) +
         svg_rules(true);
}

}  // namespace prs
