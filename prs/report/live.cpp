#include "prs/report/live.h"

#include <algorithm>
#include <memory>

#include "prs/report/findings.h"
#include "prs/report/sections.h"
#include "prs/sector/full/full_distribution.h"

namespace prs {
namespace {

constexpr std::string_view kThread = "thread";

bool is_wanted(const LiveQuestion& q, const SectionRow& row) {
  constexpr std::string_view kOfReport[] = {"studies", "provenance"};
  if (std::ranges::find(kOfReport, row.id) != std::end(kOfReport)) return false;
  if (q.quick && !row.is_quick) return false;
  return q.sections.empty() || std::ranges::find(q.sections, row.id) != q.sections.end();
}

/// The report that a page started from and what serves its questions, kept from one to the next.
struct Kept {
  input::Source source;
  std::unique_ptr<Findings> quick, complete;
  FullSolver full{FullStart::neighbour};
};

bool is_same(const input::Source& a, const input::Source& b) {
  return a.text == b.text && a.overrides == b.overrides && a.name == b.name && a.files == b.files;
}

Findings findings_for(const input::Source& source, bool quick, Kept& kept) {
  return quick ? quick_findings_of(source, kept.full)
               : findings_of(source, {}, reported_commands());
}

/// The findings of the report with its figures.
Findings& report_of(const input::Source& report, bool quick, Kept& kept) {
  if (!is_same(kept.source, report)) {
    kept.quick.reset();
    kept.complete.reset();
    kept.source = report;
  }
  std::unique_ptr<Findings>& known = quick ? kept.quick : kept.complete;
  if (known) return *known;
  auto found = std::make_unique<Findings>(findings_for(report, quick, kept));
  found->keeps_figures = true;
  for (const SectionRow& row : section_rows())
    if (!quick || row.is_quick) section_of(*found, row);
  found->keeps_figures = false;
  known = std::move(found);
  return *known;
}

LiveAnswer answer_of(Findings& all, const LiveQuestion& question) {
  LiveAnswer answer{nlohmann::ordered_json::object(), all.notes, all.converged};
  for (const SectionRow& row : section_rows())
    if (is_wanted(question, row)) answer.sections[row.id] = section_of(all, row).body;
  if (question.thread) {
    all.section = kThread;
    answer.sections[std::string(kThread)] = thread_html(all, *question.thread);
  }
  return answer;
}

}  // namespace

LiveAnswer live_sections(const input::Source& source, const LiveQuestion& question) {
  constexpr Command kOfThread[] = {Command::contact, Command::solve, Command::slip};
  thread_local Kept kept;
  const TableUnits units(question.units);
  if (question.sections == std::vector{std::string(kThread)}) {
    Findings few = findings_of(source, {}, kOfThread);
    return answer_of(few, question);
  }
  input::Source own = source;
  own.overrides.resize(std::min(question.own, own.overrides.size()));
  Findings& report = report_of(own, question.quick, kept);
  if (is_same(source, own)) return answer_of(report, question);
  Findings changed = findings_for(source, question.quick, kept);
  changed.before = &report;
  return answer_of(changed, question);
}

}  // namespace prs
