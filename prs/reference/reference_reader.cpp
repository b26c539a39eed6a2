#include "prs/reference/reference_reader.h"

#include <fmt/ranges.h>

#include <boost/algorithm/string/replace.hpp>
#include <set>

#include "prs/indices.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/field.h"
#include "prs/input/reader.h"
#include "prs/input/readings.h"
#include "prs/input/varied_input.h"
#include "prs/model/check_case.h"
#include "prs/record/response_path.h"
#include "prs/reference/referenced_analyses.h"

namespace prs {
namespace {

using input::Conversion, input::Node, input::Readings, input::ReferenceItem, input::shown;

constexpr std::size_t kMostRows = 100'000;
constexpr std::size_t kMostComputed = 1'000;  ///< Largest number of rows that each need a case of their own.
constexpr std::string_view kThread = "thread", kForce = "axial_force", kLoadCase = "load_case";

/// Responses of an analysis at a place of its document.
struct Responses {
  Command command;
  bool is_of_load_case;
  ResponsePaths paths;

  /// `screw.load_rate_percent` of `screw.load_rate_percent.max`, which is a number as well.
  bool has_number(const std::string& path) const {
    return contains(paths.numbers, path) || std::ranges::any_of(paths.series, [&](const std::string& series) {
             return path.size() > series.size() && path.starts_with(series) &&
                    summary_named(path.substr(series.size()), 1.0);
           });
  }
  bool has(const std::string& path, bool over_threads) const {
    return over_threads ? is_of_load_case && contains(paths.series, path) : has_number(path);
  }
  const std::vector<std::string>& named(bool over_threads) const { return over_threads ? paths.series : paths.numbers; }
};

/// Responses of load cases first, as `prs list responses` has them.
const std::vector<Responses>& known_responses() {
  static const std::vector<Responses> all = [] {
    constexpr std::string_view kLoadCases = "load_cases[]";
    std::vector<Responses> known;
    std::set<std::string_view> places;
    for (const AnyAnalysis& analysis : referenced_analyses())
      for (const Place& place : analysis.places) {
        if (place.path == "model" || !places.insert(place.path).second) continue;
        Responses& of = known.emplace_back(Responses{analysis.command, place.path.starts_with(kLoadCases), {}});
        const std::size_t from = of.is_of_load_case ? std::min(kLoadCases.size() + 1, place.path.size()) : 0;
        add_paths(place.record(), std::string(place.path.substr(from)), of.paths);
      }
    std::stable_partition(known.begin(), known.end(), [](const Responses& r) { return r.is_of_load_case; });
    return known;
  }();
  return all;
}

/// The place that has a response; null where none has.
const Responses* place_of(const std::string& path, bool over_threads) {
  const auto found =
      std::ranges::find_if(known_responses(), [&](const Responses& r) { return r.has(path, over_threads); });
  return found == known_responses().end() ? nullptr : &*found;
}

std::string nearest_responses(const std::string& path, bool over_threads) {
  const bool of_threads = over_threads || place_of(path, true);
  std::vector<std::string_view> all;
  for (const Responses& of : known_responses())
    if (of.is_of_load_case || !of_threads)
      all.insert(all.end(), of.named(of_threads).begin(), of.named(of_threads).end());
  const std::vector<std::string_view> near = input::near_words(path, all);
  return near.empty() ? fmt::format("write for example `{}`; `prs list responses` has all",
                                    of_threads ? "screw.load_rate_percent" : "axial_displacement_um")
                      : fmt::format("did you mean `{}`?", fmt::join(near, "`, `"));
}

/// A heading without its unit, and the unit, for people.
struct Heading {
  std::string_view stem;
  std::string unit;
};

/// The unit at the end is any of an input or that of a key of documents, with `_` for a blank and `_per_` for a
/// stroke: `torque_screw_lbf_in`, `axial_stiffness_kN_per_mm`.
Heading split_heading(std::string_view name) {
  for (std::size_t at = name.find('_'); at != name.npos; at = name.find('_', at + 1)) {
    std::string unit = boost::replace_all_copy(std::string(name.substr(at + 1)), "_per_", "/");
    std::ranges::replace(unit, '_', ' ');
    if (input::is_unit(unit)) return {name.substr(0, at), std::move(unit)};
  }
  return {name.substr(0, name.size() - unit_of(name).suffix.size()), unit_of_response(name)};
}

/// A column that is read as a response.
struct Column {
  std::size_t field = 0;
  const Responses* of = nullptr;
  std::string response, unit;
  Conversion to_unit = {};
};

/// Whether the input that rows set is one of their load case: `axial_force`.
bool is_of_load(std::string_view path) { return !path.empty() && path.find_first_of(".[") == path.npos; }

class ReferenceReader {
 public:
  ReferenceReader(const input::Source& source, const Case& c) : source_(source), case_(c), errors_(source) {
    root_ = read_document(source, errors_);
    items_ = read_case_file(root_, errors_).references;
    errors_.throw_if_any();
  }

