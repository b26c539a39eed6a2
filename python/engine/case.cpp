#include "python/engine/case.h"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <type_traits>
#include <utility>

#include "prs/input/reader.h"
#include "prs/output/check.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/preload_json.h"
#include "prs/run/analyses.h"
#include "python/engine/beside.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

/// A source that finds its files from wherever it is used later.
input::Source load(const std::string& file, std::vector<std::string> overrides) {
  input::Source source = input::load_source(file, std::move(overrides));
  source.folder = std::filesystem::absolute(file).parent_path();
  return source;
}

}  // namespace

CaseSource::CaseSource(input::Source source)
    : source_(std::make_shared<const input::Source>(std::move(source))) {
  values(Command::check);
}

std::shared_ptr<const Case> CaseSource::values(Command command) const {
  if (const auto kept = values_.find(command); kept != values_.end()) return kept->second;
  const auto read = [&] {
    const WithoutInterpreter without;
    return std::make_shared<const Case>(input::read_case_input(*source_, command).values);
  };
  return values_.try_emplace(command, read()).first->second;
}

template <class Run, class Make>
std::shared_ptr<Document> CaseSource::analysis(Command command, Run run, Make make) const {
  const std::shared_ptr<const Case> values = this->values(command);
  const WithoutInterpreter without;
  auto result =
      std::make_shared<const std::invoke_result_t<Run, const input::Source&, const Case&>>(
          run(*source_, *values));
  return std::make_shared<Document>(
      [result, source = source_, make] { return make(*result, document_info(*source)); });
}

std::shared_ptr<Document> CaseSource::check() const {
  const auto checked = [](const input::Source& source, const Case&) {
    return run_check(source, input::read_case_input(source, Command::check));
  };
  return analysis(Command::check, checked, [](const CheckResult& r, const DocumentInfo& info) {
    return check_json(r.fields, r.contacts, r.warnings, info);
  });
}

std::shared_ptr<Document> CaseSource::contact() const {
  return analysis(Command::contact, run_contact, to_json);
}

std::shared_ptr<Document> CaseSource::solve() const {
  return analysis(Command::solve, run_solve, to_json);
}

std::shared_ptr<Document> CaseSource::slip() const {
  return analysis(Command::slip, run_slip, to_json);
}

std::shared_ptr<Document> CaseSource::preload() const {
  return analysis(Command::preload, run_preload, preload_json);
}

std::shared_ptr<Document> CaseSource::life() const {
  return analysis(Command::life, run_life, life_json);
}

std::shared_ptr<Document> CaseSource::measures() const {
  return analysis(Command::measures, run_measures, measures_json);
}

void bind_case(nb::module_& module) {
  nb::class_<input::Source>(module, "Source", "A case as it was written.")
      .def_static(
          "of_text",
          [](std::string name, std::string text, std::vector<std::string> overrides,
             const std::string& folder) {
            return input::source_of_text(std::move(name), std::move(text), std::move(overrides),
                                         folder);
          },
          nb::arg("name"), nb::arg("text"), nb::arg("overrides"), nb::arg("folder"),
          "A text of at most 1 MiB, which names files in that folder. InputError where it is "
          "longer.")
      .def_static("load", &load, nb::arg("file"), nb::arg("overrides"),
                  "Reads a file of at most 1 MiB. InputError where that is not possible.")
      .def_prop_ro("folder", [](const input::Source& source) { return source.folder.string(); })
      .def_ro("name", &input::Source::name)
      .def_prop_ro(
          "text",
          [](const input::Source& source) {
            return nb::steal<nb::str>(PyUnicode_DecodeUTF8(
                source.text.data(), static_cast<Py_ssize_t>(source.text.size()), "replace"));
          })
      .def_ro("overrides", &input::Source::overrides);

  nb::class_<CaseSource>(module, "Case", "A case that was read and checked.")
      .def(nb::init<input::Source>(), nb::arg("source"),
           "InputError with the text of `prs check` where something is wrong.")
      .def_prop_ro("source", &CaseSource::source, nb::rv_policy::copy)
      .def("check", &CaseSource::check)
      .def("contact", &CaseSource::contact)
      .def("solve", &CaseSource::solve)
      .def("slip", &CaseSource::slip)
      .def("preload", &CaseSource::preload)
      .def("life", &CaseSource::life)
      .def("measures", &CaseSource::measures);
}

}  // namespace prs::python
