#include "prs/study/design_engine.h"

#include "prs/indices.h"
#include "prs/reference/reference_reader.h"
#include "prs/study/design_batches.h"
#include "prs/study/design_responses.h"

namespace prs {
namespace {

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
      : input(given), responses(given), set(instructions) {}

  const input::StudyInput& input;
  DesignResponses responses;
  simd::InstructionSet set;
  bool in_columns = false;   ///< Whether BarBatch or SlipBatch gets what it takes.
  bool side_by_side = true;  ///< Whether the bodies of the base case take many designs.
  bool all_rollers = false;  ///< Whether it is a full mechanism.

  /// Data of a thread.
  struct Worker {
    Worker(const input::StudyInput& input, simd::InstructionSet set)
        : reader(input), columns(set), slips(set), sectors(set), contacts(set) {}

    DesignReader reader;
    DesignResponses::Memory memory;
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

  Command command() const { return responses.study.command; }
  bool in_batches() const {
    return responses.numbers &&
           (command() == Command::solve || (responses.measures() && !responses.load_cases.empty()));
  }
  /// Whether contacts of many designs are found together; those of Detail::complete are not.
  bool shares_contacts() const {
    return responses.numbers && responses.detail == Detail::numbers && command() != Command::life;
  }

  void read_base(Arrays arrays) {
    const auto of_reference = [](const std::string& path) { return path.starts_with("references["); };
    responses.of_references = (command() == Command::solve || command() == Command::slip) &&
                              std::ranges::any_of(responses.study.responses, of_reference);
    Json document;
    const auto worker = borrowed();
    std::optional<Case> base;
    const DesignStatus status = status_after([&] {
      base = worker->reader.read(0);
      side_by_side = base->model.bodies->side_by_side;
      all_rollers = base->model.all_rollers();
      responses.keep_history(*base);
      return responses.by_document(*base, input.source, document);
    });
    if (base && responses.of_references)
      read_references(input.source, *base);  // An error in a file fails the study, not a design.
    if (!status.converged()) document = nullptr;
    responses.choose(base, document, arrays);
    if (!responses.numbers) return;
    in_columns = (command() == Command::solve || command() == Command::slip) && responses.detail == Detail::numbers;
    if (!document.is_null())
      leave_out_parts(*base, *worker, document);
    else if (all_rollers)
      responses.detail = Detail::complete;
  }

  /// Leaves out of all designs each part of the results without which the base case has the same numbers. What
  /// the numbers lack is computed in full.
  void leave_out_parts(const Case& base, const Worker& worker, const Json& document) {
    const auto row = [&] {
      return evaluate(0, 1, [](DesignReader& reader, std::size_t) -> Case& { return reader.read(0); }, {}).responses;
    };
    std::vector<bool*> parts;
    if (std::ranges::any_of(base.load_cases, [](const LoadCase& load) { return load.modes.has_value(); }))
      parts.push_back(&responses.number_detail.modes);
    else
      responses.number_detail.modes = false;
    auto& [loads, slip, modes] = responses.number_detail;
    if (goes_to_columns(base, worker))
      parts.insert(parts.end(), {&loads.axial_load, &loads.load_rate, &loads.ellipses, &loads.tangent_stiffness,
                                 &slip.threads, &slip.films});
    else if (goes_to_sectors(base))
      parts.push_back(&loads.tangent_stiffness);
    else if (!all_rollers)
      return;
    std::vector<double> documented;
    for (const std::string& path : responses.study.responses)
      documented.push_back(response(document, path).value_or(kNoResponse));
    const auto has_all = [&](const std::vector<double>& found) {
      return std::ranges::equal(found, documented,
                                [](double f, double d) { return std::isfinite(f) || std::isnan(d); });
    };
    std::vector<double> whole = row();
    if (!has_all(whole) && responses.detail == Detail::numbers) {
      responses.detail = Detail::complete;
      in_columns = false;
      whole = row();
    }
    if (!has_all(whole)) responses.numbers.reset();
    for (bool* part : parts) {
      if (!responses.numbers) return;
      *part = false;
      *part = !are_same(row(), whole);
    }
  }

