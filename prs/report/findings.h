#pragma once

#include <tuple>

#include "prs/loads/case_table.h"
#include "prs/report/report.h"
#include "prs/run/check.h"
#include "prs/run/commands.h"

namespace prs {

class FullSolver;

/// Result of a command.
struct CommandAnswer {
  Command command;
  Delivery delivery;
  Json document;
  Pictures pictures = {};
};

/// Files of a study or an optimization from an earlier run.
struct StoredRun {
  Command command;
  std::vector<OutputFile> files;
};

/// Place of a drawn picture: the section, its name, and how many of that name precede it there.
using FigurePlace = std::tuple<std::string, std::string, int>;

/// Data from which a page is made.
struct Findings {
  input::Source source;
  ReportOptions options;
  std::string date;
  DocumentInfo origin;  ///< Origin of the case, as in its documents; empty for quick findings.
  Delivery check;
  std::vector<CommandAnswer> answers;
  std::vector<StoredRun> studies;
  std::vector<Warning> warnings;  ///< Warnings of all results.
  CaseVerdict verdict;
  std::vector<std::string> notes;
  std::vector<std::string> void_paths;  ///< Inputs that overrides replace.
  bool converged = true;
  bool is_full = false;  ///< Whether there are all rollers, not one representing all.

  const Findings* before = nullptr;  ///< Earlier findings, drawn behind these in grey.
  /// Commands with their own loads, which stayed while those of the load cases moved, and the reasons.
  std::map<Command, std::string> unmoved = {};
  std::vector<Command> lacking = {};       ///< Commands whose module is missing.
  std::string section = {};                ///< Section being written.
  std::map<std::string, int> places = {};  ///< Number of pictures of each name in the section so far.
  bool keeps_figures = false;              ///< Whether figures are kept, to be drawn behind others.
  std::map<FigurePlace, Figure> figures = {};

  const CheckResult& checked() const { return *check.result<CheckResult>(); }
  const CommandAnswer* answer(Command command) const;
  /// Result of a command; null if it was not run.
  template <class R>
  const R* result(Command command) const {
    const CommandAnswer* of = answer(command);
    return of ? of->delivery.result<R>() : nullptr;
  }
  /// Load cases, solved if the case has all inputs.
  const CommandAnswer* most_complete() const;
  /// Threads one by one: with slip, whose loads are those of the running screw, if the case has all inputs of it.
  const CommandAnswer* of_threads() const;
};

/// All commands that a page shows, in the order in which they run.
std::span<const Command> reported_commands();

/// Runs the commands for which the case has all inputs; for studies and optimizations, takes the contents of `results`
/// in the options. Throws InputError if the case is wrong.
Findings findings_of(input::Source source, ReportOptions options, std::span<const Command> commands);

/// Findings for sections that follow a moving value: the loads if the case has all inputs of `solve`, else the
/// contacts, and the warnings of the check. `full` solves one full mechanism after the other.
Findings quick_findings_of(input::Source source, FullSolver& full);

/// Value under a key; null if there is none.
const Json& under(const Json& json, const std::string& key);

/// Value of an input as in a file; empty if there is none.
std::string input_value(const Findings& all, std::string_view path);

/// Number of inputs that comments of the file call assumed.
std::size_t assumed_inputs(const Findings& all);

/// HTML with the state, headline numbers, and the number of warnings.
std::string verdict_html(const Findings& all);

/// The first sheet of a print, to sign: requirement, verdict, the numbers that matter most, drawing, what they rest on.
std::string summary_html(Findings& all);

/// Failed commands, one line for each.
std::vector<std::string> unconverged(const Findings& all);
/// Warnings, or the assumptions among them; empty if there are none.
std::string warning_list(const Findings& all, bool assumptions);

/// Name of the case, and its mechanism in a sentence.
std::string head_html(const Findings& all);

/// Figure at the place of a picture, before it is written: with the former one behind it.
std::string figure_html(Findings& all, Figure figure);

/// A section of the page and the function that writes it.
struct SectionRow {
  std::string_view id, title;
  std::function<std::string(Findings&)> make;
  bool is_quick = false;  ///< Whether it needs only `solve` or `contact`, so that it follows a moving value.
};

/// Sections in the order of a review: the answer, the part, doubts, inputs, then results.
std::span<const SectionRow> section_rows();

ReportSection section_of(Findings& all, const SectionRow& row);

}  // namespace prs
