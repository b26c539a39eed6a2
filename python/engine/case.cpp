#include "python/engine/case.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <map>
#include <utility>

#include "prs/export/fmu.h"
#include "prs/export/robot.h"
#include "prs/input/document.h"
#include "prs/input/echo.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/output/staged_file.h"
#include "prs/page/page.h"
#include "prs/run/analyses.h"
#include "prs/size/size_analysis.h"
#include "prs/threads/threads.h"
#include "python/engine/interpreter_guard.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

/// A source that finds its files from any working directory.
input::Source load(const std::string& file, std::vector<std::string> overrides) {
  input::Source source = input::load_source(file, std::move(overrides));
  source.folder = std::filesystem::absolute(file).parent_path();
  return source;
}

using Files = std::map<std::string, nb::bytes>;

std::optional<Files> files_of(const input::Source& source) {
  if (!source.files) return std::nullopt;
  Files files;
  for (const auto& [name, text] : *source.files) files.emplace(name, nb::bytes(text.data(), text.size()));
  return files;
}

input::Source of_text(std::string name, std::string text, std::vector<std::string> overrides, const std::string& folder,
                      const std::optional<Files>& files) {
  input::Source source = input::source_of_text(std::move(name), std::move(text), std::move(overrides), folder);
  if (files) source.files.emplace();
  if (files)
    for (const auto& [file, content] : *files)
      source.files->emplace(file, std::string(content.c_str(), content.size()));
  return source;
}

}  // namespace

CaseSource::CaseSource(input::Source source) : source_(std::make_shared<const input::Source>(std::move(source))) {
  const std::shared_ptr<const input::CaseInput> read = input(Command::check);
  if (!read->values.life || !read->values.life->history) return;
  const GilRelease released;
  source_ = std::make_shared<const input::Source>(input::with_files(*source_, *read->values.life->history));
}

std::shared_ptr<const input::CaseInput> CaseSource::input(Command command) const {
  if (const auto kept = inputs_.find(command); kept != inputs_.end()) return kept->second;
  const auto read = [&] {
    const GilRelease released;
    return std::make_shared<const input::CaseInput>(input::read_case_input(*source_, command));
  };
  return inputs_.try_emplace(command, read()).first->second;
}

std::shared_ptr<Document> CaseSource::run(const AnyAnalysis& row) const {
  const std::shared_ptr<const input::CaseInput> input = this->input(row.command);
  const GilRelease released;
  const auto delivery = std::make_shared<const Delivery>(row.run(*source_, *input));
  return std::make_shared<Document>(
      [delivery, source = source_, command = row.command] {
        return delivery->document(document_info(*source, command));
      },
      delivery->pictures ? keeping(delivery->pictures(), delivery) : Pictures{}, delivery->converged);
}

bool CaseSource::report(const std::string& file, const std::vector<std::string>& results,
                        const std::string& live_parts) const {
  const GilRelease released;
  const Report report = make_report(*source_, {.command = "Case.report of the Python package",
                                               .results = {results.begin(), results.end()},
                                               .live_parts = live_parts});
  StagedFile staged(file);
  staged.append(report.html);
  staged.publish();
  return report.converged;
}

std::string CaseSource::thread_profiles() const {
  constexpr int kIntervals = 24;
  const std::shared_ptr<const input::CaseInput> input = this->input(Command::check);
  const Mechanism mechanism = input::compute_from(*source_, [&] { return resolved(input->values.mechanism); });
  const contact::MechanismGeometry threads = threads_of(mechanism);
  const auto profile = [](const contact::Thread& thread) {
    const contact::ThreadSurface surface(thread);
    const contact::RadiusLimits limits = contact::usable_limits(surface);
    nlohmann::ordered_json radius, height;
    for (int k = 0; k <= kIntervals; ++k) {
      const double r = limits.smallest + (limits.largest - limits.smallest) * k / kIntervals;
      radius.push_back(r);
      height.push_back(surface.profile(r).height);
    }
    return nlohmann::ordered_json{
        {"lead", thread.lead}, {"pitch", thread.pitch}, {"radius", radius}, {"height", height}};
  };
  return nlohmann::ordered_json{{"centre_distance", threads.centre_distance},
                                {"screw", profile(threads.screw)},
                                {"roller", profile(threads.roller)},
                                {"nut", profile(threads.nut)}}
      .dump();
}

