#include "prs/report/tables.h"

#include <regex>

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/pictures.h"
#include "prs/record/table_layout.h"
#include "prs/report/glossary.h"
#include "prs/report/report.h"
#include "prs/svg/panel.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kLongestList = 3;  ///< Longest list that is not shown as its range.

struct Rows {
  std::string text;
  std::string_view group;
  const QuantityInfo* outer = nullptr;  ///< Quantity whose parts, numbers of one unit, are the rows.
};

std::string heading(std::string_view title, std::size_t columns) {
  return fmt::format("<tr class=\"group\"><th colspan=\"{}\" scope=\"colgroup\">{}</th></tr>\n", columns + 2,
                     html(capitalised(std::string(title))));
}

bool any(const std::vector<RecordColumn>& columns) {
  return std::ranges::any_of(columns, [](const RecordColumn& c) { return c.record != nullptr; });
}

/// Range of the numbers of nested arrays; empty if there are none.
std::pair<double, double> range_of(const Json& value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (value.is_number()) return {value.get<double>(), value.get<double>()};
  std::pair range{kInfinity, -kInfinity};
  if (!value.is_array()) return range;
  for (const Json& entry : value) {
    const auto [least, most] = range_of(entry);
    range = {std::min(range.first, least), std::max(range.second, most)};
  }
  return range;
}

/// Largest magnitude of the numbers of all columns.
double largest_of(const std::vector<RecordColumn>& columns) {
  double largest = 0.0;
  for (const RecordColumn& column : columns)
    if (column.record)
      if (const auto [least, most] = range_of(*column.record); least <= most)
        largest = std::max({largest, -least, most});
  return largest;
}

void add_row(Rows& rows, const std::string& title, const QuantityInfo& q, std::string_view document_unit,
             const std::vector<RecordColumn>& columns) {
  const ReportUnit unit = report_unit(q.key, document_unit, largest_of(columns));
  std::string cells;
  const bool is_range = q.key.find("range") != q.key.npos;
  bool found = false;
  for (const RecordColumn& column : columns) {
    const std::string shown = column.record ? report_value(*column.record, unit, is_range) : "";
    found = found || !shown.empty();
    cells += fmt::format("<td>{}</td>", shown.empty() ? "–" : shown);
  }
  if (!found) return;
  if (q.group != rows.group && !q.group.empty()) rows.text += heading(q.group, columns.size());
  rows.group = q.group;
  const QuantityInfo& named = rows.outer ? *rows.outer : q;
  const std::string shown = capitalised(title);
  rows.text += fmt::format("<tr><th scope=\"row\"{}>{}</th>{}<td class=\"unit\">{}</td></tr>\n",
                           q.meaning.empty() ? "" : fmt::format(" title=\"{}\"", html(q.meaning)),
                           named.meaning.empty() ? prose_html(shown) : term_html(capitalised(named.title), shown),
                           cells, prose_html(unit.text));
}

void add_rows(Rows& rows, const RecordInfo& info, const std::vector<RecordColumn>& columns, const RecordChoice& choice,
              const std::string& prefix, std::string_view unit);

/// Adds a nested record: one of numbers with one unit continues the rows, others get a heading.
void add_record(Rows& rows, const QuantityInfo& q, const std::vector<RecordColumn>& columns, const RecordChoice& choice,
                const std::string& prefix, std::string_view unit) {
  const RecordInfo& info = q.record();
  const std::string title = prefix.empty() ? q.title : prefix + ", " + q.title;
  const RecordChoice inside{.hidden = choice.hidden, .reach = choice.reach};
  if (!unit.empty()) {
    const QuantityInfo* const outer = std::exchange(rows.outer, rows.outer ? rows.outer : &q);
    add_rows(rows, info, columns, inside, title, unit);
    rows.outer = outer;
    return;
  }
  Rows own;
  add_rows(own, info, columns, inside, "", unit);
  if (own.text.empty()) return;
  rows.text += heading(title, columns.size()) + own.text;
  rows.group = "-";  // The following rows are outside the group.
}

