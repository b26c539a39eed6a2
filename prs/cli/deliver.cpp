#include "prs/cli/deliver.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "prs/cli/interruption.h"
#include "prs/figures/figure_json.h"

namespace prs::cli {
namespace {

/// The document first; false where a picture is missing.
bool write(const Delivery& delivery, const std::string& document, const Figures& shown,
           const OutputOptions& options) {
  const Interruption after_the_files;  // What is written is listed, whatever ends the run.
  std::vector<OutputFile> files{{delivery.file, document}};
  if (delivery.files) std::ranges::move(delivery.files(options.csv), std::back_inserter(files));
  if (delivery.keeps_figures && !shown.empty())
    files.push_back({delivery.file.substr(0, delivery.file.find('.')) + std::string(kFiguresEnding),
                     figures_text(shown)});
  write_files(*options.output, files);
  Undrawn undrawn = draw_figures(shown, *options.output);
  if (Interruption::asked()) throw Interrupted();
  for (const std::string& note : delivery.without_figure) undrawn.notes.push_back(note);
  return report(undrawn, options);
}

}  // namespace

int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options) {
  const bool has_document = options.json || options.output;
  if (options.figures && !has_document)
    note(options, "--figures has no effect without a document; add --json or --output DIR");
  Figures shown;
  if (delivery.pictures && (options.output || (options.figures && options.json)))
    shown = figures(delivery.pictures());
  std::string document;
  if (has_document) {
    nlohmann::ordered_json json = delivery.document(info);
    if (options.figures) json["figures"] = to_json(shown);
    document = delivery.text ? delivery.text(json) : json_text(json);
  }
  const bool written = !options.output || write(delivery, document, shown, options);
  if (options.json) {
    print(document);
    for (const std::string& text : delivery.notes) note(options, text);
  } else if (!options.quiet) {
    const TableUnits units(options.units);
    print(options.all && delivery.full_table ? delivery.full_table() : delivery.table());
    const bool more_than_document = delivery.files || delivery.pictures;
    if (options.output && more_than_document)
      print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return exit_status(written, delivery.converged);
}

}  // namespace prs::cli
