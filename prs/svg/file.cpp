#include "prs/svg/file.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/record/figure_parts.h"
#include "prs/svg/palette.h"
#include "prs/svg/panel.h"
#include "prs/svg/series.h"

namespace prs {

std::string svg_file(const Figure& drawn) {
  const Figure figure = with_ranges(with_true_legend(drawn));
  const Layout layout(figure);
  const std::vector<std::string> title = fitted_lines(figure.title, layout.width() - 60);
  const bool titled =
      std::ranges::any_of(figure.panels, [](const Panel& panel) { return !panel.title.empty(); });
  // The layout has room for titles of two lines.
  const int top = (titled ? 0 : 22) + (title.size() < 2 ? 6 : 0);
  const int height = layout.height() - top;
  std::string all = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 {2} {0} "
      "{1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n"
      "<title>{3}</title>\n<style>\n{4}</style>\n"
      "<rect y=\"{2}\" width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      layout.width(), height, top, html(figure.title), svg_rules(false));
  const double baseline = top + 25 + kLineHeight * static_cast<double>(title.size() - 1);
  all += texts(0.5 * layout.width(), baseline, "m b", title);
  for (std::size_t k = 0; k < figure.panels.size(); ++k)
    all += "\n" + panel_svg(figure, layout, k, "panel");
  if (figure.colours) all += "\n" + colour_bar_svg(*figure.colours, layout.colour_bar());
  for (std::size_t k = 0; k < figure.legend.size(); ++k) {
    const LegendEntry& entry = figure.legend[k];
    const Box box = layout.legend_entry(k);
    all += fmt::format("\n<g transform=\"translate({} {})\">{}</g>", box.left, box.top,
                       legend_symbol(figure.styles[entry.style]));
    const std::vector<std::string> lines =
        fitted_lines(entry.title, box.width() - kLegendSymbolWidth - 6);
    all += text(box.left + kLegendSymbolWidth + 6, box.top + 13, "",
                lines.size() > 1 ? lines.front() + "…" : lines.front());
  }
  return all + "\n</svg>\n";
}

}  // namespace prs
