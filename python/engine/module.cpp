#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <exception>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "fe/cholesky.h"
#include "prs/input/schema.h"
#include "prs/input/source.h"
#include "prs/input/units.h"
#include "prs/measures/measures_analysis.h"
#include "prs/page/live_parts.h"
#include "prs/record/table_units.h"
#include "prs/run/document_schema.h"
#include "prs/run/response_lists.h"
#include "prs/sector/influence/matrix_cache.h"
#include "prs/version.h"
#include "python/engine/case.h"
#include "python/engine/document.h"
#include "python/engine/interpreter_guard.h"
#include "python/engine/optimization.h"
#include "python/engine/study.h"
#include "python/engine/theory.h"
#include "simd/instruction_set.h"

namespace nb = nanobind;

namespace {

/// Converts to `rollerscrew.InputError`, with its parts as attributes.
void raise_input_errors(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const prs::input::InputError& error) {
    const std::string_view what = error.what();
    const nb::object text =
        nb::steal(PyUnicode_DecodeUTF8(what.data(), static_cast<Py_ssize_t>(what.size()), "replace"));
    const nb::object made = nb::module_::import_("rollerscrew.errors").attr("input_error")(text);
    PyErr_SetObject(made.type().ptr(), made.ptr());
  }
}

}  // namespace

NB_MODULE(_engine, module) {
  using namespace prs;
  using namespace prs::python;
  module.doc() = "The engine of rollerscrew: cases, studies and documents as the program has them.";
  module.attr("version") = kVersion;
  simd::widest();        // The import fails if PRS_INSTRUCTION_SET names an unavailable set.
  fe::Cholesky::name();  // Loads the library: a fork must not happen while a thread loads it.
  nb::register_exception_translator(raise_input_errors);
  module.def(
      "schema", [] { return json_text(input::schema()); }, "JSON Schema of the input, as `prs schema` prints it.");
  module.def(
      "results_schema", [] { return json_text(results_schema()); },
      "Every quantity of the results, as `prs schema results` prints it.");
  module.def(
      "lubricants", [] { return json_text(lubricants_json()); },
      "Those known by name, as `prs list lubricants --json` prints them.");
  module.def(
      "units", [] { return json_text(units_json()); }, "Units of the input, as `prs list units --json` prints them.");
  module.def(
      "live_parts_absent", [](const std::string& folder) { return read_live_parts(folder).absent; }, nb::arg("folder"),
      "Why a folder makes no page live; empty where it does.");
  module.def(
      "input_paths",
      [] {
        std::vector<std::string> paths;
        for (const input::InputKey& key : input::input_keys()) paths.push_back(key.path);
        return paths;
      },
      "Paths of all inputs, as `prs list inputs` prints them.");
  module.def("known_responses", &known_responses, "Every path that a study may record.");
  module.def("number_in", &input::number_in, nb::arg("value"), nb::arg("unit"),
             "The number of a value such as `5 mm` in a unit; None where that is not possible.");
  module.def("knows_unit", &input::is_unit, nb::arg("unit"), "Whether values may be written in it.");
  module.def(
      "measure_explanations", [] { return json_text(measure_explanations_json()); },
      "Formula, validity and source of every measure.");
  module.def(
      "response_title",
      [](const std::string& path) {
        const ResponseTitle title = response_title(path);
        return std::pair(title.name, title.unit);
      },
      nb::arg("path"), "What a person calls a response, and its unit.");
#ifdef NDEBUG
  nb::set_leak_warnings(false);  // Objects of daemon threads outlive the interpreter.
#endif
  end_work_with(module);
  bind_document(module);
  bind_case(module);
  bind_study(module);
  bind_optimization(module);
  bind_theory(module);
  shared_matrix_cache().keep_in(cache_directory());
}
