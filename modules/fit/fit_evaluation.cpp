#include "modules/fit/fit_evaluation.h"

#include <mutex>

#include "modules/response/response_analysis.h"
#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/input/readings.h"
#include "prs/losses/preload_analysis.h"
#include "prs/optimize/optimizer.h"
#include "prs/preload/preload_record.h"
#include "prs/record/record_table.h"
#include "prs/study/design_engine.h"
#include "prs/study/design_reader.h"
#include "prs/study/response.h"
#include "prs/study/study_run.h"

namespace prs {
namespace {

namespace estimation = modules::fit;
using modules::fit::Failure, modules::fit::Request;

/// Results of one design: a number for each response, or rows of them.
struct RowsOfDesign {
  std::vector<std::vector<double>> values;  ///< Values of each curve of its group; NaN for missing ones.
  std::string reason;                       ///< Reason why there are none at all.
  bool is_refused = false;
};

/// Curves of one case: with the same conditions, so that they share computations.
struct Group {
  std::string key;
  std::vector<std::size_t> curves;
  std::vector<std::size_t> response_of;  ///< Response of each curve in the study, which has each once.
  input::StudyInput input;
  std::vector<std::vector<Draw>> designs;           ///< Draws of the conditions, without repetition.
  std::vector<std::vector<std::size_t>> design_of;  ///< Design of each row of each curve.
  std::vector<double> places = {};                  ///< Places of a series, ascending.
  std::vector<std::vector<std::size_t>> place_of = {};
  std::unique_ptr<DesignEngine> engine = {};
  std::string without_answer = {};  ///< Reason why there is no engine.
  /// Losses of cycles, by the parameters that they depend on.
  std::map<std::vector<double>, DutyLosses> losses = {};
  std::vector<DesignReader> idle = {};
  std::unique_ptr<std::mutex> mutex = std::make_unique<std::mutex>();
};

/// A duty with steps split at each of these times.
std::vector<Heat::DutyStep> cut(const std::vector<Heat::DutyStep>& duty, const std::vector<double>& times) {
  double period = 0.0;
  for (const Heat::DutyStep& step : duty) period += step.time();
  std::vector<Heat::DutyStep> pieces;
  double start = 0.0;
  for (const Heat::DutyStep& step : duty) {
    const double end = start + step.time();
    double from = start;
    const auto add = [&](double to) {
      Heat::DutyStep piece = step;
      (piece.load_case ? piece.duration : piece.rest) = to - from;
      pieces.push_back(piece);
      from = to;
    };
    for (const double t : times)
      if (t > from + 1e-9 * period && t < end - 1e-9 * period) add(t);
    add(end);
    start = end;
  }
  return pieces;
}

/// Duration of a series in time.
double period_of(const Case& c, const std::string& series) {
  if (series == "response.time_s") return c.response ? c.response->duration : 0.0;
  double period = 0.0;
  if (c.heat)
    for (const Heat::DutyStep& step : c.heat->duty) period += step.time();
  return period;
}

/// Sorts places and removes repeated ones.
void sort_once(std::vector<double>& places) {
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

}  // namespace

struct FitEvaluation::Parts {
  Parts(const FitInput& given, std::size_t on) : input(given), threads(on) {
    for (std::size_t c = 0; c < input.curves.size(); ++c) add(c);
    for (Group& group : groups) prepare(group);
  }

  void add(std::size_t index) {
    const FitCurve& curve = input.curves[index];
    std::string key = fmt::format("{} {} {}", curve.command.word, curve.series, flow_text(curve.base));
    for (const FitCondition& condition : curve.conditions) key += condition.path + condition.unit;
    auto group = std::ranges::find(groups, key, &Group::key);
    if (group == groups.end()) {
      group = groups.insert(groups.end(), Group{.key = key,
                                                .curves = {},
                                                .response_of = {},
                                                .input = {input.source, curve.base, {}},
                                                .designs = {},
                                                .design_of = {}});
      Study& study = group->input.study;
      study.command = curve.command;
      study.plan = Plan::monte_carlo;
      for (const FitParameter& p : input.parameters) study.factors.push_back(factor(p.path, p.unit));
      for (const FitCondition& condition : curve.conditions)
        study.factors.push_back(factor(condition.path, condition.unit));
    }
    group->curves.push_back(index);
    std::vector<std::string>& responses = group->input.study.responses;
    const auto response = std::ranges::find(responses, curve.response);
    group->response_of.push_back(static_cast<std::size_t>(response - responses.begin()));
    if (response == responses.end()) responses.push_back(curve.response);
    group->places.insert(group->places.end(), curve.places.begin(), curve.places.end());
  }

