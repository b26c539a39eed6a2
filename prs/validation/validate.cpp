#include "prs/validation/validate.h"

#include <fmt/ranges.h>

#include <iterator>

#include "prs/run/commands.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kLeastColumn = 7;  // Characters, in the text of a table.

/// Value at a path such as `load_cases[0].screw.axial_load_N[3]`.
std::optional<double> number_at(const Json& document, std::string path) {
  for (char& c : path)
    if (c == '.' || c == '[') c = '/';
  std::erase(path, ']');
  const Json::json_pointer place("/" + path);
  if (!document.contains(place) || !document.at(place).is_number()) return std::nullopt;
  return document.at(place).get<double>();
}

Json document_of(const ReferenceCase& reference, const SourceExtension& code) {
  if (reference.file.empty()) return code.formulas ? code.formulas() : Json::object();
  const Delivery found =
      run(analysis_of(reference.command), input::load_source(reference.file.string(), {}));
  Json document = found.document({});
  if (code.derived) document["derived"] = code.derived(*found.result<Result>());
  return document;
}

std::vector<Comparison> compare(const ReferenceCase& reference, const SourceExtension& code) {
  const Json document = document_of(reference, code);
  const std::string name =
      reference.file.empty() ? reference.formulas : reference.file.stem().string();
  return each(reference.values, [&](const PrintedValue& value) {
    return Comparison{name, value, number_at(document, value.quantity)};
  });
}

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void add(SourceReport& report, Supplement&& supplement) {
  append(report.statements, std::move(supplement.statements));
  append(report.tables, std::move(supplement.tables));
  append(report.figures, std::move(supplement.figures));
  append(report.files, std::move(supplement.files));
}

SourceReport report_on(const std::filesystem::path& folder,
                       const std::vector<SourceExtension>& extensions) {
  const Reference reference = read_reference(folder / "reference.yaml");
  SourceReport report;
  report.name = std::filesystem::canonical(folder).filename().string();
  report.source = reference.source;
  SourceExtension code;
  for (const SourceExtension& c : extensions)
    if (c.folder == report.name) code = c;
  for (const ReferenceCase& c : reference.cases) append(report.comparisons, compare(c, code));
  if (code.tables) report.tables = code.tables();
  if (!code.supplement) return report;
  // Left out where the reference does not hold the case that the code is about.
  const auto subject = std::ranges::find_if(reference.cases, [&](const ReferenceCase& c) {
    return code.subject.empty() ? !c.file.empty() : c.file.filename() == code.subject;
  });
  if (subject == reference.cases.end()) return report;
  const input::Source source = input::load_source(subject->file.string(), {});
  const Case c = input::read_case_input(source, subject->command).values;
  input::compute_from(source, [&] { add(report, code.supplement(c, reference)); });
  for (const PrintedStatement& s : reference.statements)
    if (std::ranges::find(report.statements, s.text, &ComparedStatement::text) ==
        report.statements.end())
      throw std::logic_error(fmt::format("{}: no code has the check {}", report.name, s.check));
  return report;
}

/// In order of `Verdict::Kind`.
constexpr std::array kVerdicts{"holds", "holds only with", "does not hold"};

const char* verdict_name(Verdict::Kind kind) {
  return kVerdicts.at(static_cast<std::size_t>(kind));
}

std::string comparison_text(const Comparison& c) {
  const PrintedValue& r = c.reference;
  std::string text = fmt::format("  {:<11} {:<22} {:<45} printed {:<11}", name(c.outcome()),
                                 r.where, r.quantity, r.printed.text);
  if (c.computed)
    text += fmt::format(" computed {:<14.8g} {} of {} digits", *c.computed,
                        r.printed.agreeing_digits(*c.computed), r.printed.digits());
  text += '\n';
  if (!r.differs.empty())
    text += wrapped(
        r.corrected ? fmt::format("{}; corrected {}", r.differs, r.corrected->text) : r.differs,
        "              ", 110);
  return text;
}

std::string value_text(const ValidationTable& table, double value) {
  return table.decimals ? fmt::format("{:.{}f}", value, *table.decimals)
                        : fmt::format("{:.6g}", value);
}

