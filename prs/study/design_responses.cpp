#include "prs/study/design_responses.h"

#include <numeric>

#include "modules/response/response_analysis.h"
#include "prs/compare/compare_references.h"
#include "prs/compare/reference_analysis.h"
#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/reference/reference_reader.h"
#include "prs/slip/running.h"

namespace prs {
namespace {

Result analyze_for(Command command, const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (command == Command::contact) return analyze_contacts(c, std::move(contacts), options.detail);
  return command == Command::slip ? analyze_heat(c, std::move(contacts), options)
                                  : analyze_loads(c, std::move(contacts), options);
}

/// Status of the duty, or of the first load case, that did not converge.
DesignStatus status_of(const Result& result) {
  if (result.heat_cycle && !result.heat_cycle->converged())
    return {std::string(name(result.heat_cycle->status)), fmt::format("duty: {}", result.heat_cycle->reason)};
  for (const LoadCaseResult& load_case : result.load_cases) {
    if (load_case.heat && !load_case.heat->converged())
      return {std::string(name(load_case.heat->status)),
              fmt::format("load case {}: {}", load_case.load_case.name, load_case.heat->reason)};
    const bool slips = load_case.slip.has_value();
    if (load_case.converged() && (!slips || load_case.slip->has_answer())) continue;
    const std::string name(slips ? slip_status_name(load_case) : status_name(load_case));
    return {name, fmt::format("load case {} did not converge", load_case.load_case.name)};
  }
  return {};
}

/// The responses as numbers of results; none if one of them needs the document.
std::optional<std::vector<ResultNumber>> numbers_of(const std::vector<std::string>& responses) {
  std::vector<ResultNumber> numbers;
  for (const std::string& path : responses) {
    std::optional<ResultNumber> number = result_number(path);
    if (!number) return std::nullopt;
    numbers.push_back(std::move(*number));
  }
  return numbers;
}

/// Load cases of `all` that the numbers, or the duty, need, ascending.
std::vector<std::size_t> load_cases_of(const std::vector<ResultNumber>& numbers, std::size_t all, bool needs_duty) {
  std::vector<std::size_t> indices;
  if (needs_duty) {
    indices.resize(all);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
  }
  for (const ResultNumber& number : numbers)
    if (number.load_case) indices.push_back(*number.load_case);
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

/// Place in the case of load case k of a document: `contact` answers those of equal shares
/// alone.
std::size_t place_of(std::size_t k, const std::vector<LoadCase>& all, Command command) {
  if (command != Command::contact) return k;
  for (const auto at : indices(all))
    if (all[at].share == LoadCase::Share::equal && k-- == 0) return at;
  return all.size();
}

/// A case with nothing but some of its load cases, with their modes or not, and with its duty or not,
/// as long as this lives.
class OnlyLoadCases {
 public:
  OnlyLoadCases(Case& c, const std::vector<std::size_t>& indices, Command command, bool with_modes, bool with_duty,
                std::vector<LoadCase>& memory)
      : case_(c), with_duty_(with_duty), others_(memory) {
    others_.resize(indices.size());
    std::size_t known = 0;
    for (const std::size_t k : indices) {
      const std::size_t at = place_of(k, c.load_cases, command);
      if (at >= c.load_cases.size()) break;
      others_[known] = c.load_cases[at];
      if (!with_modes) others_[known].modes.reset();
      ++known;
    }
    others_.resize(known);
    exchange();
  }
  ~OnlyLoadCases() { exchange(); }
  OnlyLoadCases(const OnlyLoadCases&) = delete;
  OnlyLoadCases& operator=(const OnlyLoadCases&) = delete;

 private:
  void exchange() {
    std::swap(case_.load_cases, others_);
    if (case_.heat && !with_duty_) std::swap(case_.heat->duty, duty_);
  }

  Case& case_;
  bool with_duty_;
  std::vector<LoadCase>& others_;
  decltype(Heat::duty) duty_;
};

}  // namespace

/// The history of a case; that of the base case is read once.
std::optional<LoadHistory> DesignResponses::history_of(const Case& c) const {
  if (!c.life->history) return std::nullopt;
  if (history && c.life->history == history_source) return history;
  return input::read_force_history(*c.life->history, input.source);
}

/// Computes lives and calls `use` with them if there are any.
template <class Use>
DesignStatus DesignResponses::with_lives(const Case& c, Use use) const {
  const LifeResult result = analyze_warm_life(c, history_of(c));
  if (!result.converged()) return {"not_converged", *result.failure};
  use(result);
  return {};
}

/// The document of load cases, with the deviations of references if they are recorded.
Json DesignResponses::document_with_references(const Case& c, const input::Source& source, Result result) const {
  Json document = document_of(study.command == Command::slip ? slip_analysis() : solve_analysis(), result, {});
  if (!of_references) return document;
  ModelComparison comparison;
  comparison.models.push_back(std::move(result));
  compare_references(source, c, read_references(source, c), comparison);
  put_references(document, comparison);
  return document;
}

void DesignResponses::keep_history(const Case& base) {
  if (study.command != Command::life || !base.life->history) return;
  history = history_of(base);
  history_source = base.life->history;
}

DesignStatus DesignResponses::by_document(const Case& c, const input::Source& source, Json& document) const {
  if (study.command == Command::life)
    return with_lives(c, [&](const LifeResult& lives) { document = document_of(life_analysis(), lives, {}); });
  if (study.command == Command::response) {
    const ResponseResult result = analyze_response(c, input.source);
    if (!result.converged()) return {"not_converged", std::string(name(result.run.status))};
    document = document_of(response_analysis(), result, {});
    return {};
  }
  if (measures()) {
    const MeasuresResult result = analyze_measures(c);
    document = document_of(measures_analysis(), result, {});
    return status_of(result.analysis);
  }
  Result result = analyze_for(study.command, c, checked_contacts(c, Detail::complete), {});
  DesignStatus status = status_of(result);
  document = document_with_references(c, source, std::move(result));
  return status;
}

void DesignResponses::choose(const std::optional<Case>& base, const Json& document, Arrays arrays) {
  const std::size_t threads = base ? static_cast<std::size_t>(base->mechanism.contacts_per_roller) : 0;
  study.responses = recorded_columns(study, document, threads, arrays);
  if (study.command != Command::response) numbers = numbers_of(study.responses);
  if (!numbers) return;
  const bool has_mission = base && warms(base->heat) && base->heat->has_mission();
  needs_duty = has_mission || std::ranges::any_of(*numbers, &ResultNumber::needs_duty);
  load_cases = load_cases_of(*numbers, base ? base->load_cases.size() : 0, needs_duty);
  const auto of_mechanism = [](const ResultNumber& number) { return !number.load_case; };
  if (measures() || std::ranges::any_of(*numbers, of_mechanism)) contact_detail = ContactDetail::numbers;
  if (std::ranges::any_of(*numbers, &ResultNumber::needs_complete)) detail = Detail::complete;
}

void DesignResponses::set_numbers(double* row, const Answer& known, const std::vector<LoadCaseResult>& results,
                                  const std::vector<std::optional<LoadMeasures>>& load_measures) const {
  for (const auto k : up_to(numbers->size())) {
    const ResultNumber& number = (*numbers)[k];
    Answer answer = known;
    if (number.load_case) {
      const auto at = std::ranges::find(load_cases, *number.load_case);
      const auto index = static_cast<std::size_t>(at - load_cases.begin());
      if (index >= results.size()) continue;
      answer.load_case = &results[index];
      if (index < load_measures.size() && load_measures[index]) answer.load_measures = &*load_measures[index];
    }
    row[k] = number.value(answer).value_or(kNoResponse);
  }
}

void DesignResponses::set_numbers(double* row, const MeasuresResult& result) const {
  set_numbers(row, {.contacts = result.analysis.contacts, .measures = &result.measures}, result.analysis.load_cases,
              result.load_measures);
}

DesignStatus DesignResponses::answer(Case& c, const DesignReader& reader, Memory& memory, double* row,
                                     const Contacts* found) const {
  if (!numbers) {
    Json document;
    const DesignStatus status = by_document(c, of_references ? reader.source() : input.source, document);
    if (status.converged())
      for (const auto k : indices(study.responses))
        row[k] = response(document, study.responses[k]).value_or(kNoResponse);
    return status;
  }
  if (study.command == Command::life)
    return with_lives(c,
                      [&](const LifeResult& lives) { set_numbers(row, {.contacts = lives.contacts, .life = &lives}); });
  const OnlyLoadCases needed(c, load_cases, study.command, number_detail.modes, needs_duty, memory.load_cases);
  AnalysisOptions options = kManyDesigns;
  options.detail = detail;
  options.full = &memory.full;
  Contacts contacts = found ? *found : checked_contacts(c, options.detail);
  if (measures()) {
    const MeasuresResult result = analyze_measures(c, std::move(contacts), options);
    DesignStatus status = status_of(result.analysis);
    if (status.converged()) set_numbers(row, result);
    return status;
  }
  const Result result = analyze_for(study.command, c, std::move(contacts), options);
  DesignStatus status = status_of(result);
  const HeatCycle* cycle = result.heat_cycle ? &*result.heat_cycle : nullptr;
  if (status.converged()) set_numbers(row, {.contacts = result.contacts, .cycle = cycle}, result.load_cases);
  return status;
}

}  // namespace prs
