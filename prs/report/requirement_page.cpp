#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "prs/record/pictures.h"
#include "prs/record/table_text.h"
#include "prs/report/report.h"
#include "prs/report/svg.h"
#include "prs/report/tables.h"
#include "prs/run/commands.h"
#include "prs/size/size_analysis.h"
#include "prs/version.h"

namespace prs {
namespace {

constexpr std::size_t kMostShown = 50;  ///< Candidates that the page shows.

using SizeRows = std::vector<std::vector<std::string>>;

std::string sized_number(const std::optional<double>& value, int digits = 4) {
  return html(significant(value, digits));
}

/// What was asked for, and every input with its default.
std::string requirement_html(const SizeResult& r) {
  const MotionCycle& cycle = r.input.cycle;
  SizeRows segments, inputs;
  for (const MotionSegment& s : cycle.shown)
    segments.push_back({html(s.name), sized_number(s.duration), sized_number(1e3 * s.start_speed),
                        sized_number(1e3 * s.end_speed), sized_number(1e3 * s.travel()),
                        sized_number(s.force, 6)});
  for (const input::EchoEntry& f : r.input.fields)
    inputs.push_back({html(f.path), html(f.value), f.is_default ? "default" : "given"});
  return fmt::format(
             "<p>Mean load {} N, largest force {} N, largest speed {} mm/s, {} mm of travel per "
             "cycle of {} s.</p>\n",
             sized_number(cycle.mean_load, 6), sized_number(cycle.largest_force, 6),
             sized_number(1e3 * cycle.largest_speed), sized_number(1e3 * cycle.travel),
             sized_number(cycle.duration)) +
         plain_table(
             {"Segment", "Duration, s", "From, mm/s", "To, mm/s", "Travel, mm", "Axial force, N"},
             segments, true) +
         folded_html("Every input", plain_table({"Input", "Value", ""}, inputs));
}

std::string criteria_html(const SizedCandidate& c) {
  SizeRows rows;
  for (const SizeCriterion& k : c.criteria)
    rows.push_back({html(words_of(k.name) + (k.unit.empty() ? "" : fmt::format(", {}", k.unit))),
                    sized_number(k.value, 5), sized_number(k.limit, 5), sized_number(k.margin),
                    html(words_of(name(k.status))), html(k.reason)});
  return plain_table({"Criterion", "Value", "Limit", "Margin", "", "Why"}, rows, true);
}

std::string candidates_html(const SizeResult& r) {
  SizeRows rows;
  for (const SizedCandidate& c : r.candidates) {
    if (rows.size() == kMostShown) break;
    rows.push_back({fmt::format("{}", c.rank), html(c.name), c.passes ? "passes" : "fails",
                    sized_number(c.life.hours), sized_number(c.static_safety),
                    sized_number(c.buckling_safety), sized_number(c.motor_rms_torque),
                    sized_number(c.weight), html(words_of(c.limited_by))});
  }
  return plain_table({"Rank", "Screw", "", "L10, h", "Static safety", "Buckling safety",
                      "T rms, N m", "Weight, kg", "Limited by"},
                     rows, true);
}

std::string assumptions_html(const SizeResult& r) {
  SizeRows rows;
  for (const std::string& text : deciding_defaults(r)) rows.push_back({html(text), "decides"});
  for (const std::string& text : r.candidates.front().warnings) rows.push_back({html(text), ""});
  for (const std::string& text : sentences(r.warnings)) rows.push_back({html(text), ""});
  return plain_table({"Default or warning", ""}, rows) +
         "<p>Left out: preload, side loads, shock, resonance of the drive, price, and the weight "
         "of "
         "the nut.</p>\n";
}

}  // namespace

ReportParts requirement_parts(const input::Source& source, const ReportOptions& options) {
  const SizeResult result = size_screws(read_requirement(source));
  const SizedCandidate& first = result.candidates.front();
  const std::string stem = std::filesystem::path(source.name).stem().string();
  ReportParts parts;
  parts.title = stem + " · which screw";
  parts.mark = stem;
  parts.head = fmt::format(
      "<p class=\"eyebrow\">Planetary roller screw · sizing</p>\n<h1>{}</h1>\n<p "
      "class=\"lead\">{}</p>\n",
      html(stem),
      result.passing() > 0
          ? html(fmt::format("{} of {} candidates pass; the first is {}.", result.passing(),
                             result.candidates.size() + result.invalid.size(), first.name))
          : html(fmt::format("Nothing passes; the nearest is {}.", first.name)));
  const auto picture = [&](std::string_view name) {
    std::string text;
    for (const Picture& p : size_pictures(result))
      if (p.name == name)
        for (const Figure& figure : p.make({}))
          text += "<figure>" + svg(figure, std::string(name)) + "</figure>\n";
    return text;
  };
  parts.sections = {{"requirement", "Requirement", requirement_html(result)},
                    {"first", "First candidate: " + html(first.name),
                     criteria_html(first) + picture("size_curve")},
                    {"candidates", "Candidates",
                     picture("size_map") + candidates_html(result) + picture("size_margins")},
                    {"assumptions", "Assumptions and warnings", assumptions_html(result)}};
  DocumentInfo info = document_info(source, Command::size);
  const Delivery delivery = size_delivery(result);
  parts.data["results"]["size"] = delivery.document(info);
  parts.shown["results"]["size"] = delivery.outline(info);
  parts.foot = fmt::format(
      "<p>Made by prs {}{}. SHA-256 of the requirement: <span "
      "class=\"mono\">{}</span></p>",
      html(kVersion), options.command.empty() ? "" : ": " + html(options.command),
      info.input_sha256);
  return parts;
}

}  // namespace prs
