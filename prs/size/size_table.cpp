#include <fmt/ranges.h>

#include <set>

#include "prs/loads/heat_record.h"
#include "prs/loads/warnings.h"
#include "prs/record/csv_writer.h"
#include "prs/record/quantity_csv.h"
#include "prs/record/table_text.h"
#include "prs/record/table_units.h"
#include "prs/size/size_analysis.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kNameWidth = 16, kVerdictWidth = 8, kCellWidth = 10;

/// A row of the list of candidates.
std::string line_of(const std::string& rank, std::string_view name, std::string_view verdict,
                    const std::vector<std::string>& cells, std::string_view limited_by) {
  std::string line = padded(rank, 5, false) + "  " + fitted(name, kNameWidth, true) +
                     padded(std::string(verdict), kVerdictWidth, true);
  for (const std::string& cell : cells) line += padded(cell, kCellWidth, false);
  return ended(line + "  " + std::string(limited_by));
}

std::string asked(const SizeResult& r) {
  const MotionCycle& c = r.input.cycle;
  std::vector<std::string> parts;
  if (c.mean_load) parts.push_back("mean load " + fixed_with_unit(c.mean_load, "kN", 3));
  parts.push_back("largest force " + fixed_with_unit(c.largest_force, "kN", 3));
  parts.push_back(fmt::format("largest speed {:.4g} mm/s", 1e3 * c.largest_speed));
  parts.push_back(
      fmt::format("{} per cycle of {:.4g} s", fixed_with_unit(c.travel, "mm", 0), c.duration));
  if (r.input.values.stroke)
    parts.push_back("stroke " + fixed_with_unit(r.input.values.stroke, "mm", 0));
  return hanging("Asked for: ", 11, fmt::format("{}", fmt::join(parts, ", ")));
}

std::string verdict(const SizeResult& r) {
  const std::size_t passing = r.passing(), invalid = r.invalid.size();
  const std::string refused =
      invalid == 0 ? "" : fmt::format("; {} cannot be made: see size.json", invalid);
  if (passing > 0)
    return fmt::format("{} of {} candidates pass{}\n", passing, r.candidates.size() + invalid,
                       refused);
  const SizedCandidate& nearest = r.candidates.front();
  std::vector<std::string> missed = nearest.missed();
  std::ranges::transform(missed, missed.begin(), words_of);
  std::string text =
      fmt::format("NOTHING PASSES, of {} candidates{}\n", r.candidates.size() + invalid, refused);
  text += hanging(
      "  ", 2, fmt::format("The nearest, {}, misses {}.", nearest.name, fmt::join(missed, ", ")));
  if (r.relax)
    text += hanging("  ", 2,
                    fmt::format("To relax: with {} of {:.4g} in place of {:.4g}, {} passes.",
                                words_of(r.relax->criterion), r.relax->needed, r.relax->limit,
                                r.candidates[static_cast<std::size_t>(r.relax->rank) - 1].name));
  return text;
}

/// Whether temperatures rest on conductances of still air.
bool is_rough(const SizeResult& r) {
  const auto& k = r.input.values.conductance;
  return !(k.screw_ambient && k.nut_ambient);
}

std::string row(const SizeResult& r, const SizedCandidate& c) {
  const std::optional<double> heat = c.hottest_part();
  return line_of(fmt::format("{}", c.rank), c.name, c.passes ? "passes" : "fails",
                 {significant(c.life.hours, 4), fixed(c.static_safety, 1.0, 2),
                  fixed(c.buckling_safety, 1.0, 2), fixed(c.motor_rms_torque, "N m", 2),
                  heat ? fmt::format("{:.0f}{}", *heat - 273.15, is_rough(r) ? "*" : "")
                       : std::string(kAbsent),
                  fixed(c.weight, "kg", 2)},
                 words_of(c.limited_by));
}

std::string candidate_rows(const SizeResult& r, std::size_t count) {
  std::string text =
      line_of("", "", "", {"L10", "static", "buckling", "T rms", "hottest", "weight"},
              "limited by") +
      line_of("rank", "screw", "",
              {"h", "safety", "safety", with_table_unit("N m"), "°C", with_table_unit("kg")}, "");
  for (std::size_t k = 0; k < std::min(count, r.candidates.size()); ++k)
    text += row(r, r.candidates[k]);
  if (count < r.candidates.size())
    text +=
        fmt::format("  … of {}; more with --top N, {}\n", r.candidates.size(), all_in("size.csv"));
  if (is_rough(r) && r.candidates.front().temperature)
    text += "  * of bare parts in still air: see `heat`\n";
  return text;
}

/// A bar of the margin: half of its length is 1.
std::string bar(double margin) {
  constexpr double kHalf = 10.0;
  const auto length = static_cast<std::size_t>(std::lround(std::min(margin, 2.0) * kHalf));
  std::string text;
  for (std::size_t k = 0; k < length; ++k) text += "█";
  return margin > 2.0 ? text + "▶" : text;
}