  static Factor factor(const std::string& path, const std::string& unit) {
    Factor f{.path = path, .label = path, .unit = unit, .levels = {}, .base = {}};
    f.continuous = true;
    return f;
  }

  void prepare(Group& group) {
    input::ErrorList errors(input.source);
    const input::CaseFile file = read_case_file(group.input.base, errors);
    if (errors.empty()) check_times(group, first_case(file, group, errors));
    errors.throw_if_any();
    sort_once(group.places);
    set_designs(group);
    set_bases(group);
    const FitCurve& first = first_curve(group);
    try {
      if (first.series.empty() && first.command != Command::preload)
        group.engine = std::make_unique<DesignEngine>(group.input, simd::InstructionSet::best, Arrays::refused);
      else
        check_document(group);
    } catch (const UnknownResponse& error) {
      // Known responses may have no result at the start.
      const auto k = std::ranges::find(group.response_of, error.index()) - group.response_of.begin();
      const FitCurve& curve = input.curves[group.curves[static_cast<std::size_t>(k)]];
      if (!curve.is_usual_command || !result_number(curve.response))
        input::fail_at(input.source, curve.at + ".response", error.what());
      group.without_answer = "no " + curve.response;
    }
  }

  const FitCurve& first_curve(const Group& group) const { return input.curves[group.curves[0]]; }

  /// Series in time stand within the period of the case.
  void check_times(const Group& group, const Case& base) const {
    const FitCurve& first = first_curve(group);
    if (!first.series.ends_with(".time_s")) return;
    const double period = period_of(base, first.series);
    if (period == 0.0)
      input::fail_at(input.source, first.at + ".response",
                     "got {} of a case without a duty; expected `heat.duty`; add for example `duty: [{{load_case: "
                     "{}, duration: 60 min}}, {{rest: 12 h}}]`",
                     first.response, base.load_cases.empty() ? "run" : base.load_cases[0].name);
    for (const std::size_t c : group.curves) {
      const FitCurve& curve = input.curves[c];
      for (std::size_t i = 0; i < curve.rows; ++i)
        if (const double t = curve.places[i]; !(t >= 0.0 && t <= period * (1.0 + 1e-12)))
          throw input::InputError(fmt::format(
              "{}:{}:{}: error: {}: got {:g} s; expected a time of the period, 0 to {:g} s; fix or delete the row",
              name_in_messages(curve.file, input.source), curve.lines[i], curve.columns[i], first.series, t, period));
    }
  }

  /// Numbers the conditions of all rows, each once.
  void set_designs(Group& group) const {
    std::map<std::vector<std::string>, std::size_t> known;
    for (const std::size_t c : group.curves) {
      const FitCurve& curve = input.curves[c];
      auto& design_of = group.design_of.emplace_back();
      auto& place_of = group.place_of.emplace_back();
      for (std::size_t i = 0; i < curve.rows; ++i) {
        if (!curve.series.empty())
          place_of.push_back(
              static_cast<std::size_t>(std::ranges::lower_bound(group.places, curve.places[i]) - group.places.begin()));
        const auto texts = each(curve.conditions, [&](const FitCondition& condition) { return condition.texts[i]; });
        const auto [at, is_new] = known.try_emplace(texts, group.designs.size());
        design_of.push_back(at->second);
        if (is_new) group.designs.push_back(conditions_of(group, curve, texts));
      }
    }
  }

  /// Draws of the conditions of a row; words become levels.
  std::vector<Draw> conditions_of(Group& group, const FitCurve& curve, const std::vector<std::string>& texts) const {
    std::vector<Draw> draws;
    for (std::size_t j = 0; j < texts.size(); ++j) {
      if (!curve.conditions[j].unit.empty()) {
        draws.push_back({.kind = Draw::Kind::number, .number = *input::parse_number(texts[j])});
        continue;
      }
      std::vector<Level>& levels = group.input.study.factors[input.parameters.size() + j].levels;
      const auto level = std::ranges::find(levels, texts[j], &Level::text);
      draws.push_back({.kind = Draw::Kind::level, .level = static_cast<std::size_t>(level - levels.begin())});
      if (level == levels.end()) levels.push_back({texts[j], input::parse_number(texts[j])});
    }
    return draws;
  }

