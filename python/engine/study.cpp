#include "python/engine/study.h"

#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "prs/input/study_reader.h"
#include "prs/optimize/optimizer.h"
#include "prs/run/commands.h"
#include "prs/run/study.h"
#include "prs/study/designs.h"
#include "prs/study/study_json.h"
#include "prs/study/study_pictures.h"
#include "prs/study/study_result.h"
#include "prs/study/study_run.h"
#include "python/engine/document.h"
#include "python/engine/interpreter_guard.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

/// Number, status and reason of a design.
using Failure = std::tuple<std::size_t, std::string, std::string>;

/// Results of many designs, one row each.
struct Designs {
  std::vector<std::string> responses;
  std::size_t count = 0;
  std::shared_ptr<const std::vector<double>> values;  ///< count x responses; NaN if missing.
  std::vector<Failure> failures;                      ///< Designs that did not converge.
};

/// A study of a file, ready to run.
class StudySource : public std::enable_shared_from_this<StudySource> {
 public:
  explicit StudySource(const input::Source& source)
      : in_(input::read_study_input(source)), info_(document_info(source, Command::study)) {
    if (in_.study.plan != Plan::derivatives) engine_.reset(new DesignEngine(study_engine(in_)));
  }

  bool has_designs() const { return engine_ != nullptr; }
  const DesignEngine& engine() const {
    if (!engine_) throw std::invalid_argument("a study of plan `derivatives` has no designs");
    return *engine_;
  }
  const Study& study() const { return engine().study(); }
  const DocumentInfo& info() const { return info_; }
  std::size_t designs() const { return design_count(study()); }
  const input::StudyInput& input() const { return in_; }

  /// Warnings on factors that overrides make void.
  std::vector<std::string> warnings() const {
    return sentences(void_factor_warnings(in_, engine_ ? study().responses : in_.study.responses));
  }

  std::shared_ptr<Document> derivatives() const {
    auto result = std::make_shared<const CaseDerivatives>(run_derivatives(in_));
    return std::make_shared<Document>([result, info = info_] { return derivatives_json(*result, info); },
                                      keeping(derivatives_pictures(*result), result));
  }

  JournalHeader header() const {
    return {key_of(in_, in_.study.command), in_.source, study().responses, designs(), Shard{}};
  }

  void require_columns(std::size_t columns) const {
    if (const std::size_t factors = study().factors.size(); columns != factors)
      throw std::invalid_argument(
          fmt::format("got {} columns; expected one of each of the {} inputs", columns, factors));
  }
  void require_designs(std::size_t first, std::size_t count) const {
    if (first > designs() || count > designs() - first)
      throw nb::index_error(fmt::format("designs {} to {} of {}", first, first + count, designs()).c_str());
  }

 private:
  input::StudyInput in_;
  DocumentInfo info_;
  std::unique_ptr<const DesignEngine> engine_;
};

/// A study with the rows of all designs.
class StudyRows {
 public:
  StudyRows(std::shared_ptr<const StudySource> source, StoredRows rows)
      : source_(std::move(source)), rows_(std::move(rows)) {
    const DesignRange all{0, source_->designs()};
    if (!rows_.missing(all).empty()) throw std::invalid_argument("designs are missing among the records");
  }
  StudyRows(StudyRows&&) = default;

  std::shared_ptr<Document> document() const {
    auto result = std::make_shared<StudyResult>(StudyResult{source_->study(), {}, 0, 0, 0, {}});
    StudyAnalysis analysis(source_->study());
    for_each_block([&](const RowBlock& block) {
      add(*result, block);
      analysis.add(block);
    });
    result->summary = analysis.summary();
    result->warnings =
        study_warnings(source_->input(), *result, [this]() -> const DesignEngine& { return source_->engine(); });
    return std::make_shared<Document>([result, source = source_] { return study_json(*result, source->info()); },
                                      keeping(study_pictures(*result), result));
  }

  Designs designs() const {
    Designs designs{source_->study().responses, source_->designs(), nullptr, {}};
    auto values = std::make_shared<std::vector<double>>();
    values->reserve(designs.count * designs.responses.size());
    for_each_block([&](const RowBlock& block) {
      values->insert(values->end(), block.responses.begin(), block.responses.end());
      for (const RowBlock::Failure& failure : block.failures)
        designs.failures.emplace_back(block.first + failure.row, failure.status.name, failure.status.reason);
    });
    designs.values = std::move(values);
    return designs;
  }

 private:
  template <class Take>
  void for_each_block(Take take) const {
    for (std::size_t k = 0; k < rows_.block_count(); ++k) take(rows_.block(k));
  }

  std::shared_ptr<const StudySource> source_;
  StoredRows rows_;
};

