#include "prs/run/commands.h"

#include "prs/losses/solve_analysis.h"
#include "prs/run/analyses.h"
#include "prs/version.h"

namespace prs {

const AnyAnalysis& analysis_of(Command command) {
  const auto found = std::ranges::find(analyses(), command, &AnyAnalysis::command);
  if (found == analyses().end()) throw std::logic_error(std::string(name(command)) + " is in no list of analyses");
  return *found;
}

const OtherFile* other_file(const input::Source& source) {
  input::ErrorList told_by_the_reader(source);
  const input::Node root = input::read_document(source, told_by_the_reader);
  if (input::find(root, "mechanism")) return nullptr;
  const auto is = [&](const OtherFile& file) { return input::find(root, file.key) != nullptr; };
  const auto found = std::ranges::find_if(other_files(), is);
  return found == other_files().end() ? nullptr : &*found;
}

Delivery run_solve(const input::Source& source, const input::CaseInput& in, const AnalysisOptions& options) {
  return delivered(source, in, solve_analysis(),
                   [&](const input::Source&, const input::CaseInput& of) { return solved(of.values, options); });
}

Delivery run(const AnyAnalysis& analysis, const input::Source& source) {
  if (analysis.command == Command::check)
    if (const OtherFile* file = other_file(source)) return file->check(source);
  return analysis.run(source, input::read_case_input(source, analysis.command));
}

DocumentInfo document_info(const input::Source& source, Command command) {
  const OtherFile* const file = other_file(source);
  return {kVersion,
          kSchemaVersion,
          file ? input::input_sha256(source, file->files(source)) : input::input_sha256(source, command),
          source.overrides,
          std::string(name(command)),
          source.name,
          [source, file] { return file ? file->resolved_input(source) : input::resolved_input(source); }};
}

}  // namespace prs