  void set_bases(Group& group) const {
    for (std::size_t j = 0; j < group.input.study.factors.size(); ++j) {
      Factor& f = group.input.study.factors[j];
      const Draw* draw = j < input.parameters.size() ? nullptr : &group.designs[0][j - input.parameters.size()];
      const double number = draw ? draw->number : input.parameters[j].start;
      f.base = draw && draw->kind == Draw::Kind::level ? f.levels[draw->level]
                                                       : Level{input::with_unit(number, f.unit), number};
      if (f.levels.empty()) f.distribution = {Distribution::Kind::uniform, number, number};
    }
  }

  /// Case of the first row, at whose place its errors are reported.
  Case first_case(const input::CaseFile& file, const Group& group, input::ErrorList& errors) const {
    const std::size_t c = group.curves[0];
    const FitCurve& curve = input.curves[c];
    try {
      Case base = checked_case(file, group.input.base, group.input.study.command, errors);
      errors.throw_if_any();
      return base;
    } catch (const input::InputError& error) {
      if (curve.conditions.empty()) throw;
      input::fail_at(input.source, curve.at, "got a case that its command refuses at {}: {}", place_of(input, c, 0),
                     error.what());
    }
  }

  /// Checks that a design which no study can run has its responses.
  void check_document(Group& group) {
    const std::string& series = first_curve(group).series;
    if (series == "response.time_s") return;  // Keys of the series are known.
    if (series == "heat_cycle.time_s") {
      for (const auto k : indices(group.input.study.responses))
        if (part_of(group.input.study.responses[k]) == nullptr)
          throw UnknownResponse(
              k, fmt::format(
                     "got {}; expected `heat_cycle.temperature_degC.screw`, `.rollers` or `.nut`; write one of them",
                     group.input.study.responses[k]));
      return;
    }
    const RowsOfDesign found = rows_of(group, with_parameters(group, starts(), 0));
    if (!found.reason.empty()) return;  // Reported where the response is evaluated.
    for (const auto k : indices(group.input.study.responses)) {
      if (std::ranges::any_of(found.values[k], [](double v) { return std::isfinite(v); })) continue;
      std::vector<std::string_view> keys;
      const RecordInfo& record = describe<PreloadPointOf>();
      for (const QuantityInfo& q : record.quantities)
        if (q.kind == Kind::number) keys.push_back(q.key);
      const std::string_view path = group.input.study.responses[k];
      throw UnknownResponse(
          k, fmt::format("got {}; expected a number of `prs preload`, of a series one of {}; did you mean `{}`?", path,
                         fmt::join(keys, ", "),
                         fmt::join(input::near_words(path.substr(path.rfind('.') + 1), keys), "`, `")));
    }
  }

  std::vector<double> starts() const { return each(input.parameters, &FitParameter::start); }

  std::vector<Draw> with_parameters(const Group& group, const std::vector<double>& u, std::size_t design) const {
    std::vector<Draw> draws;
    for (std::size_t j = 0; j < input.parameters.size(); ++j) {
      const FitParameter& p = input.parameters[j];
      draws.push_back({.kind = Draw::Kind::number, .number = std::clamp(u[j], p.from, p.to)});
    }
    const std::vector<Draw>& conditions = group.designs[design];
    draws.insert(draws.end(), conditions.begin(), conditions.end());
    return draws;
  }

  static const std::vector<double>* part_of(const std::string& response, const HeatCycle* cycle = nullptr) {
    static const std::vector<double> there;
    constexpr std::pair<std::string_view, std::vector<double> PerPart<std::vector<double>>::*> kNames[] = {
        {"screw", &PerPart<std::vector<double>>::screw},
        {"rollers", &PerPart<std::vector<double>>::roller},
        {"nut", &PerPart<std::vector<double>>::nut}};
    for (const auto& [word, part] : kNames)
      if (response == fmt::format("heat_cycle.temperature_degC.{}", word))
        return cycle ? &(cycle->temperature.*part) : &there;
    return nullptr;
  }

  DesignReader borrowed(Group& group) {
    const std::lock_guard lock(*group.mutex);
    if (group.idle.empty()) return DesignReader(group.input);
    DesignReader reader = std::move(group.idle.back());
    group.idle.pop_back();
    return reader;
  }

