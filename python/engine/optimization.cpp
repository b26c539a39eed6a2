#include "python/engine/optimization.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <memory>
#include <optional>
#include <utility>

#include "prs/input/optimize_reader.h"
#include "prs/optimize/optimize_pictures.h"
#include "prs/run/commands.h"
#include "prs/run/study.h"
#include "python/engine/document.h"
#include "python/engine/interpreter_guard.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

/// Document, and the source with the chosen design written into it.
using Outcome = std::pair<std::shared_ptr<Document>, std::optional<std::string>>;

std::optional<Outcome> optimize(const input::Source& source, std::size_t threads, Supervision& supervision) {
  std::optional<OptimizationResult> result = run_optimization(
      input::read_optimize_input(source), threads, Journal::temporary,
      {[&] { return supervision.stopped(); }, [&](const StudyProgress& progress) { supervision.report(progress); }});
  if (!result) return std::nullopt;
  auto shared = std::make_shared<const OptimizationResult>(std::move(*result));
  return Outcome{std::make_shared<Document>(
                     [shared, info = document_info(source, Command::optimize)] { return optimize_json(*shared, info); },
                     keeping(optimization_pictures(*shared), shared)),
                 chosen_case(*shared, source)};
}

}  // namespace

void bind_optimization(nb::module_& module) {
  module.def(
      "optimize",
      [](const input::Source& source, std::size_t threads, const nb::object& progress) {
        return beside_interpreter([&](Supervision& supervision) { return optimize(source, threads, supervision); },
                                  progress);
      },
      nb::arg("source"), nb::arg("threads"), nb::arg("progress").none(),
      nb::sig("def optimize(source: Source, threads: int, progress: "
              "collections.abc.Callable[[int, int], object] | None) -> "
              "tuple[Document, str | None]"));
}

}  // namespace prs::python
