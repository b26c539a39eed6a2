#include "prs/study/design_engine.h"

#include <numeric>

#include "modules/response/response_analysis.h"
#include "prs/compare/compare_references.h"
#include "prs/compare/reference_analysis.h"
#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/input/force_history.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/reference/reference_reader.h"
#include "prs/slip/running.h"
#include "prs/study/design_batches.h"
#include "prs/study/design_reader.h"
#include "prs/study/response.h"

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

/// Runs `compute` and returns the reason if it stopped.
template <class Compute>
DesignStatus status_after(Compute compute) {
  try {
    return compute();
  } catch (const input::InputError& error) {
    return {"refused", error.what()};
  } catch (const CaseError& error) {
    return {"refused", error.problem().text()};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {"failed", error.what()};
  }
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

/// Results of batches besides loads and approaches, and whether load cases have their modes.
struct NumberDetail {
  LoadDetail loads;
  SlipDetail slip;
  bool modes = true;
};

/// Whether numbers are the same to rounding, or missing in both.
bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return std::isnan(x) == std::isnan(y) && !(std::abs(x - y) > 1e-9 * std::abs(x));
  });
}

/// Designs whose contacts are found and whose sectors are solved together: many lanes, little
/// memory.
constexpr std::size_t kBatch = 64;

/// Whether designs that follow are left out.
using Stop = std::function<bool()>;

/// Reads the case of the design that a row of a block answers.
using ReadRow = std::function<Case&(DesignReader& reader, std::size_t row)>;

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

/// The mechanism, if it is valid; none if the scalar chain must report the error.
std::optional<Mechanism> sound_mechanism(Case& c) {
  try {
    return checked_mechanism(c);
  } catch (const CaseError&) {
    return std::nullopt;
  }
}

}  // namespace

struct DesignEngine::Parts {
  Parts(const input::StudyInput& given, simd::InstructionSet instructions)
      : input(given), study(given.study), set(instructions) {}

  const input::StudyInput& input;
  Study study;
  simd::InstructionSet set;
  std::optional<std::vector<ResultNumber>> numbers;
  std::vector<std::size_t> load_cases;                 ///< Load cases that the numbers need.
  bool needs_duty = false;                             ///< Whether one of the numbers, or temperatures, is of a duty.
  bool in_columns = false;                             ///< Whether BarBatch or SlipBatch gets what it takes.
  NumberDetail number_detail;                          ///< Load-case data for the numbers.
  bool of_references = false;                          ///< Whether deviations of references are recorded.
  Detail detail = Detail::numbers;                     ///< Detail of the results for the numbers.
  ContactDetail contact_detail = ContactDetail::laws;  ///< Detail of the contacts for the numbers.
  bool side_by_side = true;                            ///< Whether the bodies of the base case take many designs.
  bool all_rollers = false;                            ///< Whether it is a full mechanism.
  std::optional<LoadHistory> history;                  ///< History of the base case.
  std::optional<HistorySource> history_source;

  /// Data of a thread.
  struct Worker {
    Worker(const input::StudyInput& input, simd::InstructionSet set)
        : reader(input), columns(set), slips(set), sectors(set), contacts(set) {}

    DesignReader reader;
    FullSolver full;
    BarBatch columns;
    SlipBatch slips;
    SectorBatch sectors;
    SharedContacts contacts;
    /// Rows that no batch answers, and their contacts, where these are found together.
    struct Alone {
      std::size_t row = 0;
      std::optional<std::size_t> contacts = {};
    };
    std::vector<Alone> alone;
    std::vector<LoadCase> load_cases;  ///< Memory of `OnlyLoadCases`.
  };

  /// A worker that no other thread has, as long as the pointer lives.
  auto borrowed() {
    std::unique_ptr<Worker> worker;
    if (const std::lock_guard lock(mutex); !idle.empty()) {
      worker = std::move(idle.back());
      idle.pop_back();
    }
    if (!worker) worker = std::make_unique<Worker>(input, set);
    const auto give_back = [this](Worker* used) noexcept {
      std::unique_ptr<Worker> owned(used);
      try {
        const std::lock_guard lock(mutex);
        idle.push_back(std::move(owned));
      } catch (const std::bad_alloc&) {  // A worker that cannot be kept is made again.
      }
    };
    return std::unique_ptr<Worker, decltype(give_back)>(worker.release(), give_back);
  }

