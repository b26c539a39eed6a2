#pragma once

#include <tuple>

#include "prs/loads/case_table.h"
#include "prs/report/report.h"
#include "prs/run/check.h"
#include "prs/run/commands.h"

namespace prs {

class FullSolver;

/// What a command found.
struct CommandAnswer {
  Command command;
  Delivery delivery;
  Json document;
  Pictures pictures = {};
};

/// Files of a study or an optimization that was run before.
struct StoredRun {
  Command command;
  std::vector<OutputFile> files;
};

/// A drawn picture: the section, its name, and how many of that name stood before it there.
using FigurePlace = std::tuple<std::string, std::string, int>;

/// What a page is made of.
struct Findings {
  input::Source source;
  ReportOptions options;
  std::string date;
  DocumentInfo origin;  ///< Origin of the case, as in its documents; of quick findings empty.
  Delivery check;
  std::vector<CommandAnswer> answers;
  std::vector<StoredRun> studies;
  std::vector<Warning> warnings;  ///< Warnings of all that was computed.
  CaseVerdict verdict;
  std::vector<std::string> notes;
  std::vector<std::string> void_paths;  ///< Inputs that overrides stand in for.
  bool converged = true;
  bool is_full = false;  ///< All rollers, not one for all.

  const Findings* before = nullptr;  ///< Shown behind these, in grey.
  /// What has loads of its own, which stayed while those of the load cases moved, and why.
  std::map<Command, std::string> unmoved = {};
  std::vector<Command> lacking = {};       ///< Commands whose module is not here.
  std::string section = {};                ///< The one that is being written.
  std::map<std::string, int> places = {};  ///< How many of a name stand in it so far.
  bool keeps_figures = false;              ///< For those that are drawn behind others.
  std::map<FigurePlace, Figure> figures = {};

  const CheckResult& checked() const { return *check.result<CheckResult>(); }
  const CommandAnswer* answer(Command command) const;
  /// What a command found; null where it was not run.
  template <class R>
  const R* result(Command command) const {
    const CommandAnswer* of = answer(command);
    return of ? of->delivery.result<R>() : nullptr;
  }
  /// The load cases, solved where the case has all for it.
  const CommandAnswer* most_complete() const;
};

/// All commands that a page shows, in the order in which they run.
std::span<const Command> reported_commands();

/// Runs those of the commands for which the case has all that it needs; of studies and
/// optimizations, takes what `results` of the options hold. Throws InputError where the case is
/// wrong.
Findings findings_of(input::Source source, ReportOptions options, std::span<const Command> commands);

/// What sections need that follow a moving value: the loads where the case has all for `solve`,
/// else the contacts, and of the check its warnings. `full` solves one full mechanism after the
/// other.
Findings quick_findings_of(input::Source source, FullSolver& full);

/// What stands under a key; null where there is nothing.
const Json& under(const Json& json, const std::string& key);

/// Value of an input as the file could have it; empty where there is none.
std::string input_value(const Findings& all, std::string_view path);

/// State, numbers of interest, and how many warnings.
std::string verdict_html(const Findings& all);

/// What did not converge, a line for each command.
std::vector<std::string> unconverged(const Findings& all);
/// Warnings, or the assumptions among them; empty where there is none.
std::string warning_list(const Findings& all, bool assumptions);

/// Sliders and fields for the inputs that matter, by what the case states; empty where it has
/// nothing that a page could move.
std::string controls_html(const Findings& all);

/// Name of the case, and its mechanism in a sentence.
std::string head_html(const Findings& all);

/// The load cases whose threads can be looked at, and the most loaded thread; null where none can.
Json thread_choices(const Findings& all);

/// The figure that the place of a picture shows, before it is written: with what stood there
/// before behind it.
std::string figure_html(Findings& all, Figure figure, bool narrow = false);

/// A section of the page and how it is written.
struct SectionRow {
  std::string_view id, title;
  std::function<std::string(Findings&)> make;
  bool is_quick = false;  ///< Needs `solve` or `contact` alone: follows while a value moves.
};

/// In the order in which a reviewer asks: the answer, the part, what is doubtful, what was put in,
/// then what came out.
std::span<const SectionRow> section_rows();

ReportSection section_of(Findings& all, const SectionRow& row);

}  // namespace prs