/// Columns as wide as what they hold.
std::string table_text(const ValidationTable& table) {
  std::vector<std::vector<std::string>> rows{table.columns};
  for (const ValidationTable::Row& row : table.rows) {
    rows.push_back({row.label});
    for (const double value : row.values) rows.back().push_back(value_text(table, value));
  }
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), kLeastColumn);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text = wrapped(table.title, "  ", 110);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += fmt::format(fmt::runtime(i == 0 ? "    {:<{}}" : "  {:>{}}"), row[i], widths[i]);
    text += '\n';
  }
  return text;
}

std::string statement_text(const ComparedStatement& s) {
  std::string verdict = verdict_name(s.verdict.kind);
  if (!s.verdict.only_with.empty())
    verdict += fmt::format(" {}", fmt::join(s.verdict.only_with, ", "));
  std::transform(verdict.begin(), verdict.begin() + 1, verdict.begin(),
                 [](char c) { return static_cast<char>(std::toupper(c)); });
  return wrapped(fmt::format("{}: \"{}\"", s.section, s.text), "  ", 110) +
         wrapped(verdict + ". " + s.verdict.evidence, "      ", 110) +
         (s.verdict.why.empty() ? "" : wrapped("Why: " + s.verdict.why, "      ", 110));
}

Json comparison_json(const Comparison& c) {
  const PrintedValue& r = c.reference;
  Json json{{"case", c.case_name},
            {"where", r.where},
            {"quantity", r.quantity},
            {"printed", r.printed.text},
            {"printed_digits", r.printed.digits()}};
  if (c.computed) {
    json["computed"] = *c.computed;
    json["agreeing_digits"] = r.printed.agreeing_digits(*c.computed);
  }
  json["verdict"] = name(c.outcome());
  if (!r.differs.empty()) json["reason"] = r.differs;
  if (r.corrected) json["corrected"] = r.corrected->text;
  return json;
}

}  // namespace

const char* name(Outcome outcome) {
  static constexpr std::array kNames{"reproduces", "differs", "unexpected", "missing"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

Outcome Comparison::outcome() const {
  if (!computed) return Outcome::missing;
  const bool as_printed = reference.printed.is_reproduced_by(*computed);
  if (reference.differs.empty()) return as_printed ? Outcome::reproduces : Outcome::unexpected;
  const bool as_corrected =
      !reference.corrected || reference.corrected->is_reproduced_by(*computed);
  return !as_printed && as_corrected ? Outcome::differs : Outcome::unexpected;
}

std::vector<SourceReport> validate(const std::filesystem::path& directory,
                                   const std::vector<SourceExtension>& extensions,
                                   const ValidationProgress& progress) {
  std::vector<std::filesystem::path> folders;
  if (std::filesystem::exists(directory / "reference.yaml")) folders.push_back(directory);
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (std::filesystem::exists(entry.path() / "reference.yaml")) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  std::vector<SourceReport> reports;
  for (const auto& folder : folders) {
    if (progress) progress(folder.filename().string(), reports.size(), folders.size());
    reports.push_back(report_on(folder, extensions));
  }
  return reports;
}

std::string validation_text(const std::vector<SourceReport>& reports) {
  std::string text;
  for (const SourceReport& report : reports) {
    text += fmt::format("{}: {}\n", report.name, report.source);
    std::string case_name;
    for (const Comparison& c : report.comparisons) {
      if (std::exchange(case_name, c.case_name) != c.case_name)
        text += fmt::format(" {}\n", c.case_name);
      text += comparison_text(c);
    }
    for (const ValidationTable& table : report.tables) text += table_text(table);
    for (const ComparedStatement& s : report.statements) text += statement_text(s);
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
    for (const Comparison& c : report.comparisons) source["values"].push_back(comparison_json(c));
    for (const ValidationTable& table : report.tables) {
      Json rows = Json::array();
      for (const ValidationTable::Row& row : table.rows)
        rows.push_back({{"label", row.label}, {"values", row.values}});
      source["tables"].push_back(
          {{"title", table.title}, {"columns", table.columns}, {"rows", std::move(rows)}});
    }
    for (const ComparedStatement& s : report.statements)
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
