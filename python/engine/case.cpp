#include "python/engine/case.h"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <utility>

#include "prs/document/life_json.h"
#include "prs/document/measures_json.h"
#include "prs/document/preload_json.h"
#include "prs/input/reader.h"
#include "prs/output/check.h"
#include "prs/run/analyses.h"
#include "python/engine/beside.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

/// The document that `make` writes of a result, once it is looked at.
template <class Result, class Make>
std::shared_ptr<Document> document(Result result, std::shared_ptr<const input::Source> source,
                                   Make make) {
  auto shared = std::make_shared<const Result>(std::move(result));
  return std::make_shared<Document>(
      [shared, source, make] { return make(*shared, document_info(*source)); });
}

/// A source that finds its files from wherever it is used later.
input::Source load(const std::string& file, std::vector<std::string> overrides) {
  input::Source source = input::load_source(file, std::move(overrides));
  source.folder = std::filesystem::absolute(file).parent_path();
  return source;
}

template <std::shared_ptr<Document> (CaseSource::*run)() const>
std::shared_ptr<Document> without_interpreter(const CaseSource& c) {
  const WithoutInterpreter without;
  return (c.*run)();
}

}  // namespace

CaseSource::CaseSource(input::Source source)
    : source_(std::make_shared<const input::Source>(std::move(source))) {
  values(Command::check);
}

std::shared_ptr<const Case> CaseSource::values(Command command) const {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const Case>& kept = values_[command];
  if (!kept) kept = std::make_shared<const Case>(input::read_case_input(*source_, command).values);
  return kept;
}

std::shared_ptr<Document> CaseSource::check() const {
  return document(run_check(*source_, input::read_case_input(*source_, Command::check)), source_,
                  [](const CheckResult& r, const DocumentInfo& info) {
                    return check_json(r.fields, r.contacts, r.unusual, info);
                  });
}

std::shared_ptr<Document> CaseSource::contact() const {
  return document(run_contact(*source_, *values(Command::contact)), source_, to_json);
}

std::shared_ptr<Document> CaseSource::solve() const {
  return document(run_solve(*source_, *values(Command::solve)), source_, to_json);
}

std::shared_ptr<Document> CaseSource::slip() const {
  return document(run_slip(*source_, *values(Command::slip)), source_, to_json);
}

std::shared_ptr<Document> CaseSource::preload() const {
  return document(run_preload(*source_, *values(Command::preload)), source_, preload_json);
}

std::shared_ptr<Document> CaseSource::life() const {
  return document(run_life(*source_, *values(Command::life)), source_, life_json);
}

std::shared_ptr<Document> CaseSource::measures() const {
  return document(run_measures(*source_, *values(Command::measures)), source_, measures_json);
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
      .def(nb::init<input::Source>(), nb::arg("source"), nb::call_guard<WithoutInterpreter>(),
           "InputError with the text of `prs check` where something is wrong.")
      .def_prop_ro("source", &CaseSource::source, nb::rv_policy::copy)
      .def("check", &without_interpreter<&CaseSource::check>)
      .def("contact", &without_interpreter<&CaseSource::contact>)
      .def("solve", &without_interpreter<&CaseSource::solve>)
      .def("slip", &without_interpreter<&CaseSource::slip>)
      .def("preload", &without_interpreter<&CaseSource::preload>)
      .def("life", &without_interpreter<&CaseSource::life>)
      .def("measures", &without_interpreter<&CaseSource::measures>);
}

}  // namespace prs::python
