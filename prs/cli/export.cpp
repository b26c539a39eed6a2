#include "prs/cli/export.h"

#include <system_error>

#include "modules/response/response.h"
#include "prs/cli/command_line.h"
#include "prs/export/fmu.h"
#include "prs/export/robot.h"
#include "prs/sha256.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

/// The drive for a format whose joint has a constant mass: that of a lever in the middle of its motion.
ResponseInput with_mass(ResponseInput in) {
  if (!in.load.linkage) return in;
  const LeverMotion lever = *lever_motion(in, 0.0);
  in.load.mass = lever.reflected_mass(lever.middle());
  return in;
}

/// A form of the model: its option, its file and its function.
struct Form {
  const char* option;
  const char* ending;
  bool ExportOptions::*is_asked_for;
  std::string (*make)(const SystemModel&, const nlohmann::ordered_json&);

  std::string extension() const { return std::filesystem::path(std::string("NAME") + ending).extension().string(); }
};

constexpr Form kForms[] = {
    {"--fmu", ".fmu", &ExportOptions::fmu, [](const SystemModel& m, const auto&) { return functional_mockup_unit(m); }},
    {"--modelica", ".mo", &ExportOptions::modelica,
     [](const SystemModel& m, const auto&) { return modelica_package(m.curves, m.text); }},
    {"--mjcf", ".mjcf.xml", &ExportOptions::mjcf,
     [](const SystemModel& m, const auto& robot) { return mjcf(*m.drive, robot, m.text); }},
    {"--urdf", ".urdf", &ExportOptions::urdf,
     [](const SystemModel& m, const auto& robot) { return urdf(*m.drive, robot, m.text); }},
};

std::vector<const Form*> forms_of(const ExportOptions& options) {
  if (options.step)
    throw UsageError(
        "--step: the Python package makes STEP files, with the solid modeller that it brings: `pip "
        "install 'rollerscrew[cad]'`, then\n  python3 -c \"import rollerscrew as rs; "
        "rs.export_step(rs.Case.from_yaml('case.yaml'), 'screw.step')\"");
  std::vector<const Form*> forms;
  for (const Form& form : kForms)
    if (options.*form.is_asked_for) forms.push_back(&form);
  if (options.play && !options.mjcf) throw UsageError("--play: needs --mjcf, whose file then has the joint");
  if (options.friction_load && !options.mjcf && !options.urdf)
    throw UsageError("--friction-load: needs --mjcf or --urdf, whose constant friction is that of this load");
  if (options.is_static && !options.fmu) throw UsageError("--static: needs --fmu, which has the drive without it");
  return forms;
}

bool is_folder(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

/// Whether `--output` is the file of a form, by its ending; else it is a folder.
bool is_file_of(const Form& form, const std::filesystem::path& output) {
  return output.extension() == form.extension() && !is_folder(output);
}

/// Checks the destination before a computation of minutes.
void require_place(const std::filesystem::path& output, const std::vector<const Form*>& forms) {
  const auto fail = [&](std::string_view got, std::string_view expected) {
    throw UsageError("--output: got {}{}; expected {}", input::shown(output.string()), got, expected);
  };
  for (const Form& form : kForms) {
    if (!is_file_of(form, output)) continue;
    if (forms.size() > 1) fail(", one file, for several forms", "a folder, for example `models`");
    if (forms.size() == 1 && forms.front() != &form)
      fail(fmt::format(" for {}", forms.front()->option),
           fmt::format("a file that ends in {}, or a folder", forms.front()->extension()));
    return;
  }
  if (std::error_code error; std::filesystem::exists(output, error) && !is_folder(output))
    fail(", which is a file", "another name, or a folder");
}

/// Destination of the files of the forms, and their names.
struct Destination {
  std::filesystem::path folder;
  std::vector<OutputFile> files;

  std::string path(const OutputFile& file) const { return (folder / file.name).string(); }
};

Destination destination_of(const std::vector<const Form*>& forms, const SystemModel& model, const SystemModel& unit,
                           const nlohmann::ordered_json& robot, const std::optional<std::filesystem::path>& output) {
  Destination place;
  const bool is_file = output && forms.size() == 1 && is_file_of(*forms.front(), *output);
  if (output) place.folder = is_file ? output->parent_path() : *output;
  for (const Form* form : forms) {
    const bool is_unit = form->is_asked_for == &ExportOptions::fmu;
    const std::string file = is_file ? output->filename().string() : model.text.name + form->ending;
    place.files.push_back({file, form->make(is_unit ? unit : model, robot)});
    if (form->is_asked_for == &ExportOptions::mjcf)
      place.files.push_back(mujoco_callback(*model.drive, robot, model.text, file));
  }
  return place;
}

double positive_option(std::string_view option, const std::string& text, const input::Dimension& dimension,
                       std::string_view unit) {
  return quantity_option(option, text, dimension, input::positive, fmt::format("more than 0 {}", unit));
}

CurveOptions curve_options(const ExportOptions& o) {
  CurveOptions options;
  if (o.force) options.force = positive_option("--force", *o.force, input::unit::force, "N");
  options.speed_along_axis = o.speed && input::is_travel_speed(*o.speed);
  if (o.speed)
    options.speed =
        positive_option("--speed", *o.speed,
                        options.speed_along_axis ? input::unit::travel_speed : input::unit::rotational_speed, "rpm");
  options.load_case = o.load_case;
  return options;
}

}  // namespace

