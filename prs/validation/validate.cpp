#include "prs/validation/validate.h"

#include <fmt/ranges.h>

#include <charconv>
#include <fstream>

#include "modules/module.h"
#include "prs/run/commands.h"
#include "prs/sha256.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kLeastColumn = 7;  // Width in characters, in the text of a table.

/// Value at a path such as `load_cases[0].screw.axial_load_N[3]`.
std::optional<double> number_at(const Json& document, std::string path) {
  for (char& c : path)
    if (c == '.' || c == '[') c = '/';
  std::erase(path, ']');
  const Json::json_pointer place("/" + path);
  if (!document.contains(place) || !document.at(place).is_number()) return std::nullopt;
  return document.at(place).get<double>();
}

Json document_of(const ReferenceCase& reference, const Reference& source, const SourceExtension& code) {
  if (reference.file.empty()) return code.formulas ? code.formulas(source) : Json::object();
  const Delivery found = run(analysis_of(reference.command), input::load_source(reference.file.string(), {}));
  Json document = found.document({});
  if (code.derived) document["derived"] = code.derived(*found.result<Result>());
  return document;
}

std::vector<Comparison> compare(const ReferenceCase& reference, const Reference& source, const SourceExtension& code) {
  bool is_built = code.is_built;
  Json document = Json::object();
  try {
    document = document_of(reference, source, code);
  } catch (const modules::NotBuilt&) {
    is_built = false;
  }
  const std::string name = reference.file.empty() ? reference.formulas : reference.file.stem().string();
  return each(reference.values, [&](const PrintedValue& value) {
    return Comparison{name, value, number_at(document, value.quantity), is_built};
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
  append(report.not_built, std::move(supplement.not_built));
}

std::string hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return sha256(std::string(std::istreambuf_iterator<char>(in), {}));
}

SourceReport report_on(const std::filesystem::path& folder, const std::vector<SourceExtension>& extensions) {
  const Reference reference = read_reference(folder / "reference.yaml");
  SourceReport report;
  report.name = std::filesystem::canonical(folder).filename().string();
  report.source = reference.source;
  SourceExtension code;
  for (const SourceExtension& c : extensions)
    if (c.folder == report.name) code = c;
  report.data = reference.data.size();
  for (const auto& [file, hash] : reference.data)
    if (hash_of(folder / file) != hash) report.changed_data.push_back(file);
  for (const ReferenceCase& c : reference.cases) append(report.comparisons, compare(c, reference, code));
  if (!code.is_built && !reference.statements.empty())
    report.not_built.push_back(fmt::format("{} statements in words", reference.statements.size()));
  if (code.tables) report.tables = code.tables(reference);
  if (!code.supplement) return report;
  // Left out if the reference does not have the case of the code.
  const auto subject = std::ranges::find_if(reference.cases, [&](const ReferenceCase& c) {
    return code.subject.empty() ? !c.file.empty() : c.file.filename() == code.subject;
  });
  if (subject == reference.cases.end()) return report;
  const input::Source source = input::load_source(subject->file.string(), {});
  const Case c = input::read_case_input(source, subject->command).values;
  input::compute_from(source, [&] { add(report, code.supplement(c, reference)); });
  for (const PrintedStatement& s : reference.statements)
    if (std::ranges::find(report.statements, s.text, &ComparedStatement::text) == report.statements.end())
      throw std::logic_error(fmt::format("{}: no code has the check {}", report.name, s.check));
  return report;
}

/// Words in the order of `Verdict::Kind`.
constexpr std::array<std::string_view, 3> kVerdicts{"holds", "holds only with", "does not hold"};

std::string_view verdict_name(Verdict::Kind kind) { return kVerdicts.at(static_cast<std::size_t>(kind)); }

std::string comparison_text(const Comparison& c) {
  const PrintedValue& r = c.reference;
  std::string text =
      fmt::format("  {:<11} {:<22} {:<45} printed {:<11}", name(c.outcome()), r.where, r.quantity, r.printed.text);
  if (c.computed)
    text += fmt::format(" computed {:<14.8g} {} of {} digits", *c.computed, r.printed.agreeing_digits(*c.computed),
                        r.printed.digits());
  text += '\n';
  if (!r.differs.empty())
    text += wrapped(r.corrected ? fmt::format("{}; corrected {}", r.differs, r.corrected->text) : r.differs,
                    "              ", 110);
  return text;
}

std::string value_text(const ValidationTable& table, double value) {
  return table.decimals ? fmt::format("{:.{}f}", value, *table.decimals) : fmt::format("{:.6g}", value);
}

/// Columns as wide as their contents.
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
  std::string verdict(verdict_name(s.verdict.kind));
  if (!s.verdict.only_with.empty()) verdict += fmt::format(" {}", fmt::join(s.verdict.only_with, ", "));
  std::transform(verdict.begin(), verdict.begin() + 1, verdict.begin(),
                 [](char c) { return static_cast<char>(std::toupper(c)); });
  return wrapped(fmt::format("{}: \"{}\"", s.section, s.text), "  ", 110) +
         wrapped(verdict + ". " + s.verdict.evidence, "      ", 110) +
         (s.unexpected() ? fmt::format("      CHANGED: on record it {}\n", verdict_name(s.expected)) : "") +
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
  static constexpr std::array kNames{"reproduces", "differs", "unexpected", "missing", "not_computed"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

Outcome Comparison::outcome() const {
  if (!computed) return is_built ? Outcome::missing : Outcome::not_built;
  const bool as_printed = reference.printed.is_reproduced_by(*computed);
  if (reference.differs.empty()) return as_printed ? Outcome::reproduces : Outcome::unexpected;
  const bool as_recorded = std::abs(reference.printed.off(*computed) - reference.off) <= 1.0 &&
                           (!reference.corrected || reference.corrected->is_reproduced_by(*computed));
  return !as_printed && as_recorded ? Outcome::differs : Outcome::unexpected;
}

std::vector<SourceReport> validate(const std::filesystem::path& directory,
                                   const std::vector<SourceExtension>& extensions, const ValidationProgress& progress) {
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
      if (std::exchange(case_name, c.case_name) != c.case_name) text += fmt::format(" {}\n", c.case_name);
      text += comparison_text(c);
    }
    for (const ValidationTable& table : report.tables) text += table_text(table);
    for (const ComparedStatement& s : report.statements) text += statement_text(s);
    for (const std::string& file : report.changed_data)
      text += fmt::format("  CHANGED: {} is not the file whose SHA-256 is on record\n", file);
    if (!report.not_built.empty())
      text += wrapped(fmt::format("Not computed, because not built: {}; scripts/install.sh builds all.",
                                  fmt::join(report.not_built, ", ")),
                      "  ", 110);
    text += '\n';
  }
  return text + summary(reports).text() + '\n';
}