void add_rows(Rows& rows, const RecordInfo& info, const std::vector<RecordColumn>& columns, const RecordChoice& choice,
              const std::string& prefix, std::string_view unit) {
  std::vector<const QuantityInfo*> in_groups;  // Quantities of one group stand together.
  for (const QuantityInfo& q : info.quantities) {
    const auto last = std::ranges::find_if(in_groups.rbegin(), in_groups.rend(), [&](const QuantityInfo* other) {
      return !q.group.empty() && other->group == q.group;
    });
    in_groups.insert(last == in_groups.rend() ? in_groups.end() : last.base(), &q);
  }
  for (const bool nested : {false, true})
    for (const QuantityInfo* const each : in_groups) {
      const QuantityInfo& q = *each;
      const bool is_record = q.kind == Kind::record;
      const std::string_view own_unit = q.unit.empty() && !is_ratio(q.key) ? unit : q.unit;
      if ((is_record && own_unit.empty()) != nested) continue;
      const auto is_in = [&](const std::vector<std::string>& keys) { return contains(keys, q.key); };
      if (is_in(choice.without) || is_in(choice.hidden) || (!choice.only.empty() && !is_in(choice.only))) continue;
      const bool about_solution = q.delivery == Reach::document;
      if (about_solution != (choice.reach == Reach::document) && !is_record) continue;
      const std::vector<RecordColumn> values = columns_in(columns, q.key);
      if (!any(values)) continue;
      if (is_record)
        add_record(rows, q, values, choice, prefix, own_unit);
      else
        add_row(rows, prefix.empty() ? q.title : prefix + ", " + q.title, q, own_unit, values);
    }
}

/// Useful number of digits for a unit.
int digits_in(std::string_view unit) {
  for (const std::string_view exact : {"mm", "in", "deg", "1/mm"})
    if (unit == exact) return 5;
  for (const std::string_view rough : {"h", "km", "revolutions", "°C"})
    if (unit == rough) return 3;
  return 4;
}

}  // namespace

std::string name_with_signs(const std::string& name) {
  static const std::regex kDegrees(R"((\d) deg\b)");
  return std::regex_replace(name, kDegrees, "$1°");
}

std::string prose_html(std::string_view sentence) {
  static const std::pair<std::regex, const char*> kSigns[] = {
      {std::regex(R"(\bum\b)"), "µm"},
      {std::regex(R"(\bdeg([CF])\b)"), "°$1"},
      {std::regex(R"(^deg$|(\d) deg\b)"), "$1°"},
      {std::regex(R"(\b([A-Za-z]|[Oo]mega)_([A-Za-z\d]|max)\b)"), "$1<sub>$2</sub>"},
      {std::regex(R"(([A-Za-z])\^2(?![\d.]))"), "$1²"},
      {std::regex(R"(([A-Za-z])\^3(?![\d.]))"), "$1³"},
      {std::regex(R"(\^(-?\d+(?:\.\d+)?|\(-?[\d/]+\)))"), "<sup>$1</sup>"}};
  std::string all;
  bool is_code = false;
  for (std::size_t begin = 0; begin <= sentence.size(); is_code = !is_code) {
    const std::size_t end = std::min(sentence.find('`', begin), sentence.size());
    std::string part = html(sentence.substr(begin, end - begin));
    if (is_code)
      part = fmt::format("<code>{}</code>", part);
    else if (part.find_first_of("^_") != part.npos || part.find("um") != part.npos || part.find("deg") != part.npos)
      for (const auto& [letters, sign] : kSigns) part = std::regex_replace(part, letters, sign);
    all += part;
    begin = end + 1;
  }
  return all;
}

std::string report_number(double value, std::string_view unit) {
  if (!std::isfinite(value)) return {};
  const double size = std::abs(value);
  const int digits = digits_in(unit);
  std::string shown;
  if (unit == "N/µm") {
    shown = fmt::format("{:.1f}", value);
  } else if (size == 0.0) {
    shown = "0";
  } else if (size >= 1e6 || size < 1e-4) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const auto e = text.find('e');
    shown = fmt::format("{} × 10<sup>{}</sup>", text.substr(0, e), std::stoi(text.substr(e + 1)));
  } else if (size >= std::pow(10.0, digits) - 0.5) {
    shown = fmt::format("{:.0f}", value);
  } else {
    shown = fmt::format("{:.{}g}", value, digits);
  }
  for (std::size_t at = shown.find('-'); at != std::string::npos; at = shown.find('-', at))
    shown.replace(at, 1, "\u2212");
  return shown;
}

ReportUnit report_unit(std::string_view key, std::string_view unit, double largest) {
  constexpr double kKilonewton = 1000.0;
  if (unit.empty() && key.find("efficiency") != key.npos) return {"%", 100.0};
  if (table_system() == UnitSystem::us) return {with_table_unit(unit), table_factor(unit)};
  if (unit == "MPa") return {"GPa", 1e-3};
  if (unit == "N" && largest >= kKilonewton) return {"kN", 1e-3};
  return {std::string(unit)};
}