  bool measures() const { return study.command == Command::measures; }
  bool in_batches() const {
    return numbers && (study.command == Command::solve || (measures() && !load_cases.empty()));
  }
  /// Whether contacts of many designs are found together; those of Detail::complete are not.
  bool shares_contacts() const { return numbers && detail == Detail::numbers && study.command != Command::life; }

  /// The history of a case; that of the base case is read once.
  std::optional<LoadHistory> history_of(const Case& c) const {
    if (!c.life->history) return std::nullopt;
    if (history && c.life->history == history_source) return history;
    return input::read_force_history(*c.life->history, input.source);
  }

  /// Computes lives and calls `use` with them if there are any.
  template <class Use>
  DesignStatus with_lives(const Case& c, Use use) const {
    const LifeResult result = analyze_warm_life(c, history_of(c));
    if (!result.converged()) return {"not_converged", *result.failure};
    use(result);
    return {};
  }

  /// The document of load cases, with the deviations of references if they are recorded.
  Json document_with_references(const Case& c, const input::Source& source, Result result) const {
    Json document = document_of(study.command == Command::slip ? slip_analysis() : solve_analysis(), result, {});
    if (!of_references) return document;
    ModelComparison comparison;
    comparison.models.push_back(std::move(result));
    compare_references(source, c, read_references(source, c), comparison);
    put_references(document, comparison);
    return document;
  }