ValidationSummary summary(const std::vector<SourceReport>& reports) {
  ValidationSummary all;
  const auto count = [&](bool is_changed, bool holds) {
    ++(is_changed ? all.changed : holds ? all.hold : all.known_not_to);
  };
  for (const SourceReport& report : reports) {
    for (const Comparison& c : report.comparisons)
      if (c.outcome() == Outcome::not_built)
        ++all.not_built;
      else
        count(c.unexpected(), c.outcome() == Outcome::reproduces);
    for (const ComparedStatement& s : report.statements) count(s.unexpected(), s.verdict.kind == Verdict::Kind::holds);
    all.hold += report.data - report.changed_data.size();
    all.changed += report.changed_data.size();
  }
  all.compared = all.hold + all.known_not_to + all.changed;
  return all;
}

std::string ValidationSummary::text() const {
  return fmt::format("Compared {} numbers, statements and files: {} hold, {} {} known not to, {} changed{}.", compared,
                     hold, known_not_to, known_not_to == 1 ? "is" : "are", changed,
                     not_built == 0 ? "" : fmt::format("; {} not computed, because not built", not_built));
}

nlohmann::ordered_json validation_json(const std::vector<SourceReport>& reports, const DocumentInfo& info) {
  Json document = document_head(info, {});
  const ValidationSummary all = summary(reports);
  document["summary"] = {{"compared", all.compared}, {"hold", all.hold},           {"known_not_to", all.known_not_to},
                         {"changed", all.changed},   {"not_built", all.not_built}, {"text", all.text()}};
  document["sources"] = Json::array();
  for (const SourceReport& report : reports) {
    Json source{{"name", report.name}, {"source", report.source}};
    for (const Comparison& c : report.comparisons) source["values"].push_back(comparison_json(c));
    for (const ValidationTable& table : report.tables) {
      Json rows = Json::array();
      for (const ValidationTable::Row& row : table.rows) rows.push_back({{"label", row.label}, {"values", row.values}});
      source["tables"].push_back({{"title", table.title}, {"columns", table.columns}, {"rows", std::move(rows)}});
    }
    for (const ComparedStatement& s : report.statements)
      source["statements"].push_back({{"section", s.section},
                                      {"text", s.text},
                                      {"verdict", verdict_name(s.verdict.kind)},
                                      {"recorded", verdict_name(s.expected)},
                                      {"only_with", s.verdict.only_with},
                                      {"evidence", s.verdict.evidence},
                                      {"why", s.verdict.why}});
    for (const std::string& file : report.changed_data) source["changed_files"].push_back(file);
    for (const std::string& what : report.not_built) source["not_computed"].push_back(what);
    document["sources"].push_back(std::move(source));
  }
  return document;
}

