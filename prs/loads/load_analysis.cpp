#include "prs/loads/load_analysis.h"

#include "prs/indices.h"
#include "prs/loads/analyze.h"
#include "prs/loads/case_table.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_criteria.h"
#include "prs/loads/load_record.h"
#include "prs/loads/mechanism_figures.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {
namespace {

std::vector<std::string> contacts_without_figure(const Result& result) {
  std::vector<std::string> notes;
  for (const Interface i : kInterfaces)
    if (!result.contacts.interfaces[i].geometry.ok())
      notes.push_back(fmt::format("pictures of the contacts were not drawn: the {} threads have no contact point ({})",
                                  label(i), failure(result.contacts, i).message));
  return notes;
}

constexpr std::string_view kContactResponses[] = {"contact.screw.normal_angle_deg",
                                                  "contact.nut.normal_angle_deg",
                                                  "contact.screw.hertz_constant_N_per_mm1_5",
                                                  "contact.nut.hertz_constant_N_per_mm1_5",
                                                  "screw.peak_pressure_MPa.max",
                                                  "nut.peak_pressure_MPa.max"};

/// Largest number of cases for which documents contain the histories.
constexpr std::size_t kMostHistories = 100;

std::vector<Place> joined(std::vector<Place> first, std::initializer_list<Place> others) {
  first.insert(first.end(), others);
  return first;
}

template <Interface interface>
std::string most_loaded_thread(const LoadCaseResult& result) {
  return most_loaded_cell(result, interface);
}

constexpr CaseColumn kColumns[] = {
    {"", "load case", true, case_name_cell},
    {"force", "kN", false, force_cell},
    {"", "direction", true, direction_cell},
    {"stiffness", "N/µm", false, stiffness_cell},
    {"displ.", "µm", false, displacement_cell},
    {"screw max.", "thread: %", false, most_loaded_thread<Interface::screw>},
    {"nut max.", "thread: %", false, most_loaded_thread<Interface::nut>},
    {"pressure", "max. GPa", true, pressure_cell},
};

std::vector<double> percent(const std::vector<double>& rates) {
  std::vector<double> shown;
  for (const double rate : rates) shown.push_back(rate * "%"_per_si);
  return shown;
}

}  // namespace

std::vector<OutputFile> load_files(const Result& result, const CsvStyle& style) {
  std::vector<OutputFile> files{{"load_cases.csv", load_cases_csv(result, style)},
                                {"load_distribution.csv", load_distribution_csv(result, style)}};
  append(files, travel_files(result, style));
  return files;
}

std::vector<OutputFile> travel_files(const Result& result, const CsvStyle& style) {
  const auto has_travel = [](const LoadCaseResult& r) {
    return r.full && r.full->travel && r.full->travel->converged();
  };
  if (std::ranges::none_of(result.load_cases, has_travel)) return {};
  CsvRows positions(style), threads(style);
  for (const LoadCaseResult& r : result.load_cases) {
    if (!has_travel(r)) continue;
    const TravelResult& t = *r.full->travel;
    const std::vector<double> deviation = t.deviation();
    for (const auto k : indices(t.angle)) {
      positions.load_case(r.load_case);
      positions("angle_deg", t.angle[k]);
      positions("deviation_um", deviation[k]);
      positions("tangent_stiffness_N_per_um", entry_if_any(t.tangent_stiffness, k));
      positions("end_y_um", t.end_displacement[k].y);
      positions("end_z_um", t.end_displacement[k].z);
      positions("end_theta_y_mrad", t.end_rotation[k].y);
      positions("end_theta_z_mrad", t.end_rotation[k].z);
      positions("nut_x_N", t.nut.force[k][0]);
      positions("nut_y_N", t.nut.force[k][1]);
      positions("nut_z_N", t.nut.force[k][2]);
      positions("nut_moment_y_Nm", t.nut.moment[k].y);
      positions("nut_moment_z_Nm", t.nut.moment[k].z);
      positions.end_row();
    }
    for (const Interface i : kInterfaces)
      for (const auto j : indices(t.loads[i].mean))
        for (const auto k : indices(t.loads[i].mean[j])) {
          threads.load_case(r.load_case);
          threads("interface", name(i));
          threads("roller", j + 1);
          threads("thread", k + 1);
          threads("mean_normal_load_N", t.loads[i].mean[j][k]);
          threads("ripple_normal_load_N", t.loads[i].ripple[j][k]);
          threads.end_row();
        }
  }
  return {{"travel.csv", positions.take()}, {"travel_loads.csv", threads.take()}};
}

