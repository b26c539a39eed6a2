#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "prs/input/reader.h"
#include "prs/input/source.h"
#include "prs/loads/analysis_options.h"
#include "prs/model/command.h"
#include "prs/quantities/verdict.h"
#include "prs/run/delivery.h"

namespace prs {

/// A row of the table of commands. What a case must have for it is `input::missing`.
struct CommandRow {
  Command command = Command::check;
  std::string_view help;
  /// Runs it on a case that was read from the source for it. Throws InputError, also for what the
  /// case turns out to have wrong. Empty for `study` and `optimize`, which continue what was
  /// interrupted.
  std::function<Delivery(const input::Source&, const input::CaseInput&)> run = {};
};

/// All commands that take a case, in the order in which they are shown.
std::span<const CommandRow> commands();

const CommandRow& row_of(Command command);

/// `solve` by other means than those of its row, on a case that has all for it.
Delivery run_solve(const input::Source& source, const input::CaseInput& in,
                   AnalysisOptions options);

/// `check` without the verdict, which runs what it needs.
Delivery run_check(const input::Source& source, const input::CaseInput& in);

/// A command that was run for a case: what it found, or what it found wrong.
struct Attempt {
  Command command = Command::check;
  const Delivery* delivery = nullptr;
  std::string failure = {};
};

/// The verdict on a case by what was run of it.
CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts);

/// Reads a case for a command and runs it. Throws InputError, also where the case lacks something.
Delivery run(const CommandRow& row, const input::Source& source);

/// Origin of a command's documents of a source, which must have been read for it without an error.
DocumentInfo document_info(const input::Source& source, Command command);

}  // namespace prs
