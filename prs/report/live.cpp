
#include "prs/input/reader.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/report/findings.h"

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

/// What has loads of its own that are still the report's, while the load cases have others.
std::map<Command, std::string> unmoved(const input::Source& report, const input::Source& changed) {
  const auto values = [](const input::Source& source) {
    return input::read_case_input(source, Command::check).values;
  };
  const Case before = values(report), now = values(changed);
  const auto told = [](std::string_view key) {
    return fmt::format(
        "This does not follow the axial force of the load cases: its loads are those of "
        "<code>{}</code>.",
        key);
  };
  std::map<Command, std::string> all;
  const auto same_force = [](const LoadCase& a, const LoadCase& b) {
    return a.axial_force == b.axial_force;
  };
  const auto same_load = [](const SpectrumLoad& a, const SpectrumLoad& b) {
    return a.force == b.force;
  };
  if (std::ranges::equal(before.load_cases, now.load_cases, same_force)) return all;
  if (now.life && before.life &&
      std::ranges::equal(before.life->spectrum, now.life->spectrum, same_load))
    all[Command::life] = told(now.life->history ? "life.history" : "life.spectrum");
  if (now.preload && before.preload && before.preload->load.from == now.preload->load.from &&
      before.preload->load.to == now.preload->load.to)
    all[Command::preload] = told("preload.load");
  return all;
}

LiveAnswer answer_of(Findings& all, const LiveQuestion& question) {
  LiveAnswer answer{Json::object(), {}, nullptr, all.unmoved.empty(), all.notes, all.converged};
  for (const SectionRow& row : section_rows()) {
    if (!is_wanted(question, row)) continue;
    std::string body = section_of(all, row).body;
    for (const auto& [command, why] : all.unmoved)
      if (name(command) == row.id && !body.empty())
        body = fmt::format("<p>{}</p>\n<div class=\"stale\">\n{}</div>\n", why, body);
    answer.sections[std::string(row.id)] = std::move(body);
  }
  if (!question.quick && !all.check.empty()) {
    answer.head = head_html(all);
    answer.threads = thread_choices(all);
  }
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
  if (!question.quick) changed.unmoved = unmoved(own, source);
  return answer_of(changed, question);
}

}  // namespace prs