std::string criteria_rows(const SizedCandidate& c) {
  std::string text = fmt::format("{}, {:.6g} x {:.6g} mm, {} starts\n", c.name,
                                 1e3 * c.screw.screw_diameter, 1e3 * c.screw.lead, c.starts);
  text += fmt::format("  {:<30}{:>10}{:>10}{:>9}\n", "", "value", "limit", "margin");
  for (const SizeCriterion& k : c.criteria) {
    std::string line =
        "  " +
        padded(words_of(k.name) + (k.unit.empty() ? "" : fmt::format(", {}", k.unit)), 30, true);
    for (const std::optional<double>& value : {k.value, k.limit})
      line += padded(significant(value, 6), 10, false);
    line += padded(significant(k.margin, 4), 9, false) + "  ";
    if (k.status != CriterionStatus::pass) line += words_of(name(k.status)) + " ";
    line += k.margin ? bar(*k.margin) : k.reason;
    text += ended(std::move(line));
  }
  return text;
}

/// A criterion and an input whose default it rests on.
constexpr std::pair<std::string_view, std::string_view> kRestsOn[] = {
    {"life", "life.basis"},
    {"static_safety", "limits.static_safety"},
    {"static_safety", "life.basis"},
    {"buckling", "limits.buckling_safety"},
    {"buckling", "measures.shaft.ends"},
    {"critical_speed", "limits.critical_speed_share"},
    {"critical_speed", "measures.shaft.ends"},
    {"speed_times_diameter", "limits.speed_times_diameter"},
    {"efficiency", "friction"},
    {"motor_torque", "friction"},
    {"motor_peak_torque", "friction"},
    {"temperature", "friction"},
    {"temperature", "heat.ambient"},
};

}  // namespace

std::vector<std::string> deciding_defaults(const SizeResult& r) {
  std::set<std::string_view> decided;
  for (const SizedCandidate& c : r.candidates) {
    decided.insert(c.limited_by);
    for (const SizeCriterion& k : c.criteria)
      if (!k.holds()) decided.insert(k.name);
  }
  std::vector<std::string> told;
  for (const auto& [criterion, input] : kRestsOn)
    for (const input::EchoEntry& f : r.input.fields) {
      if (!f.is_default || !f.path.starts_with(input) || !decided.contains(criterion)) continue;
      std::string text = fmt::format("{}: {}", f.path, f.value);
      if (std::ranges::find(told, text) == told.end()) told.push_back(std::move(text));
    }
  return told;
}

std::string size_table(const SizeResult& r, std::size_t rows) {
  std::string text = verdict(r) + asked(r) + "\n" + candidate_rows(r, rows) + "\n" +
                     criteria_rows(r.candidates.front());
  if (const std::vector<std::string> defaults = deciding_defaults(r); !defaults.empty())
    text +=
        "\nDefaults that decide\n" + hanging("  ", 2, fmt::format("{}", fmt::join(defaults, "; ")));
  std::vector<Warning> warnings = r.warnings;
  for (const std::string& sentence : r.candidates.front().warnings)
    warnings.push_back({"", sentence, sentence});
  return text + warning_section(warnings);
}

namespace {

std::string candidates_csv(const SizeResult& r, const CsvStyle& style) {
  CsvWriter csv(style);
  scalar_header<SizedCandidate>(csv);
  scalar_header<PartNumbers>(csv, "temperature_degC.");
  scalar_header<SizedCandidate::ByThreads>(csv, "computed.");
  csv.end_row();
  for (const SizedCandidate& c : r.candidates) {
    scalar_fields<SizedCandidate>(csv, &c);
    std::optional<PartNumbers> celsius;
    if (c.temperature) celsius = celsius_of(*c.temperature);
    scalar_fields<PartNumbers>(csv, celsius ? &*celsius : nullptr);
    scalar_fields<SizedCandidate::ByThreads>(csv, &c.by_threads);
    csv.end_row();
  }
  return csv.take();
}

/// All items of all candidates, named by a column `kind`.
template <class Item>
std::string items_csv(const SizeResult& r, const std::vector<Item> SizedCandidate::*items,
                      std::string_view kind, const CsvStyle& style) {
  const std::string_view behind_name = record_of<Item>().quantities[1].key;
  CsvWriter csv(style);
  csv.fields("rank", "candidate", kind);
  scalar_header<Item>(csv, {}, behind_name);
  csv.end_row();
  for (const SizedCandidate& c : r.candidates)
    for (const Item& item : c.*items) {
      csv.fields(static_cast<std::size_t>(c.rank), c.name, std::string(item.name));
      scalar_fields<Item>(csv, &item, behind_name);
      csv.end_row();
    }
  return csv.take();
}

}  // namespace

std::vector<OutputFile> size_files(const SizeResult& r, const CsvStyle& style) {
  return {{"size.csv", candidates_csv(r, style)},
          {"size_criteria.csv", items_csv(r, &SizedCandidate::criteria, "criterion", style)},
          {"size_segments.csv", items_csv(r, &SizedCandidate::segments, "segment", style)}};
}

}  // namespace prs
