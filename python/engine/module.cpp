#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include <utility>

#include "fe/cholesky.h"
#include "prs/input/schema.h"
#include "prs/input/source.h"
#include "prs/input/units.h"
#include "prs/measures/measures_analysis.h"
#include "prs/record/table_units.h"
#include "prs/sector/influence/matrix_cache.h"
#include "prs/version.h"
#include "python/engine/case.h"
#include "python/engine/document.h"
#include "python/engine/interpreter_guard.h"
#include "python/engine/optimization.h"
#include "python/engine/study.h"

namespace nb = nanobind;

NB_MODULE(_engine, module) {
  using namespace prs;
  using namespace prs::python;
  module.doc() = "The engine of rollerscrew: cases, studies and documents as the program has them.";
  module.attr("version") = kVersion;
  fe::Cholesky::name();  // Loads its library: a fork must not find a thread that is about to.
  nb::exception<input::InputError>(module, "InputError", PyExc_ValueError);
  module.def(
      "schema", [] { return json_text(input::schema()); },
      "JSON Schema of the input, as `prs schema` prints it.");
  module.def("knows_unit", &input::is_unit, nb::arg("unit"),
             "Whether values may be written in it.");
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
  shared_matrix_cache().keep_in(cache_directory());
}
