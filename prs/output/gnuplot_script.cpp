#include "prs/output/gnuplot_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "prs/output/gnuplot_script_parts.h"
#include "prs/text.h"

namespace prs {
namespace {

// Layout in pixels of the SVG; the PNG has twice as many. Printed 170 mm wide, the text has 8 pt.
constexpr int kWidth = 900;
constexpr int kFontSize = 15;
constexpr int kLeft = 92, kRight = 20, kColumnGap = 68;
constexpr int kTop = 70, kRowGap = 76, kLabelledRowGap = 104, kBottom = 76;
constexpr int kTicWidth = 55, kTicHeight = 36;   // Room for a number, in drawings.
constexpr int kMostTics = 7, kTicCharacter = 8;  // In panels beside each other.
constexpr int kLegendRow = 25, kLegendMargin = 14;
constexpr int kLegendSymbol = 75, kCharacter = 10;
constexpr int kColourBarHeight = 14, kColourBarRoom = 74;  // The room with numbers and label.
constexpr double kColourBarWidth = 0.4;                    // Share of the image.
constexpr double kCellOverlap = 1.02;  // Hides the seams that smoothed edges leave.

int longest_title(const std::vector<LegendEntry>& legend) {
  std::size_t longest = 0;
  for (const LegendEntry& entry : legend)
    longest = std::max(longest, width(panel_title(entry.title)));
  return static_cast<int>(longest);
}

/// Pixels from the upper left of the image.
struct Box {
  int left = 0, right = 0, top = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

bool has_own(const Figure& figure, std::optional<Axis> Panel::*axis) {
  return std::any_of(figure.panels.begin(), figure.panels.end(),
                     [&](const Panel& panel) { return (panel.*axis).has_value(); });
}

/// Where panels and legend lie in the image.
class Layout {
 public:
  explicit Layout(const Figure& figure)
      : columns_(static_cast<int>(figure.columns)),
        overviews_(figure.first_is_overview ? 1 : 0),
        panel_height_(figure.panel_height),
        column_gap_(has_own(figure, &Panel::y) ? kLeft : kColumnGap),
        row_gap_(has_own(figure, &Panel::x) ? kLabelledRowGap : kRowGap) {
    const int cells = static_cast<int>(figure.panels.size()) - overviews_;
    const int cell_columns = columns_ - overviews_;
    rows_ = (cells + cell_columns - 1) / cell_columns;
    const double widths = kWidth - kLeft - kRight - (columns_ - 1) * column_gap_;
    other_width_ = static_cast<int>(widths / (figure.first_column + columns_ - 1));
    first_width_ = static_cast<int>(other_width_ * figure.first_column);
    const int entry_width = kLegendSymbol + kCharacter * longest_title(figure.legend);
    const int entries = static_cast<int>(figure.legend.size());
    legend_columns_ = std::clamp((kWidth - 2 * kRight) / entry_width, 1, std::max(1, entries));
    const int legend_rows = (entries + legend_columns_ - 1) / legend_columns_;
    legend_height_ = legend_rows * kLegendRow + kLegendMargin;
    colour_bar_room_ = figure.colours ? kColourBarRoom : 0;
  }

  int height() const {
    return bottom_of_row(rows_ - 1) + kBottom + colour_bar_room_ + legend_height_;
  }
  /// Share of the height, from below.
  double colour_bar_from() const {
    const int below = legend_height_ + colour_bar_room_ - kColourBarHeight;
    return below / static_cast<double>(height());
  }
  int legend_columns() const { return legend_columns_; }

  std::string legend_margins() const {
    return margins({0, kWidth, height() - legend_height_, height()});
  }

  Box panel(std::size_t index) const {
    const int c = column(index);
    const int left = kLeft + (c > 0 ? first_width_ + column_gap_ : 0) +
                     std::max(0, c - 1) * (other_width_ + column_gap_);
    const int last_row = is_overview(index) ? rows_ - 1 : row(index);
    return {left, left + (c == 0 ? first_width_ : other_width_), top_of_row(row(index)),
            bottom_of_row(last_row)};
  }
  std::string panel_margins(std::size_t index) const { return margins(panel(index)); }