  std::vector<ReferenceCurve> read() {
    std::vector<ReferenceCurve> all;
    for (const auto k : indices(items_)) {
      at_ = fmt::format("references[{}]", k);
      item_ = &items_[k];
      append(all, of_file());
    }
    return all;
  }

 private:
  template <class... Args>
  [[noreturn]] void fail(const char* key, fmt::format_string<Args...> message, Args&&... args) const {
    input::fail_at(source_, fmt::format("{}.{}", at_, key), fmt::format(message, std::forward<Args>(args)...));
  }

  std::vector<ReferenceCurve> of_file() {
    Readings table(item_->file, at_, source_);
    find_columns(table);
    std::vector<ReferenceCurve> all;
    std::set<std::pair<std::string, double>> threads;
    std::size_t rows = 0;
    while (table.next()) {
      const std::size_t most = input_path_.empty() ? kMostRows : kMostComputed;
      if (++rows > most) table.refuse(0, fmt::format("more than {} rows", most), "fewer");
      const LoadCase* load = needs_load() ? &load_of(table) : nullptr;
      ReferenceReading reading{along_at(table, load, threads), 0.0, {}, table.line()};
      std::optional<Case> row_case;
      if (!input_path_.empty()) row_case = case_at(table, load, reading.along);
      for (const Column& column : columns_) {
        ReferenceCurve& reference = of_column(all, column, load);
        reading.value = column.to_unit(table.number(column.field));
        if (deviation_) reading.deviation = std::abs(deviation_->second.factor * table.number(deviation_->first));
        if (along_ == npos && !reference.readings.empty())
          table.refuse(0, "a second row of one load case", "one, or a column `thread` or `force_kN`");
        reference.readings.push_back(reading);
        if (row_case) reference.cases.push_back(*row_case);
      }
    }
    if (rows == 0) table.refuse_file("which has no rows");
    for (ReferenceCurve& reference : all) finish(reference);
    return all;
  }

  // Columns

  void find_columns(const Readings& table) {
    const std::vector<std::string>& names = table.names();
    const auto found = [&](std::string_view name) {
      const auto at = std::ranges::find(names, name);
      return at == names.end() ? npos : static_cast<std::size_t>(at - names.begin());
    };
    for (const auto k : indices(names))
      if (std::ranges::count(names, names[k]) > 1)
        table.refuse_name(k, "which occurs twice; expected it once; rename one");
    load_case_ = found(kLoadCase);
    if (load_case_ != npos && item_->load_case)
      fail("load_case", "got {}, and {} has a column `load_case`; expected one of the two; delete one",
           shown(*item_->load_case), table.name());
    find_along(table);
    columns_.clear();
    deviation_.reset();
    if (item_->response)
      columns_ = {stated_column(table)};
    else if (item_->measured)
      fail("measured",
           "got it without `response`; expected the response that is measured; add for example "
           "`response: screw.load_rate_percent`");
    else
      for (const auto k : indices(names))
        if (k != along_ && k != load_case_) columns_.push_back(named_column(table, k));
    if (columns_.empty()) table.refuse_file("which has no column with the name of a response");
    for (const auto k : indices(columns_))
      for (const auto before : up_to(k))
        if (columns_[before].response == columns_[k].response)
          table.refuse_name(columns_[k].field,
                            fmt::format("expected each response once, and {} has that of {} already; "
                                        "give one of both a file of its own",
                                        table.names()[columns_[before].field], columns_[k].response));
    check_load(table);
    if (is_map_of_deviation()) find_deviation(table);
  }

  bool needs_load() const { return columns_[0].of->is_of_load_case || is_of_load(input_path_); }

