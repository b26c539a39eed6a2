#include "prs/study/design_engine.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "prs/heat/analyze_heat.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/force_history.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_case_result.h"
#include "prs/measures/analyze_measures.h"
#include "prs/model/case_error.h"
#include "prs/quantities/json.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/slip_quantities.h"
#include "prs/sector/chain/bar_designs.h"
#include "prs/sector/chain/fallback_solver.h"
#include "prs/sector/full/full_distribution.h"
#include "prs/study/design_reader.h"
#include "prs/study/response.h"
#include "prs/study/result_number.h"
#include "prs/threads/contact_laws.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;
using Bodies = ModelOptions::Bodies;

Result analyze_for(Command command, const Case& c, AnalysisOptions options) {
  if (command == Command::contact) return analyze_contacts(c, options.detail);
  return command == Command::slip ? analyze_heat(c, options) : analyze(c, options);
}

/// That of a duty, or of the first load case, which did not converge.
DesignStatus status_of(const Result& result) {
  if (result.heat_cycle && !result.heat_cycle->converged())
    return {std::string(name(result.heat_cycle->status)),
            fmt::format("duty: {}", result.heat_cycle->reason)};
  for (const LoadCaseResult& load_case : result.load_cases) {
    if (load_case.heat && !load_case.heat->converged())
      return {std::string(name(load_case.heat->status)),
              fmt::format("load case {}: {}", load_case.load_case.name, load_case.heat->reason)};
    const bool slips = load_case.slip.has_value();
    if (load_case.converged() && (!slips || load_case.slip->converged())) continue;
    const std::string name(slips ? slip_status_name(load_case) : status_name(load_case));
    return {name, fmt::format("load case {} did not converge", load_case.load_case.name)};
  }
  return {};
}

/// Runs `compute` and says what stopped it.
template <class Compute>
DesignStatus status_after(Compute compute) {
  try {
    return compute();
  } catch (const input::InputError& error) {
    return {"refused", error.what()};
  } catch (const CaseError& error) {
    return {"refused", fmt::format("{}: {}", error.path(), error.what())};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {"failed", error.what()};
  }
}

/// The study's responses as far as the document has them, or those of its command.
std::vector<std::string> recorded(const Study& study, const Json& document) {
  if (study.responses.empty()) {
    std::vector<std::string> paths = default_responses(study.command);
    if (!document.is_null())
      std::erase_if(paths, [&](const std::string& path) { return !response(document, path); });
    return paths;
  }
  if (document.is_null()) return study.responses;
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    const std::string& path = study.responses[k];
    if (response(document, path)) continue;
    const std::vector<std::string> known = response_paths(document);
    const std::vector<std::string_view> near =
        input::near_words(path, {known.begin(), known.end()});
    throw UnknownResponse(
        k, fmt::format("got {}; expected a number of the first load case or of the document, as "
                       "`prs list responses FILE` shows them; {}",
                       input::shown(path),
                       near.empty() ? "write for example `" + known.front() + "`"
                                    : fmt::format("did you mean `{}`?", fmt::join(near, "`, `"))));
  }
  return study.responses;
}

/// The responses as numbers of results; none where one of them needs the document.
std::optional<std::vector<ResultNumber>> numbers_of(const std::vector<std::string>& responses) {
  std::vector<ResultNumber> numbers;
  for (const std::string& path : responses) {
    std::optional<ResultNumber> number = result_number(path);
    if (!number) return std::nullopt;
    numbers.push_back(std::move(*number));
  }
  return numbers;
}

/// Load cases of `all` that the numbers need, ascending.
std::vector<std::size_t> load_cases_of(const std::vector<ResultNumber>& numbers, std::size_t all) {
  std::vector<std::size_t> indices;
  if (std::ranges::any_of(numbers, &ResultNumber::needs_duty)) {
    indices.resize(all);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
  }
  for (const ResultNumber& number : numbers)
    if (number.load_case) indices.push_back(*number.load_case);
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

/// Designs whose sectors are solved together: many lanes, little memory.
constexpr std::size_t kBatch = 64;

/// Reads the case of the design that a row of a block answers.
using ReadRow = std::function<const Case&(DesignReader& reader, std::size_t row)>;

/// What is known of one design while its sectors wait to be solved together.
struct Pending {
  std::size_t row = 0;
  Contacts contacts;
  PerInterface<ContactLaw> laws;
  std::vector<LoadCaseResult> load_cases;  ///< Those that the responses need.
  std::optional<Conditions> conditions;    ///< Where measures are taken of the solved load cases.
  bool complete = true;                    ///< Needs no other solver.
};

/// A sector of bars that waits, and where its answer goes.
struct PendingSector {
  std::size_t design = 0;     ///< Index of the pending design.
  std::size_t load_case = 0;  ///< Index among the design's load cases.
};

}  // namespace