  /// With the room of tics and labels.
  ScreenBox surface_box(std::size_t index) const {
    const Box box = panel(index);
    const double below = box.bottom + kBottom, left = box.left - 0.4 * kColumnGap;
    return {left / kWidth, 1.0 - below / height(), (box.right + kRight - left) / kWidth,
            (below - box.top + kTop / 2.0) / height()};
  }

  bool is_leftmost(std::size_t index) const { return column(index) == 0; }
  bool is_lowest(std::size_t index) const { return is_overview(index) || row(index) == rows_ - 1; }

 private:
  bool is_overview(std::size_t index) const { return static_cast<int>(index) < overviews_; }
  /// Index among the panels that are no overview.
  int cell(std::size_t index) const { return static_cast<int>(index) - overviews_; }
  int column(std::size_t index) const {
    return is_overview(index) ? 0 : overviews_ + cell(index) % (columns_ - overviews_);
  }
  int row(std::size_t index) const {
    return is_overview(index) ? 0 : cell(index) / (columns_ - overviews_);
  }
  int top_of_row(int row) const { return kTop + row * (panel_height_ + row_gap_); }
  int bottom_of_row(int row) const { return top_of_row(row) + panel_height_; }

  std::string margins(const Box& box) const {
    const double w = kWidth;
    const double h = height();
    return fmt::format(
        "set lmargin at screen {:.4f}; set rmargin at screen {:.4f}; "
        "set bmargin at screen {:.4f}; set tmargin at screen {:.4f}\n",
        box.left / w, box.right / w, 1 - box.bottom / h, 1 - box.top / h);
  }

