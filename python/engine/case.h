#pragma once

#include <nanobind/nanobind.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "prs/case.h"
#include "prs/check_case.h"
#include "prs/input/source.h"
#include "python/engine/document.h"

namespace prs::python {

/// A case as it was written, read once for each command that is asked for. May be shared between
/// threads.
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

  std::shared_ptr<const input::Source> source_;
  mutable std::mutex mutex_;
  mutable std::map<Command, std::shared_ptr<const Case>> values_;
};

void bind_case(nanobind::module_& module);

}  // namespace prs::python