int export_model(const Options& options) {
  const std::vector<const Form*> forms = forms_of(options.export_model);
  const std::optional<std::filesystem::path>& output = options.export_model.output;
  if (forms.empty() && !options.json)
    throw UsageError("the form is missing; expected --fmu, --modelica, --mjcf or --urdf, or several of them");
  if (output) require_place(*output, forms);
  CurveOptions asked = curve_options(options.export_model);
  ProgressLine line(options.quiet);
  asked.progress = [&](std::size_t points) {
    line.show([&](double) { return fmt::format("curves: {} points solved", points); });
  };
  const ExportOptions& o = options.export_model;
  const bool for_robots = o.mjcf || o.urdf;
  const input::Source source = case_source(options);
  SystemModel model = system_model(source, asked,
                                   for_robots              ? WithDrive::needed
                                   : o.fmu && !o.is_static ? WithDrive::stated
                                                           : WithDrive::never);
  if (for_robots) model.drive = with_mass(*model.drive);
  nlohmann::ordered_json robot;
  std::optional<double> friction_load;
  if (o.friction_load) friction_load = positive_option("--friction-load", *o.friction_load, input::unit::force, "N");
  if (for_robots)
    robot = input::compute_from(source, [&] { return robot_constants(model, friction_load, o.play.has_value()); });
  std::optional<SystemModel> still;  // Model without the drive, which robots need.
  if (o.fmu && o.is_static && for_robots) still = system_model(source, asked, WithDrive::never);
  line.clear();
  Destination place = destination_of(forms, model, still ? *still : model, robot, output);
  const std::optional<LeverMotion> lever = model.drive ? lever_motion(*model.drive, model.curves.lead) : std::nullopt;
  if (lever && !place.files.empty()) place.files.push_back({"linkage.csv", linkage_csv(*lever, {})});
  if (!place.files.empty()) write_files(place.folder.empty() ? std::filesystem::path(".") : place.folder, place.files);

  for (const std::string& warning : sentences(model.curves.warnings)) note(options, "warning: " + warning);
  if (options.json) {
    nlohmann::ordered_json document = document_head(model.info, model.curves.warnings);
    document["export"] = curves_json(model.curves);
    if (!robot.is_null()) document["export"]["robot"] = robot;
    if (lever) document["export"]["lever"] = object_of(*lever);
    for (const OutputFile& file : place.files)
      document["export"]["files"].push_back({{"path", place.path(file)}, {"sha256", sha256(file.content)}});
    print(json_text(document));
  } else if (!options.quiet) {
    std::string lines = wrapped(curves_text(model.curves), "", 100);
    for (const OutputFile& file : place.files)
      lines += fmt::format("{}: {:.0f} kB\n", place.path(file), static_cast<double>(file.content.size()) / 1000.0);
    print(lines);
  }
  return kDone;
}

}  // namespace prs::cli
