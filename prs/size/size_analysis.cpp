#include "prs/size/size_analysis.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "prs/record/record_table.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// The document without its candidates.
Json outline_of(const SizeResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  for (const Quantity<SizeResult>& q : record_of<SizeResult>().quantities)
    if (q.key == "candidates")
      document[q.key] = Json::array();
    else
      put_quantities<SizeResult>(document, std::span(&q, 1), result);
  return document;
}

std::optional<Json> candidate(const SizeResult& result, std::size_t k) {
  if (k >= result.candidates.size()) return std::nullopt;
  return object_of(result.candidates[k]);
}

/// What a requirement says, and how many screws it chooses from.
Delivery checked(const input::Source& source) {
  const auto in = std::make_shared<const SizeInput>(read_requirement(source));
  auto warnings = in->warnings;
  const std::size_t count = candidates_of(*in, warnings).size();
  Delivery d{"check.json"};
  d.document = [in, warnings, count](const DocumentInfo& info) {
    Json document = document_head(info, warnings);
    document["commands"] = {{"size", {{"ready", true}, {"missing", Json::array()}}}};
    document["candidates"] = count;
    for (const input::EchoEntry& f : in->fields)
      document["input"].push_back(
          {{"path", f.path}, {"value", f.value}, {"default", f.is_default}});
    return document;
  };
  const auto table = [in, warnings, count](bool all) {
    std::string text =
        fmt::format("A requirement, ready for `prs size`: {} candidates\n\nInput\n", count);
    for (const input::EchoEntry& f : in->fields)
      if (all || !f.is_default)
        text += fmt::format("  {:<42} {}   ({})\n", f.path, f.value,
                            f.is_default ? "default" : "given");
    if (!all) text += "  defaults: with --all\n";
    return text;
  };
  d.table = [table] { return table(false); };
  d.full_table = [table] { return table(true); };
  d.warnings = [warnings] { return warnings; };
  d.notes = as_notes(warnings);
  return d;
}

}  // namespace

Delivery size_delivery(SizeResult computed, std::size_t rows) {
  const auto result = std::make_shared<const SizeResult>(std::move(computed));
  Delivery d{"size.json"};
  d.held = result;
  d.result_type = &typeid(SizeResult);
  d.outline = [result](const DocumentInfo& info) { return outline_of(*result, info); };
  d.document = [result](const DocumentInfo& info) {
    Json document = outline_of(*result, info);
    for (const SizedCandidate& c : result->candidates)
      document["candidates"].push_back(object_of(c));
    return document;
  };
  d.write = [result](const Json& outline, const TextSink& sink) {
    write_with_items(
        outline, "candidates", [&](std::size_t k) { return candidate(*result, k); }, sink);
  };
  d.table = [result, rows] { return size_table(*result, rows); };
  d.full_table = [result] { return size_table(*result, result->candidates.size()); };
  d.warnings = [result] { return result->warnings; };
  d.notes = as_notes(result->warnings);
  d.files = [result](const CsvStyle& style) {
    return std::vector<OutputFile>{{"size.csv", size_csv(*result, style)},
                                   {"size_criteria.csv", size_criteria_csv(*result, style)},
                                   {"size_segments.csv", size_segments_csv(*result, style)}};
  };
  d.pictures = [result] { return size_pictures(*result); };
  return d;
}

const OtherFile& size_file() {
  static const OtherFile file{
      .command = Command::size,
      .help = "Which screw, and which motor: candidates against a requirement",
      .name = "requirement",
      .key = "motion",
      .run =
          [](const input::Source& source) {
            return size_delivery(size_screws(read_requirement(source)));
          },
      .check = checked,
      .schema = requirement_schema,
      .resolved_input = resolved_requirement,
      .record = describe<SizeResult>,
      .result_class = "SizeResult"};
  return file;
}

}  // namespace prs