std::optional<StudyRows> run(const std::shared_ptr<StudySource>& source, std::size_t threads,
                             Supervision& supervision) {
  const DesignEngine& engine = source->engine();
  const RunDesigns run_here = [&](const NextRange& next, const TakeRecord& take) {
    run_schedule(threads, engine.chunk(), next, evaluate_with(engine), take);
  };
  StoredRows rows = run_study(source->header(), nullptr, run_here,
                              {false,
                               [&] { return supervision.stopped(); },
                               [&](const StudyProgress& progress) { supervision.report(progress); },
                               {}});
  if (supervision.stopped()) return std::nullopt;
  return StudyRows(source, std::move(rows));
}

/// Rows from records in any order.
StudyRows collect(const std::shared_ptr<StudySource>& source, const std::vector<std::string>& records) {
  Journal journal = Journal::temporary(source->header());
  for (const std::string& record : records) {
    if (!journal.takes(record)) throw std::invalid_argument("a record is not one of this study, or damaged");
    journal.append(record);
  }
  std::vector<Journal> journals;
  journals.push_back(std::move(journal));
  return {source, StoredRows(std::move(journals))};
}

/// A record for designs without results.
std::string failed_record(const StudySource& source, std::size_t first, std::size_t count, const std::string& reason) {
  source.require_designs(first, count);
  RowBlock block{first, count, {}, {}};
  block.responses.assign(count * source.study().responses.size(), kNoResponse);
  for (std::size_t row = 0; row < count; ++row) block.failures.push_back({row, {"failed", reason}});
  return encode(block);
}

using Numbers = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Designs from the rows of an array: a number in the factor's unit or, for a factor with levels, the index of one.
std::vector<std::vector<Draw>> draws_of(const Study& study, const double* numbers, std::size_t rows) {
  const std::size_t factors = study.factors.size();
  std::vector<std::vector<Draw>> designs(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    designs[row].resize(factors);
    for (std::size_t f = 0; f < factors; ++f) {
      const double number = numbers[row * factors + f];
      const std::size_t levels = study.factors[f].levels.size();
      Draw& draw = designs[row][f];
      if (levels == 0) {
        if (!std::isfinite(number))
          throw std::invalid_argument(
              fmt::format("{}[{}]: got {}; expected finite numbers", study.factors[f].path, row, number));
        draw = {Draw::Kind::number, 0, number};
      } else {
        if (!(number >= 0.0 && number < static_cast<double>(levels))) throw nb::index_error("no such level");
        draw = {Draw::Kind::level, static_cast<std::size_t>(number), 0.0};
      }
    }
  }
  return designs;
}

/// Largest number of designs evaluated between checks for a stop, and the time that they should take.
constexpr std::size_t kMostAtOnce = 32'768;
constexpr std::chrono::milliseconds kAtOnce{100};

/// Results for the rows of an array; fewer if the work was stopped.
Designs evaluate(const StudySource& source, const double* numbers, std::size_t rows, std::size_t threads,
                 Supervision& supervision) {
  const Study& study = source.study();
  const EvaluateDesigns evaluate_all = evaluate_in_parallel(source.engine(), threads);
  Designs designs{study.responses, 0, nullptr, {}};
  auto values = std::make_shared<std::vector<double>>();
  values->reserve(rows * study.responses.size());
  std::size_t at_once = threads;
  while (designs.count < rows && !supervision.stopped()) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t first = designs.count;
    const std::size_t count = std::min(at_once, rows - first);
    RowBlock block = evaluate_all(draws_of(study, numbers + first * study.factors.size(), count));
    values->insert(values->end(), block.responses.begin(), block.responses.end());
    for (RowBlock::Failure& failure : block.failures)
      designs.failures.emplace_back(first + failure.row, std::move(failure.status.name),
                                    std::move(failure.status.reason));
    designs.count += count;
    supervision.report({designs.count, 0, rows});
    const bool is_fast = std::chrono::steady_clock::now() - start < kAtOnce;
    at_once = is_fast ? std::min(2 * at_once, kMostAtOnce) : std::max(at_once / 2, threads);
  }
  designs.values = std::move(values);
  return designs;
}

nb::bytes bytes_of(const std::string& record) { return nb::bytes(record.data(), record.size()); }

}  // namespace

