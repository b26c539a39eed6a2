#include "prs/loads/contact_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "contact/mechanism_geometry.h"
#include "contact/thread_surface.h"
#include "prs/loads/case_groups.h"
#include "prs/loads/case_table.h"
#include "prs/loads/contact_record.h"
#include "prs/loads/load_record.h"
#include "prs/loads/warnings.h"
#include "prs/record/table_units.h"
#include "prs/text.h"
#include "prs/threads/thread_clearance.h"

namespace prs {
namespace {

using contact::Thread;
using contact::ThreadSurface;

constexpr std::size_t kMaxNameWidth = 16;
constexpr std::size_t kLabelWidth = 38;
constexpr int kValueWidth = 16;

/// A number with the decimals that it has in a unit of documents.
struct Shown {
  std::string_view unit;
  int decimals = 0;

  std::string operator()(std::optional<double> si) const {
    const std::string text = fixed(si, unit, decimals);
    const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
    return is_zero && text.starts_with('-') ? text.substr(1) : text;
  }
};

std::string table_row(std::string_view label, const std::vector<std::string>& cells) {
  std::string line = padded(with_table_unit(label), kLabelWidth, true);
  for (const std::string& cell : cells) line += fmt::format("{:>{}}", cell, kValueWidth);
  return line + '\n';
}

// The mechanism, one column per part.

std::string mechanism_line(const Contacts& contacts) {
  const Mechanism& m = contacts.mechanism;
  return fmt::format(
      "{} roller screw, {}-handed, lead {:.6g} {}, {} roller{} ({} fit)\n"
      "centre distance {}\n",
      m.type == Mechanism::Type::standard ? "Standard" : "Inverted",
      m.lead < 0.0 ? "left" : "right", shown(std::abs(m.lead), "mm"), table_unit("mm").text,
      m.rollers, m.rollers == 1 ? "" : "s", contact::largest_roller_count(contacts.threads),
      fixed_with_unit(contacts.threads.centre_distance, "mm", 4));
}

struct PartRow {
  std::string_view label;
  Shown shown;
  std::optional<double> (*value)(const Thread&);
};

constexpr PartRow kPartRows[] = {
    {"  pitch diameter, mm",
     {"mm", 4},
     [](const Thread& t) { return std::optional(2.0 * t.pitch_radius); }},
    {"  helix angle, deg",
     {"deg", 4},
     [](const Thread& t) { return std::optional(ThreadSurface(t).helix_angle()); }},
    {"  flank from radius, mm",
     {"mm", 4},
     [](const Thread& t) { return std::optional(contact::flank_limits(t).smallest); }},
    {"  flank to radius, mm",
     {"mm", 4},
     [](const Thread& t) { return std::optional(contact::flank_limits(t).largest); }},
    {"  crest width, mm",
     {"mm", 4},
     [](const Thread& t) { return thread_widths(t).value_or(ThreadWidths{}).crest; }},
    {"  root width, mm",
     {"mm", 4},
     [](const Thread& t) { return thread_widths(t).value_or(ThreadWidths{}).root; }},
};

std::string part_rows(const contact::MechanismGeometry& threads) {
  std::string rows = table_row("Threads", {"screw", "roller", "nut"});
  for (const auto& [label, shown, value] : kPartRows) {
    const auto screw = value(threads.screw), roller = value(threads.roller),
               nut = value(threads.nut);
    if (screw || roller || nut) rows += table_row(label, {shown(screw), shown(roller), shown(nut)});
  }
  return rows;
}

// The contacts, one column per interface.

struct ContactRow {
  std::string_view key;
  int decimals;
};

constexpr ContactRow kContactRows[] = {
    {"radius_on_body_mm", 4},
    {"radius_on_roller_mm", 4},
    {"angle_on_body_deg", 4},
    {"angle_on_roller_deg", 4},
    {"normal_angle_deg", 4},
    {"backlash_mm", 4},
    {"flank_clearance_mm", 4},
    {"body_crest_clearance_mm", 4},
    {"roller_crest_clearance_mm", 4},
    {"body_curvatures_per_mm", 6},
    {"roller_curvatures_per_mm", 6},
    {"relative_curvatures_per_mm", 6},
    {"curvature_sum_per_mm", 6},
    {"first_directions_angle_deg", 4},
    {"ellipticity", 6},
    {"hertz_constant_N_per_mm1_5", 1},
};

/// One number or both of a pair, in SI.
std::array<std::optional<double>, 2> values_of(const Contacts& contacts, Interface i,
                                               const Quantity<ContactAt>& q) {
  const ContactAt contact{&contacts, i};
  if (!contact.contact().geometry.ok()) return {};
  if (q.value.number) {
    const std::optional<double> si = q.value.number(contact);
    return {si && std::isfinite(*si) ? si : std::nullopt, {}};
  }
  const auto pair = q.value.json(contact, kNoUnit);
  return {pair[0].get<double>(), pair[1].get<double>()};
}

std::string contact_rows(const Contacts& contacts) {
  std::string rows = table_row("Contacts", {label(Interface::screw), label(Interface::nut)});
  for (const auto& [key, decimals] : kContactRows) {
    const auto& q = quantity<ContactAt>(key);
    const Shown shown{q.unit.text, decimals};
    std::string label =
        fmt::format("  {}{}{}", title_of(q), q.unit.text.empty() ? "" : ", ", q.unit.text);
    const auto screw = values_of(contacts, Interface::screw, q),
               nut = values_of(contacts, Interface::nut, q);
    for (std::size_t k = 0; k < screw.size(); ++k) {
      if (!screw[k] && !nut[k]) continue;
      rows += table_row(label, {shown(screw[k]), shown(nut[k])});
      label.clear();
    }
  }
  return rows;
}

// The load cases with equal shares, one row per interface.

/// A thread's value under load; all threads of such a case have the same.
struct LoadColumn {
  std::string_view title;
  std::string_view key;
  int decimals;