  /// Parameters that affect the losses at given temperatures of the parts.
  std::vector<double> parameters_of_losses(const std::vector<Draw>& draws) const {
    std::vector<double> values;
    for (std::size_t j = 0; j < input.parameters.size(); ++j) {
      const std::string& path = input.parameters[j].path;
      if (std::ranges::none_of(std::array{"heat.conductance", "heat.capacity", "heat.specific_heat"},
                               [&](const char* head) { return path.starts_with(head); }))
        values.push_back(draws[j].number);
    }
    return values;
  }

  /// Results of a design that no study can run. `found`: receives newly computed losses of a cycle.
  RowsOfDesign rows_of(Group& group, const std::vector<Draw>& draws, DutyLosses* found = nullptr) {
    RowsOfDesign rows;
    DesignReader reader = borrowed(group);
    try {
      Case& c = reader.read(draws);
      if (const std::string& series = first_curve(group).series; series == "heat_cycle.time_s")
        set_cycle(group, c, parameters_of_losses(draws), found, rows);
      else if (series == "response.time_s")
        set_response(group, c, rows);
      else
        set_preload(group, c, rows);
    } catch (const input::InputError& error) {
      rows.reason = error.what(), rows.is_refused = true;
    } catch (const CaseError& error) {
      rows.reason = error.problem().text(), rows.is_refused = true;
    }
    const std::lock_guard lock(*group.mutex);
    group.idle.push_back(std::move(reader));
    return rows;
  }

  static void set_cycle(const Group& group, Case& c, const std::vector<double>& key, DutyLosses* found,
                        RowsOfDesign& rows) {
    const auto known = group.losses.find(key);
    std::vector<Heat::DutyStep> duty = cut(c.heat->duty, group.places);
    std::swap(duty, c.heat->duty);
    std::vector<Warning> none;
    const HeatCycle cycle = duty_cycle(c, checked_contacts(c, Detail::numbers), none,
                                       known == group.losses.end() ? nullptr : &known->second, found);
    std::swap(duty, c.heat->duty);
    if (!cycle.converged()) {
      rows.reason = cycle.reason;
      return;
    }
    for (const std::string& response : group.input.study.responses) {
      std::vector<double>& values = rows.values.emplace_back();
      const std::vector<double>& course = *part_of(response, &cycle);
      for (const double t : group.places) {
        auto at = std::ranges::lower_bound(cycle.time, t - 2e-9 * cycle.period);
        if (at == cycle.time.end()) --at;
        values.push_back(course[static_cast<std::size_t>(at - cycle.time.begin())] - 273.15);
      }
    }
  }

  void set_response(const Group& group, const Case& c, RowsOfDesign& rows) const {
    const ResponseResult result = analyze_response(c, input.source, &group.places);
    if (!result.converged()) {
      rows.reason = name(result.run.status);
      return;
    }
    Json document;
    response_analysis().put(document, result);
    for (const std::string& path : group.input.study.responses)
      rows.values.push_back(document["response"][path.substr(path.find('.') + 1)].get<std::vector<double>>());
  }

  static void set_preload(const Group& group, Case& c, RowsOfDesign& rows) {
    std::vector<double> loads = group.places;
    std::swap(loads, c.preload->load.loads);
    const PreloadResult result = analyze_warm_preload(c);
    std::swap(loads, c.preload->load.loads);
    Json document;
    preload_analysis().put(document, result);
    for (const std::string& path : group.input.study.responses) {
      std::vector<double>& values = rows.values.emplace_back();
      const std::size_t place = path.find("[]");
      for (std::size_t i = 0; i < std::max<std::size_t>(group.places.size(), 1); ++i) {
        std::string at = path;
        if (place != at.npos) at.insert(place + 1, std::to_string(i));
        values.push_back(response(document, at).value_or(kNoResponse));
      }
    }
    if (group.places.empty() && !result.converged()) rows.reason = "preload did not converge";
  }