  /// Responses of load cases and of the whole case take a table each, and the latter name no load case.
  void check_load(const Readings& table) const {
    for (const Column& column : columns_)
      if (column.of->is_of_load_case != columns_[0].of->is_of_load_case)
        table.refuse_name(column.field, fmt::format("expected a response of {}, as {} is; give it a file of its own",
                                                    columns_[0].of->is_of_load_case ? "a load case" : "the whole case",
                                                    columns_[0].response));
    for (const Column& column : columns_)
      if (const std::vector<Problem> lacks = missing(case_, column.of->command); !lacks.empty())
        table.refuse_name(column.field,
                          fmt::format("expected the response of a command that the case is ready for; `prs {}` is not: "
                                      "{}: {}",
                                      name(column.of->command), lacks[0].path, lacks[0].message));
    const std::string& response = columns_[0].response;
    if (is_of_load(input_path_) &&
        (response.starts_with("contact.") || (response.starts_with("life.") && input_path_ == kForce)))
      table.refuse_name(along_,
                        fmt::format("expected an input of the whole case, since {} is a response of it, on which "
                                    "{} of a load case does not act; name one by `along: {{column: .., input: "
                                    "..}}`, for example `life.spectrum[0].force`",
                                    response, input_path_));
    if (needs_load()) return;
    const std::string none =
        fmt::format("expected none, since {} is a response of the whole case; delete it", columns_[0].response);
    if (load_case_ != npos) table.refuse_name(load_case_, none);
    if (item_->load_case) fail("load_case", "got {}; {}", shown(*item_->load_case), none);
  }

  void find_along(const Readings& table) {
    along_ = npos;
    input_.clear(), input_path_.clear(), along_unit_.clear();
    const std::vector<std::string>& names = table.names();
    if (item_->along) {
      along_ = table.column(item_->along->column, at_ + ".along.column");
      input_ = item_->along->input.value_or(std::string(input_named(names[along_])));
      if (input_.empty())
        fail("along",
             "got the column {} without `input`; expected the input that its rows set; add for example `input: "
             "operation.speed`",
             shown(names[along_]));
    }
    for (std::size_t k = 0; along_ == npos && k < names.size(); ++k)
      if (const std::string_view input = input_named(names[k]); !input.empty()) along_ = k, input_ = input;
    if (along_ == npos || input_ == kThread) return;
    along_unit_ = item_->along && item_->along->unit ? *item_->along->unit : split_heading(names[along_]).unit;
    input_path_ = input_;
  }

  /// Input for a column of that name; empty for others.
  static std::string_view input_named(std::string_view name) {
    if (name == kThread) return kThread;
    const std::string_view quantity = split_heading(name).stem;
    return quantity == "force" || quantity == kForce ? kForce : std::string_view();
  }

  bool is_over_threads() const { return along_ != npos && input_ == kThread; }

  Column stated_column(const Readings& table) const {
    const std::string& path = *item_->response;
    const Responses* of = place_of(path, is_over_threads());
    if (!of)
      fail("response", "got {}; expected {}; {}", shown(path),
           is_over_threads() ? "an array over threads of a load case"
                             : "a number that a command finds, or with a column `thread` an array over threads",
           nearest_responses(path, is_over_threads()));
    Column column{0, of, path, unit_of_response(path), {}};
    if (item_->measured && item_->measured->column)
      column.field = table.column(*item_->measured->column, at_ + ".measured.column");
    else
      while (column.field == along_ || column.field == load_case_) ++column.field;
    if (column.field >= table.names().size()) table.refuse_file("which has no column for the reference's numbers");
    const std::string& unit = item_->measured && item_->measured->unit ? *item_->measured->unit : column.unit;
    column.to_unit = conversion_to(unit, column.unit, "measured.unit");
    return column;
  }

  Conversion conversion_to(const std::string& unit, const std::string& to, const char* key) const {
    const auto found = input::conversion(unit, to);
    if (!found)
      fail(key, "got {}; expected a unit of the response: {}; write for example `unit: \"{}\"`", shown(unit),
           input::units_like(to), to);
    return *found;
  }

  Column named_column(const Readings& table, std::size_t field) const {
    const std::string& name = table.names()[field];
    if (const Responses* of = place_of(name, is_over_threads())) return {field, of, name, unit_of_response(name), {}};
    const auto& [stem, unit] = split_heading(name);
    for (const Responses& of : known_responses())
      for (const std::string& path : of.named(is_over_threads()))
        if (split_heading(path).stem == stem && of.has(path, is_over_threads()))
          if (const auto to_unit = input::conversion(unit, unit_of_response(path)))
            return {field, &of, path, unit_of_response(path), *to_unit};
    if (!input_named(name).empty())
      table.refuse_name(field, fmt::format("expected `thread` or a force, not both, and {} stands there already; give "
                                           "the columns a file each",
                                           table.names()[along_]));
    table.refuse_name(field, fmt::format("expected `thread`, `load_case`, `force_kN` or {} by its name; {}",
                                         is_over_threads() ? "an array over threads" : "a number that a command finds",
                                         nearest_responses(name, is_over_threads())));
  }

