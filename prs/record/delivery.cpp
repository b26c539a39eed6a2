#include "prs/record/delivery.h"

#include "prs/text.h"

namespace prs {
namespace {

/// Text of JSON with malformed UTF-8 replaced.
std::string dumped(const Json& document) {
  return printable_json(document.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

Json document_head(const DocumentInfo& info, const std::vector<Warning>& warnings) {
  Json document;
  document["prs_version"] = info.version;
  document["schema_version"] = info.schema_version;
  if (!info.command.empty()) document["command"] = info.command;
  if (!info.case_file.empty()) document["case_file"] = info.case_file;
  if (!info.input_sha256.empty()) document["input_sha256"] = info.input_sha256;
  if (!info.overrides.empty()) document["overrides"] = info.overrides;
  document["warnings"] = sentences(selected(warnings, false));
  if (const auto assumptions = selected(warnings, true); !assumptions.empty())
    document["assumptions"] = sentences(assumptions);
  if (info.resolved_input) document["resolved_input"] = info.resolved_input();
  return document;
}

std::string json_text(const Json& document) { return dumped(document) + '\n'; }

void write_with_list(const Json& outline, std::string_view key,
                     const std::function<std::optional<Json>(std::size_t)>& item, const TextSink& sink) {
  const std::string text = json_text(outline);
  // JSON escapes line ends in texts, so that this line can only be the key of the document.
  const std::string empty = "\n  \"" + std::string(key) + "\": []";
  const std::size_t list = text.find(empty);
  std::optional<Json> next = list == text.npos ? std::nullopt : item(0);
  if (!next) return sink(text);
  const std::size_t first = list + empty.size() - 1;
  std::string piece = text.substr(0, first) + '\n';
  for (std::size_t k = 1; next; ++k) {
    const std::string lines = dumped(*next);
    for (std::size_t at = 0, end = 0; end != lines.npos; at = end + 1) {
      end = lines.find('\n', at);
      piece.append("    ").append(lines, at, end == lines.npos ? end : end + 1 - at);
    }
    next = item(k);
    sink(piece.append(next ? ",\n" : "\n"));
    piece.clear();
  }
  sink("  " + text.substr(first));
}

void put_first(const std::vector<Warning>& values, std::vector<Warning>& warnings) {
  for (const Warning& value : values) std::erase_if(warnings, [&](const Warning& w) { return w.path == value.path; });
  warnings.insert(warnings.begin(), values.begin(), values.end());
}

std::vector<std::string> as_notes(const std::vector<Warning>& warnings) {
  std::vector<std::string> notes = sentences(selected(warnings, false));
  for (std::string& note : notes) note.insert(0, "warning: ");
  return notes;
}

}  // namespace prs