  int columns_ = 1;
  int overviews_ = 0;
  int panel_height_ = 0;
  int column_gap_ = 0;
  int row_gap_ = 0;
  int first_width_ = 0;
  int other_width_ = 0;
  int rows_ = 1;
  int legend_columns_ = 1;
  int legend_height_ = 0;
  int colour_bar_room_ = 0;
};

std::string style_lines(const std::vector<LineStyle>& styles) {
  std::string script;
  for (std::size_t k = 0; k < styles.size(); ++k) {
    const LineStyle& s = styles[k];
    script += fmt::format("set style line {} lc rgb '{}' dt {} lw {} pt {} ps {} pi {}\n", k + 1,
                          s.colour, std::max(1, s.dash), s.width, s.point,
                          s.point == 0 ? 0.0 : 0.25 + 0.25 * s.width, s.point_interval);
  }
  return script;
}

/// Tail and head of each arrow.
std::string arrow_data(const Line& line) {
  std::string data;
  for (const Polyline& part : line.parts)
    data += fmt::format("{:.7g} {:.7g} {:.7g} {:.7g}\n", part[0][0], part[0][1],
                        part[1][0] - part[0][0], part[1][1] - part[0][1]);
  return data.empty() ? "NaN NaN NaN NaN\n" : data;
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

std::string cell_data(const CellMap& map) {
  std::string data;
  for (const Cell& cell : map.cells)
    data += fmt::format("{:.7g} {:.7g} {:.7g}\n", cell.x, cell.y, cell.value);
  return data;
}

/// One block of data a panel, its cells after its lines; two empty text lines separate them.
std::string data_block(std::size_t index, const Figure& figure) {
  const Panel& panel = figure.panels[index];
  std::string script = fmt::format("$panel_{} << END\n", index + 1);
  for (const Line& line : panel.lines)
    script += (figure.styles[line.style].arrows ? arrow_data(line) : line_data(line)) + "\n\n";
  script += cell_data(panel.map) + "END\n";
  return panel.surface ? script + surface_data(index, *panel.surface) : script;
}

std::string drawn_with(const Figure& figure, std::size_t style) {
  const LineStyle& s = figure.styles[style];
  if (s.arrows) return fmt::format("vectors filled head size screen 0.008,20 ls {}", style + 1);
  if (s.filled && s.value)
    return fmt::format("filledcurves closed fs solid noborder fc palette cb {:.7g}", *s.value);
  if (s.filled) return fmt::format("filledcurves closed fs solid noborder fc rgb '{}'", s.colour);
  const char* kind = s.point == 0 ? "lines" : s.dash == 0 ? "points" : "linespoints";
  return fmt::format("{} ls {}", kind, style + 1);
}

std::string axis_lines(char axis, const Axis& a, std::string_view label, std::string_view tics) {
  return fmt::format(
      "{5} logscale {0}\n"
      "set {0}range [{1:.7g}:{2:.7g}]\n"
      "set {0}tics {3}\n"
      "set {0}label {4}\n",
      axis, a.from, a.to, tics, gnuplot_string(label), a.logarithmic ? "set" : "unset");
}

/// Tics as the axis has them, or those that gnuplot chooses.
std::string tics_of(const Axis& axis) {
  return axis.tics.empty() ? "autofreq" : fmt::format("({})", fmt::join(axis.tics, ", "));
}

/// Tics with room for their numbers. (gnuplot's own choice runs together in narrow panels.)
std::string tics_with_room(const Axis& axis, int count) {
  return fmt::format("{:.7g}", tic_distance(axis.to - axis.from, std::max(1, count)));
}

/// As many tics as have their numbers side by side.
std::string tics_side_by_side(const Axis& axis, int width) {
  const double length = axis.to - axis.from;
  double distance = length;
  for (int count = kMostTics; count > 1; --count) {
    distance = tic_distance(length, count);
    std::size_t characters = 0;
    for (const double end : {axis.from, axis.to})
      characters =
          std::max(characters, fmt::format("{:g}", distance * std::round(end / distance)).size());
    if (length / distance * kTicCharacter * (static_cast<double>(characters) + 0.8) <= width) break;
  }
  return fmt::format("{:.7g}", distance);
}

/// The range, or a little more about its middle where gnuplot would see none.
Axis with_length(Axis axis) {
  constexpr double kLeast = 2e-6;  // Of the numbers, which are written with seven digits.
  const double size = std::max(std::abs(axis.from), std::abs(axis.to));
  const double margin = size > 0.0 ? kLeast * size : 1.0;
  if (axis.to - axis.from > margin) return axis;
  axis.from -= margin;
  axis.to += margin;
  return axis;
}

/// Widens the range about its middle to that length.
void widen(Axis& axis, double length) {
  const double margin = std::max(0.0, 0.5 * (length - (axis.to - axis.from)));
  axis.from -= margin;
  axis.to += margin;
}

void bring_to_scale(Axis& x, Axis& y, const Box& box) {
  const double unit = std::min(box.width() / (x.to - x.from), box.height() / (y.to - y.from));
  widen(x, box.width() / unit);
  widen(y, box.height() / unit);
}

std::string axes_lines(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  Axis x = with_length(panel.x.value_or(figure.x));
  Axis y = with_length(panel.y.value_or(figure.y));
  const std::string x_label = panel.x || layout.is_lowest(index) ? x.label : "";
  const std::string y_label = panel.y || layout.is_leftmost(index) ? y.label : "";
  const Box box = layout.panel(index);
  if (!figure.to_scale) {
    const bool chosen = figure.columns == 1 || x.logarithmic || !x.tics.empty();
    return axis_lines('x', x, x_label, chosen ? tics_of(x) : tics_side_by_side(x, box.width())) +
           axis_lines('y', y, y_label, tics_of(y));
  }
  bring_to_scale(x, y, box);
  return axis_lines('x', x, x_label, tics_with_room(x, box.width() / kTicWidth)) +
         axis_lines('y', y, y_label, tics_with_room(y, box.height() / kTicHeight));
}

std::string label_lines(const std::vector<Label>& labels) {
  std::string script = "unset label\n";
  for (const Label& label : labels)
    script += fmt::format("set label {0} at {1}{2:.7g}, {1}{3:.7g} {4} front\n",
                          gnuplot_string(panel_title(label.text)), label.in_panel ? "graph " : "",
                          label.x, label.y, label.centred ? "center" : "left");
  return script;
}

/// The colours, before the panels.
std::string palette_lines(const ColourScale& colours) {
  return fmt::format(
      "set palette defined (0 '#ffffe5', 1 '#fee391', 2 '#fec44f', 3 '#ec7014', 4 '#cc4c02')\n"
      "set cbrange [{:.7g}:{:.7g}]\n"
      "unset colorbox\n{}",
      colours.from, colours.to,
      colours.bands > 0 ? fmt::format("set palette maxcolors {}\n", colours.bands) : "");
}

/// A box around a drawing, two axes and a grid for reading values of other plots.
std::string_view frame_lines(bool is_drawing) {
  return is_drawing ? "set border 15 lw 0.7; set clip two\n"
                    : "set border 3\n"
                      "set grid y lc rgb '#d9d9d9' lt 1 lw 0.6\n";
}

std::string panel_lines(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  if (panel.surface)
    return surface_lines(index, panel, panel.x.value_or(figure.x), panel.y.value_or(figure.y),
                         layout.surface_box(index)) +
           std::string(frame_lines(figure.to_scale)) +
           (figure.colours ? palette_lines(*figure.colours) : "");
  std::string script = layout.panel_margins(index);
  script += fmt::format("set title {}\n", gnuplot_string(panel_title(panel.title)));
  script += axes_lines(figure, layout, index) + label_lines(panel.labels);
  std::vector<std::string> plots;
  if (!panel.map.cells.empty())
    plots.push_back(fmt::format(
        "$panel_{} index {} using 1:2:({:.7g}):({:.7g}):3 with boxxyerror fs solid noborder fc "
        "palette",
        index + 1, panel.lines.size(), 0.5 * kCellOverlap * panel.map.width,
        0.5 * kCellOverlap * panel.map.height));
  for (std::size_t k = 0; k < panel.lines.size(); ++k)
    plots.push_back(fmt::format("$panel_{} index {} with {}", index + 1, k,
                                drawn_with(figure, panel.lines[k].style)));
  if (plots.empty()) plots.push_back("NaN");
  return script + fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
}

std::string colour_bar_lines(const ColourScale& colours, const Layout& layout) {
  return fmt::format(
      "set colorbox user horizontal origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f}\n"
      "set cblabel {} offset 0,0.4\n",
      0.5 * (1.0 - kColourBarWidth), layout.colour_bar_from(), kColourBarWidth,
      static_cast<double>(kColourBarHeight) / layout.height(), gnuplot_string(colours.label));
}

/// What draws nothing but the sample in the legend.
std::string_view nothing(const LineStyle& style) {
  return style.arrows ? "'+' using (NaN):(NaN):(0):(0)" : "NaN";
}

std::string legend_lines(const Figure& figure, const Layout& layout) {
  std::string script = layout.legend_margins();
  script +=
      "unset logscale; unset title; unset xlabel; unset ylabel; unset label\n"
      "unset grid; unset border; unset xtics; unset ytics\n";
  script += fmt::format("set key center horizontal Left reverse maxcols {} samplen 3\n",
                        layout.legend_columns());
  std::vector<std::string> plots;
  if (figure.colours) {
    script += colour_bar_lines(*figure.colours, layout);
    plots.emplace_back("NaN lc palette notitle");
  }
  for (std::size_t k = 0; k < figure.legend.size(); ++k) {
    const std::size_t style = figure.legend[k].style;
    plots.push_back(fmt::format("{} with {} title legend_{}", nothing(figure.styles[style]),
                                drawn_with(figure, style), k + 1));
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
    script +=
        fmt::format("legend_{} = {}\n", k + 1, gnuplot_string(panel_title(figure.legend[k].title)));
  for (std::size_t k = 0; k < figure.panels.size(); ++k) script += data_block(k, figure);

  script += "do for [format in 'svg png'] {\n" + terminal_lines(figure, layout.height());
  script += fmt::format("set multiplot title {}\n", gnuplot_string(figure.title));
  script +=
      "set xtics out nomirror scale 0.5; set ytics out nomirror scale 0.5\n"
      "unset key\n";
  script += frame_lines(figure.to_scale);
  if (figure.colours) script += palette_lines(*figure.colours);
  for (std::size_t k = 0; k < figure.panels.size(); ++k) script += panel_lines(figure, layout, k);
  script += legend_lines(figure, layout);
  return script + "unset multiplot\nunset output\n}\n";
}

}  // namespace prs