  /// Computes designs that no study runs. One of each kind of losses goes first, the others take its tables: the
  /// same with any threads.
  std::vector<RowsOfDesign> computed_alone(Group& group, const std::vector<std::vector<Draw>>& designs) {
    std::vector<RowsOfDesign> all(designs.size());
    std::vector<DutyLosses> found(designs.size());
    std::vector<std::size_t> later;
    const bool has_losses = first_curve(group).series == "heat_cycle.time_s";
    if (group.losses.size() > 64) group.losses.clear();
    const auto keep_losses = [&](std::size_t k) {
      if (!found[k].tables.empty()) group.losses[parameters_of_losses(designs[k])] = std::move(found[k]);
    };
    for (std::size_t k = 0; k < designs.size(); ++k) {
      if (!has_losses || group.losses.contains(parameters_of_losses(designs[k]))) {
        later.push_back(k);
        continue;
      }
      all[k] = rows_of(group, designs[k], &found[k]);
      keep_losses(k);
    }
    run_in_order(later.size(), threads, [&](std::size_t at) -> std::function<void()> {
      const std::size_t k = later[at];
      auto rows = std::make_shared<RowsOfDesign>(rows_of(group, designs[k], &found[k]));
      return [&all, k, rows] { all[k] = std::move(*rows); };
    });
    std::ranges::for_each(later, keep_losses);
    return all;
  }

  std::vector<RowsOfDesign> computed(Group& group, const std::vector<std::vector<Draw>>& designs) {
    std::vector<RowsOfDesign> all(designs.size());
    if (!group.without_answer.empty()) {
      for (RowsOfDesign& rows : all) rows.reason = group.without_answer;
      return all;
    }
    if (!group.engine) {
      evaluated += designs.size() * std::max<std::size_t>(group.places.size(), 1);
      return computed_alone(group, designs);
    }
    const RowBlock block = evaluate_in_parallel(*group.engine, threads)(designs);
    evaluated += designs.size();
    const std::size_t width = group.input.study.responses.size();
    for (std::size_t k = 0; k < all.size(); ++k)
      for (std::size_t j = 0; j < width; ++j) all[k].values.push_back({block.responses[k * width + j]});
    for (const RowBlock::Failure& failure : block.failures) {
      all[failure.row].reason = failure.status.reason.empty() ? failure.status.name : failure.status.reason;
      all[failure.row].is_refused = failure.status.name == "refused";
    }
    return all;
  }

  void answer(Group& group, const std::vector<Request>& requests, std::vector<estimation::Answer>& answers) {
    struct Wanted {
      std::size_t request = 0, first = 0;
    };
    std::vector<Wanted> wanted;
    std::vector<std::vector<Draw>> designs;
    for (std::size_t r = 0; r < requests.size(); ++r) {
      if (std::ranges::none_of(group.curves, [&](std::size_t c) { return requests[r].curves[c]; })) continue;
      wanted.push_back({r, designs.size()});
      for (std::size_t d = 0; d < group.designs.size(); ++d)
        designs.push_back(with_parameters(group, requests[r].values, d));
    }
    if (wanted.empty()) return;
    const std::vector<RowsOfDesign> all = computed(group, designs);
    for (const auto& [r, first] : wanted)
      for (std::size_t k = 0; k < group.curves.size(); ++k) {
        const std::size_t c = group.curves[k];
        if (!requests[r].curves[c]) continue;
        for (std::size_t i = 0; i < input.curves[c].rows; ++i) {
          const RowsOfDesign& rows = all[first + group.design_of[k][i]];
          const double value = !rows.reason.empty()   ? kNoResponse
                               : group.places.empty() ? rows.values[group.response_of[k]][0]
                                                      : rows.values[group.response_of[k]][group.place_of[k][i]];
          answers[r].values[c].push_back(value);
          if (std::isfinite(value) || (answers[r].failure && answers[r].failure->curve <= c)) continue;
          answers[r].failure =
              Failure{c, i, rows.reason.empty() ? "no " + input.curves[c].response : rows.reason, rows.is_refused};
        }
      }
  }

  const FitInput& input;
  std::size_t threads;
  std::vector<Group> groups;
  std::size_t evaluated = 0;
};

FitEvaluation::FitEvaluation(const FitInput& input, std::size_t threads)
    : parts_(std::make_unique<Parts>(input, threads)) {}
FitEvaluation::~FitEvaluation() = default;

std::vector<estimation::Answer> FitEvaluation::operator()(const std::vector<Request>& requests) {
  std::vector<estimation::Answer> answers(requests.size());
  for (estimation::Answer& answer : answers) answer.values.resize(parts_->input.curves.size());
  for (Group& group : parts_->groups) parts_->answer(group, requests, answers);
  return answers;
}

std::size_t FitEvaluation::rows() const { return parts_->evaluated; }

}  // namespace prs
