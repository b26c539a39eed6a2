#include "prs/run/compare_cases.h"

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/table_layout.h"
#include "prs/run/commands.h"
#include "prs/study/response.h"
#include "prs/text.h"

namespace prs {
namespace {

using Paths = std::vector<std::string>;

/// Numbers of a command's document that a reader compares first: of each load case, and of the whole.
struct Headlines {
  Command command;
  Paths of_load_case, of_whole = {};
};

const std::vector<Headlines>& headlines() {
  static const std::vector<Headlines> all = {
      {Command::contact, {}, {"contact.screw.backlash_mm", "contact.nut.backlash_mm"}},
      {Command::solve, default_responses(Command::solve)},
      {Command::slip, {"slip.efficiency", "slip.power_loss_W", "slip.torque_screw_Nm", "heat.temperature_degC.nut"}},
      {Command::preload, {}, {"preload.lost_motion_um"}},
      {Command::life,
       {},
       {"life.static_safety", "life.system.l10_revolutions", "life.system.l10_hours", "life.catalogue.l10_revolutions",
        "life.catalogue.l10_hours"}},
      {Command::measures, {"measures.solved_static_safety"}, {"measures.dynamic_capacity_N", "measures.weight_kg"}},
  };
  return all;
}

/// A value of both cases; absent if a case lacks it.
template <class T>
using Both = std::array<std::optional<T>, 2>;

struct InputRow {
  std::string path;
  Both<std::string> value;
  std::optional<double> change;
};

struct ResultRow {
  Command command;
  std::string load_case;  ///< Empty for the whole case.
  std::string path;
  Both<double> value;
  std::optional<double> change;
};

struct CaseComparison {
  std::array<DocumentInfo, 2> info;
  std::array<std::vector<Warning>, 2> warnings;
  std::vector<InputRow> inputs;
  std::vector<ResultRow> results;
  std::vector<std::string> notes;
  Figures figures;
  bool converged = true;
};

/// Relative change from the first to the second: 0.02 is 2 % more. Absent if the signs differ.
std::optional<double> change(const Both<double>& value) {
  if (!value[0] || !value[1] || *value[0] == 0.0 || *value[0] * *value[1] < 0.0) return std::nullopt;
  return (*value[1] - *value[0]) / std::abs(*value[0]);
}

std::optional<double> change(const input::EchoEntry& a, const input::EchoEntry& b) {
  if (a.dimension != b.dimension || (a.dimension && zero_depends_on_unit(*a.dimension))) return std::nullopt;
  return change({a.number, b.number});
}

/// Text as in the file.
std::string told(const input::EchoEntry& entry) { return entry.written.empty() ? entry.value : entry.written; }

std::vector<InputRow> differing_inputs(const std::vector<input::EchoEntry>& first,
                                       const std::vector<input::EchoEntry>& second) {
  std::map<std::string_view, const input::EchoEntry*> others;
  for (const input::EchoEntry& entry : second) others.emplace(entry.path, &entry);
  std::vector<InputRow> rows;
  for (const input::EchoEntry& entry : first) {
    const auto other = others.extract(entry.path);
    if (!other)
      rows.push_back({entry.path, {told(entry), std::nullopt}, {}});
    else if (other.mapped()->value != entry.value)
      rows.push_back({entry.path, {told(entry), told(*other.mapped())}, change(entry, *other.mapped())});
  }
  for (const input::EchoEntry& entry : second)
    if (others.contains(entry.path)) rows.push_back({entry.path, {std::nullopt, told(entry)}, {}});
  return rows;
}

std::string name_of(const Json& load_case) { return load_case.value("name", ""); }

/// Pairs of equal names, the k-th with the k-th of that name; by index if no names are equal.
std::vector<std::pair<std::size_t, std::size_t>> paired(const Json& first, const Json& second) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<bool> taken(second.size());
  for (const auto i : indices(first))
    for (const auto k : indices(second))
      if (!taken[k] && name_of(first[i]) == name_of(second[k])) {
        taken[k] = true;
        pairs.emplace_back(i, k);
        break;
      }
  if (pairs.empty())
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) pairs.emplace_back(k, k);
  return pairs;
}

