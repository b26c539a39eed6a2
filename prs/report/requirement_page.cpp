#include "prs/report/requirement_page.h"

#include <boost/algorithm/string/replace.hpp>

#include "prs/indices.h"
#include "prs/report/glossary.h"
#include "prs/run/commands.h"
#include "prs/size/size_analysis.h"
#include "prs/text.h"
#include "prs/version.h"

namespace prs {
namespace {

constexpr std::size_t kMostShown = 50;  ///< Largest number of candidates on the page.

/// First items, one row each, with a column for each of these keys of their record.
template <class Item>
std::string items_html(const std::vector<Item>& items, std::initializer_list<std::string_view> keys) {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows(std::min(items.size(), kMostShown));
  for (const std::string_view key : keys) {
    const Quantity<Item>& q = quantity<Item>(key);
    const ReportUnit unit = report_unit(key, q.unit.text);
    head.push_back(prose_html(capitalised(title_of(q)) + (unit.text.empty() ? "" : ", ") +
                              boost::replace_all_copy(unit.text, " ", "\u00a0")));
    for (const auto k : indices(rows)) {
      Json cell;  // Cell as documents show it.
      put_quantities<Item>(cell, std::span(&q, 1), items[k]);
      rows[k].push_back(cell.empty()           ? "–"
                        : key == "reason"      ? prose_html(cell.front().get<std::string>())
                        : key == "source_name" ? breakable_html(cell.front().get<std::string>())
                                               : report_value(cell.front(), unit));
    }
  }
  return plain_table(head, rows, true);
}

std::string requirement_inputs_html(const SizeResult& r) {
  std::vector<std::vector<std::string>> rows;
  for (const input::EchoEntry& f : r.input.fields)
    rows.push_back({breakable_html(f.path), prose_html(f.written.empty() ? f.value : f.written),
                    f.is_default ? "default" : "given"});
  return folded_html("Every input", plain_table({"Input", "Value", ""}, rows));
}

std::string assumptions_html(const SizeResult& r) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& text, const std::string& about) {
    rows.push_back({prose_html(text), html(about)});
  };
  for (const std::string& text : deciding_defaults(r)) add(text, "decides");
  for (const std::string& text : sentences(r.candidates.front().warnings)) add(text, r.candidates.front().name);
  for (const std::string& text : sentences(r.warnings)) add(text, "all candidates");
  return plain_table({"Default or warning", "About"}, rows) +
         "<p>Left out: preload, side loads, shock, resonance of the drive, price, and the weight "
         "of the nut.</p>\n";
}

}  // namespace

ReportParts requirement_parts(const input::Source& source, const ReportOptions& options) {
  const SizeResult result = size_screws(read_requirement(source));
  const SizedCandidate& first = result.candidates.front();
  const std::string stem = std::filesystem::path(source.name).stem().string();
  const DocumentInfo info = document_info(source, Command::size);
  const Delivery delivery = size_delivery(result);
  ReportParts parts;
  parts.title = stem + " · which screw";
  parts.mark = stem;
  parts.head = fmt::format(
      "<p class=\"eyebrow\">Planetary roller screw · sizing</p>\n<h1>{}</h1>\n<p "
      "class=\"lead\">{}</p>\n",
      html(stem),
      result.passing() > 0 ? html(fmt::format("{} of {} candidates pass; the first is {}.", result.passing(),
                                              result.candidates.size() + result.invalid.size(), first.name))
                           : html(fmt::format("Nothing passes; the nearest is {}.", first.name)));
  const auto picture = [&](std::string_view name) {
    std::string text;
    for (const Picture& p : delivery.pictures())
      if (p.name == name)
        for (const Figure& figure : p.make({}))
          text +=
              fmt::format("<figure><figcaption>{}</figcaption><div class=\"wide\" tabindex=\"0\">{}</div></figure>\n",
                          prose_html(figure.title), svg(figure, std::string(name)));
    return text;
  };
  const MotionCycle& cycle = result.input.cycle;
  const Json requirement = object_of(RequirementOf{&result, &cycle}), candidate = object_of(first);
  parts.sections = {
      {"requirement", "Requirement",
       record_table(describe<RequirementOf>(), {{"", &requirement}}) +
           items_html(cycle.shown, {"name", "duration_s", "start_speed_mm_per_s", "end_speed_mm_per_s", "travel_mm",
                                    "axial_force_N"}) +
           requirement_inputs_html(result)},
      {"first", "First candidate: " + html(first.name),
       items_html(first.criteria, {"name", "unit", "value", "limit", "margin", "status", "reason"}) +
           picture("size_curve") + picture("size_mission") +
           folded_html("Every value", record_table(describe<SizedCandidate>(), {{"", &candidate}}))},
      {"candidates", "Candidates",
       picture("size_map") +
           items_html(result.candidates, {"rank", "name", "passes", "life_hours", "basis", "static_safety",
                                          "buckling_safety", "weight_kg", "limited_by", "source_name"}) +
           items_html(result.candidates, {"rank", "name", "type", "starts", "nut_diameter_mm", "nut_length_mm",
                                          "stiffness_N_per_um", "efficiency"}) +
           items_html(result.candidates,
                      {"rank", "name", "motor_rms_torque_Nm", "motor_peak_torque_Nm", "motor_largest_speed_rpm",
                       "motor_peak_power_W", "hottest_part_degC", "brake_needed"}) +
           picture("size_margins")},
      {"assumptions", "Assumptions and warnings", assumptions_html(result)},
      {"glossary", "Glossary",
       glossary_html({{&describe<RequirementOf>(), &requirement}, {&describe<SizedCandidate>(), &candidate}})}};
  parts.data["results"]["size"] = delivery.document(info);
  parts.shown["results"]["size"] = delivery.outline(info);
  parts.foot = fmt::format(
      "<p>Made by prs {}{}. SHA-256 of the requirement: <span class=\"mono\">{}</span>. Validation record of the "
      "models: <code>docs/validation/size.md</code></p>",
      html(kVersion), options.command.empty() ? "" : ": " + html(options.command), info.input_sha256);
  return parts;
}

}  // namespace prs
