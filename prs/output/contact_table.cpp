#include "prs/output/contact_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "contact/mechanism_geometry.h"
#include "contact/thread_surface.h"
#include "prs/model/units.h"
#include "prs/output/warnings.h"
#include "prs/quantities/case_groups.h"
#include "prs/quantities/quantities.h"
#include "prs/text.h"
#include "prs/threads/thread_clearance.h"

namespace prs {
namespace {

using contact::InterfaceGeometry;
using contact::Thread;
using contact::ThreadSurface;

constexpr std::size_t kMaxNameWidth = 20;
constexpr int kLabelWidth = 38;
constexpr int kValueWidth = 16;
constexpr std::string_view kAbsent = "–";

/// A number as it is shown, SI * factor.
struct Shown {
  double factor = 1.0;
  int decimals = 0;

  std::string operator()(std::optional<double> si) const {
    if (!si) return std::string(kAbsent);
    const bool is_zero = std::abs(*si * factor) < 0.5 * std::pow(10.0, -decimals);
    return fmt::format("{:.{}f}", is_zero ? 0.0 : *si * factor, decimals);
  }
};

std::string table_row(std::string_view label, const std::vector<std::string>& cells) {
  std::string line = fmt::format("{:<{}}", label, kLabelWidth);
  for (const std::string& cell : cells) line += fmt::format("{:>{}}", cell, kValueWidth);
  return line + '\n';
}

// The mechanism, a column a part.

std::string mechanism_line(const Contacts& contacts) {
  const Mechanism& m = contacts.mechanism;
  return fmt::format(
      "{} roller screw, {}-handed, lead {:.6g} mm, {} rollers ({} fit)\n"
      "centre distance {:.4f} mm\n",
      m.type == Mechanism::Type::standard ? "Standard" : "Inverted",
      m.lead < 0.0 ? "left" : "right", std::abs(m.lead) * per_si::millimetre, m.rollers,
      contact::largest_roller_count(contacts.threads),
      contacts.threads.centre_distance * per_si::millimetre);
}

struct PartRow {
  std::string_view label;
  Shown shown;
  std::optional<double> (*value)(const Thread&);
};

template <auto width>
std::optional<double> of_widths(const Thread& thread) {
  const std::optional<ThreadWidths> widths = thread_widths(thread);
  return widths ? (*widths).*width : std::nullopt;
}

constexpr PartRow kPartRows[] = {
    {"  pitch diameter, mm",
     {per_si::millimetre, 4},
     [](const Thread& t) { return std::optional(2.0 * t.pitch_radius); }},
    {"  helix angle, deg",
     {per_si::degree, 4},
     [](const Thread& t) { return std::optional(ThreadSurface(t).helix_angle()); }},
    {"  flank from radius, mm",
     {per_si::millimetre, 4},
     [](const Thread& t) { return std::optional(contact::flank_limits(t).smallest); }},
    {"  flank to radius, mm",
     {per_si::millimetre, 4},
     [](const Thread& t) { return std::optional(contact::flank_limits(t).largest); }},
    {"  crest width, mm", {per_si::millimetre, 4}, of_widths<&ThreadWidths::crest>},
    {"  root width, mm", {per_si::millimetre, 4}, of_widths<&ThreadWidths::root>},
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

// The contacts, a column an interface.

struct ContactRow {
  std::string_view label;
  Shown shown;
  std::optional<double> (*value)(const Contacts&, Interface);
};

/// Reads a value of the contact point and the curvatures there.
template <auto value>
std::optional<double> of_geometry(const Contacts& contacts, Interface i) {
  const InterfaceGeometry& geometry = contacts.interfaces[i].geometry;
  return geometry.ok() ? std::optional<double>(value(geometry)) : std::nullopt;
}

template <double contact::HertzConstants::*value>
std::optional<double> of_hertz(const Contacts& contacts, Interface i) {
  const InterfaceContact& c = contacts.interfaces[i];
  return c.has_hertz() ? std::optional<double>(c.hertz.*value) : std::nullopt;
}

template <auto clearance>
std::optional<double> of_clearance(const Contacts& contacts, Interface i) {
  const std::optional<ThreadClearance>& c = contacts.interfaces[i].clearance;
  return c ? std::optional<double>((*c).*clearance) : std::nullopt;
}

std::optional<double> backlash(const Contacts& contacts, Interface i) {
  const contact::MechanismGeometry& threads = contacts.threads;
  const Thread& body = i == Interface::screw ? threads.screw : threads.nut;
  const contact::ContactPoint& point = contacts.interfaces[i].geometry.point;
  const bool has_meaning = point.ok() && contact::same_pitch(body, threads.roller);
  return has_meaning ? std::optional<double>(point.backlash) : std::nullopt;
}

using G = InterfaceGeometry;
constexpr Shown kLength{per_si::millimetre, 4};
constexpr Shown kAngle{per_si::degree, 4};
constexpr Shown kCurvature{per_si::per_millimetre, 6};

const ContactRow kContactRows[] = {
    {"  radius on the body, mm", kLength,
     of_geometry<[](const G& g) { return g.point.radius_on_body; }>},
    {"  radius on the roller, mm", kLength,
     of_geometry<[](const G& g) { return g.point.radius_on_roller; }>},
    {"  angle on the body, deg", kAngle,
     of_geometry<[](const G& g) { return g.point.angle_on_body; }>},
    {"  angle on the roller, deg", kAngle,
     of_geometry<[](const G& g) { return g.point.angle_on_roller; }>},
    {"  normal against the axis, deg", kAngle,
     of_geometry<[](const G& g) { return g.point.normal_angle(); }>},
    {"  backlash, mm", kLength, backlash},
    {"  flank to flank when centred, mm", kLength, of_clearance<&ThreadClearance::flank>},
    {"  crest of the body to flank, mm", kLength, of_clearance<&ThreadClearance::body_crest>},
    {"  crest of the roller to flank, mm", kLength, of_clearance<&ThreadClearance::roller_crest>},
    {"  curvatures of the body, 1/mm", kCurvature,
     of_geometry<[](const G& g) { return g.body.first; }>},
    {"", kCurvature, of_geometry<[](const G& g) { return g.body.second; }>},
    {"  curvatures of the roller, 1/mm", kCurvature,
     of_geometry<[](const G& g) { return g.roller.first; }>},
    {"", kCurvature, of_geometry<[](const G& g) { return g.roller.second; }>},
    {"  relative curvatures, 1/mm", kCurvature,
     of_geometry<[](const G& g) { return g.relative.first; }>},
    {"", kCurvature, of_geometry<[](const G& g) { return g.relative.second; }>},
    {"  their sum, 1/mm", kCurvature, of_geometry<[](const G& g) { return g.curvature_sum(); }>},
    {"  angle of the first directions, deg", kAngle,
     of_geometry<[](const G& g) { return g.first_directions_angle(); }>},
    {"  ellipticity b/a", {1.0, 6}, of_hertz<&contact::HertzConstants::ellipticity>},
    {"  Hertz constant, N/mm^1.5",
     {per_si::newton_per_millimetre1_5, 1},
     of_hertz<&contact::HertzConstants::hertz_constant>},
};

std::string contact_rows(const Contacts& contacts) {
  std::string rows = table_row("Contacts", {label(Interface::screw), label(Interface::nut)});
  for (const auto& [label, shown, value] : kContactRows) {
    const auto screw = value(contacts, Interface::screw), nut = value(contacts, Interface::nut);
    if (screw || nut) rows += table_row(label, {shown(screw), shown(nut)});
  }
  return rows;
}

// The load cases with equal shares, a row an interface.

/// A thread's value under load; all threads of such a case have the same.
struct LoadColumn {
  std::string_view title;
  std::string_view unit;
  std::vector<double> InterfaceLoads::*values;
  Shown shown;
};

constexpr LoadColumn kLoadColumns[] = {
    {"thread", "N", &InterfaceLoads::axial_load, {1.0, 2}},
    {"normal", "N", &InterfaceLoads::normal_load, {1.0, 2}},
    {"a", "mm", &InterfaceLoads::semi_major, {per_si::millimetre, 4}},
    {"b", "mm", &InterfaceLoads::semi_minor, {per_si::millimetre, 4}},
    {"peak", "MPa", &InterfaceLoads::peak_pressure, {per_si::megapascal, 1}},
    {"approach", "µm", &InterfaceLoads::approach, {per_si::micrometre, 3}},
    {"shear", "MPa", &InterfaceLoads::max_shear_stress, {per_si::megapascal, 1}},
    {"depth", "mm", &InterfaceLoads::max_shear_depth, {per_si::millimetre, 4}},
};

using Cases = std::vector<const LoadCaseResult*>;

bool has_equal_shares(const LoadCaseResult& result) {
  return result.load_case.share == LoadCase::Share::equal && result.threads.has_value();
}

std::optional<double> value(const LoadCaseResult& result, Interface i, const LoadColumn& column) {
  const std::vector<double>& values = (*result.threads)[i].*column.values;
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
  constexpr int kCellWidth = 9;
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
      cells.push_back(column.shown(value(result, i, column)));
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
    units.emplace_back(column.unit);
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
  const std::string warnings = warning_summary(result);
  return warnings.empty() ? table : table + '\n' + warnings;
}

}  // namespace prs