bool all_converged(const Result& result) {
  return std::ranges::all_of(result.load_cases, [](const LoadCaseResult& r) { return r.converged() && travels(r); });
}

std::vector<std::string> summary_of_warnings(const Result& result) {
  std::string text = warning_summary(all_warnings(result));
  return text.empty() ? std::vector<std::string>{} : std::vector{std::move(text)};
}

const Analysis<Result>& contact_analysis() {
  static const std::vector<Place> places = with_loads();
  static const Analysis<Result> analysis{
      .command = Command::contact,
      .help = "Contact points, backlash, curvatures, ellipses, pictures",
      .file = "contact.json",
      .run = [](const input::Source&, const input::CaseInput& in) { return analyze_contacts(in.values); },
      .places = places,
      .put = put_loads,
      .load_case = load_case_json,
      .table = contact_table,
      .notes = summary_of_warnings,
      .pictures = [](const Result& r, const Case& c) { return with_drawings(contact_pictures(r), c, r); },
      .without_figure = contacts_without_figure,
      .criteria = load_criteria,
      .all_warnings = all_warnings,
      .responses = kContactResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

void put_contacts(Json& document, const Contacts& contacts) {
  document["contact"] = object_of(contacts);
  if (Json threads = object_of(contacts.threads); !threads.empty()) document["threads"] = std::move(threads);
}

void put_loads(Json& document, const Result& result) {
  if (result.contacts.threads.centre_distance > 0.0) put_contacts(document, result.contacts);
  if (has_solved(result)) document["model"] = object_of(ModelSummary{&result});
  document["load_cases"] = Json::array();
}

std::optional<Json> load_case_json(const Result& result, std::size_t k) {
  if (k >= result.load_cases.size()) return std::nullopt;
  Json json = object_of(result.load_cases[k]);
  if (result.load_cases.size() > kMostHistories) json.erase("newton_history");
  return json;
}

std::vector<Place> with_contacts(std::initializer_list<Place> places) {
  return joined({{"contact", describe<Contacts>}, {"threads", describe<contact::MechanismGeometry>, false}}, places);
}

std::vector<Place> with_loads(std::initializer_list<Place> places) {
  return joined({{"contact", describe<Contacts>, false},
                 {"threads", describe<contact::MechanismGeometry>, false},
                 {"model", describe<ModelSummary>, false},
                 {"load_cases[]", describe<LoadCaseResult>}},
                places);
}

std::string load_case_table(const Result& result) {
  std::string model = model_line(result);
  if (!model.empty())
    model = wrapped(fmt::format("{}; thread loads {}", model.substr(0, model.size() - 1), state_of_loads(result)), "",
                    kTableWidth);
  const std::string table = model + case_table({kColumns, 3, not_converged, "load_cases.csv"}, result.load_cases);
  return table + warning_section(all_warnings(result));
}

std::string load_distribution_chart(const LoadCaseResult& result) {
  const std::string title = case_name_cell(result);
  if (!result.threads) return fmt::format("{}: no load distribution ({})\n", title, status_name(result));

  const bool rollers = result.full != nullptr;
  PerInterface<std::vector<double>> shares;
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*result.threads)[i];
    shares[i] = percent(rollers ? loads.rollers->share : loads.load_rate);
  }
  const double mean = "%"_per_si / static_cast<double>(shares.screw.size());
  return fmt::format("{}: share of each {}, mean {:.2f} %\n", title, rollers ? "roller" : "thread", mean) +
         bar_chart(shares, 2, "%");
}