  RowBlock evaluate(std::size_t first, std::size_t rows, const ReadRow& read, const Stop& stop) {
    RowBlock block{first, rows, {}, {}};
    block.responses.assign(rows * responses.study.responses.size(), kNoResponse);
    const auto worker = borrowed();
    for (std::size_t row = 0; row < block.rows;) {
      row = evaluate_batch(read, row, std::min(row + kBatch, block.rows), *worker, block, stop);
      if (row < block.rows && stop && stop()) block.rows = row;
    }
    block.responses.resize(block.rows * responses.study.responses.size());
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
      responses.set_numbers(row_of(block, row), {.contacts = contacts}, results);
    };
    const auto leave = [&](std::size_t row) { worker.alone.push_back({row}); };
    worker.columns.solve(responses.number_detail.loads, take, leave);
    worker.slips.solve(responses.number_detail.loads, responses.number_detail.slip, take, leave);
    worker.sectors.solve(
        responses.contact_detail, responses.measures() || responses.number_detail.loads.tangent_stiffness,
        [&](SectorBatch::Design& design) {
          if (responses.measures())
            measure(design, row_of(block, design.row));
          else
            take(design.row, design.load_cases, design.contacts);
        },
        leave);
    worker.contacts.find();
    std::ranges::sort(worker.alone, {}, &Worker::Alone::row);
    Contacts found;
    for (const auto& [row, contacts] : worker.alone) {
      const bool known = worker.contacts.get(contacts, responses.contact_detail, found);
      keep_failure(row, [&, row = row] {
        Case& c = read(worker.reader, row);
        return responses.answer(c, worker.reader, worker.memory, row_of(block, row), known ? &found : nullptr);
      });
      if (stop && stop()) return row + 1;
    }
    return to;
  }

  /// Gives each row to a batch, or to those that are answered alone.
  void read_batch(const ReadRow& read, std::size_t from, std::size_t to, Worker& worker,
                  const auto& keep_failure) const {
    worker.columns.clear(responses.contact_detail);
    worker.slips.clear(responses.contact_detail);
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
    return command() == Command::slip ? worker.slips.takes(c, responses.load_cases)
                                      : BarBatch::takes(c, responses.load_cases);
  }
  bool goes_to_sectors(const Case& c) const { return in_batches() && !runs(c) && c.model.side_by_side(); }
  bool runs(const Case& c) const {
    return command() == Command::solve && c.model.loads == ModelOptions::Loads::running;
  }

  /// Adds a design to a batch; false if no batch takes it.
  bool add_to_batch(std::size_t row, Case& c, Worker& worker) const {
    if (goes_to_columns(c, worker)) {
      const std::optional<Mechanism> mechanism = sound_mechanism(c);
      if (!mechanism) return false;
      if (command() == Command::slip)
        worker.slips.add(row, c, *mechanism, responses.load_cases);
      else
        worker.columns.add(row, c, *mechanism, responses.load_cases);
      return true;
    }
    if (!goes_to_sectors(c)) return false;
    worker.sectors.add(row, c, responses.load_cases, responses.measures(), responses.detail);
    return true;
  }

  /// Measures a design whose load cases are solved.
  void measure(SectorBatch::Design& design, double* row) const {
    Result solved;
    std::swap(solved.contacts, design.contacts);
    std::swap(solved.load_cases, design.load_cases);
    MeasuresResult result = measured(design.conditions, std::move(solved), responses.detail);
    responses.set_numbers(row, result);
    std::swap(result.analysis.contacts, design.contacts);
    std::swap(result.analysis.load_cases, design.load_cases);
  }

  double* row_of(RowBlock& block, std::size_t row) const {
    return block.responses.data() + row * responses.study.responses.size();
  }

  std::mutex mutex;
  std::vector<std::unique_ptr<Worker>> idle;
};

DesignEngine::DesignEngine(const input::StudyInput& input, simd::InstructionSet set, Arrays arrays)
    : parts_(std::make_unique<Parts>(input, set)) {
  parts_->read_base(arrays);
}

DesignEngine::~DesignEngine() = default;

const Study& DesignEngine::study() const { return parts_->responses.study; }

bool DesignEngine::needs_modes() const { return parts_->responses.number_detail.modes; }

RowBlock DesignEngine::evaluate(std::size_t first, std::size_t count, const std::function<bool()>& stop) const {
  return parts_->evaluate(
      first, count, [first](DesignReader& reader, std::size_t row) -> Case& { return reader.read(first + row); }, stop);
}

RowBlock DesignEngine::evaluate(const std::vector<std::vector<Draw>>& designs) const {
  return parts_->evaluate(
      0, designs.size(), [&](DesignReader& reader, std::size_t row) -> Case& { return reader.read(designs[row]); }, {});
}

std::size_t DesignEngine::chunk() const {
  if (!parts_->side_by_side || parts_->responses.needs_duty) return 1;
  if (!parts_->responses.numbers || parts_->command() == Command::life) return 8;
  if (parts_->command() == Command::slip || parts_->all_rollers) return 32;
  return 512;
}

}  // namespace prs
