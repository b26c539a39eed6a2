#include "prs/validation/validate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prs/analyze.h"
#include "prs/input/reader.h"
#include "prs/output/json.h"
#include "prs/output/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Value at a path such as `load_cases[0].screw.axial_load_N[3]`.
std::optional<double> number_at(const Json& document, std::string path) {
  for (char& c : path)
    if (c == '.' || c == '[') c = '/';
  std::erase(path, ']');
  const Json::json_pointer pointer("/" + path);
  if (!document.contains(pointer) || !document.at(pointer).is_number()) return std::nullopt;
  return document.at(pointer).get<double>();
}

SourceReport report_on(const std::filesystem::path& folder, const StatementJudges& judges) {
  const Reference reference = read_reference(folder / "reference.yaml");
  const Case c = input::read_case(reference.case_file.string(), {}, Command::solve);
  SourceReport report;
  report.name = folder.filename().string();
  report.source = reference.source;
  const Json document = to_json(analyze(c), {});
  for (const PrintedValue& value : reference.values)
    report.comparisons.push_back({value, number_at(document, value.quantity)});
  for (const auto& [name, judge] : judges)
    if (name == report.name) report.statements = judge(c);
  return report;
}

const char* verdict_name(const Comparison& c) {
  if (!c.computed) return "missing";
  if (c.unexpected()) return "unexpected";
  return c.reproduces() ? "reproduces" : "differs";
}

const char* verdict_name(Verdict::Kind kind) {
  switch (kind) {
    case Verdict::Kind::holds:
      return "holds";
    case Verdict::Kind::holds_only_with:
      return "holds only with";
    case Verdict::Kind::does_not_hold:
      return "does not hold";
  }
  return "";
}

std::string comparison_text(const Comparison& c) {
  const PrintedValue& r = c.reference;
  std::string text = fmt::format("  {:<11} {:<15} {:<45} printed {:<10}", verdict_name(c), r.where,
                                 r.quantity, r.printed);
  if (c.computed)
    text += fmt::format(" computed {:.8g} ({:+.2e})", *c.computed, *c.computed / r.value() - 1.0);
  text += '\n';
  if (!r.differs.empty()) text += wrapped(r.differs, "              ", 110);
  return text;
}

std::string statement_text(const JudgedStatement& s) {
  std::string verdict = verdict_name(s.verdict.kind);
  if (!s.verdict.only_with.empty())
    verdict += fmt::format(" {}", fmt::join(s.verdict.only_with, ", "));
  std::transform(verdict.begin(), verdict.begin() + 1, verdict.begin(),
                 [](char c) { return static_cast<char>(std::toupper(c)); });
  return wrapped(fmt::format("{}: \"{}\"", s.section, s.text), "  ", 110) +
         wrapped(verdict + ". " + s.verdict.evidence, "      ", 110) +
         (s.verdict.why.empty() ? "" : wrapped("Why: " + s.verdict.why, "      ", 110));
}

}  // namespace

bool Comparison::reproduces() const {
  // A printed digit is rounded from a computation of unknown rounding: one part in 1e9 of slack.
  return computed &&
         std::abs(*computed - reference.value()) <= reference.half_unit() * (1.0 + 1e-9);
}

std::vector<SourceReport> validate(const std::filesystem::path& directory,
                                   const StatementJudges& judges) {
  std::vector<std::filesystem::path> folders;
  if (std::filesystem::exists(directory / "reference.yaml")) folders.push_back(directory);
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (std::filesystem::exists(entry.path() / "reference.yaml")) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  std::vector<SourceReport> reports;
  for (const auto& folder : folders) reports.push_back(report_on(folder, judges));
  return reports;
}

std::string validation_text(const std::vector<SourceReport>& reports) {
  std::string text;
  for (const SourceReport& report : reports) {
    text += fmt::format("{}: {}\n", report.name, report.source);
    for (const Comparison& c : report.comparisons) text += comparison_text(c);
    for (const JudgedStatement& s : report.statements) text += statement_text(s);
    text += '\n';
  }
  return text;
}

nlohmann::ordered_json validation_json(const std::vector<SourceReport>& reports,
                                       const DocumentInfo& info) {
  Json document = document_head(info, {});
  document["sources"] = Json::array();
  for (const SourceReport& report : reports) {
    Json source{{"name", report.name}, {"source", report.source}};
    for (const Comparison& c : report.comparisons) {
      Json json{{"where", c.reference.where},
                {"quantity", c.reference.quantity},
                {"printed", c.reference.printed}};
      if (c.computed) json["computed"] = *c.computed;
      json["verdict"] = verdict_name(c);
      if (!c.reference.differs.empty()) json["reason"] = c.reference.differs;
      source["values"].push_back(std::move(json));
    }
    for (const JudgedStatement& s : report.statements)
      source["statements"].push_back({{"section", s.section},
                                      {"text", s.text},
                                      {"verdict", verdict_name(s.verdict.kind)},
                                      {"only_with", s.verdict.only_with},
                                      {"evidence", s.verdict.evidence},
                                      {"why", s.verdict.why}});
    document["sources"].push_back(std::move(source));
  }
  return document;
}

}  // namespace prs