namespace {

using input::ErrorList;
using input::Node;
using input::parse_number;
using Keys = std::initializer_list<std::string_view>;

constexpr int kMostDecimals = 15;

/// Whether a node is a map with these keys only; missing ones are reported where they are read.
bool is_map_of(const Node& node, Keys known, ErrorList& errors) {
  if (node.kind != Node::Kind::map) {
    errors.add(node.place, node.key, "expected a map of {}", fmt::join(known, ", "));
    return false;
  }
  for (const Node& child : node.children)
    if (std::find(known.begin(), known.end(), child.key) == known.end())
      errors.add(child.key_place, child.key, "unknown key; expected one of {}", fmt::join(known, ", "));
  return true;
}

std::string optional_text(const Node& map, std::string_view key, ErrorList& errors) {
  const Node* node = input::find(map, key);
  if (node == nullptr) return {};
  if (node->kind == Node::Kind::scalar && !node->text.empty()) return node->text;
  errors.add(node->place, key, "expected a text");
  return {};
}

std::string required_text(const Node& map, std::string_view key, ErrorList& errors) {
  if (input::find(map, key) == nullptr) errors.add(map.place, key, "missing; expected a text");
  return optional_text(map, key, errors);
}

/// Items of a list, which must exist and not be empty.
const std::vector<Node>& required_list(const Node& map, std::string_view key, ErrorList& errors) {
  static const std::vector<Node> none;
  const Node* list = input::find(map, key);
  if (list != nullptr && list->kind == Node::Kind::sequence && !list->children.empty()) return list->children;
  errors.add(list != nullptr ? list->place : map.place, key, "expected a list");
  return none;
}

PrintedNumber printed_number(const Node& map, std::string_view key, ErrorList& errors) {
  PrintedNumber number{required_text(map, key, errors), {}};
  if (!number.text.empty() && !parse_number(number.text))
    errors.add(input::find(map, key)->place, key, "got {}; expected a number", input::shown(number.text));
  return number;
}

/// `{decimals: 4, because: ..}`: a precision other than the last digit's needs a reason.
std::optional<int> stated_decimals(const Node& map, ErrorList& errors) {
  const Node* precision = input::find(map, "precision");
  if (precision == nullptr || !is_map_of(*precision, {"decimals", "because"}, errors)) return {};
  required_text(*precision, "because", errors);
  const std::optional<double> decimals = parse_number(required_text(*precision, "decimals", errors));
  if (decimals && *decimals >= 0.0 && *decimals <= kMostDecimals && *decimals == std::floor(*decimals))
    return static_cast<int>(*decimals);
  errors.add(precision->place, "decimals", "expected a whole number from 0 to {}", kMostDecimals);
  return {};
}

PrintedValue read_value(const Node& node, ErrorList& errors) {
  PrintedValue value;
  if (!is_map_of(node, {"quantity", "where", "printed", "precision", "differs", "off", "corrected"}, errors))
    return value;
  value.quantity = required_text(node, "quantity", errors);
  value.where = required_text(node, "where", errors);
  value.printed = printed_number(node, "printed", errors);
  value.printed.decimals = stated_decimals(node, errors);
  value.differs = optional_text(node, "differs", errors);
  if (!value.differs.empty()) value.off = parse_number(required_text(node, "off", errors)).value_or(0.0);
  if (const Node* corrected = input::find(node, "corrected")) {
    value.corrected = printed_number(node, "corrected", errors);
    if (value.differs.empty()) errors.add(corrected->key_place, "corrected", "expected `differs` next to it: say why");
  }
  return value;
}

Command read_command(const Node& node, ErrorList& errors) {
  const std::string command = optional_text(node, "command", errors);
  if (command == "contact") return Command::contact;
  if (command == "slip") return Command::slip;
  if (!command.empty() && command != "solve")
    errors.add(input::find(node, "command")->place, "command", "got {}; expected solve | contact | slip",
               input::shown(command));
  return Command::solve;
}

ReferenceCase read_case(const Node& node, const std::filesystem::path& folder, ErrorList& errors) {
  ReferenceCase c;
  if (input::find(node, "formulas") != nullptr) {
    if (!is_map_of(node, {"formulas", "values"}, errors)) return c;
    c.formulas = required_text(node, "formulas", errors);
  } else {
    if (!is_map_of(node, {"case", "command", "values"}, errors)) return c;
    c.file = folder / required_text(node, "case", errors);
    c.command = read_command(node, errors);
  }
  for (const Node& value : required_list(node, "values", errors)) c.values.push_back(read_value(value, errors));
  return c;
}

PrintedStatement read_statement(const Node& node, ErrorList& errors) {
  if (!is_map_of(node, {"section", "text", "check", "why", "expected"}, errors)) return {};
  PrintedStatement s{required_text(node, "section", errors), required_text(node, "text", errors),
                     required_text(node, "check", errors), optional_text(node, "why", errors)};
  const std::string expected = optional_text(node, "expected", errors);
  const auto found = std::ranges::find(kVerdicts, expected);
  if (found != kVerdicts.end())
    s.expected = static_cast<Verdict::Kind>(found - kVerdicts.begin());
  else if (!expected.empty())
    errors.add(input::find(node, "expected")->place, "expected", "got {}; expected {}", input::shown(expected),
               fmt::join(kVerdicts, " | "));
  if (s.expected != Verdict::Kind::holds && s.why.empty())
    errors.add(node.place, "why", "missing; expected the reason why it does not hold");
  return s;
}

}  // namespace

