#include "prs/output/figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "prs/output/text.h"

namespace prs {
namespace {

// Layout in pixels of the SVG; the PNG has twice as many. Printed 170 mm wide, the text has 8 pt.
constexpr int kWidth = 900;
constexpr int kFontSize = 15;
constexpr int kPanelHeight = 235;
constexpr int kLeft = 92, kRight = 20, kColumnGap = 68;
constexpr int kTop = 70, kRowGap = 76, kBottom = 76;
constexpr int kLegendRow = 25, kLegendMargin = 14;
constexpr int kLegendSymbol = 75, kCharacter = 10;
constexpr std::size_t kMaxTitle = 44;  // Characters that fit above a panel.

/// A gnuplot string in which nothing is interpreted: what means something to gnuplot becomes an
/// octal escape. (Single quotes would not do: gnuplot 5.4 takes a leading doubled quote for the
/// end.)
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text))
    if (std::string_view("\"'\\`@$#{}!").find(c) == std::string_view::npos)
      result += c;
    else
      result += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  return result + '"';
}

std::string title(std::string_view text) { return shortened(printable(text), kMaxTitle); }

int longest_title(const std::vector<LegendEntry>& legend) {
  std::size_t longest = 0;
  for (const LegendEntry& entry : legend) longest = std::max(longest, width(title(entry.title)));
  return static_cast<int>(longest);
}

/// Where panels and legend lie in the image.
class Layout {
 public:
  explicit Layout(const Figure& figure) : columns_(static_cast<int>(figure.columns)) {
    const int panels = static_cast<int>(figure.panels.size());
    rows_ = (panels + columns_ - 1) / columns_;
    const int entry_width = kLegendSymbol + kCharacter * longest_title(figure.legend);
    const int entries = static_cast<int>(figure.legend.size());
    legend_columns_ = std::clamp((kWidth - 2 * kRight) / entry_width, 1, std::max(1, entries));
    const int legend_rows = (entries + legend_columns_ - 1) / legend_columns_;
    legend_height_ = legend_rows * kLegendRow + kLegendMargin;
  }

  int height() const {
    return kTop + rows_ * kPanelHeight + (rows_ - 1) * kRowGap + kBottom + legend_height_;
  }
  int legend_columns() const { return legend_columns_; }

  std::string legend_margins() const {
    return margins(0, kWidth, height() - legend_height_, height());
  }

  std::string panel_margins(std::size_t index) const {
    const int panel_width = (kWidth - kLeft - kRight - (columns_ - 1) * kColumnGap) / columns_;
    const int left = kLeft + column(index) * (panel_width + kColumnGap);
    const int top = kTop + row(index) * (kPanelHeight + kRowGap);
    return margins(left, left + panel_width, top, top + kPanelHeight);
  }

  bool is_leftmost(std::size_t index) const { return column(index) == 0; }
  bool is_lowest(std::size_t index) const { return row(index) == rows_ - 1; }

 private:
  int column(std::size_t index) const { return static_cast<int>(index) % columns_; }
  int row(std::size_t index) const { return static_cast<int>(index) / columns_; }

  std::string margins(int left, int right, int top, int bottom) const {
    const double w = kWidth;
    const double h = height();
    return fmt::format(
        "set lmargin at screen {:.4f}; set rmargin at screen {:.4f}; "
        "set bmargin at screen {:.4f}; set tmargin at screen {:.4f}\n",
        left / w, right / w, 1 - bottom / h, 1 - top / h);
  }

  int columns_ = 1;
  int rows_ = 1;
  int legend_columns_ = 1;
  int legend_height_ = 0;
};

std::string style_lines(const std::vector<LineStyle>& styles) {
  std::string script;
  for (std::size_t k = 0; k < styles.size(); ++k) {
    const LineStyle& s = styles[k];
    script += fmt::format("set style line {} lc rgb '{}' dt {} lw {} pt {} ps {} pi {}\n", k + 1,
                          s.colour, s.dash, s.width, s.point,
                          s.point == 0 ? 0.0 : 0.25 + 0.25 * s.width, s.point_interval);
  }
  return script;
}

/// Points of a line; an empty text line interrupts it.
std::string line_data(const Line& line) {
  std::string data;
  for (const Polyline& part : line.parts) {
    if (part.empty()) continue;
    if (!data.empty()) data += '\n';
    for (const auto& [x, y] : part) data += fmt::format("{:.7g} {:.7g}\n", x, y);
  }
  return data.empty() ? "NaN NaN\n" : data;
}

/// One block of data a panel; two empty text lines separate its lines.
std::string data_block(std::size_t index, const Panel& panel) {
  std::string script = fmt::format("$panel_{} << END\n", index + 1);
  for (const Line& line : panel.lines) script += line_data(line) + "\n\n";
  return script + "END\n";
}