std::string report_value(const Json& value, const ReportUnit& unit, bool is_range) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer()) return report_number(value.get<double>(), "");
  if (value.is_number()) return report_number(value.get<double>() * unit.factor, unit.text);
  if (value.is_string()) return prose_html(words_of_text(value.get<std::string>()));
  if (!value.is_array() || value.empty()) return {};
  const auto is_number = [](const Json& entry) { return entry.is_number(); };
  if (value.size() <= kLongestList && std::ranges::all_of(value, is_number)) {
    constexpr double kNoise = 1e-9;  // Share of the largest number below which a value is a rounded zero.
    double largest = 0.0;
    for (const Json& entry : value) largest = std::max(largest, std::abs(entry.get<double>()));
    std::string all;
    for (const Json& entry : value)
      all += (all.empty() ? ""
              : is_range  ? " … "
                          : ", ") +
             (std::abs(entry.get<double>()) < kNoise * largest ? "0" : report_value(entry, unit));
    return all;
  }
  const auto [least, most] = range_of(value);
  if (!(least <= most)) return {};
  const std::string low = report_number(least * unit.factor, unit.text);
  const std::string high = report_number(most * unit.factor, unit.text);
  return low == high ? low : low + " … " + high;
}

std::string record_table(const RecordInfo& info, const std::vector<RecordColumn>& columns, const RecordChoice& choice) {
  Rows rows;
  add_rows(rows, info, columns, choice, "", "");
  if (rows.text.empty()) return {};
  std::string head;
  const bool titled = std::ranges::any_of(columns, [](const RecordColumn& c) { return !c.title.empty(); });
  for (const RecordColumn& column : columns)
    head += fmt::format("<th scope=\"col\">{}</th>", breakable_html(name_with_signs(column.title)));
  constexpr std::size_t kFewColumns = 5;
  return fmt::format(
      "<div class=\"wide\" tabindex=\"0\"><table "
      "class=\"quantities{}\">\n{}<tbody>\n{}</tbody></table></div>\n",
      columns.size() > kFewColumns ? " many" : "",
      titled ? fmt::format("<thead><tr><td></td>{}<th scope=\"col\" class=\"unit\">unit</th></tr></thead>\n", head)
             : "",
      rows.text);
}

std::vector<RecordColumn> columns_in(const std::vector<RecordColumn>& columns, std::string_view key) {
  std::vector<RecordColumn> all;
  for (const RecordColumn& column : columns) {
    const bool has = column.record && column.record->is_object() && column.record->contains(key);
    all.push_back({column.title, has ? &(*column.record)[std::string(key)] : nullptr});
  }
  return all;
}

std::string folded_html(std::string_view title, const std::string& body, bool is_printed) {
  if (body.empty()) return {};
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n", is_printed ? " class=\"printed\" open" : "",
                     html(title), body);
}

const RecordInfo* record_in(const RecordInfo& info, std::string_view key) {
  const auto found = std::ranges::find(info.quantities, key, &QuantityInfo::key);
  return found == info.quantities.end() || !found->record ? nullptr : &found->record();
}

std::string plain_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                        bool of_numbers) {
  std::string text =
      fmt::format("<div class=\"wide\" tabindex=\"0\"><table{}>\n", of_numbers ? " class=\"quantities\"" : "");
  const auto look = [&](std::size_t column) {  // Words begin at the left, numbers end at the right.
    static const std::regex kWords("^[A-Za-z<]|[0-9][A-Za-df-z]");  // Words, and names such as `30x10`.
    const auto has_words = [&](const std::vector<std::string>& row) {
      return column < row.size() && std::regex_search(row[column], kWords);
    };
    return of_numbers && column > 0 && std::ranges::any_of(rows, has_words) ? " class=\"words\"" : "";
  };
  if (!head.empty()) {
    text += "<thead><tr>";
    for (const auto k : indices(head))
      text += head[k].empty() ? "<td></td>" : fmt::format("<th scope=\"col\"{}>{}</th>", look(k), head[k]);
    text += "</tr></thead>\n";
  }
  text += "<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    if (row.size() == 1) {
      text += fmt::format("<tr class=\"group\"><th colspan=\"{}\" scope=\"colgroup\">{}</th></tr>\n", head.size(),
                          row.front());
      continue;
    }
    text += fmt::format("<tr><th scope=\"row\">{}</th>", row.front());
    for (std::size_t k = 1; k < row.size(); ++k) text += fmt::format("<td{}>{}</td>", look(k), row[k]);
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string breakable_html(std::string_view name) {
  std::string text;
  for (const char c : html(name)) {
    if (c == '[') text += "<wbr>";
    text += c;
    if (std::string_view("._-/").find(c) != std::string_view::npos) text += "<wbr>";
  }
  return text;
}