std::vector<std::string> CaseSource::export_model(const std::string& file, std::optional<double> force,
                                                  std::optional<double> speed, std::optional<std::string> load_case,
                                                  std::optional<double> friction_load, bool play_joint) const {
  const GilRelease released;
  const std::filesystem::path path(file);
  const std::string ending = path.extension();
  const bool for_robots = ending == ".xml" || ending == ".urdf";
  SystemModel model = system_model(*source_, {.force = force, .speed = speed, .load_case = std::move(load_case)},
                                   for_robots         ? WithDrive::needed
                                   : ending == ".fmu" ? WithDrive::stated
                                                      : WithDrive::never);
  model.text.name = model_name(file);
  nlohmann::ordered_json robot;
  if (for_robots)
    robot = input::compute_from(*source_, [&] { return robot_constants(model, friction_load, play_joint); });
  const auto write = [&](const OutputFile& out) {
    StagedFile staged(path.parent_path() / out.name);
    staged.append(out.content);
    staged.publish();
  };
  if (ending == ".xml") write(mujoco_callback(*model.drive, robot, model.text, path.filename()));
  write({path.filename(), ending == ".mo"     ? modelica_package(model.curves, model.text)
                          : ending == ".xml"  ? mjcf(*model.drive, robot, model.text)
                          : ending == ".urdf" ? urdf(*model.drive, robot, model.text)
                                              : functional_mockup_unit(model)});
  return sentences(model.curves.warnings);
}

void bind_case(nb::module_& module) {
  nb::class_<input::Source>(module, "Source", "A case as it was written.")
      .def_static("of_text", &of_text, nb::arg("name"), nb::arg("text"), nb::arg("overrides"), nb::arg("folder"),
                  nb::arg("files").none() = nb::none(),
                  "A text of at most 1 MiB, which names files in that folder; those in `files` are not "
                  "read. InputError where it is longer.")
      .def_static("load", &load, nb::arg("file"), nb::arg("overrides"),
                  "Reads a file of at most 1 MiB. InputError where that is not possible.")
      .def_prop_ro("folder", [](const input::Source& source) { return source.folder.string(); })
      .def_prop_ro("files", &files_of, "Texts of the files that it names, once they are read.")
      .def("written", &input::written_case,
           "The text with the overrides written into it; None where one has no place there.")
      .def_ro("name", &input::Source::name)
      .def_prop_ro("text",
                   [](const input::Source& source) {
                     return nb::steal<nb::str>(PyUnicode_DecodeUTF8(
                         source.text.data(), static_cast<Py_ssize_t>(source.text.size()), "replace"));
                   })
      .def_ro("overrides", &input::Source::overrides);

  nb::class_<CaseSource> bound(module, "Case", "A case that was read and checked.");
  bound
      .def(nb::init<input::Source>(), nb::arg("source"),
           "InputError with the text of `prs check` where something is wrong.")
      .def("report", &CaseSource::report, nb::arg("file"), nb::arg("results"), nb::arg("live_parts"),
           "Writes everything that the case requests as one page; whether all of it converged.")
      .def("thread_profiles", &CaseSource::thread_profiles,
           "Axial profiles of the threads as JSON, in metres: radii, and half the width of the "
           "groove at each; of the nut those of the air in it.")
      .def("export_model", &CaseSource::export_model, nb::arg("file"), nb::arg("force").none(), nb::arg("speed").none(),
           nb::arg("load_case").none(), nb::arg("friction_load").none() = nb::none(), nb::arg("play_joint") = false,
           "Writes a model of the screw by the file's ending, .fmu, .mo, .xml or .urdf; its warnings.")
      .def_prop_ro("source", &CaseSource::source, nb::rv_policy::copy);
  module.def(
      "size",
      [](const input::Source& source) {
        const GilRelease released;
        const auto delivery = std::make_shared<const Delivery>(size_delivery(size_screws(read_requirement(source))));
        return std::make_shared<Document>(
            [delivery, source] { return delivery->document(document_info(source, Command::size)); },
            keeping(delivery->pictures(), delivery));
      },
      nb::arg("source"), "Which screw, and which motor, for a requirement.");
  for (const AnyAnalysis& row : analyses())
    if (row.run) bound.def(name(row.command).data(), [&row](const CaseSource& c) { return c.run(row); });
}

}  // namespace prs::python
