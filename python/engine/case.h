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

/// A case as written, read once for each command used. Threads may share it: its cached data are only accessed by the
/// thread with the interpreter, also when the process forks.
class CaseSource {
 public:
  /// Reads and checks a source. Throws InputError, with the text of `prs check`.
  explicit CaseSource(input::Source source);

  const input::Source& source() const { return *source_; }

  /// Document of a command that delivers one, computed when it is first read. Throws InputError if the case lacks
  /// inputs.
  std::shared_ptr<Document> run(const AnyAnalysis& row) const;

  /// Writes the page of `prs report`, with the studies in folders and the live parts in the folder `live_parts`;
  /// returns whether all converged.
  bool report(const std::string& file, const std::vector<std::string>& results, const std::string& live_parts) const;

  /// Axial profiles of the threads as JSON, SI units, for solid models of the grooved bodies.
  std::string thread_profiles() const;

  /// Writes one of the forms of `prs export`, chosen by its ending; returns warnings.
  std::vector<std::string> export_model(const std::string& file, std::optional<double> force,
                                        std::optional<double> speed, std::optional<std::string> load_case,
                                        std::optional<double> friction_load, bool play_joint) const;

 private:
  std::shared_ptr<const input::CaseInput> input(Command command) const;

  std::shared_ptr<const input::Source> source_;
  mutable std::map<Command, std::shared_ptr<const input::CaseInput>> inputs_;
};

void bind_case(nanobind::module_& module);

}  // namespace prs::python