  const Quantity<InterfaceLoads>& of() const { return quantity<InterfaceLoads>(key); }
};

constexpr LoadColumn kLoadColumns[] = {
    {"thread", "axial_load_N", 2},
    {"normal", "normal_load_N", 2},
    {"a", "semi_major_mm", 4},
    {"b", "semi_minor_mm", 4},
    {"peak", "peak_pressure_MPa", 1},
    {"approach", "approach_um", 3},
    {"shear", "max_shear_stress_MPa", 1},
    {"depth", "max_shear_depth_mm", 4},
};

using Cases = std::vector<const LoadCaseResult*>;

bool has_equal_shares(const LoadCaseResult& result) {
  return result.load_case.share == LoadCase::Share::equal && result.threads.has_value();
}

std::optional<double> value(const LoadCaseResult& result, Interface i, const LoadColumn& column) {
  const std::span<const double> values = column.of().value.series((*result.threads)[i]);
  return values.empty() ? std::nullopt : std::optional<double>(values.front());
}

/// All of them or, of long ranges, the first, middle and last.
Cases shown_cases(const std::vector<LoadCaseResult>& results, std::size_t& count) {
  Cases shown;
  count = 0;
  for (const CaseGroup& group : group_cases(results)) {
    Cases equal;
    std::copy_if(group.cases.begin(), group.cases.end(), std::back_inserter(equal),
                 [](const LoadCaseResult* result) { return has_equal_shares(*result); });
    count += equal.size();
    if (results.size() > kMaxUnfoldedCases && equal.size() > 3)
      equal = {equal.front(), equal[equal.size() / 2], equal.back()};
    shown.insert(shown.end(), equal.begin(), equal.end());
  }
  return shown;
}

/// Columns of which any case has a value.
std::vector<LoadColumn> present_columns(const Cases& cases) {
  std::vector<LoadColumn> columns;
  std::copy_if(std::begin(kLoadColumns), std::end(kLoadColumns), std::back_inserter(columns),
               [&](const LoadColumn& column) {
                 return std::any_of(cases.begin(), cases.end(), [&](const LoadCaseResult* c) {
                   return value(*c, Interface::screw, column) || value(*c, Interface::nut, column);
                 });
               });
  return columns;
}

std::string case_row(const std::string& name, std::string_view interface,
                     const std::vector<std::string>& cells) {
  constexpr int kCellWidth = 8;
  std::string line = fmt::format("  {:<{}} {:<6}", name, kMaxNameWidth, interface);
  for (const std::string& cell : cells) line += fmt::format(" {:>{}}", cell, kCellWidth);
  return line + '\n';
}

std::string load_rows(const LoadCaseResult& result, const std::vector<LoadColumn>& columns) {
  std::string rows;
  std::string name = shortened(printable(result.load_case.name), kMaxNameWidth);
  for (const Interface i : kInterfaces) {
    std::vector<std::string> cells;
    for (const LoadColumn& column : columns)
      cells.push_back(Shown{column.of().unit.text, column.decimals}(value(result, i, column)));
    rows += case_row(name, prs::name(i), cells);
    name.clear();
  }
  return rows;
}

std::string load_table(const std::vector<LoadCaseResult>& results) {
  std::size_t count = 0;
  const Cases cases = shown_cases(results, count);
  if (cases.empty()) return {};
  const std::vector<LoadColumn> columns = present_columns(cases);
  std::vector<std::string> titles, units;
  for (const LoadColumn& column : columns) {
    titles.emplace_back(column.title);
    units.push_back(with_table_unit(column.of().unit.text));
  }
  std::string table = "\nEqual shares of all threads\n";
  table += case_row("", "", titles) + case_row("load case", "", units);
  for (const LoadCaseResult* result : cases) table += load_rows(*result, columns);
  if (cases.size() < count) table += fmt::format("  … {} of {} cases\n", cases.size(), count);
  return table;
}

}  // namespace

std::string contact_table(const Result& result) {
  const Contacts& contacts = result.contacts;
  std::string table = mechanism_line(contacts) + '\n' + part_rows(contacts.threads) + '\n' +
                      contact_rows(contacts) + load_table(result.load_cases);
  return table + warning_section(all_warnings(result));
}

}  // namespace prs
