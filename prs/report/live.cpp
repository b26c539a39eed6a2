#include "prs/report/live.h"

#include <algorithm>
#include <memory>

#include "prs/input/reader.h"
#include "prs/report/findings.h"
#include "prs/report/sections.h"

namespace prs {
namespace {

constexpr std::string_view kThread = "thread";

bool is_wanted(const LiveQuestion& q, const SectionRow& row) {
  constexpr std::string_view kOfReport[] = {"models", "studies", "provenance"};
  if (std::ranges::find(kOfReport, row.id) != std::end(kOfReport)) return false;
  if (q.quick && !row.is_quick) return false;
  return q.sections.empty() || std::ranges::find(q.sections, row.id) != q.sections.end();
}

/// Few commands while a value moves: the loads where they can be solved.
std::vector<Command> commands_for(const input::Source& source, const LiveQuestion& q) {
  const auto all = reported_commands();
  const bool of_thread = q.sections == std::vector{std::string(kThread)};
  if (!q.quick && !of_thread) {
    std::vector<Command> most(all.begin(), all.end());
    std::erase(most, Command::compare);  // Three models, for a section that stays the report's.
    return most;
  }
  const input::CaseInput in = input::read_case_input(source, Command::check);
  std::vector<Command> few{input::missing(in, Command::solve).empty() ? Command::solve
                                                                      : Command::contact};
  if (of_thread) few.push_back(Command::slip);
  return few;
}

/// The report that a page started from, kept from one question to the next.
struct Before {
  input::Source source;
  std::unique_ptr<Findings> quick, complete;
};

bool is_same(const input::Source& a, const input::Source& b) {
  return a.text == b.text && a.overrides == b.overrides && a.name == b.name;
}

void write_all(Findings& all) {
  for (const SectionRow& row : section_rows()) section_of(all, row);
}

const Findings& before(const input::Source& report, const LiveQuestion& q) {
  static Before kept;
  if (!is_same(kept.source, report)) kept = {report, nullptr, nullptr};
  std::unique_ptr<Findings>& known = q.quick ? kept.quick : kept.complete;
  if (!known) {
    known = std::make_unique<Findings>(findings_of(report, {}, commands_for(report, q)));
    write_all(*known);
  }
  return *known;
}

}  // namespace

LiveAnswer live_sections(const input::Source& source, const LiveQuestion& question) {
  input::Source report = source;
  report.overrides.resize(std::min(question.own, report.overrides.size()));
  Findings all = findings_of(source, {}, commands_for(source, question));
  if (!is_same(source, report)) all.before = &before(report, question);
  LiveAnswer answer{nlohmann::ordered_json::object(), all.notes, all.converged};
  for (const SectionRow& row : section_rows())
    if (is_wanted(question, row)) answer.sections[row.id] = section_of(all, row).body;
  if (question.thread) {
    all.section = kThread;
    answer.sections[std::string(kThread)] = thread_html(all, *question.thread);
  }
  return answer;
}

}  // namespace prs