  bool is_map_of_deviation() const { return item_->deviation && item_->deviation->starts_with('{'); }

  void find_deviation(const Readings& table) {
    const Node& node = *find_path(root_, at_ + ".deviation");
    const Node *its = find(node, "column"), *in = find(node, "unit");
    if (!its || node.children.size() > (in ? 2U : 1U) || !item_->response)
      fail("deviation", "got {}; expected {{column: .., unit: ..}}, beside `response`", shown(*item_->deviation));
    const Column& column = columns_[0];
    deviation_ = {table.column(its->text, at_ + ".deviation.column"),
                  conversion_to(in ? in->text : column.unit, column.unit, "deviation.unit")};
  }

  // Rows

  std::vector<std::string> names_of_loads() const {
    std::vector<std::string> names;
    for (const LoadCase& load : case_.load_cases)
      if (load.is_solved()) names.push_back(load.name);
    return names;
  }

  /// A range of forces is one item, whose force the rows set.
  const LoadCase* find_load(std::string_view name) const {
    for (const LoadCase& load : case_.load_cases)
      if (load.is_solved() && (load.name == name || (!input_path_.empty() && load.name == fmt::format("{}[0]", name))))
        return &load;
    return nullptr;
  }

  const LoadCase& load_of(const Readings& table) const {
    const std::vector<std::string> names = names_of_loads();
    if (load_case_ != npos) {
      const std::string name = table.text(load_case_);
      if (const LoadCase* load = find_load(name)) return *load;
      table.refuse(load_case_, name.empty() ? "nothing" : shown(name),
                   fmt::format("a load case that is solved: {}", shown(fmt::format("{}", fmt::join(names, ", ")))));
    }
    if (item_->load_case) {
      if (const LoadCase* load = find_load(*item_->load_case)) return *load;
      const std::string hint = input::did_you_mean(*item_->load_case, {names.begin(), names.end()});
      fail("load_case", "got {}; expected a load case that is solved: {}; {}", shown(*item_->load_case),
           shown(fmt::format("{}", fmt::join(names, ", "))), hint.empty() ? "write one of them" : hint);
    }
    const bool is_one = std::ranges::all_of(
        case_.load_cases, [&](const LoadCase& load) { return load.input_path == case_.load_cases.front().input_path; });
    if (names.size() == 1 || (!input_path_.empty() && is_one)) return *find_load_or_first(names);
    table.refuse_file(
        fmt::format("which names no load case; a column `load_case`, or the key `load_case` of "
                    "`references`, names one of {}",
                    shown(fmt::format("{}", fmt::join(names, ", ")))));
  }
  const LoadCase* find_load_or_first(const std::vector<std::string>& names) const { return find_load(names.front()); }

  double along_at(const Readings& table, const LoadCase* load,
                  std::set<std::pair<std::string, double>>& threads) const {
    if (along_ == npos) return 0.0;
    const double along = table.number(along_);
    if (input_ != kThread) return along;
    const int count = case_.mechanism.contacts_per_roller;
    if (along != std::floor(along) || along < 1.0 || along > count)
      table.refuse(along_, fmt::format("{}", along), fmt::format("a thread from 1 to {}", count));
    if (!threads.emplace(load->name, along).second)
      table.refuse(along_, fmt::format("thread {} of {} a second time", along, shown(load->name)), "each thread once");
    return along;
  }

