#include "modules/fit/fit_reader.h"

#include <charconv>
#include <set>

#include "modules/response/response_analysis.h"
#include "prs/heat/analyze_heat.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/field.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/input/readings.h"
#include "prs/input/schema.h"
#include "prs/input/varied_input.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/record/record_table.h"
#include "prs/record/response_path.h"

namespace prs {
namespace {

using input::CaseFile, input::FitConditionItem, input::FitCurveItem, input::FitItem, input::FitParameterItem;
using input::Conversion, input::conversion, input::Node, input::Readings, input::shown, input::Slot, input::units_like;
using input::with_unit;

constexpr std::size_t kMostRows = 1'000'000;

/// Text as written: `460 J/(kg K)` for a value with brackets, which is in quotes.
std::string unquoted(const std::string& text) {
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

/// Responses that studies record.
std::vector<std::string_view> usual_responses() {
  std::vector<std::string_view> all;
  const auto add = [&](const auto& analysis) {
    all.insert(all.end(), analysis.responses.begin(), analysis.responses.end());
  };
  add(solve_analysis()), add(slip_analysis()), add(life_analysis()), add(measures_analysis()), add(response_analysis());
  return all;
}

/// Adds the paths of the numbers that a document states.
void add_numbers(const Node& node, const std::string& path, std::vector<std::string>& all) {
  if (node.kind == Node::Kind::scalar && input::split_unit(node.text)) all.push_back(path);
  for (std::size_t k = 0; k < node.children.size(); ++k) {
    const Node& child = node.children[k];
    const std::string dot = path.empty() ? "" : ".";
    add_numbers(child, path + (node.kind == Node::Kind::map ? dot + child.key : fmt::format("[{}]", k)), all);
  }
}

/// Commands whose responses curves may have; a response whose block names none is of `solve`.
constexpr Command kCommands[] = {Command::contact, Command::solve,    Command::slip,    Command::preload,
                                 Command::life,    Command::measures, Command::response};

constexpr std::string_view kResponseTime = "response.time_s";

/// Abscissa of a series; none for a single number.
std::optional<std::string> along_of(std::string_view response) {
  if (response.starts_with("preload.loads[].")) return "preload.loads[].axial_force_N";
  constexpr std::string_view kTemperature = "heat_cycle.temperature_degC.";
  if (response.starts_with(kTemperature) && response.find('.', kTemperature.size()) == response.npos)
    return "heat_cycle.time_s";
  if (response == kResponseTime || !response.starts_with("response.")) return std::nullopt;
  for (const QuantityInfo& q : response_analysis().places[0].record().quantities)
    if (q.kind == Kind::series && response.substr(response.find('.') + 1) == q.key) return std::string(kResponseTime);
  return std::nullopt;
}

class FitReader : input::VariedInput {
 public:
  FitReader(const FitItem& item, const input::Source& source, const Node& root, Node& base, CaseFile& file,
            input::ErrorList& errors)
      : VariedInput(source, root, base, errors), item_(item), file_(file), fields_(echo(file, base)) {}

  FitInput read() {
    FitInput all{.source = source_, .parameters = {}, .curves = {}, .profile = {}};
    all.level = item_.level;
    all.starts = static_cast<std::size_t>(item_.starts);
    for (std::size_t k = 0; k < item_.parameters.size(); ++k) all.parameters.push_back(parameter(k));
    check_once(all.parameters);
    errors_.throw_if_any();
    for (const FitParameter& p : all.parameters)
      set_value(base_, p.path, input::scalar(with_unit(p.start, p.unit), {}), {}, errors_);
    for (std::size_t k = 0; k < item_.curves.size(); ++k)
      all.curves.push_back(curve(item_.curves[k], fmt::format("fit.curves[{}]", k), k, all));
    for (std::size_t k = 0; k < item_.bands.size(); ++k)
      all.curves.push_back(band(item_.bands[k], fmt::format("fit.bands[{}]", k), all.parameters));
    check_names(all);
    errors_.throw_if_any();
    check_counts(all);
    read_profile(all);
    errors_.throw_if_any();
    return all;
  }

 private:
  template <class... Args>
  [[noreturn]] void fail(const std::string& at, fmt::format_string<Args...> message, Args&&... args) const {
    errors_.throw_if_any();
    input::fail_at(source_, at, fmt::format(message, std::forward<Args>(args)...));
  }

  double number(const std::string& text, const std::string& unit, const char* key, std::string_view of) const {
    const std::optional<double> value = input::number_in(text, unit);
    if (!value)
      fail(fmt::format("{}.{}", path_, key), "got {}; expected {} {}; write for example `{}: {}`", shown(text),
           unit.empty() ? "a number without unit, as" : "a number with a unit of", of,
           std::string_view(key).substr(std::string_view(key).find('.') + 1), with_unit(1.0, unit));
    return *value;
  }

  FitParameter parameter(std::size_t k) {
    FitParameterItem item = item_.parameters[k];
    for (std::string* text : {&item.from, &item.to, item.start ? &*item.start : nullptr,
                              item.prior ? &item.prior->mean : nullptr, item.prior ? &item.prior->deviation : nullptr})
      if (text) *text = unquoted(*text);
    path_ = fmt::format("fit.parameters[{}]", k);
    FitParameter p{.path = input::with_indices(root_, item.path), .label = item.label.value_or(item.path), .unit = {}};
    if (!check_outside("path", item.path)) errors_.throw_if_any();
    p.path = as_in_file(p.path);
    const Slot::Kind kind = kind_of(p.path);
    if (kind == Slot::Kind::none && wrong(p.path, item.from)) fail_as_unknown(p.path, item.path);
    if (kind != Slot::Kind::number && kind != Slot::Kind::none) fail_as_no_number(item.path);
    for (const char* end : {".from", ".to"})
      if (!check_in_place(p.path, *find_path(root_, path_ + end))) errors_.throw_if_any();
    const Slot slot = find_slot(file_, p.path);
    const auto from = input::split_unit(item.from);
    if (slot.kind != Slot::Kind::number || !from) fail_as_no_number(item.path);
    p.unit = from->unit;
    p.is_log = item.scale == FitParameterItem::Scale::log;
    p.from = from->number;
    p.to = number(item.to, p.unit, "to", "`from`");
    check_range(p, item, slot);
    read_start(p, item);
    if (item.prior) read_prior(p, *item.prior, slot);
    return p;
  }

  /// A path to one law hides those to others.
  Slot::Kind kind_of(const std::string& path) const {
    CaseFile file = file_;
    return find_slot(file, path).kind;
  }

  [[noreturn]] void fail_as_unknown(const std::string& path, const std::string& written) const {
    std::vector<std::string> stated;
    add_numbers(base_, "", stated);
    std::set<std::string> all(stated.begin(), stated.end());
    for (const input::EchoEntry& entry : fields_)
      if (entry.number) all.insert(entry.path);
    for (const input::InputKey& key : input::input_keys()) all.insert(key.path);
    std::erase_if(all, [&](const std::string& one) { return kind_of(one) != Slot::Kind::number; });
    const std::vector<std::string_view> near = input::near_words(path, {all.begin(), all.end()});
    fail(path_ + ".path", "got {}, an unknown path; expected one of `prs list inputs`; {}", shown(written),
         near.empty() ? "state the block that has it, or write for example `path: materials.youngs_modulus`"
                      : fmt::format("did you mean `{}`?", fmt::join(near, "`, `")));
  }

  void check_range(const FitParameter& p, const FitParameterItem& item, const Slot& slot) const {
    if (!(p.from < p.to))
      fail(path_ + ".from", "got {}; expected less than `to`, {}; {}", shown(item.from), shown(item.to),
           p.from == p.to ? "write two different ones" : "swap the two");
    if (p.is_log && slot.dimension && zero_depends_on_unit(*slot.dimension))
      fail(path_ + ".scale", "got log of a temperature, whose zero is a convention; expected linear; delete the key");
    else if (p.is_log && !(p.from > 0.0))
      fail(path_ + ".from", "got {} with `scale: log`; expected more than 0; write a larger one, or `scale: linear`",
           shown(item.from));
  }

  void read_start(FitParameter& p, const FitParameterItem& item) const {
    const std::optional<Node> stands = base_value(p.path, fields_);
    if (stands && find_path(base_, p.path)) p.stood = flow_text(*stands);
    const std::optional<double> there = stands ? input::number_in(unquoted(flow_text(*stands)), p.unit) : std::nullopt;
    p.has_start = item.start.has_value();
    if (item.start) {
      p.start = number(*item.start, p.unit, "start", "`from`");
    } else if (there) {
      p.start = *there;
    } else {
      fail(path_ + ".path",
           "got {}, which the file does not state and which has no default; expected a value there, or `start`; add "
           "for example `start: {}`",
           shown(item.path), shown(item.from));
    }
    if (!(p.start >= p.from && p.start <= p.to))
      fail(path_ + (item.start ? ".start" : ".path"), "got {}{} of {}; expected {} to {}; {}",
           item.start ? "" : "the start ", with_unit(p.start, p.unit), shown(item.path), item.from, item.to,
           item.start ? "write one between them" : "widen the bounds, or add `start`");
  }

  [[noreturn]] void fail_as_no_number(const std::string& path) const {
    fail(path_ + ".path",
         "got {}; expected one number that may vary continuously: no list, word or whole number; write for example "
         "`path: friction.coulomb`",
         shown(path));
  }

  /// Path in the form of the file: `friction.coulomb` and `friction.model.coulomb` lead to the same value.
  std::string as_in_file(const std::string& path) const {
    constexpr std::string_view kModel = ".model.";
    std::string other = path;
    if (const std::size_t at = path.find(kModel); at != path.npos)
      other.replace(at, kModel.size(), ".");
    else if (const std::size_t dot = path.rfind('.'); dot != path.npos)
      other.replace(dot, 1, kModel);
    return find_path(base_, other) && !find_path(base_, path) ? other : path;
  }

  void read_prior(FitParameter& p, const FitParameterItem::Prior& item, const Slot& slot) const {
    FitParameter::Prior prior;
    prior.mean = number(item.mean, p.unit, "prior.mean", "`from`");
    const auto written = input::split_unit(item.deviation);
    if (written && written->unit == "%")
      prior.deviation = 0.01 * written->number * std::abs(prior.mean);
    else if (written && written->unit.empty() == p.unit.empty())
      if (const auto by = conversion(written->unit, p.unit)) prior.deviation = by->factor * written->number;
    if (written && written->unit == "%" && slot.dimension && zero_depends_on_unit(*slot.dimension))
      fail(path_ + ".prior.deviation",
           "got {} of a temperature, whose zero is a convention; expected no share but a value with unit; write for "
           "example `deviation: 1 K`",
           shown(item.deviation));
    if (written && written->unit == "%" && written->number > 0.0 && prior.mean == 0.0)
      fail(path_ + ".prior.deviation", "got {} of a mean of 0; expected a value; write for example `deviation: {}`",
           shown(item.deviation), with_unit(1.0, p.unit));
    if (!(prior.deviation > 0.0))
      fail(path_ + ".prior.deviation",
           "got {}; expected more than 0, a share of the mean or {}; write for example `deviation: 3 %`",
           shown(item.deviation), slot.dimension ? "a value in " + input::unit_list(*slot.dimension) : "a number");
    if (p.is_log && !(prior.mean > 0.0))
      fail(path_ + ".prior.mean", "got {} with `scale: log`; expected more than 0; write `scale: linear`",
           shown(item.mean));
    p.prior = prior;
  }

  void check_once(const std::vector<FitParameter>& parameters) const {
    std::vector<input::SetPath> paths;
    for (std::size_t k = 0; k < parameters.size(); ++k)
      paths.push_back({parameters[k].path, fmt::format("fit.parameters[{}].path", k), k});
    check_paths(paths, "parameter", false, root_, errors_);
  }

  /// Error of a text as the value of a path; none if it is valid.
  std::optional<std::string> wrong(const std::string& path, const std::string& text) const {
    input::ErrorList found(source_);
    Node design = base_;
    if (set_value(design, path, input::scalar(text, {}), {}, found)) read_case_file(design, found);
    return found.empty() ? std::nullopt : std::optional(found.first());
  }

  void check_condition(const FitCurve& c, const std::string& path, const std::vector<FitParameter>& parameters) const {
    const auto clashes = [&](const std::string& other) {
      return other == path || input::is_part_of(other, path) || input::is_part_of(path, other);
    };
    std::vector<std::string> others = each(c.conditions, &FitCondition::path);
    for (const auto& [other, value] : c.constants) others.push_back(other);
    if (const auto other = std::ranges::find_if(others, clashes); other != others.end())
      fail(path_ + ".path", "got {} {}; expected each input once in a curve; delete one of the two", shown(path),
           path == *other ? "a second time" : "as well as " + shown(*other));
    if (std::ranges::any_of(parameters, clashes, &FitParameter::path))
      fail(path_ + ".path", "got {}, which is a parameter too; expected it once; delete one of the two", shown(path));
    if (!check_outside("path", path)) errors_.throw_if_any();
  }

  /// Sets a value that is the same in all rows.
  void set_constant(FitCurve& curve, const std::string& path, const char* key) {
    const Node value = *find_path(root_, fmt::format("{}.{}", path_, key));
    if (!check_in_place(path, value)) errors_.throw_if_any();
    set_value(curve.base, path, value, locate(root_, path_ + ".path"), errors_);
    curve.constants.emplace_back(path, flow_text(value));
  }

  Command command_of(const std::string& response, const std::optional<std::string>& written,
                     const std::string& at) const {
    std::string_view rest = response;
    if (rest.starts_with("load_cases["))
      if (const std::size_t dot = rest.find("]."); dot != rest.npos) rest.remove_prefix(dot + 2);
    const std::string_view block = rest.substr(0, std::min(rest.find('.'), rest.size()));
    const std::string_view word = written                     ? *written
                                  : block.starts_with("heat") ? "slip"
                                  : block == "threads"        ? "contact"
                                                              : block;
    const auto found = std::ranges::find(kCommands, word, &Command::word);
    if (found != std::end(kCommands)) return *found;
    if (!written) return Command::solve;
    fail(at + ".command", "got {}; expected contact, solve, slip, preload, life, measures or response; delete the key",
         shown(*written));
  }

  FitCurve start_curve(const FitCurveItem& item, const std::string& at) {
    FitCurve c;
    c.at = at;
    c.response = response_path(root_, file_.load_cases, item.response);
    c.command = command_of(c.response, item.command, at);
    c.is_usual_command = !item.command || c.command == command_of(c.response, {}, at);
    c.unit = unit_of_response(c.response);
    c.base = base_;
    return c;
  }

  FitCurve curve(const FitCurveItem& item, const std::string& at, std::size_t k, const FitInput& before) {
    FitCurve c = start_curve(item, at);
    c.name = item.name.value_or(fmt::format("curve-{}", k + 1));
    c.file = item.file;
    c.use = item.use == FitCurveItem::Use::fit ? FitCurve::Use::fit : FitCurve::Use::compare;
    c.has_offset = item.offset;
    read_loss(c, item);
    check_series(c, item);
    Readings table(item.file, at, source_);
    const std::size_t measured = table.column(item.measured.column.value_or("measured"), at + ".measured.column");
    const Conversion to_unit = unit_at(item.measured.unit.value_or(""), c.unit, at + ".measured", c.response);

    std::vector<Column> columns = read_conditions(c, item, table, before.parameters);
    std::optional<std::size_t> place;
    Conversion to_place;
    if (item.along) {
      place = table.column(item.along->column, at + ".along.column");
      to_place = unit_at(item.along->unit, c.series.ends_with("_s") ? "s" : "N", at + ".along", c.series);
    }
    const Deviation deviation = read_deviation(item, c, table);
    while (table.next()) {
      if (++rows_ > kMostRows)
        fail(at + ".file", "got more than {} rows in all; expected at most as many; leave some out", kMostRows);
      c.lines.push_back(table.line());
      c.measured.push_back(to_unit(table.number(measured)));
      if (place) {
        c.places.push_back(to_place(table.number(*place)));
        c.columns.push_back(table.column_at(*place));
      }
      if (deviation.column || deviation.fixed) c.deviation.push_back(deviation_of_row(deviation, c, table, measured));
      for (std::size_t j = 0; j < columns.size(); ++j) read_condition(c.conditions[j], columns[j], table);
    }
    c.rows = c.measured.size();
    if (c.rows == 0) table.refuse_file("which has no rows");
    for (const FitCondition& condition : c.conditions)
      set_value(c.base, condition.path, input::scalar(joined(condition.texts[0], condition.unit), {}), {}, errors_);
    const auto [least, greatest] = std::ranges::minmax(c.measured);
    if (c.has_offset && least == greatest)
      fail(at + ".offset", "got true of a curve whose readings are all equal; expected two different ones; delete it");
    return c;
  }

  /// A column of readings that sets an input.
  struct Column {
    std::size_t field = 0;
    std::string at;  ///< Path of the condition.
    Slot slot = {};
    const input::Unit* unit = nullptr;
    std::set<std::string> sound = {};  ///< Words that were tried.
  };

  std::vector<Column> read_conditions(FitCurve& c, const FitCurveItem& item, const Readings& table,
                                      const std::vector<FitParameter>& parameters) {
    std::vector<Column> columns;
    for (std::size_t j = 0; j < item.conditions.size(); ++j) {
      const FitConditionItem& condition = item.conditions[j];
      path_ = fmt::format("{}.conditions[{}]", c.at, j);
      const std::string path = as_in_file(input::with_indices(root_, condition.path));
      check_condition(c, path, parameters);
      if (condition.values || condition.value.has_value() == condition.column.has_value())
        fail(path_,
             "got neither or both of `column` and `value`; expected one of them; write `value: ..`, or `column` and "
             "`unit`");
      if (condition.value) {
        set_constant(c, path, "value");
        continue;
      }
      if (item.along)
        fail(path_ + ".column", "got a column of a series; expected the same value in all rows; write `value: ..`");
      columns.push_back({table.column(*condition.column, path_ + ".column"), path_});
      c.conditions.push_back({path, condition.unit.value_or(""), {}});
    }
    return columns;
  }

  void read_condition(FitCondition& condition, Column& column, const Readings& table) {
    path_ = column.at;
    std::string text = table.text(column.field);
    if (condition.texts.empty()) prepare(condition, text, column.slot, column.unit);
    if (!condition.unit.empty()) {
      const double value = table.number(column.field);
      const std::string written = with_unit(value, condition.unit);
      if (column.unit && !input::slot_value(column.slot, value, column.unit))
        table.refuse(column.field, written, wrong(condition.path, written).value_or("another value"));
      text = fmt::format("{}", value);
    } else if (column.sound.insert(text).second) {
      if (text.empty()) table.refuse(column.field, "nothing", "a value");
      constexpr std::string_view kExpected = "; expected ";
      if (std::optional<std::string> problem = wrong(condition.path, text)) {
        if (const std::size_t at = problem->find(kExpected); at != problem->npos)
          problem->erase(0, at + kExpected.size());
        table.refuse(column.field, shown(text), *problem);
      }
    }
    condition.texts.push_back(std::move(text));
  }

  static std::string joined(const std::string& text, const std::string& unit) {
    return unit.empty() ? text : text + " " + unit;
  }

  /// Compares the unit of a column with that of the input that it sets.
  void prepare(FitCondition& condition, const std::string& first, Slot& slot, const input::Unit*& unit) {
    CaseFile file = file_;
    {
      Node design = base_;
      input::ErrorList none(source_);
      if (set_value(design, condition.path, input::scalar(joined(first, condition.unit), {}), {}, none))
        file = read_case_file(design, none);
    }
    slot = find_slot(file, condition.path);
    if (slot.kind == Slot::Kind::none)
      if (const auto problem = wrong(condition.path, joined(first, condition.unit)))
        fail(path_ + ".path", "{}", problem->substr(problem->find(": ") + 2));
    if (slot.kind != Slot::Kind::number) return;
    const input::Dimension* d = slot.dimension;
    const bool fits =
        !d ? condition.unit.empty()
           : input::find_unit(condition.unit, *d) || (d->by_lead && input::find_unit(condition.unit, *d->by_lead));
    if (!fits)
      fail(path_ + ".unit", "got {}; expected {}; write for example `unit: {}`",
           condition.unit.empty() ? "none" : shown(condition.unit),
           d ? "the unit of " + std::string(d->name) + ": " + input::unit_list(*d) : "none", d ? d->canonical : "\"\"");
    if (d) unit = input::find_unit(condition.unit, *d);
    // Numbers are set through their place in this case.
    slot.numbers.clear(), slot.list = nullptr, slot.whole = nullptr;
  }

  Conversion unit_at(const std::string& written, const std::string& unit, const std::string& at,
                     const std::string& response) const {
    const auto found = conversion(written, unit);
    if (found) return *found;
    std::string other;
    if (unit.empty()) {  // The name may lack the unit.
      const std::vector<std::string_view> known = usual_responses(), near = input::near_words(response, known);
      other = near.empty() ? ", or another response of `prs list responses`"
                           : fmt::format(", or did you mean the response `{}`?", fmt::join(near, "`, `"));
    }
    fail(at + ".unit", "got {}; expected a unit of the response {}: {}; write for example `unit: {}`{}",
         written.empty() ? "none" : shown(written), shown(response), units_like(unit),
         unit.empty() || unit == "%" ? "\"%\"" : unit, other);
  }

  /// Deviation of readings as the file states it.
  struct Deviation {
    std::optional<std::size_t> column = {};
    std::optional<double> fixed = {};
    bool is_share = false;  ///< In percent of the reading.
    Conversion to_unit = {};
  };

  /// Deviation of the reading that was read last.
  static double deviation_of_row(const Deviation& deviation, const FitCurve& c, const Readings& table,
                                 std::size_t measured) {
    const double reading = c.measured.back();
    const double one = deviation.column ? table.number(*deviation.column) : *deviation.fixed;
    const double value = deviation.is_share ? 0.01 * one * std::abs(reading) : deviation.to_unit.factor * one;
    if (!(value > 0.0))
      table.refuse(deviation.column.value_or(measured),
                   deviation.is_share && reading == 0.0 ? "a share of a reading of 0" : fmt::format("{}", one),
                   "a deviation above 0");
    return value;
  }

  Deviation read_deviation(const FitCurveItem& item, const FitCurve& c, const Readings& table) const {
    Deviation deviation;
    if (!item.deviation || *item.deviation == "estimated") return deviation;
    const std::string key = c.at + ".deviation";
    const Node& node = *find_path(root_, key);
    std::string unit;
    if (node.kind == Node::Kind::map) {
      const Node *its = find(node, "column"), *in = find(node, "unit");
      const bool known = its && its->kind == Node::Kind::scalar && (!in || in->kind == Node::Kind::scalar);
      if (!known || node.children.size() > (in ? 2U : 1U))
        fail(key, "got {}; expected {{column: .., unit: ..}}", shown(flow_text(node)));
      deviation.column = table.column(its->text, key + ".column");
      unit = in ? in->text : "";
    } else {
      const std::string text = unquoted(*item.deviation);
      const auto written = input::split_unit(text);  // The unit is part of the text.
      if (!written)
        fail(key,
             "got {}; expected a value, a share of the reading, {{column: .., unit: ..}} or estimated; write for "
             "example `deviation: {}`",
             shown(*item.deviation), with_unit(0.05, c.unit));
      deviation.fixed = written->number;
      unit = written->unit;
      if (!(written->number > 0.0))
        fail(key, "got {}; expected more than 0; write for example `deviation: {}`", shown(*item.deviation),
             with_unit(0.05, c.unit));
    }
    deviation.is_share = unit == "%";
    if (deviation.is_share || (unit.empty() && c.unit == "%")) return deviation;
    const auto found = conversion(unit, c.unit);
    if (!found)
      fail(deviation.column ? key + ".unit" : key,
           "got {}; expected a unit of the response: {}; write for example `{}`",
           unit.empty() ? "no unit" : shown(unit), units_like(c.unit), with_unit(0.05, c.unit));
    deviation.to_unit = *found;
    return deviation;
  }

  void read_loss(FitCurve& c, const FitCurveItem& item) const {
    using Kind = modules::fit::Loss::Kind;
    if (!item.loss) return;
    const std::string key = c.at + ".loss";
    const Node& node = *find_path(root_, key);
    const Node* inner = node.kind == Node::Kind::map && node.children.size() == 1 ? &node.children[0] : nullptr;
    const std::string& word = inner ? inner->key : node.text;
    if (word == "huber")
      c.loss = {Kind::huber, 1.345};
    else if (word == "cauchy")
      c.loss = {Kind::cauchy, 2.385};
    else if (inner || node.kind != Node::Kind::scalar || word != "squares")
      fail(key,
           "got {}; expected squares, huber, cauchy, {{huber: 1.345}} or {{cauchy: 2.385}}; write for example `loss: "
           "huber`",
           shown(flow_text(node)));
    if (!inner) return;
    const std::optional<double> scale = input::parse_number(inner->text);
    if (!scale || !(*scale > 0.0))
      fail(key, "got {}; expected a scale above 0, in standard deviations; write for example `{{{}: {}}}`",
           shown(flow_text(node)), word, c.loss.scale);
    c.loss.scale = *scale;
  }

  void check_series(FitCurve& c, const FitCurveItem& item) const {
    const std::optional<std::string> series = along_of(c.response);
    const bool is_series = series || c.response.find("[]") != std::string::npos;
    if (!is_series && !item.along) return;
    if (!series)
      fail(is_series ? c.at + ".response" : c.at + ".along",
           "got {}, {}; expected `preload.loads[].KEY`, `heat_cycle.temperature_degC.PART` or `response.KEY` of a "
           "series with `along`",
           shown(c.response), is_series ? "no such series" : "which is no series");
    if (!item.along)
      fail(c.at + ".response",
           "got {}, a series, without `along`; expected where its rows stand; add `along: {{response: {}, column: .., "
           "unit: ..}}`",
           shown(c.response), *series);
    if (item.along->response != *series)
      fail(c.at + ".along.response", "got {}; expected {}, over which {} stands; write that",
           shown(item.along->response), *series, shown(c.response));
    c.series = *series;
  }

  FitCurve band(const input::FitBandItem& item, const std::string& at, const std::vector<FitParameter>& parameters) {
    FitCurve c = start_curve(item, at);
    c.name = *item.name;
    c.use = FitCurve::Use::band;
    c.rows = 1;
    if (c.response.find("[]") != std::string::npos || along_of(c.response))
      fail(at + ".response", "got {}, a series; expected a single number; write for example `{}`", shown(c.response),
           "slip.power_loss_W");
    for (std::size_t j = 0; j < item.conditions.size(); ++j) {
      const FitConditionItem& condition = item.conditions[j];
      path_ = fmt::format("{}.conditions[{}]", at, j);
      const std::string path = input::with_indices(root_, condition.path);
      check_condition(c, path, parameters);
      if (condition.column || condition.value.has_value() == condition.values.has_value())
        fail(path_, "got neither or both of `value` and `values`, or a column; expected one of the two");
      if (condition.value) {
        set_constant(c, path, "value");
        continue;
      }
      FitCondition all{path, "", texts_of(*condition.values)};
      for (const std::string& text : all.texts)
        if (const auto problem = wrong(path, text)) fail(path_ + ".values", "{}", *problem);
      if (!c.conditions.empty() && all.texts.size() != c.rows)
        fail(path_ + ".values", "got {} values; expected {}, as many as those of `{}`; write as many", all.texts.size(),
             c.rows, c.conditions[0].path);
      c.rows = all.texts.size();
      set_value(c.base, path, input::scalar(all.texts[0], {}), {}, errors_);
      c.conditions.push_back(std::move(all));
    }
    return c;
  }

  std::vector<std::string> texts_of(const input::WrittenValues& values) const {
    if (!values.range) return each(values.list, unquoted);
    const input::WrittenRange& range = *values.range;
    const bool logarithmic = range.spacing == input::WrittenRange::Spacing::logarithmic;
    const std::string from = unquoted(range.from), to = unquoted(range.to);
    const std::optional<Ends> ends = read_ends("values.", from, to, false);
    errors_.throw_if_any();
    if (logarithmic && !(ends->from.number * ends->to.number > 0.0))
      fail(path_ + ".values.from", "got {} with `spacing: logarithmic`; expected two numbers of one sign",
           shown(range.from));
    std::vector<std::string> texts;
    for (int k = 0; k < range.steps; ++k) {
      const double at = k == range.steps - 1 ? ends->to.number
                        : k == 0             ? ends->from.number
                                             : interpolated(ends->from.number, ends->to.number,
                                                            static_cast<double>(k) / (range.steps - 1), logarithmic);
      texts.push_back(with_unit(at, ends->from.unit));
    }
    return texts;
  }

  void check_names(const FitInput& all) const {
    for (std::size_t k = 0; k < item_.curves.size(); ++k)
      for (std::size_t i = 0; i < k; ++i)
        if (all.curves[i].name == all.curves[k].name)
          refuse(root_, fmt::format("fit.curves[{}].{}", k, item_.curves[k].name ? "name" : "file"),
                 fmt::format("got {} a second time; expected a name of its own; rename one", shown(all.curves[k].name)),
                 errors_);
  }

  void check_counts(const FitInput& all) const {
    std::size_t rows = 0, unknowns = all.parameters.size();
    for (const FitParameter& p : all.parameters) rows += p.prior ? 1 : 0;
    bool any = false;
    for (const FitCurve& c : all.curves) {
      if (c.use != FitCurve::Use::fit) continue;
      any = true;
      rows += c.rows;
      unknowns += c.has_offset ? 1 : 0;
    }
    if (!any)
      fail("fit.curves", "got none with `use: fit`; expected one at least; write `use: fit`, or delete the key");
    if (rows < unknowns)
      fail("fit.parameters",
           "got {} row{}, priors included, for {} parameters, offsets included; expected at least as many rows; "
           "measure more, or fix some parameters",
           rows, rows == 1 ? "" : "s", unknowns);
  }

  void read_profile(FitInput& all) const {
    if (!item_.profile || *item_.profile == "false") return;
    const Node& node = *find_path(root_, "fit.profile");
    for (const FitCurve& c : all.curves)
      if (c.use == FitCurve::Use::fit && c.loss.is_robust())
        fail("fit.profile",
             "got it with the robust loss of {}; expected `loss: squares` of all curves; delete one of the two",
             shown(c.name));
    if (*item_.profile == "true") {
      for (std::size_t k = 0; k < all.parameters.size(); ++k) all.profile.push_back(k);
      return;
    }
    if (node.kind != Node::Kind::sequence)
      fail("fit.profile", "got {}; expected a list of paths of parameters, or true", shown(*item_.profile));
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const std::string path = input::with_indices(root_, node.children[i].text);
      const auto found = std::ranges::find(all.parameters, path, &FitParameter::path);
      if (found == all.parameters.end())
        fail(fmt::format("fit.profile[{}]", i), "got {}; expected the path of a parameter: {}", shown(path),
             fmt::join(each(all.parameters, &FitParameter::path), ", "));
      all.profile.push_back(static_cast<std::size_t>(found - all.parameters.begin()));
    }
  }

  const FitItem& item_;
  CaseFile& file_;
  std::vector<input::EchoEntry> fields_;
  std::size_t rows_ = 0;
};

}  // namespace

FitInput read_fit_input(const input::Source& source) {
  input::ErrorList errors(source);
  const Node root = read_document(source, errors);
  const CaseFile whole = read_case_file(root, errors);
  if (!whole.fit) read_case_input(source, Command::fit);  // Reports the missing fit.
  errors.throw_if_any();
  Node base = root;
  std::erase_if(base.children, [](const Node& child) {
    return child.key == "optimize" || child.key == "study" || child.key == "fit";
  });
  CaseFile file = read_case_file(base, errors);
  errors.throw_if_any();
  return FitReader(*whole.fit, source, root, base, file, errors).read();
}

}  // namespace prs