struct DesignEngine::Parts {
  explicit Parts(const input::StudyInput& given) : input(given), study(given.study) {}

  const input::StudyInput& input;
  Study study;
  std::optional<std::vector<ResultNumber>> numbers;
  std::vector<std::size_t> load_cases;  ///< Load cases that the numbers need.
  bool needs_duty = false;              ///< Whether one of the numbers is of a duty.
  Detail detail = Detail::numbers;      ///< What the numbers need.
  Bodies bodies = Bodies::bars;         ///< Bodies of the base case.
  bool all_rollers = false;             ///< Whether it is a full mechanism.
  std::optional<LoadHistory> history;   ///< History of the base case.
  std::optional<HistorySource> history_source;

  /// What a thread needs for itself.
  struct Worker {
    DesignReader reader;
    BarDesignSolver solver = BarDesignSolver();
    FullSolver full = FullSolver();
  };

  /// A worker that no other thread has.
  class Borrowed {
   public:
    explicit Borrowed(Parts& parts) : parts_(parts), worker_(parts.take()) {}
    ~Borrowed() { parts_.give_back(std::move(worker_)); }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    Worker* get() { return &worker_; }
    Worker* operator->() { return &worker_; }

   private:
    Parts& parts_;
    Worker worker_;
  };

  Worker take() {
    {
      const std::lock_guard lock(mutex);
      if (!idle.empty()) {
        Worker worker = std::move(idle.back());
        idle.pop_back();
        return worker;
      }
    }
    return Worker{DesignReader(input)};
  }
  void give_back(Worker worker) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(worker));
  }

  bool in_batches() const {
    return numbers && (study.command == Command::solve ||
                       (study.command == Command::measures && !load_cases.empty()));
  }

  /// The history of a case; that of the base case is read once.
  std::optional<LoadHistory> history_of(const Case& c) const {
    if (!c.life->history) return std::nullopt;
    if (history && c.life->history == history_source) return history;
    return input::read_force_history(*c.life->history, input.source);
  }

  /// Lives, of which `use` is told where there are any.
  template <class Use>
  DesignStatus with_lives(const Case& c, Use use) const {
    const LifeResult result = analyze_life(c, history_of(c));
    if (!result.converged()) return {"not_converged", *result.failure};
    use(result);
    return {};
  }

  /// The chain of the command on one case, the whole document.
  DesignStatus by_document(const Case& c, Json& document) const {
    if (study.command == Command::life)
      return with_lives(c, [&](const LifeResult& lives) { document = life_json(lives, {}); });
    if (study.command == Command::measures) {
      const MeasuresResult result = analyze_measures(c);
      document = measures_json(result, {});
      return status_of(result.analysis);
    }
    const Result result = analyze_for(study.command, c, {});
    document = to_json(result, {});
    return status_of(result);
  }

  void read_base() {
    Json document;
    std::size_t all_load_cases = 0;
    Borrowed worker(*this);
    const DesignStatus status = status_after([&] {
      const Case& c = worker->reader.read(0);
      all_load_cases = c.load_cases.size();
      bodies = c.model.bodies;
      all_rollers = c.model.mechanism == ModelOptions::Mechanism::full;
      if (study.command == Command::life && c.life->history) {
        history = history_of(c);
        history_source = c.life->history;
      }
      return by_document(c, document);
    });
    if (!status.converged()) document = nullptr;
    study.responses = recorded(study, document);
    numbers = numbers_of(study.responses);
    if (!numbers) return;
    load_cases = load_cases_of(*numbers, all_load_cases);
    needs_duty = std::ranges::any_of(*numbers, &ResultNumber::needs_duty);
    // A full mechanism has its tangent stiffness only with Detail::complete.
    const auto is_tangent = [](const std::string& path) {
      return path.find("tangent_stiffness") != std::string::npos;
    };
    if (std::ranges::any_of(*numbers, &ResultNumber::needs_complete) ||
        (all_rollers && std::ranges::any_of(study.responses, is_tangent)))
      detail = Detail::complete;
  }

  /// `known`: all that does not depend on the load case.
  void set_numbers(double* row, const Answer& known,
                   const std::vector<LoadCaseResult>& results = {},
                   const std::vector<std::optional<LoadMeasures>>& measures = {}) const {
    for (std::size_t k = 0; k < numbers->size(); ++k) {
      const ResultNumber& number = (*numbers)[k];
      Answer answer = known;
      if (number.load_case) {
        const auto at = std::ranges::find(load_cases, *number.load_case);
        const auto index = static_cast<std::size_t>(at - load_cases.begin());
        if (index >= results.size()) continue;
        answer.load_case = &results[index];
        if (index < measures.size() && measures[index]) answer.load_measures = &*measures[index];
      }
      row[k] = number.value(answer).value_or(kNoResponse);
    }
  }

  void set_numbers(double* row, const MeasuresResult& result) const {
    set_numbers(row, {.contacts = result.analysis.contacts, .measures = &result.measures},
                result.analysis.load_cases, result.load_measures);
  }

  DesignStatus answer(const Case& c, FullSolver& full, double* row) const {
    if (!numbers) {
      Json document;
      const DesignStatus status = by_document(c, document);
      if (status.converged())
        for (std::size_t k = 0; k < study.responses.size(); ++k)
          row[k] = response(document, study.responses[k]).value_or(kNoResponse);
      return status;
    }
    if (study.command == Command::life)
      return with_lives(c, [&](const LifeResult& lives) {
        set_numbers(row, {.contacts = lives.contacts, .life = &lives});
      });
    Case needed = c;
    keep_needed(needed);
    AnalysisOptions options = kManyDesigns;
    options.detail = detail;
    options.full = &full;
    if (study.command == Command::measures) {
      const MeasuresResult result = analyze_measures(needed, options);
      DesignStatus status = status_of(result.analysis);
      if (status.converged()) set_numbers(row, result);
      return status;
    }
    const Result result = analyze_for(study.command, needed, options);
    DesignStatus status = status_of(result);
    if (status.converged())
      set_numbers(
          row,
          {.contacts = result.contacts, .cycle = result.heat_cycle ? &*result.heat_cycle : nullptr},
          result.load_cases);
    return status;
  }

  /// Leaves out load cases that no response needs.
  void keep_needed(Conditions& c) const {
    if (c.heat && !needs_duty) c.heat->duty.clear();
    std::vector<LoadCase> needed;
    for (const std::size_t k : load_cases)
      if (k < c.load_cases.size()) needed.push_back(std::move(c.load_cases[k]));
    c.load_cases = std::move(needed);
  }

  /// Adds the sectors of one design of a batch, whose contacts are found.
  DesignStatus prepare(const Conditions& c, Pending& design, std::size_t index,
                       std::vector<PendingSector>& sectors, std::vector<SectorModel>& bars,
                       std::vector<double>& forces) const {
    design.laws = contact_laws(c, design.contacts);
    const std::size_t first = sectors.size();
    const auto on_same_sector = [](const LoadCase& x, const LoadCase& y) {
      return x.direction == y.direction && x.position == y.position;
    };
    for (const std::size_t k : load_cases) {
      if (k >= c.load_cases.size()) break;
      const LoadCase& load = c.load_cases[k];
      if (load.share == LoadCase::Share::equal) {
        design.load_cases.push_back(equal_share_result(load, design.contacts, design.laws));
        continue;
      }
      std::size_t known = first;
      while (known < sectors.size() &&
             !on_same_sector(load, design.load_cases[sectors[known].load_case].load_case))
        ++known;
      if (known < sectors.size())
        bars.push_back(bars[known]);
      else
        bars.push_back(sector_model(design.contacts.mechanism, *c.structure, *c.materials, c.model,
                                    design.laws, *load.direction, *load.position, c.deviations));
      forces.push_back(load.axial_force);
      sectors.push_back({index, design.load_cases.size()});
      design.load_cases.emplace_back().load_case = load;
    }
    return {};
  }

  RowBlock evaluate(std::size_t first, std::size_t rows, const ReadRow& read) {
    RowBlock block{first, rows, {}, {}};
    block.responses.assign(rows * study.responses.size(), kNoResponse);
    if (in_batches())
      evaluate_batches(read, block);
    else
      evaluate_one_by_one(read, block);
    return block;
  }

  void evaluate_batches(const ReadRow& read, RowBlock& block) {
    Borrowed worker(*this);
    for (std::size_t row = 0; row < block.rows; row += kBatch)
      evaluate_batch(read, row, std::min(row + kBatch, block.rows), *worker.get(), block);
    std::ranges::sort(block.failures, {}, &RowBlock::Failure::row);
  }

  /// Rows [from, to) of a block.
  void evaluate_batch(const ReadRow& read, std::size_t from, std::size_t to, Worker& worker,
                      RowBlock& block) {
    std::vector<Pending> designs;
    std::vector<PendingSector> sectors;
    std::vector<SectorModel> bars;
    std::vector<double> forces;
    designs.reserve(to - from);
    for (std::size_t row = from; row < to; ++row) {
      const std::size_t waiting = sectors.size();
      Pending design;
      design.row = row;
      bool done = false;
      DesignStatus status = status_after([&]() -> DesignStatus {
        const Case& c = read(worker.reader, row);
        if (c.model.bodies == Bodies::bars &&
            c.model.mechanism == ModelOptions::Mechanism::sector) {
          design.contacts = checked_contacts(c, detail);
          if (study.command == Command::measures) design.conditions = c;
          return prepare(c, design, designs.size(), sectors, bars, forces);
        }
        done = true;
        return answer(c, worker.full, row_of(block, row));
      });
      if (status.converged() && !done) {
        designs.push_back(std::move(design));
      } else {
        sectors.resize(waiting);
        bars.resize(waiting);
        forces.resize(waiting);
        if (!status.converged()) block.failures.push_back({row, std::move(status)});
      }
    }
    std::vector<LoadDistribution> loads(bars.size());
    worker.solver.solve(bars, forces, loads);
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      Pending& design = designs[sectors[k].design];
      design.complete = design.complete && FallbackSolver::complete(loads[k]);
      LoadCaseResult& result = design.load_cases[sectors[k].load_case];
      result = solved_result(result.load_case, design.contacts, design.laws, std::move(loads[k]));
    }
    for (Pending& design : designs) {
      double* const row = row_of(block, design.row);
      if (design.complete && design.conditions) {
        Result known;
        known.contacts = std::move(design.contacts);
        known.load_cases = std::move(design.load_cases);
        set_numbers(row, measured(*design.conditions, std::move(known), detail));
        continue;
      }
      if (design.complete) {
        set_numbers(row, {.contacts = design.contacts}, design.load_cases);
        continue;
      }
      DesignStatus status =
          status_after([&] { return answer(read(worker.reader, design.row), worker.full, row); });
      if (!status.converged()) block.failures.push_back({design.row, std::move(status)});
    }
  }

  void evaluate_one_by_one(const ReadRow& read, RowBlock& block) {
    Borrowed worker(*this);
    for (std::size_t row = 0; row < block.rows; ++row) {
      DesignStatus status = status_after(
          [&] { return answer(read(worker->reader, row), worker->full, row_of(block, row)); });
      if (!status.converged()) block.failures.push_back({row, std::move(status)});
    }
  }

  double* row_of(RowBlock& block, std::size_t row) const {
    return block.responses.data() + row * study.responses.size();
  }

  std::mutex mutex;
  std::vector<Worker> idle;
};

DesignEngine::DesignEngine(const input::StudyInput& input)
    : parts_(std::make_unique<Parts>(input)) {
  parts_->read_base();
}

DesignEngine::~DesignEngine() = default;

const Study& DesignEngine::study() const { return parts_->study; }

RowBlock DesignEngine::evaluate(std::size_t first, std::size_t count) const {
  return parts_->evaluate(first, count,
                          [first](DesignReader& reader, std::size_t row) -> const Case& {
                            return reader.read(first + row);
                          });
}

RowBlock DesignEngine::evaluate(const std::vector<std::vector<Draw>>& designs) const {
  return parts_->evaluate(0, designs.size(),
                          [&](DesignReader& reader, std::size_t row) -> const Case& {
                            return reader.read(designs[row]);
                          });
}

std::size_t DesignEngine::chunk() const {
  if (parts_->bodies == Bodies::influence || parts_->needs_duty) return 1;
  if (!parts_->numbers || parts_->study.command == Command::life) return 8;
  if (parts_->study.command == Command::slip || parts_->all_rollers) return 32;
  return parts_->bodies == Bodies::bars ? 512 : 64;
}

}  // namespace prs