std::string_view drawn_with(const LineStyle& style) {
  return style.point == 0 ? "lines" : "linespoints";
}

std::string axis_lines(char axis, const Axis& a) {
  std::string script = fmt::format("set {}range [{:.7g}:{:.7g}]\n", axis, a.from, a.to);
  if (!a.tics.empty()) script += fmt::format("set {}tics ({})\n", axis, fmt::join(a.tics, ", "));
  return script;
}

std::string panel_lines(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  std::string script = layout.panel_margins(index);
  script += fmt::format("set title {}\n", quoted(title(panel.title)));
  script += fmt::format("set ylabel {}\n", quoted(layout.is_leftmost(index) ? figure.y.label : ""));
  script += fmt::format("set xlabel {}\n", quoted(layout.is_lowest(index) ? figure.x.label : ""));
  std::vector<std::string> plots;
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    const std::size_t style = panel.lines[k].style;
    plots.push_back(fmt::format("$panel_{} index {} with {} ls {}", index + 1, k,
                                drawn_with(figure.styles[style]), style + 1));
  }
  if (plots.empty()) plots.push_back("NaN");
  return script + fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
}

std::string legend_lines(const Figure& figure, const Layout& layout) {
  std::string script = layout.legend_margins();
  script +=
      "unset title; unset xlabel; unset ylabel\n"
      "unset grid; unset border; unset xtics; unset ytics\n";
  script += fmt::format("set key center horizontal Left reverse maxcols {} samplen 3\n",
                        layout.legend_columns());
  std::vector<std::string> plots;
  for (std::size_t k = 0; k < figure.legend.size(); ++k) {
    const std::size_t style = figure.legend[k].style;
    plots.push_back(fmt::format("NaN with {} ls {} title legend_{}",
                                drawn_with(figure.styles[style]), style + 1, k + 1));
  }
  return script + fmt::format("plot [0:1] [0:1] {}\n", fmt::join(plots, ", \\\n     "));
}

std::string terminal_lines(const Figure& figure, int height) {
  return fmt::format(
      "if (format eq 'svg') {{\n"
      "set terminal svg size {0},{1} noenhanced font 'Helvetica,{2}' background 'white'\n"
      "}} else {{\n"
      "set terminal pngcairo size {3},{4} noenhanced font 'Sans,{5}' linewidth 2 pointscale 2\n"
      "}}\n"
      "set output '{6}.'.format\n",
      kWidth, height, kFontSize, 2 * kWidth, 2 * height, 1.5 * kFontSize, figure.name);
}

}  // namespace

void fit_y_range(Figure& figure) {
  double least = HUGE_VAL;
  double largest = -HUGE_VAL;
  for (const Panel& panel : figure.panels)
    for (const Line& line : panel.lines)
      for (const Polyline& part : line.parts)
        for (const auto& [x, y] : part) {
          least = std::min(least, y);
          largest = std::max(largest, y);
        }
  const bool from_zero = least < 0.5 * largest;
  const double margin = 0.06 * (largest - (from_zero ? 0.0 : least));
  figure.y.from = from_zero ? 0.0 : least - margin;
  figure.y.to = largest > figure.y.from ? largest + margin : figure.y.from + 1.0;
}

std::string gnuplot_script(const Figure& figure) {
  const Layout layout(figure);
  std::string script = fmt::format(
      "# Draws {0}.svg and {0}.png: gnuplot {0}.gp\n"
      "set encoding utf8\n"
      "set minussign\n"
      "set format '%g'\n"
      "set title offset 0,-0.8\n",
      figure.name);
  script += style_lines(figure.styles);
  for (std::size_t k = 0; k < figure.legend.size(); ++k)
    script += fmt::format("legend_{} = {}\n", k + 1, quoted(title(figure.legend[k].title)));
  for (std::size_t k = 0; k < figure.panels.size(); ++k) script += data_block(k, figure.panels[k]);

  script += "do for [format in 'svg png'] {\n" + terminal_lines(figure, layout.height());
  script += fmt::format("set multiplot title {}\n", quoted(figure.title));
  script +=
      "set border 3; set xtics out nomirror scale 0.5; set ytics out nomirror scale 0.5\n"
      "set grid y lc rgb '#d9d9d9' lt 1 lw 0.6\n"
      "unset key\n";
  script += axis_lines('x', figure.x) + axis_lines('y', figure.y);
  for (std::size_t k = 0; k < figure.panels.size(); ++k) script += panel_lines(figure, layout, k);
  script += legend_lines(figure, layout);
  return script + "unset multiplot\nunset output\n}\n";
}

}  // namespace prs