std::string load_cases_csv(const Result& result, const CsvStyle& style) {
  CsvRows csv(style);
  for (const LoadCaseResult& r : result.load_cases) {
    csv.load_case(r.load_case);
    csv.record("", r, "converged");
    for (const Interface i : kInterfaces) {
      const InterfaceLoads loads = r.threads ? (*r.threads)[i] : InterfaceLoads{};
      const auto field = [&](std::string_view key, const auto& value) {
        csv(fmt::format("{}_{}", name(i), key), value);
      };
      const auto thread = index_of_largest(loads.load_rate);
      const auto row = static_cast<std::size_t>(std::max(loads.threads_per_roller, 0));
      field("most_loaded_thread", thread ? std::optional((row ? *thread % row : *thread) + 1) : std::nullopt);
      field("largest_load_rate_percent", entry_if_any(loads.load_rate, thread));
      field("largest_peak_pressure_MPa", entry_if_any(loads.peak_pressure, index_of_largest(loads.peak_pressure)));
    }
    csv("loads", name(r.loads));
    csv.record("running_", r.running);
    const auto* at_rest = r.running && r.running->converged() ? &r.running->at_rest : nullptr;
    for (const Interface i : kInterfaces)
      csv(fmt::format("static_{}_largest_normal_load_N", name(i)),
          at_rest ? std::optional(at_rest->largest_normal_load[i]) : std::nullopt);
    csv.record("static_", at_rest);
    csv.end_row();
  }
  return csv.take();
}

std::string load_distribution_csv(const Result& result, const CsvStyle& style) {
  CsvRows csv(style);
  const bool all_rollers =
      std::ranges::any_of(result.load_cases, [](const LoadCaseResult& r) { return r.full != nullptr; });
  const auto add_row = [&](const LoadCaseResult& r, const PerInterface<InterfaceLoads>& loads, std::size_t k) {
    csv.load_case(r.load_case);
    const auto row = static_cast<std::size_t>(loads.screw.threads_per_roller);
    if (all_rollers) csv("roller", row ? std::optional(k / row + 1) : std::nullopt);
    csv("thread", row ? k % row + 1 : k + 1);
    for (const Interface i : kInterfaces) csv.series(fmt::format("{}_", name(i)), loads[i], k);
    csv("loads", name(r.loads));
    csv.end_row();
  };
  add_row({}, {}, 0);
  csv.drop_rows();
  for (const LoadCaseResult& r : result.load_cases)
    if (r.threads)
      for (const auto k : indices(r.threads->screw.axial_load)) add_row(r, *r.threads, k);
  return csv.take();
}