double PrintedNumber::value() const { return parse_number(text).value_or(0.0); }

/// Decimal exponent of the last known digit: 3.6062e5 -> 1.
int PrintedNumber::last_place() const {
  if (decimals) return -*decimals;
  const std::size_t exponent_at = text.find_first_of("eE");
  int exponent = 0;
  if (exponent_at != std::string::npos)
    exponent = static_cast<int>(parse_number(text.substr(exponent_at + 1)).value_or(0.0));
  const std::string mantissa = text.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  if (point == std::string::npos) return exponent;
  return exponent - static_cast<int>(mantissa.size() - point - 1);
}

double PrintedNumber::off(double computed) const { return 0.5 * (computed - value()) / half_unit(); }

double PrintedNumber::half_unit() const { return 0.5 * std::pow(10.0, last_place()); }

bool PrintedNumber::is_reproduced_by(double computed) const {
  // A printed digit is rounded from a computation of unknown rounding, hence a tolerance of one part in 1e9.
  return std::abs(computed - value()) <= half_unit() * (1.0 + 1e-9);
}

int PrintedNumber::digits() const {
  const double size = std::abs(value());
  const int first_place = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) : -1;
  return std::max(first_place - last_place() + 1, 0);
}

int PrintedNumber::agreeing_digits(double computed) const {
  if (is_reproduced_by(computed)) return digits();
  const double off = std::abs(computed - value()) / half_unit();
  return std::max(digits() - static_cast<int>(std::ceil(std::log10(off))), 0);
}

