#pragma once

#include "prs/input/echo.h"
#include "prs/model/command.h"
#include "prs/model/limits.h"
#include "prs/model/motor_duty.h"

namespace prs::input {

struct CaseFile;
struct LoadCaseItem;

/// A case and the list of all its values, defaults included.
struct CaseInput {
  Case values;
  std::vector<EchoEntry> fields;
  std::optional<Command> study;        ///< Command that the file's study runs.
  std::optional<Command> optimize;     ///< Command that an optimization runs.
  bool fits = false;                   ///< Whether the file states a fit.
  std::vector<Warning> warnings = {};  ///< Warnings on unusual values.
  std::optional<Limits> limits = {};   ///< Limits that the verdict checks.
  std::optional<MotorDuty> motor = {};
};

/// Inputs that a command needs and the file lacks or states otherwise, see `prs::missing`.
std::vector<Problem> unmet(const CaseInput& input, Command command);

/// Paths of inputs that a command needs and the file lacks, see `prs::missing`; empty if the command can run.
std::vector<std::string> missing(const CaseInput& input, Command command);

/// Reads a document, each value independently: contradictions between values are left to `checked_case`.
CaseFile read_case_file(const Node& root, ErrorList& errors);

/// One load case for each point of each range.
std::vector<LoadCase> expand(const std::vector<LoadCaseItem>& items);

/// Index of the first case of an item among the expanded ones.
std::size_t first_case(const std::vector<LoadCaseItem>& items, std::size_t item);

/// Sets force, position and speed of the cases that were expanded from an item before its numbers
/// changed.
void update_numbers(std::vector<LoadCase>& cases, const std::vector<LoadCaseItem>& items, std::size_t item);

/// Problems that `check_case` finds in a case or, if there are none, inputs that the command lacks.
std::vector<Problem> problems_of(const Case& c, Command command);

/// The case of a document that was read without an error, ranges of load cases expanded; problems that `check_case` and
/// the requirements of the command find are added to `errors`.
Case checked_case(const CaseFile& file, const Node& root, Command command, ErrorList& errors);

/// Reads and checks the input of a command. Throws InputError, which names every error found.
///
/// Ranges of load cases are expanded.
CaseInput read_case_input(const Source& source, Command command);

/// Reads and checks the input of a command; values only. `overrides`: `path=value` each.
Case read_case(const std::string& file, const std::vector<std::string>& overrides, Command command);

/// Reads the case from a text; `name`: file name for messages.
Case read_case_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
                    Command command);

}  // namespace prs::input
