#pragma once

#include <nanobind/nanobind.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prs/input/source.h"
#include "prs/run/commands.h"
#include "python/engine/document.h"

namespace prs::python {

/// A case as it was written, read once for each command that is asked for. Threads may share it:
/// what it keeps is only touched by who has the interpreter, as whoever forks the process has.
class CaseSource {
 public:
  /// Reads and checks it. Throws InputError, with the text of `prs check`.
  explicit CaseSource(input::Source source);

  const input::Source& source() const { return *source_; }

  /// The document of a command that delivers one, once it is looked at. Throws InputError where it
  /// needs what the case lacks.
  std::shared_ptr<Document> run(const AnyAnalysis& row) const;

  /// Writes the page of `prs report`, with the studies that folders hold and what the folder `live_parts` has
  /// of live pages; whether all converged.
  bool report(const std::string& file, const std::vector<std::string>& results, const std::string& live_parts) const;

  /// Axial profiles of the threads as JSON, SI: what solid models of the grooved bodies are made
  /// of.
  std::string thread_profiles() const;

  /// Writes one of the forms of `prs export`, by its ending; its warnings.
  std::vector<std::string> export_model(const std::string& file, std::optional<double> force,
                                        std::optional<double> speed, std::optional<std::string> load_case,
                                        std::optional<double> friction_load) const;

 private:
  std::shared_ptr<const input::CaseInput> input(Command command) const;

  std::shared_ptr<const input::Source> source_;
  mutable std::map<Command, std::shared_ptr<const input::CaseInput>> inputs_;
};

void bind_case(nanobind::module_& module);

}  // namespace prs::python
