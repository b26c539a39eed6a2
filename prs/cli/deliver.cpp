#include "prs/cli/deliver.h"

#include <iterator>
#include <system_error>

#include "prs/cli/interruption.h"
#include "prs/output/run_files.h"
#include "prs/record/figure_json.h"

namespace prs::cli {
namespace {

using WriteText = std::function<void(const TextSink&)>;

void write(const Delivery& delivery, const WriteText& document, const Figures& shown,
           const OutputOptions& options) {
  const Interruption after_the_files;  // What is written is listed, whatever ends the run.
  std::error_code told_by_the_file;
  std::filesystem::create_directories(*options.output, told_by_the_file);
  const std::filesystem::path path = *options.output / delivery.file;
  StagedFile staged(path);
  document([&](std::string_view text) { staged.append(text); });
  staged.close();
  std::vector<OutputFile> files;
  if (delivery.files) std::ranges::move(delivery.files(options.csv), std::back_inserter(files));
  if (delivery.keeps_figures && !shown.empty())
    files.push_back({delivery.file.substr(0, delivery.file.find('.')) + std::string(kFiguresEnding),
                     figures_text(shown)});
  write_files(*options.output, files);
  staged.publish();
  record_written(path);
  draw_figures(shown, *options.output, options.png);
  if (Interruption::asked()) throw Interrupted();
  for (const std::string& text : delivery.without_figure) note(options, text);
}

}  // namespace

std::vector<std::string> notes_of(std::string text) {
  if (text.empty()) return {};
  text.erase(text.find_last_not_of('\n') + 1);
  return {std::move(text)};
}

int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options) {
  const bool has_document = options.json || options.output;
  if (options.figures && !has_document)
    note(options, "--figures has no effect without a document; add --json or --output DIR");
  Figures shown;
  if (delivery.pictures && (options.output || (options.figures && options.json)))
    shown = figures(delivery.pictures(), options.all);
  nlohmann::ordered_json json;
  if (has_document) {
    json = delivery.outline ? delivery.outline(info) : delivery.document(info);
    if (options.figures) json["figures"] = to_json(shown);
  }
  const WriteText document = [&](const TextSink& sink) {
    delivery.write ? delivery.write(json, sink) : sink(json_text(json));
  };
  if (options.output) write(delivery, document, shown, options);
  if (options.json) {
    document([](std::string_view text) { print(text); });
    for (const std::string& text : delivery.notes) note(options, text);
  } else if (!options.quiet) {
    const TableUnits units(options.units);
    print(options.all && delivery.full_table ? delivery.full_table() : delivery.table());
    const bool more_than_document = delivery.files || delivery.pictures;
    if (options.output && more_than_document)
      print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return exit_status(delivery.converged);
}

}  // namespace prs::cli
