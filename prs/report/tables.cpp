#include "prs/report/tables.h"

#include <nlohmann/json.hpp>

#include "prs/loads/case_table.h"
#include "prs/record/table_units.h"
#include "prs/report/svg.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kLongestList = 3;  ///< Of longer ones tables show the range.

struct Rows {
  std::string text;
  std::string_view group;
};

std::string heading(std::string_view title, std::size_t columns) {
  return fmt::format("<tr class=\"group\"><th colspan=\"{}\" scope=\"colgroup\">{}</th></tr>\n",
                     columns + 2, html(capitalised(std::string(title))));
}

bool any(const std::vector<RecordColumn>& columns) {
  return std::ranges::any_of(columns, [](const RecordColumn& c) { return c.record != nullptr; });
}

/// From the least to the largest number of arrays in arrays; empty where there is none.
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

/// The largest number of all columns, without its sign.
double largest_of(const std::vector<RecordColumn>& columns) {
  double largest = 0.0;
  for (const RecordColumn& column : columns)
    if (column.record)
      if (const auto [least, most] = range_of(*column.record); least <= most)
        largest = std::max({largest, -least, most});
  return largest;
}

void add_row(Rows& rows, const std::string& title, const QuantityInfo& q,
             std::string_view document_unit, const std::vector<RecordColumn>& columns) {
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
  rows.text += fmt::format("<tr><th scope=\"row\"{}>{}</th>{}<td class=\"unit\">{}</td></tr>\n",
                           q.meaning.empty() ? "" : fmt::format(" title=\"{}\"", html(q.meaning)),
                           html(capitalised(title)), cells, html(unit.text));
}

void add_rows(Rows& rows, const RecordInfo& info, const std::vector<RecordColumn>& columns,
              const RecordChoice& choice, const std::string& prefix, std::string_view unit);

/// A record within another: one of numbers with one unit continues the rows, others get a heading.
void add_record(Rows& rows, const QuantityInfo& q, const std::vector<RecordColumn>& columns,
                const RecordChoice& choice, const std::string& prefix, std::string_view unit) {
  const RecordInfo& info = q.record();
  const std::string title = prefix.empty() ? q.title : prefix + ", " + q.title;
  const RecordChoice inside{.hidden = choice.hidden, .reach = choice.reach};
  if (!unit.empty()) return add_rows(rows, info, columns, inside, title, unit);
  Rows own;
  add_rows(own, info, columns, inside, "", unit);
  if (own.text.empty()) return;
  rows.text += heading(title, columns.size()) + own.text;
  rows.group = "-";  // What follows has left the group.
}

void add_rows(Rows& rows, const RecordInfo& info, const std::vector<RecordColumn>& columns,
              const RecordChoice& choice, const std::string& prefix, std::string_view unit) {
  for (const bool nested : {false, true})
    for (const QuantityInfo& q : info.quantities) {
      const bool is_record = q.kind == Kind::record;
      const std::string_view own_unit = q.unit.empty() ? unit : q.unit;
      if ((is_record && own_unit.empty()) != nested) continue;
      const auto is_in = [&](const std::vector<std::string>& keys) {
        return std::ranges::find(keys, q.key) != keys.end();
      };
      if (is_in(choice.without) || is_in(choice.hidden) ||
          (!choice.only.empty() && !is_in(choice.only)))
        continue;
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

/// Digits that are worth showing.
int digits_in(std::string_view unit) {
  for (const std::string_view exact : {"mm", "in", "deg", "1/mm"})
    if (unit == exact) return 5;
  for (const std::string_view rough : {"h", "km", "revolutions", "°C"})
    if (unit == rough) return 3;
  return 4;
}

}  // namespace

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

std::string unit_in(std::string_view path) {
  for (std::size_t dot = path.size(); dot != std::string_view::npos;
       dot = dot > 0 ? path.rfind('.', dot - 1) : std::string_view::npos) {
    std::string_view key = path.substr(dot < path.size() && path[dot] == '.' ? dot + 1 : dot);
    key = key.substr(0, key.find_first_of(".["));
    if (key.ends_with("_degC")) return "°C";
    if (const ShownUnit& unit = unit_of(key); !unit.text.empty()) return std::string(unit.text);
  }
  return {};
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
  if (value.is_string()) return html(words_of_text(value.get<std::string>()));
  if (!value.is_array() || value.empty()) return {};
  const auto is_number = [](const Json& entry) { return entry.is_number(); };
  if (value.size() <= kLongestList && std::ranges::all_of(value, is_number)) {
    constexpr double kNoise = 1e-9;  // Of the largest: what rounding leaves of a zero.
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

std::string record_table(const RecordInfo& info, const std::vector<RecordColumn>& columns,
                         const RecordChoice& choice) {
  Rows rows;
  add_rows(rows, info, columns, choice, "", "");
  if (rows.text.empty()) return {};
  std::string head;
  const bool titled =
      std::ranges::any_of(columns, [](const RecordColumn& c) { return !c.title.empty(); });
  for (const RecordColumn& column : columns)
    head += fmt::format("<th scope=\"col\">{}</th>", html(column.title));
  return fmt::format(
      "<div class=\"wide\" tabindex=\"0\"><table "
      "class=\"quantities\">\n{}<tbody>\n{}</tbody></table></div>\n",
      titled
          ? fmt::format(
                "<thead><tr><td></td>{}<th scope=\"col\" class=\"unit\">unit</th></tr></thead>\n",
                head)
          : "",
      rows.text);
}

std::vector<RecordColumn> columns_in(const std::vector<RecordColumn>& columns,
                                     std::string_view key) {
  std::vector<RecordColumn> all;
  for (const RecordColumn& column : columns) {
    const bool has = column.record && column.record->is_object() && column.record->contains(key);
    all.push_back({column.title, has ? &(*column.record)[std::string(key)] : nullptr});
  }
  return all;
}

std::string folded_html(std::string_view title, const std::string& body) {
  if (body.empty()) return {};
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", html(title), body);
}

const RecordInfo* record_in(const RecordInfo& info, std::string_view key) {
  const auto found = std::ranges::find(info.quantities, key, &QuantityInfo::key);
  return found == info.quantities.end() || !found->record ? nullptr : &found->record();
}

std::string plain_table(const std::vector<std::string>& head,
                        const std::vector<std::vector<std::string>>& rows, bool of_numbers) {
  std::string text = fmt::format("<div class=\"wide\" tabindex=\"0\"><table{}>\n",
                                 of_numbers ? " class=\"quantities\"" : "");
  if (!head.empty()) {
    text += "<thead><tr>";
    for (const std::string& cell : head)
      text += cell.empty() ? "<td></td>" : fmt::format("<th scope=\"col\">{}</th>", cell);
    text += "</tr></thead>\n";
  }
  text += "<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    if (row.size() == 1) {
      text +=
          fmt::format("<tr class=\"group\"><th colspan=\"{}\" scope=\"colgroup\">{}</th></tr>\n",
                      head.size(), row.front());
      continue;
    }
    text += fmt::format("<tr><th scope=\"row\">{}</th>", row.front());
    for (std::size_t k = 1; k < row.size(); ++k) text += fmt::format("<td>{}</td>", row[k]);
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace prs
