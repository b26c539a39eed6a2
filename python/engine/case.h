#pragma once

#include <nanobind/nanobind.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "prs/input/source.h"
#include "prs/model/case.h"
#include "prs/model/check_case.h"
#include "python/engine/document.h"

namespace prs::python {

/// A case as it was written, read once for each command that is asked for. Threads may share it:
/// what it keeps is only touched by who has the interpreter, as whoever forks the process has.
class CaseSource {
 public:
  /// Reads and checks it. Throws InputError, with the text of `prs check`.
  explicit CaseSource(input::Source source);

  const input::Source& source() const { return *source_; }

  std::shared_ptr<Document> check() const;
  std::shared_ptr<Document> contact() const;
  std::shared_ptr<Document> solve() const;
  std::shared_ptr<Document> slip() const;
  std::shared_ptr<Document> preload() const;
  std::shared_ptr<Document> life() const;
  std::shared_ptr<Document> measures() const;

 private:
  /// The case for a command. Throws InputError where that needs what the case lacks.
  std::shared_ptr<const Case> values(Command command) const;

  /// The document that `make` writes of what `run` computes, once it is looked at.
  template <class Run, class Make>
  std::shared_ptr<Document> analysis(Command command, Run run, Make make) const;

  std::shared_ptr<const input::Source> source_;
  mutable std::map<Command, std::shared_ptr<const Case>> values_;
};

void bind_case(nanobind::module_& module);

}  // namespace prs::python
