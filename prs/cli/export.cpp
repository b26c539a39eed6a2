#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "prs/cli/commands.h"
#include "prs/cli/quantity_option.h"
#include "prs/cli/usage_error.h"
#include "prs/export/system_model.h"
#include "prs/output/staged_file.h"
#include "prs/quantities/json.h"
#include "prs/sha256.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

/// A form of the model: its option, its file and what makes it.
struct Form {
  const char* option;
  const char* ending;
  bool ExportOptions::*is_asked_for;
  std::string (*make)(const SystemCurves&, const ModelText&);
};

constexpr Form kForms[] = {
    {"--fmu", ".fmu", &ExportOptions::fmu, functional_mockup_unit},
    {"--modelica", ".mo", &ExportOptions::modelica, modelica_package},
};

std::vector<const Form*> forms_of(const ExportOptions& options) {
  if (options.step)
    throw UsageError(
        "--step: the Python package makes STEP files, with the solid modeller that it brings: "
        "`pip install 'rollerscrew[cad]'`, then\n  python3 -c \"import rollerscrew as rs; "
        "rs.export_step(rs.Case.from_yaml('case.yaml'), 'screw.step')\"");
  std::vector<const Form*> forms;
  for (const Form& form : kForms)
    if (options.*form.is_asked_for) forms.push_back(&form);
  return forms;
}

/// `--output` with the ending of the form is its file, else a folder.
std::filesystem::path path_of(const Form& form, const std::string& name,
                              const std::optional<std::filesystem::path>& output) {
  if (!output) return name + form.ending;
  if (output->extension() == form.ending) return *output;
  return *output / (name + form.ending);
}

double positive_option(std::string_view option, const std::string& text,
                       const input::Dimension& dimension, std::string_view unit) {
  return quantity_option(option, text, dimension, input::positive,
                         fmt::format("more than 0 {}", unit));
}

CurveOptions curve_options(const ExportOptions& o) {
  CurveOptions options;
  if (o.force) options.force = positive_option("--force", *o.force, input::unit::force, "N");
  if (o.speed)
    options.speed = positive_option("--speed", *o.speed, input::unit::rotational_speed, "rpm");
  options.load_case = o.load_case;
  return options;
}

}  // namespace

int export_model(const Options& options) {
  const std::vector<const Form*> forms = forms_of(options.export_model);
  const std::optional<std::filesystem::path>& output = options.export_model.output;
  if (forms.empty() && !options.json)
    throw UsageError("the form is missing; expected --fmu, --modelica or both");
  if (forms.size() > 1 && output)
    for (const Form* form : forms)
      if (output->extension() == form->ending)
        throw UsageError(fmt::format(
            "--output: got {}, one file, for two forms; expected a folder, for example `models`",
            input::shown(output->string())));
  const CurveOptions asked = curve_options(options.export_model);
  const SystemModel model = system_model(case_source(options), asked);
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  for (const Form* form : forms)
    files.emplace_back(path_of(*form, model.text.name, output),
                       form->make(model.curves, model.text));
  for (const auto& [path, content] : files) {
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
    StagedFile file(path);
    file.append(content);
    file.publish();
  }

  for (const std::string& warning : model.curves.warnings) note(options, "warning: " + warning);
  if (options.json) {
    nlohmann::ordered_json document = document_head(model.info, model.curves.warnings);
    document["export"] = curves_json(model.curves);
    for (const auto& [path, content] : files)
      document["export"]["files"].push_back({{"path", path.string()}, {"sha256", sha256(content)}});
    print(json_text(document));
  } else if (!options.quiet) {
    std::string lines = wrapped(curves_text(model.curves), "", 100);
    for (const auto& [path, content] : files)
      lines += fmt::format("{}: {:.0f} kB\n", path.string(),
                           static_cast<double>(content.size()) / 1000.0);
    print(lines);
  }
  return kDone;
}

}  // namespace prs::cli