/// Whether a number is compared. Among lives: with a stated capacity those of the catalogue's formula, else those of
/// the mechanism.
bool is_life_in_use(const std::string& path, const std::array<Json, 2>& documents) {
  const bool of_catalogue = path.starts_with("life.catalogue.");
  if (!of_catalogue && !path.starts_with("life.system.")) return true;
  return std::ranges::any_of(documents, [&](const Json& document) {
    const Json& capacity = document.at("life").at("capacity");
    return (capacity.value("source", "") == "given") == of_catalogue;
  });
}

void add_results(const Headlines& of, std::array<Json, 2> documents, CaseComparison& c) {
  const auto add = [&](const std::string& load_case, const std::string& path, const Json& first, const Json& second) {
    const Both<double> value{response(first, path), response(second, path)};
    if (!value[0] && !value[1]) return;
    const bool is_temperature = path.find("_degC") != std::string::npos;
    c.results.push_back({of.command, load_case, path, value, is_temperature ? std::nullopt : change(value)});
  };
  std::array<Json, 2> loads;
  for (const auto k : up_to(2)) {
    loads[k] = documents[k].value("load_cases", Json::array());
    documents[k].erase("load_cases");
  }
  for (const auto& [i, k] : paired(loads[0], loads[1])) {
    const std::string a = name_of(loads[0][i]), b = name_of(loads[1][k]);
    for (const std::string& path : of.of_load_case) add(a == b ? a : a + " / " + b, path, loads[0][i], loads[1][k]);
  }
  for (const std::string& path : of.of_whole)
    if (is_life_in_use(path, documents)) add("", path, documents[0], documents[1]);
}

void add_figures(const Figures& first, const Figures& second, const std::string& other, Figures& overlaid) {
  for (Figure figure : first) {
    const auto of_name = [&](const Figure& f) { return f.name == figure.name; };
    const auto behind = std::ranges::find_if(second, of_name);
    if (behind == second.end() || std::ranges::any_of(overlaid, of_name)) continue;
    const auto grey = add_behind(figure, *behind);
    const bool has_curves = std::ranges::any_of(figure.panels, [&](const Panel& panel) {
      return std::ranges::any_of(panel.series, [&](const Series& s) { return s.style == grey; });
    });
    if (grey && has_curves) {
      figure.legend.push_back({other, *grey});
      overlaid.push_back(std::move(figure));
    }
  }
}

CaseComparison compared(const input::Source& first, const input::Source& second) {
  CaseComparison c;
  const std::array<const input::Source*, 2> sources{&first, &second};
  std::array<input::CaseInput, 2> in;
  for (const auto k : up_to(2)) {
    in[k] = input::read_case_input(*sources[k], Command::check);
    c.info[k] = document_info(*sources[k], Command::compare);
    c.warnings[k] = analysis_of(Command::check).run(*sources[k], in[k]).warnings();
  }
  c.inputs = differing_inputs(in[0].fields, in[1].fields);
  for (const Headlines& of : headlines()) {
    const bool ready[] = {input::unmet(in[0], of.command).empty(), input::unmet(in[1], of.command).empty()};
    if (ready[0] != ready[1])
      c.notes.push_back(fmt::format("{}: {} alone has all for it; `prs check` says what to add", name(of.command),
                                    sources[ready[0] ? 0 : 1]->name));
    if (!ready[0] || !ready[1]) continue;
    std::array<Json, 2> documents;
    std::array<Figures, 2> drawn;
    for (const auto k : up_to(2)) {
      const Delivery d = analysis_of(of.command).run(*sources[k], in[k]);
      documents[k] = d.document({});
      if (d.pictures) drawn[k] = figures(d.pictures());
      c.converged = c.converged && d.converged;
    }
    add_results(of, std::move(documents), c);
    add_figures(drawn[0], drawn[1], second.name, c.figures);
  }
  return c;
}

template <class Row, std::size_t k>
constexpr auto of_value = of<[](const Row& row) { return row.value[k]; }>;

constexpr std::string_view kOfValue = "from the value to the other, of the value";

constexpr Quantity<InputRow> kInputs[] = {
    {"path", always<&InputRow::path>},
    {"value", of_value<InputRow, 0>},
    {"other_value", of_value<InputRow, 1>},
    {"change_percent", of<&InputRow::change>, kOfValue},
};