  /// The case with the row's value in the place of the input and, of responses of a load case, that one alone. A
  /// negative force beside a `direction` is one in the other direction.
  Case case_at(const Readings& table, const LoadCase* load, double value) const {
    const std::string path = is_of_load(input_path_) ? path_in(*load, input_path_) : with_indices(root_, input_path_);
    const std::string beside = path.substr(0, path.rfind('.')) + ".direction";
    const Node* direction = value < 0.0 && path.ends_with("force") ? find_path(root_, beside) : nullptr;
    const std::string text = input::with_unit(direction ? -value : value, along_unit_);
    input::ErrorList found(source_);
    Node design = root_;
    std::optional<Case> c;
    const auto set = [&](const std::string& at, const std::string& to) {
      return set_value(design, at, input::scalar(to, {}), {}, found);
    };
    if (set(path, text) &&
        (!direction ||
         set(beside, std::string(name(direction->text == "tension" ? Direction::compression : Direction::tension))))) {
      const input::CaseFile file = read_case_file(design, found);
      for (const Column& column : columns_)
        if (found.empty())
          c = checked_case(file, design, column.of->command == Command::solve ? Command::compare : column.of->command,
                           found);
    }
    if (!found.empty()) {
      const std::string problem = found.first();
      const std::size_t expected = problem.find("; expected ");
      table.refuse(along_, text,
                   fmt::format("{} ({})", expected == problem.npos ? problem : problem.substr(expected + 11), path));
    }
    if (!columns_[0].of->is_of_load_case) return *std::move(c);
    std::erase_if(c->load_cases, [&](const LoadCase& other) { return other.input_path != load->input_path; });
    c->load_cases.resize(1);
    if (c->heat) c->heat->duty.clear();
    return *std::move(c);
  }

  ReferenceCurve& of_column(std::vector<ReferenceCurve>& all, const Column& column, const LoadCase* load) const {
    const std::string name = load && column.of->is_of_load_case ? load->name : "";
    for (ReferenceCurve& reference : all)
      if (reference.response == column.response && reference.load_case == name) return reference;
    ReferenceCurve& reference = all.emplace_back();
    reference.name = item_->name.value_or(std::filesystem::path(item_->file).stem().string());
    reference.file = item_->file;
    reference.at = at_;
    reference.load_case = name;
    reference.command = column.of->command;
    reference.response = column.response;
    reference.unit = column.unit;
    reference.along = along_ == npos ? "" : input_;
    reference.along_unit = along_unit_;
    return reference;
  }

  void finish(ReferenceCurve& reference) const {
    std::vector<std::size_t> order(reference.readings.size());
    for (const auto k : indices(order)) order[k] = k;
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return reference.readings[k].along; });
    const auto sorted = [&](auto& items) {
      if (items.empty()) return;
      auto from = items;
      for (const auto k : indices(order)) items[k] = from[order[k]];
    };
    sorted(reference.readings), sorted(reference.cases);
    if (item_->tolerance) reference.tolerance = spread(*item_->tolerance, "tolerance", reference);
    if (!item_->deviation || is_map_of_deviation()) return;
    const Spread own = spread(*item_->deviation, "deviation", reference);
    for (ReferenceReading& reading : reference.readings)
      reading.deviation = own.at(reading.value, reference.mean_magnitude());
  }

  Spread spread(const std::string& written, const char* key, const ReferenceCurve& reference) const {
    std::string text = written;
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    Spread result{.text = text};
    for (const auto& [ending, of] :
         {std::pair{" of the mean", Spread::Of::mean}, std::pair{" of each value", Spread::Of::each}})
      if (text.ends_with(ending)) {
        result.of = of;
        text.erase(text.size() - std::string_view(ending).size());
      }
    const auto number = input::split_unit(text);
    const bool is_share = result.of != Spread::Of::value;
    const auto to_unit =
        number ? input::conversion(std::string(number->unit), is_share ? "%" : reference.unit) : std::nullopt;
    if (!number || !to_unit || !(number->number > 0.0))
      fail(key,
           "got {}; expected more than 0 as `10 % of the mean`, `10 % of each value` or a value in {}; write for "
           "example `{}: 10 % of the mean`",
           shown(written), reference.unit.empty() ? "no unit" : reference.unit, key);
    result.amount = to_unit->factor * number->number;
    return result;
  }

  static constexpr std::size_t npos = std::string::npos;

  const input::Source& source_;
  const Case& case_;
  input::ErrorList errors_;
  Node root_;
  std::vector<ReferenceItem> items_;

  // Path of the block being read.
  std::string at_;
  const ReferenceItem* item_ = nullptr;
  std::size_t load_case_ = npos, along_ = npos;
  std::string input_, input_path_, along_unit_;
  std::vector<Column> columns_;
  std::optional<std::pair<std::size_t, Conversion>> deviation_;
};

}  // namespace

std::vector<ReferenceCurve> read_references(const input::Source& source, const Case& c) {
  return ReferenceReader(source, c).read();
}

}  // namespace prs