void bind_study(nb::module_& module) {
  nb::class_<Designs>(module, "Designs", "Answers of many designs, a row each.")
      .def_ro("responses", &Designs::responses)
      .def_ro("count", &Designs::count)
      .def_ro("failures", &Designs::failures, "Number, status and reason of those without answer.")
      .def_prop_ro(
          "values",
          [](const Designs& designs) { return view(designs.values, designs.count, designs.responses.size()); },
          nb::sig("def values(self) -> numpy.typing.NDArray[numpy.float64]"));

  nb::class_<StudyRows>(module, "StudyRows", "A study with the rows of all designs.")
      .def("document", &StudyRows::document, nb::call_guard<GilRelease>())
      .def("designs", &StudyRows::designs, nb::call_guard<GilRelease>());

  nb::class_<StudySource>(module, "Study", "A study of a file, ready to run.")
      .def(nb::init<input::Source>(), nb::arg("source"), nb::call_guard<GilRelease>())
      .def_prop_ro("has_designs", &StudySource::has_designs)
      .def_prop_ro("count", &StudySource::designs)
      .def_prop_ro("chunk", [](const StudySource& s) { return s.engine().chunk(); })
      .def_prop_ro("warnings", &StudySource::warnings, "Which factors overrides of the file make void.")
      .def("derivatives", &StudySource::derivatives, nb::call_guard<GilRelease>())
      .def("factor_names",
           [](const StudySource& s) {
             std::vector<std::string> names;
             for (const FactorColumn& column : factor_columns(s.study())) names.push_back(column.name);
             return names;
           })
      .def(
          "factor_words",
          [](const StudySource& s) {
            std::vector<std::vector<std::string>> words;
            for (const FactorColumn& column : factor_columns(s.study())) words.push_back(column.words);
            return words;
          },
          "Of each column: what its indices stand for; empty where it holds numbers.")
      .def(
          "factor_values",
          [](const StudySource& s) {
            const std::vector<FactorColumn> columns = factor_columns(s.study());
            auto values =
                std::make_shared<const std::vector<double>>(factor_values(s.study(), columns, 0, s.designs()));
            return view(values, s.designs(), columns.size());
          },
          nb::sig("def factor_values(self) -> numpy.typing.NDArray[numpy.float64]"))
      .def(
          "overrides",
          [](const StudySource& s, std::size_t design) {
            s.require_designs(design, 1);
            return overrides(s.study(), prs::design(s.study(), design));
          },
          nb::arg("design"), "What a design sets, as `--set` takes it.")
      .def(
          "overrides_of",
          [](const StudySource& s, const Numbers& numbers) {
            s.require_columns(numbers.shape(1));
            if (numbers.shape(0) != 1) throw std::invalid_argument("expected one row");
            return overrides(s.study(), draws_of(s.study(), numbers.data(), 1).front());
          },
          nb::arg("numbers"),
          nb::sig("def overrides_of(self, numbers: numpy.typing.NDArray[numpy.float64]) -> "
                  "list[str]"),
          "What one row of numbers sets.")
      .def(
          "record",
          [](const StudySource& s, std::size_t first, std::size_t count) {
            s.require_designs(first, count);
            std::string record;
            {
              const GilRelease released;
              record = encode(s.engine().evaluate(first, count));
            }
            return bytes_of(record);
          },
          nb::arg("first"), nb::arg("count"), "Answers of designs [first, first + count).")
      .def(
          "failed_record",
          [](const StudySource& s, std::size_t first, std::size_t count, const std::string& reason) {
            return bytes_of(failed_record(s, first, count, reason));
          },
          nb::arg("first"), nb::arg("count"), nb::arg("reason"))
      .def(
          "collect",
          [](const std::shared_ptr<StudySource>& s, const std::vector<nb::bytes>& records) {
            std::vector<std::string> copies;
            for (const nb::bytes& record : records) copies.emplace_back(record.c_str(), record.size());
            const GilRelease released;
            return collect(s, copies);
          },
          nb::arg("records"), "ValueError where designs are missing.")
      .def(
          "run",
          [](const std::shared_ptr<StudySource>& s, std::size_t threads, const nb::object& progress) {
            return beside_interpreter([&](Supervision& supervision) { return run(s, threads, supervision); }, progress);
          },
          nb::arg("threads"), nb::arg("progress").none(),
          nb::sig("def run(self, threads: int, progress: collections.abc.Callable[[int, int], "
                  "object] | None) -> StudyRows"))
      .def(
          "answer",
          [](const StudySource& s, const Numbers& numbers) {
            s.require_columns(numbers.shape(1));
            const GilRelease released;
            Supervision supervision;
            return evaluate(s, numbers.data(), numbers.shape(0), 1, supervision);
          },
          nb::arg("numbers"), nb::sig("def answer(self, numbers: numpy.typing.NDArray[numpy.float64]) -> Designs"),
          "A few designs, by this thread.")
      .def(
          "evaluate",
          [](const StudySource& s, const Numbers& numbers, std::size_t threads, const nb::object& progress) {
            s.require_columns(numbers.shape(1));
            return beside_interpreter(
                [&](Supervision& supervision) {
                  return evaluate(s, numbers.data(), numbers.shape(0), threads, supervision);
                },
                progress);
          },
          nb::arg("numbers"), nb::arg("threads"), nb::arg("progress").none(),
          nb::sig("def evaluate(self, numbers: numpy.typing.NDArray[numpy.float64], threads: int, "
                  "progress: collections.abc.Callable[[int, int], object] | None) -> Designs"));

  module.def("available_processors", &available_processors);
  module.def("unit_key", &unit_key, nb::arg("unit"), "A unit as it stands in keys: `N/mm^1.5` is `N_per_mm1_5`.");
}

}  // namespace prs::python
