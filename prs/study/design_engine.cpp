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
#include "prs/life/life_analysis.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_case_result.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/slip_record.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/analyze_measures.h"
#include "prs/measures/measures_analysis.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/model/case_error.h"
#include "prs/sector/chain/bar_designs.h"
#include "prs/sector/chain/fallback_solver.h"
#include "prs/sector/chain/refined_designs.h"
#include "prs/slip/running.h"
#include "prs/study/bar_batch.h"
#include "prs/study/design_reader.h"
#include "prs/study/response.h"
#include "prs/study/result_number.h"
#include "prs/study/slip_batch.h"
#include "prs/threads/contact_batch.h"
#include "prs/threads/contact_laws.h"
#include "prs/threads/threads.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;
using Bodies = ModelOptions::Bodies;

Result analyze_for(Command command, const Conditions& c, Contacts contacts,
                   AnalysisOptions options) {
  if (command == Command::contact) return analyze_contacts(c, std::move(contacts), options.detail);
  return command == Command::slip ? analyze_heat(c, std::move(contacts), options)
                                  : analyze_loads(c, std::move(contacts), options);
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
    return {"refused", error.problem().text()};
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

/// Designs whose contacts are found and whose sectors are solved together: many lanes, little
/// memory.
constexpr std::size_t kBatch = 64;

/// Whether designs that follow are left out.
using Stop = std::function<bool()>;

/// Reads the case of the design that a row of a block answers.
using ReadRow = std::function<Case&(DesignReader& reader, std::size_t row)>;

/// Where load case k of a document stands in the case: `contact` answers those of equal shares
/// alone.
std::size_t place_of(std::size_t k, const std::vector<LoadCase>& all, Command command) {
  if (command != Command::contact) return k;
  for (std::size_t at = 0; at < all.size(); ++at)
    if (all[at].share == LoadCase::Share::equal && k-- == 0) return at;
  return all.size();
}

/// A case with nothing but some of its load cases, and with its duty or not, as long as this lives.
class OnlyLoadCases {
 public:
  OnlyLoadCases(Case& c, const std::vector<std::size_t>& indices, Command command, bool with_duty,
                std::vector<LoadCase>& memory)
      : case_(c), with_duty_(with_duty), others_(memory) {
    others_.resize(indices.size());
    std::size_t known = 0;
    for (const std::size_t k : indices) {
      const std::size_t at = place_of(k, c.load_cases, command);
      if (at >= c.load_cases.size()) break;
      others_[known++] = c.load_cases[at];
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

/// Contacts of designs, found together: entry k of `rows` is where the contacts of row k of a batch
/// stand, none where they are not among them.
struct BatchContacts {
  struct Entry {
    Mechanism mechanism;
    contact::MechanismGeometry threads;
  };
  ContactBatch found;
  std::vector<Entry> entries = {};
  std::vector<std::optional<std::size_t>> rows = {};

  void start(std::size_t row_count) {
    found.clear();
    rows.assign(row_count, std::nullopt);
  }
  /// Mechanisms that have yet to be designed are left out.
  void add(std::size_t row, const Mechanism& mechanism, const std::optional<Materials>& materials) {
    if (mechanism.geometry != Mechanism::Geometry::simulation) return;
    const std::size_t k = found.size();
    if (entries.size() <= k) entries.resize(k + 1);
    entries[k].mechanism = mechanism;
    entries[k].threads = threads_of(mechanism);
    found.add(entries[k].threads, materials);
    rows[row] = k;
  }
  /// False where `checked_contacts` finds them or says why there are none.
  bool get(std::size_t row, ContactDetail detail, Contacts& contacts) const {
    const std::optional<std::size_t> k = rows[row];
    return k && found.get(*k, entries[*k].mechanism, entries[*k].threads, detail, contacts);
  }
};

/// What is known of one design while its sectors wait to be solved together.
struct Pending {
  std::size_t row = 0;
  Conditions conditions;  ///< What a sector is made of, or measures are taken of.
  Contacts contacts;
  bool has_contacts = false;
  PerInterface<ContactLaw> laws;
  std::vector<LoadCaseResult> load_cases;  ///< Those that the responses need.
  bool complete = true;                    ///< Needs no other solver.

  void set(std::size_t of_row, const Case& c, const std::vector<std::size_t>& indices,
           bool is_measured) {
    row = of_row;
    complete = true;
    if (is_measured) {
      conditions = c;
    } else {
      conditions.structure = c.structure;
      conditions.materials = c.materials;
      conditions.deviations = c.deviations;
      conditions.contact = c.contact;
      conditions.model = c.model;
    }
    const auto missing = [&](std::size_t k) { return k >= c.load_cases.size(); };
    const auto known = std::ranges::find_if(indices, missing) - indices.begin();
    load_cases.resize(static_cast<std::size_t>(known));
    for (std::size_t i = 0; i < load_cases.size(); ++i)
      load_cases[i].load_case = c.load_cases[indices[i]];
  }
};

/// Designs of a batch and their sectors; memory is kept from batch to batch.
struct Batch {
  /// A sector that waits, and where its answer goes.
  struct Sector {
    std::size_t design = 0;     ///< Index of the pending design.
    std::size_t load_case = 0;  ///< Index among the design's load cases.
  };

  BatchContacts contacts;
  std::vector<Pending> designs = {};
  std::vector<Sector> sectors = {};
  std::vector<SectorModel> models = {};
  std::vector<double> forces = {};
  std::vector<LoadDistribution> loads = {};
  std::vector<LoadCase> load_cases = {};  ///< Memory of `OnlyLoadCases`.
};

/// None where the scalar chain says why.
std::optional<Mechanism> sound_mechanism(Case& c) {
  try {
    return checked_mechanism(c);
  } catch (const CaseError&) {
    return std::nullopt;
  }
}

/// Element k of memory that grows.
template <class T>
T& at(std::vector<T>& values, std::size_t k) {
  if (values.size() <= k) values.resize(k + 1);
  return values[k];
}

}  // namespace

struct DesignEngine::Parts {
  Parts(const input::StudyInput& given, simd::InstructionSet instructions)
      : input(given), study(given.study), set(instructions) {}

  const input::StudyInput& input;
  Study study;
  simd::InstructionSet set;
  std::optional<std::vector<ResultNumber>> numbers;
  std::vector<std::size_t> load_cases;  ///< Load cases that the numbers need.
  bool needs_duty = false;              ///< Whether one of the numbers is of a duty.
  bool in_columns = false;              ///< Whether BarBatch or SlipBatch gets what it takes.
  NumberDetail number_detail;           ///< What the numbers need of load cases.
  Detail detail = Detail::numbers;      ///< What the numbers need of the results.
  ContactDetail contact_detail = ContactDetail::laws;  ///< What they need of the contacts.
  Bodies bodies = Bodies::bars;                        ///< Bodies of the base case.
  bool all_rollers = false;                            ///< Whether it is a full mechanism.
  std::optional<LoadHistory> history;                  ///< History of the base case.
  std::optional<HistorySource> history_source;

  /// What a thread needs for itself.
  struct Worker {
    DesignReader reader;
    BarDesignSolver bars;
    RefinedDesignSolver refined;
    FullSolver full = FullSolver();
    Batch batch;
    BarBatch columns;
    SlipBatch slips;
    std::vector<bool> in_columns = {};  ///< Rows that `slips` answers.
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
    return Worker{DesignReader(input), BarDesignSolver(set),       RefinedDesignSolver(set),
                  FullSolver(),        Batch{{ContactBatch(set)}}, BarBatch(set),
                  SlipBatch(set)};
  }
  /// A destructor calls it: a worker that there is no place for is made anew.
  void give_back(Worker worker) noexcept try {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(worker));
  } catch (const std::bad_alloc&) {
  }

  bool measures() const { return study.command == Command::measures; }
  bool in_batches() const {
    return numbers && (study.command == Command::solve || (measures() && !load_cases.empty()));
  }
  /// Whether contacts of many designs are found together; those of Detail::complete are not.
  bool shares_contacts() const {
    return numbers && detail == Detail::numbers && study.command != Command::life;
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
      return with_lives(
          c, [&](const LifeResult& lives) { document = document_of(life_analysis(), lives, {}); });
    if (measures()) {
      const MeasuresResult result = analyze_measures(c);
      document = document_of(measures_analysis(), result, {});
      return status_of(result.analysis);
    }
    const Result result = analyze_for(study.command, c, checked_contacts(c, Detail::complete), {});
    document = document_of(study.command == Command::slip ? slip_analysis() : solve_analysis(),
                           result, {});
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
    const auto of_mechanism = [](const ResultNumber& number) { return !number.load_case; };
    if (measures() || std::ranges::any_of(*numbers, of_mechanism))
      contact_detail = ContactDetail::numbers;
    // A full mechanism has its tangent stiffness only with Detail::complete.
    number_detail = prs::number_detail(*numbers);
    if (std::ranges::any_of(*numbers, &ResultNumber::needs_complete) ||
        (all_rollers && number_detail.loads.tangent_stiffness))
      detail = Detail::complete;
    in_columns = (study.command == Command::solve || study.command == Command::slip) &&
                 detail == Detail::numbers;
  }

  /// `known`: all that does not depend on the load case.
  void set_numbers(double* row, const Answer& known,
                   const std::vector<LoadCaseResult>& results = {},
                   const std::vector<std::optional<LoadMeasures>>& load_measures = {}) const {
    for (std::size_t k = 0; k < numbers->size(); ++k) {
      const ResultNumber& number = (*numbers)[k];
      Answer answer = known;
      if (number.load_case) {
        const auto at = std::ranges::find(load_cases, *number.load_case);
        const auto index = static_cast<std::size_t>(at - load_cases.begin());
        if (index >= results.size()) continue;
        answer.load_case = &results[index];
        if (index < load_measures.size() && load_measures[index])
          answer.load_measures = &*load_measures[index];
      }
      row[k] = number.value(answer).value_or(kNoResponse);
    }
  }

  void set_numbers(double* row, const MeasuresResult& result) const {
    set_numbers(row, {.contacts = result.analysis.contacts, .measures = &result.measures},
                result.analysis.load_cases, result.load_measures);
  }

  /// `found`: the contacts, where they are known.
  DesignStatus answer(Case& c, Worker& worker, double* row, const Contacts* found = nullptr) const {
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
    const OnlyLoadCases needed(c, load_cases, study.command, needs_duty, worker.batch.load_cases);
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
    if (status.converged())
      set_numbers(row, {.contacts = result.contacts, .cycle = cycle}, result.load_cases);
    return status;
  }

  /// Adds the sectors of design k of a batch, whose contacts are found. False where one of them has
  /// no place among the columns.
  bool prepare(Batch& batch, std::size_t k) const {
    Pending& design = batch.designs[k];
    const Conditions& c = design.conditions;
    design.laws = contact_laws(c, design.contacts);
    const auto on_sector_of = [&](const LoadCase& load) {
      return [&design, &load](const Batch::Sector& sector) {
        const LoadCase& other = design.load_cases[sector.load_case].load_case;
        return other.direction == load.direction && other.position == load.position;
      };
    };
    const auto first = static_cast<std::ptrdiff_t>(batch.sectors.size());
    for (std::size_t i = 0; i < design.load_cases.size(); ++i) {
      LoadCaseResult& result = design.load_cases[i];
      const LoadCase& load = result.load_case;
      if (load.share == LoadCase::Share::equal) {
        result = equal_share_result(load, design.contacts, design.laws);
        continue;
      }
      SectorModel& model = at(batch.models, batch.sectors.size());
      const auto known =
          std::find_if(batch.sectors.begin() + first, batch.sectors.end(), on_sector_of(load));
      if (known != batch.sectors.end())
        model = batch.models[static_cast<std::size_t>(known - batch.sectors.begin())];
      else
        set_sector_model(model, design.contacts.mechanism, *c.structure, *c.materials, c.model,
                         design.laws, *load.direction, *load.position, c.deviations);
      if (model.is_refined && !RefinedDesignSolver::takes(model)) return false;
      batch.forces.push_back(load.axial_force);
      batch.sectors.push_back({k, i});
    }
    return true;
  }

  RowBlock evaluate(std::size_t first, std::size_t rows, const ReadRow& read, const Stop& stop) {
    RowBlock block{first, rows, {}, {}};
    block.responses.assign(rows * study.responses.size(), kNoResponse);
    Borrowed worker(*this);
    for (std::size_t row = 0; row < block.rows;) {
      const std::size_t to = std::min(row + kBatch, block.rows);
      row = in_batches() ? evaluate_batch(read, row, to, *worker.get(), block, stop)
                         : evaluate_one_by_one(read, row, to, *worker.get(), block, stop);
      if (row < block.rows && stop && stop()) block.rows = row;
    }
    block.responses.resize(block.rows * study.responses.size());
    std::ranges::sort(block.failures, {}, &RowBlock::Failure::row);
    return block;
  }

  /// Rows [from, to) of a block, or those before the row that is returned.
  std::size_t evaluate_batch(const ReadRow& read, std::size_t from, std::size_t to, Worker& worker,
                             RowBlock& block, const Stop& stop) {
    Batch& batch = worker.batch;
    const std::size_t designs = read_batch(read, from, to, worker, block, stop);
    worker.columns.solve(
        worker.bars, number_detail.loads,
        [&](std::size_t row, const std::vector<LoadCaseResult>& results, const Contacts& contacts) {
          set_numbers(row_of(block, row), {.contacts = contacts}, results);
        },
        [&](std::size_t row) { answer_alone(read, row, worker, block); });
    if (designs == 0) return to;
    batch.contacts.found.find();
    batch.sectors.clear();
    batch.forces.clear();
    for (std::size_t k = 0; k < designs; ++k) {
      Pending& design = batch.designs[k];
      design.complete = design.has_contacts ||
                        batch.contacts.get(design.row - from, contact_detail, design.contacts);
      if (!design.complete) continue;
      const std::size_t waiting = batch.sectors.size();
      design.complete = false;  // Also where it is refused: alone it says why.
      status_after([&] {
        design.complete = prepare(batch, k);
        return DesignStatus{};
      });
      if (design.complete) continue;
      batch.sectors.resize(waiting);
      batch.forces.resize(waiting);
    }
    const std::size_t sectors = batch.sectors.size();
    if (batch.loads.size() < sectors) batch.loads.resize(sectors);
    const std::span<const SectorModel> models(batch.models.data(), sectors);
    const std::span<LoadDistribution> loads(batch.loads.data(), sectors);
    const bool tangent_stiffness = measures() || number_detail.loads.tangent_stiffness;
    worker.bars.tangent_stiffness = worker.refined.tangent_stiffness = tangent_stiffness;
    worker.bars.solve(models, batch.forces, loads);
    worker.refined.solve(models, batch.forces, loads);
    for (std::size_t k = 0; k < sectors; ++k) {
      Pending& design = batch.designs[batch.sectors[k].design];
      design.complete =
          design.complete && FallbackSolver::complete(batch.loads[k], tangent_stiffness);
      set_solved_result(design.load_cases[batch.sectors[k].load_case], design.contacts,
                        {numbers_of(design.laws.screw), numbers_of(design.laws.nut)},
                        batch.loads[k], set);
    }
    for (std::size_t k = 0; k < designs; ++k) {
      Pending& design = batch.designs[k];
      if (!design.complete)
        answer_alone(read, design.row, worker, block);
      else if (measures())
        measure(design, row_of(block, design.row));
      else
        set_numbers(row_of(block, design.row), {.contacts = design.contacts}, design.load_cases);
    }
    return to;
  }

  /// Of a design whose load cases are solved.
  void measure(Pending& design, double* row) const {
    Result solved;
    std::swap(solved.contacts, design.contacts);
    std::swap(solved.load_cases, design.load_cases);
    MeasuresResult result = measured(design.conditions, std::move(solved), detail);
    set_numbers(row, result);
    std::swap(result.analysis.contacts, design.contacts);
    std::swap(result.analysis.load_cases, design.load_cases);
  }

  /// What has no place in a batch, or no answer: by the scalar chain, which says why.
  void answer_alone(const ReadRow& read, std::size_t row, Worker& worker, RowBlock& block) {
    DesignStatus status =
        status_after([&] { return answer(read(worker.reader, row), worker, row_of(block, row)); });
    if (!status.converged()) block.failures.push_back({row, std::move(status)});
  }

  /// Designs that wait for contacts and loads; the others are answered. `to` is where it stopped.
  std::size_t read_batch(const ReadRow& read, std::size_t from, std::size_t& to, Worker& worker,
                         RowBlock& block, const Stop& stop) {
    Batch& batch = worker.batch;
    batch.contacts.start(to - from);
    worker.columns.clear(contact_detail);
    std::size_t designs = 0;
    for (std::size_t row = from; row < to; ++row) {
      DesignStatus status = status_after([&]() -> DesignStatus {
        Case& c = read(worker.reader, row);
        if (c.model.bodies == Bodies::influence ||
            c.model.mechanism == ModelOptions::Mechanism::full ||
            (!measures() && c.model.loads == ModelOptions::Loads::running)) {
          DesignStatus answered = answer(c, worker, row_of(block, row));
          if (stop && stop()) to = row + 1;
          return answered;
        }
        if (in_columns && BarBatch::takes(c, load_cases)) {
          const std::optional<Mechanism> mechanism = sound_mechanism(c);
          if (!mechanism) return answer(c, worker, row_of(block, row));
          worker.columns.add(row, c, *mechanism, load_cases);
          return {};
        }
        Pending& design = at(batch.designs, designs);
        design.set(row, c, load_cases, measures());
        design.has_contacts =
            !shares_contacts() || c.mechanism.geometry == Mechanism::Geometry::design;
        if (design.has_contacts)
          design.contacts = checked_contacts(c, detail);
        else
          batch.contacts.add(row - from, c.mechanism, c.materials);
        ++designs;
        return {};
      });
      if (!status.converged()) block.failures.push_back({row, std::move(status)});
    }
    return designs;
  }

  /// Rows [from, to) of a block, or those before the row that is returned, whose contacts are found
  /// together; slip with equal shares in columns.
  std::size_t evaluate_one_by_one(const ReadRow& read, std::size_t from, std::size_t to,
                                  Worker& worker, RowBlock& block, const Stop& stop) {
    BatchContacts& contacts = worker.batch.contacts;
    contacts.start(to - from);
    worker.slips.clear(contact_detail);
    worker.in_columns.assign(to - from, false);
    if (shares_contacts()) {
      for (std::size_t row = from; row < to; ++row)
        status_after([&]() -> DesignStatus {
          Case& c = read(worker.reader, row);
          if (in_columns && worker.slips.takes(c, load_cases)) {
            worker.slips.add(row, c, checked_mechanism(c), load_cases);
            worker.in_columns[row - from] = true;
          } else {
            contacts.add(row - from, c.mechanism, c.materials);
          }
          return {};
        });
      contacts.found.find();
    }
    worker.slips.solve(
        number_detail.loads, number_detail.slip,
        [&](std::size_t row, const std::vector<LoadCaseResult>& results, const Contacts& found) {
          set_numbers(row_of(block, row), {.contacts = found}, results);
        },
        [&](std::size_t row) { worker.in_columns[row - from] = false; });
    Contacts found;
    for (std::size_t row = from; row < to; ++row) {
      if (worker.in_columns[row - from]) continue;
      const bool known = contacts.get(row - from, contact_detail, found);
      DesignStatus status = status_after([&] {
        return answer(read(worker.reader, row), worker, row_of(block, row),
                      known ? &found : nullptr);
      });
      if (!status.converged()) block.failures.push_back({row, std::move(status)});
      if (stop && stop()) return row + 1;
    }
    return to;
  }

  double* row_of(RowBlock& block, std::size_t row) const {
    return block.responses.data() + row * study.responses.size();
  }

  std::mutex mutex;
  std::vector<Worker> idle;
};

DesignEngine::DesignEngine(const input::StudyInput& input, simd::InstructionSet set)
    : parts_(std::make_unique<Parts>(input, set)) {
  parts_->read_base();
}

DesignEngine::~DesignEngine() = default;

const Study& DesignEngine::study() const { return parts_->study; }

RowBlock DesignEngine::evaluate(std::size_t first, std::size_t count,
                                const std::function<bool()>& stop) const {
  return parts_->evaluate(
      first, count,
      [first](DesignReader& reader, std::size_t row) -> Case& { return reader.read(first + row); },
      stop);
}

RowBlock DesignEngine::evaluate(const std::vector<std::vector<Draw>>& designs) const {
  return parts_->evaluate(
      0, designs.size(),
      [&](DesignReader& reader, std::size_t row) -> Case& { return reader.read(designs[row]); },
      {});
}

std::size_t DesignEngine::chunk() const {
  if (parts_->bodies == Bodies::influence || parts_->needs_duty) return 1;
  if (!parts_->numbers || parts_->study.command == Command::life) return 8;
  if (parts_->study.command == Command::slip || parts_->all_rollers) return 32;
  return 512;
}

}  // namespace prs