namespace {

constexpr int kTitleTop = 36;

/// Legend as a list of the page, whose lines break at the edge of the screen.
std::string legend_html(const Figure& figure) {
  if (figure.legend.empty()) return {};
  std::string all = "<ul class=\"legend\">";
  for (const LegendEntry& entry : figure.legend)
    all += fmt::format("<li><svg viewBox=\"0 0 {} 16\" aria-hidden=\"true\">{}</svg>{}</li>", kLegendSymbolWidth,
                       legend_symbol(figure.styles[entry.style]), prose_html(entry.title));
  return all + "</ul>";
}

/// Whether a panel is drawn half as wide as the page: others are flat, or have words at their axes.
bool is_half(const Figure& figure, const Panel& panel) {
  constexpr double kWord = 50.0;  // Width in pixels.
  if (longest_text(x_axis(figure, panel)) > kWord || longest_text(y_axis(figure, panel)) > kWord) return false;
  return figure.columns > 1 || figure.aspect == 0.0 || figure.aspect >= 0.5;
}

/// One panel of the figure, without a legend.
Figure panel_alone(const Figure& figure, std::size_t index) {
  Figure one{figure.name, figure.title, figure.x, figure.y};
  one.panels.push_back(figure.panels[index]);
  one.styles = figure.styles;
  one.aspect = figure.aspect;
  one.to_scale = figure.to_scale;
  return one;
}

/// Element over a panel whose points are threads, with their places for scripts.
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
  const bool titled = std::ranges::any_of(figure.panels, [](const Panel& panel) { return !panel.title.empty(); });
  const int top = titled ? kTitleTop - 6 : kTitleTop + 20;  // The page has the title.
  const std::string& title = figure.panels[index].title;
  constexpr int kSecondLine = 26;  // Space below the axis that few labels need.
  const Axis& x = x_axis(one, one.panels[0]);
  const bool is_short =
      !one.panels[0].surface &&
      (x.hidden || (longest_text(x) == 0.0 && fitted_lines(text_of(x), layout.panel(0).width()).size() < 2));
  const int height = layout.height() - top - (is_short && !x.hidden ? kSecondLine : 0);
  return fmt::format("<svg viewBox=\"0 {} {} {}\" class=\"{}\" role=\"img\" aria-label=\"{}\">", top, layout.width(),
                     height, half ? "half" : "whole",
                     html(title.empty() ? figure.title : figure.title + ": " + title)) +
         panel_svg(one, layout, 0, fmt::format("{}-{}", id, index)) + pick_svg(frame_of(one, layout, 0)) + "</svg>";
}

/// The scale of the colours as a separate image.
std::string colour_bar(const ColourScale& scale) {
  return fmt::format("<svg viewBox=\"0 0 {} 76\" class=\"half\" role=\"img\" aria-label=\"{}\">{}</svg>", kHalfWidth,
                     html(text_of({scale.label, scale.unit})), colour_bar_svg(scale, {40, kHalfWidth - 40, 8, 22}));
}

/// Axes and colours in the units of tables.
Figure with_table_units(Figure figure) {
  std::set<std::string> units = {figure.x.unit, figure.y.unit};
  if (figure.colours) units.insert(figure.colours->unit);
  for (Panel& panel : figure.panels) {
    for (const std::optional<Axis>& axis : {panel.x, panel.y})
      if (axis) units.insert(axis->unit);
  }
  for (const std::string& unit : units)
    figure = in_unit(std::move(figure), {unit, with_table_unit(unit), table_factor(unit)});
  return figure;
}

}  // namespace

std::string svg(const Figure& drawn, const std::string& id) {
  const Figure figure =
      with_ranges(with_true_legend(table_system() == UnitSystem::us ? with_table_units(drawn) : in_page_units(drawn)));
  std::string all = "<div class=\"panels\">";
  for (const auto k : indices(figure.panels)) all += image(figure, k, id);
  all += "</div>";
  if (figure.colours) all += colour_bar(*figure.colours);
  return all + legend_html(figure);
}

std::string svg_style() {
  std::string light, dark;
  // On dark paper black and blue must be lighter.
  constexpr std::string_view kOnDark[] = {"#56b4e9", "#ff8a3c", "#2fc79b", "#e6a3cb", "#f0b73c", "#9bd4f5",
                                          "#e8e8e6", "#a5a5a5", "#b5b5b5", "#6b6b6b", "#ff6b4a"};
  for (const auto k : indices(kColours)) {
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