namespace {

using contact::Thread;
using contact::ThreadSurface;

constexpr std::size_t kNameWidth = 16;
constexpr TableRows kRows{38, 16};
constexpr TableRows kLoadRows{25, 8, 1};

// The mechanism, one column per part.

std::string mechanism_line(const Contacts& contacts) {
  const Mechanism& m = contacts.mechanism;
  return fmt::format(
      "{} roller screw, {}-handed, lead {:.6g} {}, {} roller{} ({} fit)\n"
      "centre distance {}\n",
      capitalised(std::string(contact::facts_of(m.type).name)), m.lead < 0.0 ? "left" : "right",
      shown(std::abs(m.lead), "mm"), table_unit("mm").text, m.rollers, m.rollers == 1 ? "" : "s",
      contact::largest_roller_count(contacts.threads), fixed_with_unit(contacts.threads.centre_distance, "mm", 4));
}

using Number = std::optional<double>;

struct PartRow {
  std::string_view label;  ///< Label with the unit of documents at its end.
  std::string_view unit;
  Number (*value)(const Thread&);
};

constexpr PartRow kPartRows[] = {
    {"  pitch diameter, mm", "mm", [](const Thread& t) { return Number(2.0 * t.pitch_radius); }},
    {"  helix angle, deg", "deg", [](const Thread& t) { return Number(ThreadSurface(t).helix_angle()); }},
    {"  flank from radius, mm", "mm", [](const Thread& t) { return Number(contact::flank_limits(t).smallest); }},
    {"  flank to radius, mm", "mm", [](const Thread& t) { return Number(contact::flank_limits(t).largest); }},
    {"  crest width, mm", "mm", [](const Thread& t) { return thread_widths(t).value_or(ThreadWidths{}).crest; }},
    {"  root width, mm", "mm", [](const Thread& t) { return thread_widths(t).value_or(ThreadWidths{}).root; }},
};

std::string part_rows(const contact::MechanismGeometry& threads) {
  std::string rows = kRows("Threads", {"screw", "roller", "nut"});
  for (const auto& [label, unit, value] : kPartRows) {
    std::vector<std::string> cells;
    for (const Thread* thread : {&threads.screw, &threads.roller, &threads.nut})
      cells.push_back(fixed(value(*thread), unit, 4));
    if (std::ranges::count(cells, kAbsent) < 3) rows += kRows(with_table_unit(label), cells);
  }
  return rows;
}

// A row of the contacts, one column per interface.

struct ContactRow {
  std::string_view key;
  int decimals;
};

constexpr ContactRow kContactRows[] = {
    {"radius_on_body_mm", 4},          {"radius_on_roller_mm", 4},        {"angle_on_body_deg", 4},
    {"angle_on_roller_deg", 4},        {"normal_angle_deg", 4},           {"backlash_mm", 4},
    {"flank_clearance_mm", 4},         {"body_crest_clearance_mm", 4},    {"roller_crest_clearance_mm", 4},
    {"body_curvatures_per_mm", 6},     {"roller_curvatures_per_mm", 6},   {"relative_curvatures_per_mm", 6},
    {"curvature_sum_per_mm", 6},       {"first_directions_angle_deg", 4}, {"ellipticity", 6},
    {"hertz_constant_N_per_mm1_5", 1},
};

/// One number or both of a pair, in SI.
std::array<Number, 2> values_of(const Contacts& contacts, Interface i, const Quantity<ContactAt>& q) {
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
  std::string rows = kRows("Contacts", {label(Interface::screw), label(Interface::nut)});
  for (const auto& [key, decimals] : kContactRows) {
    const auto& q = quantity<ContactAt>(key);
    const std::string_view unit = q.unit.text;
    std::string label = fmt::format("  {}{}{}", title_of(q), unit.empty() ? "" : ", ", unit);
    const auto screw = values_of(contacts, Interface::screw, q), nut = values_of(contacts, Interface::nut, q);
    for (const auto k : indices(screw))
      if (screw[k] || nut[k])
        rows += kRows(with_table_unit(std::exchange(label, "")),
                      {fixed(screw[k], unit, decimals), fixed(nut[k], unit, decimals)});
  }
  return rows;
}

/// A thread's value under load, for load cases with equal shares, one row per interface: all threads of such a case
/// have the same.
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

Number value(const LoadCaseResult& result, Interface i, const LoadColumn& column) {
  const std::span<const double> values = column.of().value.series((*result.threads)[i]);
  return values.empty() ? std::nullopt : Number(values.front());
}

/// All load cases or, for long ranges, the first, middle and last.
Cases shown_cases(const std::vector<LoadCaseResult>& results, std::size_t& count) {
  Cases shown;
  count = 0;
  for (const CaseGroup& group : group_cases(results)) {
    Cases equal;
    std::ranges::copy_if(group.cases, std::back_inserter(equal),
                         [](const LoadCaseResult* result) { return has_equal_shares(*result); });
    count += equal.size();
    if (results.size() > kMaxUnfoldedCases && equal.size() > 3)
      equal = {equal.front(), equal[equal.size() / 2], equal.back()};
    shown.insert(shown.end(), equal.begin(), equal.end());
  }
  return shown;
}

std::string load_table(const std::vector<LoadCaseResult>& results) {
  std::size_t count = 0;
  const Cases cases = shown_cases(results, count);
  if (cases.empty()) return {};
  std::vector<LoadColumn> columns;
  std::vector<std::string> titles, units;
  for (const LoadColumn& column : kLoadColumns) {
    if (std::ranges::none_of(cases, [&](const LoadCaseResult* c) {
          return value(*c, Interface::screw, column) || value(*c, Interface::nut, column);
        }))
      continue;
    columns.push_back(column);
    titles.emplace_back(column.title);
    units.push_back(with_table_unit(column.of().unit.text));
  }
  std::string table = "\nEqual shares of all threads\n" + kLoadRows("", titles) + kLoadRows("  load case", units);
  for (const LoadCaseResult* result : cases) {
    std::string label = fitted(printable(result->load_case.name), kNameWidth, true);
    for (const Interface i : kInterfaces) {
      std::vector<std::string> cells;
      for (const LoadColumn& column : columns)
        cells.push_back(fixed(value(*result, i, column), column.of().unit.text, column.decimals));
      table += kLoadRows(fmt::format("  {:{}} {}", std::exchange(label, ""), kNameWidth, name(i)), cells);
    }
  }
  if (cases.size() < count) table += fmt::format("  … {} of {} cases\n", cases.size(), count);
  return table;
}

}  // namespace

std::string contact_table(const Result& result) {
  const Contacts& contacts = result.contacts;
  std::string table = mechanism_line(contacts) + '\n' + part_rows(contacts.threads) + '\n' + contact_rows(contacts) +
                      load_table(result.load_cases);
  return table + warning_section(all_warnings(result));
}

}  // namespace prs