Reference read_reference(const std::filesystem::path& file) {
  const input::Source source = input::load_source(file.string(), {});
  ErrorList errors(source);
  const Node root = input::read_document(source, errors);
  Reference reference{.folder = file.parent_path()};
  if (is_map_of(root, {"source", "cases", "statements", "data"}, errors)) {
    reference.source = required_text(root, "source", errors);
    for (const Node& c : required_list(root, "cases", errors))
      reference.cases.push_back(read_case(c, reference.folder, errors));
    if (input::find(root, "statements") != nullptr)
      for (const Node& s : required_list(root, "statements", errors))
        reference.statements.push_back(read_statement(s, errors));
    if (const Node* data = input::find(root, "data"))
      for (const Node& entry : data->children) reference.data.emplace(entry.key, entry.text);
  }
  errors.throw_if_any();
  return reference;
}

CsvTable::CsvTable(const std::filesystem::path& file)
    : source_(input::load_source(file.string(), {})), reader_(source_.text) {
  if (std::optional<Row> header = next_row()) header_ = std::move(header->fields);
  while (std::optional<Row> row = next_row()) {
    if (row->fields.size() != header_.size())
      fail_at(row->offset, "",
              fmt::format("got {} fields; expected {} as in the heading; complete or delete the row",
                          row->fields.size(), header_.size()));
    rows_.push_back(*std::move(row));
  }
  if (rows_.empty()) fail_at(0, "", "got no row of values; expected some below the column names; check the file");
}

std::optional<CsvTable::Row> CsvTable::next_row() {
  try {
    if (!reader_.next()) return std::nullopt;
  } catch (const input::CsvError& error) {
    fail_at(error.offset(), "", error.what());
  }
  Row row{reader_.row_offset(), {}};
  for (const std::string_view field : reader_.fields()) {
    if (field.empty())
      fail_at(reader_.field_offset(row.offset, row.fields.size()), "",
              "got an empty field; expected a value; write one");
    row.fields.emplace_back(field);
  }
  return row;
}

bool CsvTable::has_column(std::string_view name) const { return std::ranges::find(header_, name) != header_.end(); }

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::ranges::find(header_, name);
  if (found == header_.end()) fail_at(0, name, "missing; expected a column of this name");
  return static_cast<std::size_t>(found - header_.begin());
}

std::string CsvTable::text(std::size_t row, std::size_t column) const { return rows_[row].fields[column]; }

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows_[row].fields[column];
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    fail(row, column, fmt::format("got {}; expected a number", input::shown(text)));
  return value;
}

double CsvTable::half_unit(std::size_t row, std::size_t column) const {
  return PrintedNumber{rows_[row].fields[column], {}}.half_unit();
}

void CsvTable::fail(std::size_t row, std::size_t column, std::string_view message) const {
  fail_at(reader_.field_offset(rows_[row].offset, column), header_[column], message);
}

void CsvTable::fail_at(std::size_t offset, std::string_view key, std::string_view message) const {
  input::ErrorList errors(source_);
  errors.fail({offset}, key, message);
}

}  // namespace prs