  /// The chain of the command on the case of a source, the whole document.
  DesignStatus by_document(const Case& c, const input::Source& source, Json& document) const {
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

  void read_base(Arrays arrays) {
    const auto of_reference = [](const std::string& path) { return path.starts_with("references["); };
    of_references = (study.command == Command::solve || study.command == Command::slip) &&
                    std::ranges::any_of(study.responses, of_reference);
    Json document;
    std::size_t all_load_cases = 0, threads = 0;
    const auto worker = borrowed();
    std::optional<Case> base;
    const DesignStatus status = status_after([&] {
      base = worker->reader.read(0);
      all_load_cases = base->load_cases.size();
      threads = static_cast<std::size_t>(base->mechanism.contacts_per_roller);
      side_by_side = base->model.bodies->side_by_side;
      all_rollers = base->model.all_rollers();
      if (study.command == Command::life && base->life->history) {
        history = history_of(*base);
        history_source = base->life->history;
      }
      return by_document(*base, input.source, document);
    });
    if (base && of_references)
      read_references(input.source, *base);  // An error in a file fails the study, not a design.
    if (!status.converged()) document = nullptr;
    study.responses = recorded_columns(study, document, threads, arrays);
    if (study.command != Command::response) numbers = numbers_of(study.responses);
    if (!numbers) return;
    const bool has_mission = base && warms(base->heat) && base->heat->has_mission();
    needs_duty = has_mission || std::ranges::any_of(*numbers, &ResultNumber::needs_duty);
    load_cases = load_cases_of(*numbers, all_load_cases, needs_duty);
    const auto of_mechanism = [](const ResultNumber& number) { return !number.load_case; };
    if (measures() || std::ranges::any_of(*numbers, of_mechanism)) contact_detail = ContactDetail::numbers;
    if (std::ranges::any_of(*numbers, &ResultNumber::needs_complete)) detail = Detail::complete;
    in_columns = (study.command == Command::solve || study.command == Command::slip) && detail == Detail::numbers;
    if (!document.is_null())
      leave_out_parts(*base, *worker, document);
    else if (all_rollers)
      detail = Detail::complete;
  }

  /// Leaves out of all designs each part of the results without which the base case has the same numbers. What
  /// the numbers lack is computed in full.
  void leave_out_parts(const Case& base, const Worker& worker, const Json& document) {
    const auto row = [&] {
      return evaluate(0, 1, [](DesignReader& reader, std::size_t) -> Case& { return reader.read(0); }, {}).responses;
    };
    std::vector<bool*> parts;
    if (std::ranges::any_of(base.load_cases, [](const LoadCase& load) { return load.modes.has_value(); }))
      parts.push_back(&number_detail.modes);
    else
      number_detail.modes = false;
    auto& [loads, slip, modes] = number_detail;
    if (goes_to_columns(base, worker))
      parts.insert(parts.end(), {&loads.axial_load, &loads.load_rate, &loads.ellipses, &loads.tangent_stiffness,
                                 &slip.threads, &slip.films});
    else if (goes_to_sectors(base))
      parts.push_back(&loads.tangent_stiffness);
    else if (!all_rollers)
      return;
    std::vector<double> documented;
    for (const std::string& path : study.responses)
      documented.push_back(response(document, path).value_or(kNoResponse));
    const auto has_all = [&](const std::vector<double>& found) {
      return std::ranges::equal(found, documented,
                                [](double f, double d) { return std::isfinite(f) || std::isnan(d); });
    };
    std::vector<double> whole = row();
    if (!has_all(whole) && detail == Detail::numbers) {
      detail = Detail::complete;
      in_columns = false;
      whole = row();
    }
    if (!has_all(whole)) numbers.reset();
    for (bool* part : parts) {
      if (!numbers) return;
      *part = false;
      *part = !are_same(row(), whole);
    }
  }

  /// `known`: all that does not depend on the load case.
  void set_numbers(double* row, const Answer& known, const std::vector<LoadCaseResult>& results = {},
                   const std::vector<std::optional<LoadMeasures>>& load_measures = {}) const {
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

  void set_numbers(double* row, const MeasuresResult& result) const {
    set_numbers(row, {.contacts = result.analysis.contacts, .measures = &result.measures}, result.analysis.load_cases,
                result.load_measures);
  }

  /// `found`: the contacts, where they are known.
  DesignStatus answer(Case& c, Worker& worker, double* row, const Contacts* found = nullptr) const {
    if (!numbers) {
      Json document;
      const DesignStatus status = by_document(c, of_references ? worker.reader.source() : input.source, document);
      if (status.converged())
        for (const auto k : indices(study.responses))
          row[k] = response(document, study.responses[k]).value_or(kNoResponse);
      return status;
    }
    if (study.command == Command::life)
      return with_lives(
          c, [&](const LifeResult& lives) { set_numbers(row, {.contacts = lives.contacts, .life = &lives}); });
    const OnlyLoadCases needed(c, load_cases, study.command, number_detail.modes, needs_duty, worker.load_cases);
    AnalysisOptions options = kManyDesigns;
    options.detail = detail;
    options.full = &worker.full;
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

  RowBlock evaluate(std::size_t first, std::size_t rows, const ReadRow& read, const Stop& stop) {
    RowBlock block{first, rows, {}, {}};
    block.responses.assign(rows * study.responses.size(), kNoResponse);
    const auto worker = borrowed();
    for (std::size_t row = 0; row < block.rows;) {
      row = evaluate_batch(read, row, std::min(row + kBatch, block.rows), *worker, block, stop);
      if (row < block.rows && stop && stop()) block.rows = row;
    }
    block.responses.resize(block.rows * study.responses.size());
    std::erase_if(block.failures, [&](const auto& failure) { return failure.row >= block.rows; });
    std::ranges::sort(block.failures, {}, &RowBlock::Failure::row);
    return block;
  }

  /// Evaluates rows [from, to) of a block, or those before the returned row: side by side if a batch takes them, then
  /// one by one the rest, whose contacts are found together.
  std::size_t evaluate_batch(const ReadRow& read, std::size_t from, std::size_t to, Worker& worker, RowBlock& block,
                             const Stop& stop) const {
    const auto keep_failure = [&](std::size_t row, const auto& compute) {
      DesignStatus status = status_after(compute);
      if (!status.converged()) block.failures.push_back({row, std::move(status)});
    };
    read_batch(read, from, to, worker, keep_failure);
    const auto take = [&](std::size_t row, const std::vector<LoadCaseResult>& results, const Contacts& contacts) {
      set_numbers(row_of(block, row), {.contacts = contacts}, results);
    };
    const auto leave = [&](std::size_t row) { worker.alone.push_back({row}); };
    worker.columns.solve(number_detail.loads, take, leave);
    worker.slips.solve(number_detail.loads, number_detail.slip, take, leave);
    worker.sectors.solve(
        contact_detail, measures() || number_detail.loads.tangent_stiffness,
        [&](SectorBatch::Design& design) {
          if (measures())
            measure(design, row_of(block, design.row));
          else
            take(design.row, design.load_cases, design.contacts);
        },
        leave);
    worker.contacts.find();
    std::ranges::sort(worker.alone, {}, &Worker::Alone::row);
    Contacts found;
    for (const auto& [row, contacts] : worker.alone) {
      const bool known = worker.contacts.get(contacts, contact_detail, found);
      keep_failure(row, [&, row = row] {
        return answer(read(worker.reader, row), worker, row_of(block, row), known ? &found : nullptr);
      });
      if (stop && stop()) return row + 1;
    }
    return to;
  }

  /// Gives each row to a batch, or to those that are answered alone.
  void read_batch(const ReadRow& read, std::size_t from, std::size_t to, Worker& worker,
                  const auto& keep_failure) const {
    worker.columns.clear(contact_detail);
    worker.slips.clear(contact_detail);
    worker.sectors.clear();
    worker.contacts.clear();
    worker.alone.clear();
    for (std::size_t row = from; row < to; ++row) {
      if (!in_batches() && !shares_contacts()) {
        worker.alone.push_back({row});
        continue;
      }
      keep_failure(row, [&]() -> DesignStatus {
        Case& c = read(worker.reader, row);
        if (add_to_batch(row, c, worker)) return {};
        worker.alone.push_back({row});
        if (!in_batches())
          status_after([&]() -> DesignStatus {
            worker.alone.back().contacts = worker.contacts.add(c.mechanism, c.materials);
            return {};
          });
        return {};
      });
    }
  }

  /// Whether BarBatch or SlipBatch takes the design.
  bool goes_to_columns(const Case& c, const Worker& worker) const {
    if (!in_columns || runs(c)) return false;
    return study.command == Command::slip ? worker.slips.takes(c, load_cases) : BarBatch::takes(c, load_cases);
  }
  bool goes_to_sectors(const Case& c) const { return in_batches() && !runs(c) && c.model.side_by_side(); }
  bool runs(const Case& c) const {
    return study.command == Command::solve && c.model.loads == ModelOptions::Loads::running;
  }

  /// Adds a design to a batch; false if no batch takes it.
  bool add_to_batch(std::size_t row, Case& c, Worker& worker) const {
    if (goes_to_columns(c, worker)) {
      const std::optional<Mechanism> mechanism = sound_mechanism(c);
      if (!mechanism) return false;
      if (study.command == Command::slip)
        worker.slips.add(row, c, *mechanism, load_cases);
      else
        worker.columns.add(row, c, *mechanism, load_cases);
      return true;
    }
    if (!goes_to_sectors(c)) return false;
    worker.sectors.add(row, c, load_cases, measures(), detail);
    return true;
  }

  /// Measures a design whose load cases are solved.
  void measure(SectorBatch::Design& design, double* row) const {
    Result solved;
    std::swap(solved.contacts, design.contacts);
    std::swap(solved.load_cases, design.load_cases);
    MeasuresResult result = measured(design.conditions, std::move(solved), detail);
    set_numbers(row, result);
    std::swap(result.analysis.contacts, design.contacts);
    std::swap(result.analysis.load_cases, design.load_cases);
  }

  double* row_of(RowBlock& block, std::size_t row) const {
    return block.responses.data() + row * study.responses.size();
  }

  std::mutex mutex;
  std::vector<std::unique_ptr<Worker>> idle;
};

DesignEngine::DesignEngine(const input::StudyInput& input, simd::InstructionSet set, Arrays arrays)
    : parts_(std::make_unique<Parts>(input, set)) {
  parts_->read_base(arrays);
}

DesignEngine::~DesignEngine() = default;

const Study& DesignEngine::study() const { return parts_->study; }

bool DesignEngine::needs_modes() const { return parts_->number_detail.modes; }

RowBlock DesignEngine::evaluate(std::size_t first, std::size_t count, const std::function<bool()>& stop) const {
  return parts_->evaluate(
      first, count, [first](DesignReader& reader, std::size_t row) -> Case& { return reader.read(first + row); }, stop);
}

RowBlock DesignEngine::evaluate(const std::vector<std::vector<Draw>>& designs) const {
  return parts_->evaluate(
      0, designs.size(), [&](DesignReader& reader, std::size_t row) -> Case& { return reader.read(designs[row]); }, {});
}

std::size_t DesignEngine::chunk() const {
  if (!parts_->side_by_side || parts_->needs_duty) return 1;
  if (!parts_->numbers || parts_->study.command == Command::life) return 8;
  if (parts_->study.command == Command::slip || parts_->all_rollers) return 32;
  return 512;
}

}  // namespace prs