constexpr Quantity<ResultRow> kResults[] = {
    {"command", always<[](auto& row) { return name(row.command); }>},
    {"load_case", filled<&ResultRow::load_case>},
    {"path", always<&ResultRow::path>},
    {"value", of_value<ResultRow, 0>},
    {"other_value", of_value<ResultRow, 1>},
    {"change_percent", of<&ResultRow::change>, kOfValue},
};

constexpr Quantity<CaseComparison> kOther[] = {
    {"case_file", always<[](auto& c) { return c.info[1].case_file; }>},
    {"input_sha256", always<[](auto& c) { return c.info[1].input_sha256; }>},
    {"warnings", always<[](auto& c) { return sentences(c.warnings[1]); }>},
};

constexpr Quantity<CaseComparison> kComparison[] = {
    {"other", always_table<kOther>},
    {"inputs", always_table<kInputs, &CaseComparison::inputs>},
    {"results", always_table<kResults, &CaseComparison::results>},
};

Json document(const CaseComparison& c, const DocumentInfo& info) {
  Json json = document_head(info, c.warnings[0]);
  put_quantities<CaseComparison>(json, kComparison, c);
  return json;
}

std::string line(const std::string& what, const Both<std::string>& value, const std::optional<double>& change) {
  constexpr std::size_t kName = 50, kValue = 21, kChange = 11;
  std::string text = "  " + fitted(printable(what), kName, true);
  for (const auto& v : value) text += "  " + fitted(v ? printable(*v) : std::string(kAbsent), kValue);
  return ended(text + padded(change ? fixed_change(100.0 * *change, 2) + " %" : "", kChange, false));
}

std::string table(const CaseComparison& c) {
  std::string text = line("", {c.info[0].case_file, c.info[1].case_file}, {});
  text += c.inputs.empty() ? "Inputs do not differ\n" : "Inputs that differ\n";
  for (const InputRow& row : c.inputs) text += line(row.path, row.value, row.change);
  const ResultRow* before = nullptr;
  for (const ResultRow& row : c.results) {
    if (!before || before->command != row.command || before->load_case != row.load_case)
      text += fmt::format("\n{}{}{}\n", name(row.command), row.load_case.empty() ? "" : ": ", printable(row.load_case));
    before = &row;
    const TableResponse shown = table_response(row.path);
    Both<std::string> value;
    for (const auto k : up_to(2))
      if (row.value[k]) value[k] = significant(shown.factor * *row.value[k]);
    text += line(shown.text(), value, row.change);
  }
  if (!c.notes.empty()) text += '\n';
  for (const std::string& note : c.notes) text += wrapped(printable(note), "", kTableWidth);
  for (const auto k : up_to(2)) {
    std::string alone;
    const std::vector<std::string> others = sentences(c.warnings[1 - k]);
    for (const std::string& warning : sentences(c.warnings[k]))
      if (!contains(others, warning)) alone += wrapped(printable(warning), "  ", kTableWidth);
    if (!alone.empty()) text += fmt::format("\nWarnings of {} alone\n{}", printable(c.info[k].case_file), alone);
  }
  return text;
}

std::string csv(const CaseComparison& c, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("command", "load_case", "path", "value", "other_value", "change_percent");
  for (const InputRow& row : c.inputs)
    csv.row("input", "", row.path, row.value[0].value_or(""), row.value[1].value_or(""), scaled(row.change, 100.0));
  for (const ResultRow& row : c.results)
    csv.row(name(row.command), row.load_case, row.path, row.value, scaled(row.change, 100.0));
  return csv.take();
}

}  // namespace

const RecordInfo& case_comparison_record() {
  static const RecordInfo info = described<CaseComparison>({}, {}, kComparison);
  return info;
}

Delivery compare_cases(const input::Source& first, const input::Source& second) {
  const auto c = std::make_shared<const CaseComparison>(compared(first, second));
  Delivery d{"comparison.json", [=](const DocumentInfo& info) { return document(*c, info); }, [=] { return table(*c); },
             c->notes, [=] { return c->warnings[0]; }};
  d.files = [=](const CsvStyle& style) { return std::vector<OutputFile>{{"differences.csv", csv(*c, style)}}; };
  d.pictures = [=] { return Pictures{{"curves", "two cases", [=](const FigureOptions&) { return c->figures; }}}; };
  d.converged = c->converged;
  return d;
}

}  // namespace prs
