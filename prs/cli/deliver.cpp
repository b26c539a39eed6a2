#include "prs/cli/deliver.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace prs::cli {
namespace {

/// The document first; false where a picture is missing.
bool write(const Delivery& delivery, const std::string& document, const OutputOptions& options) {
  std::vector<OutputFile> files{{delivery.file, document}};
  if (delivery.files) std::ranges::move(delivery.files(), std::back_inserter(files));
  write_files(*options.output, files);
  if (!delivery.figures) return true;
  Undrawn undrawn = draw_figures(delivery.figures(), *options.output);
  for (const std::string& note : delivery.without_figure) undrawn.notes.push_back(note);
  return report(undrawn, options);
}

}  // namespace

int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options) {
  std::string document;
  if (options.json || options.output) document = json_text(delivery.document(info));
  const bool written = !options.output || write(delivery, document, options);
  if (options.json) {
    print(document);
    for (const std::string& text : delivery.notes) note(options, text);
  } else if (!options.quiet) {
    print(delivery.table());
    const bool more_than_document = delivery.files || delivery.figures;
    if (options.output && more_than_document)
      print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return exit_status(written, delivery.converged);
}

}  // namespace prs::cli
