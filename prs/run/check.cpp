#include "prs/run/check.h"

#include "prs/loads/load_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "prs/loads/case_table.h"
#include "prs/loads/contact_record.h"
#include "prs/loads/warnings.h"
#include "prs/model/units.h"
#include "prs/record/record_table.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Lengths that follow from the mechanism.
constexpr Quantity<Mechanism> kDerived[] = {
    {"axial_pitch_mm", always<axial_pitch>},
    {"contact_length_mm",
     always<[](auto& m) { return (m.contacts_per_roller - 1) * axial_pitch(m); }>},
    {"roller_spacing_mm", always<[](auto& m) {
       return 2.0 * *m.centre_distance * std::sin(std::numbers::pi / m.rollers);
     }>},
};

std::vector<const Problem*> problems_of(const CheckResult& result) {
  std::vector<const Problem*> all;
  for (const CommandNeeds& command : result.commands)
    for (const Problem& problem : command.unmet)
      if (std::ranges::none_of(all, [&](const Problem* p) { return p->path == problem.path; }))
        all.push_back(&problem);
  return all;
}

std::string paths_of(const CommandNeeds& command, bool missing) {
  std::string paths;
  for (const Problem& problem : command.unmet)
    if (problem.is_missing() == missing) paths += (paths.empty() ? "" : ", ") + problem.path;
  return paths;
}

/// A row per command; below, each thing to add or change once.
std::string readiness(const CheckResult& result) {
  std::string text = "Commands\n";
  for (const CommandNeeds& command : result.commands) {
    if (command.command == Command::check) continue;
    std::string what = "ready";
    if (!command.unmet.empty()) {
      const std::string missing = paths_of(command, true), wrong = paths_of(command, false);
      what = missing.empty() ? "" : "add " + missing;
      if (!wrong.empty()) what += (what.empty() ? "change " : "; change ") + wrong;
    }
    text += fmt::format("  {:<12} {}\n", name(command.command), printable(what));
  }
  const std::vector<const Problem*> problems = problems_of(result);
  if (!problems.empty()) text += "\nTo add or change\n";
  for (const Problem* problem : problems) {
    std::string_view message = problem->message;
    if (problem->is_missing()) message.remove_prefix(Problem::kMissing.size());
    text += wrapped(printable(fmt::format("{}: {}", problem->path, message)), "  ", kTableWidth);
  }
  return text;
}

/// What a value rests on, and the reason of an assumed one.
std::pair<std::string_view, std::string_view> basis_of(const input::EchoEntry& f,
                                                       const CheckResult& result) {
  if (f.is_default) return {"default", {}};
  const auto found = result.assumed.find(f.path);
  if (found == result.assumed.end()) return {"given", {}};
  return {"assumed", found->second};
}

/// A reason stands below the first of the values that share it.
std::string input_list(const CheckResult& result) {
  std::string text = "\nInput\n";
  std::string_view told;
  for (const input::EchoEntry& f : result.fields) {
    const auto [basis, reason] = basis_of(f, result);
    text += fmt::format("  {:<42} {}   ({}{}{})\n", f.path, printable(f.value), basis,
                        f.origin.empty() ? "" : " ", f.origin);
    if (!reason.empty() && reason != told)
      text += wrapped(printable(reason), std::string(6, ' '), kTableWidth);
    told = reason;
  }
  return text;
}

/// A key of documents as tables show it, and what shows its number: `centre_distance, in`.
std::pair<std::string, double> labelled(std::string path) {
  for (std::size_t end = path.size(); end != std::string::npos; end = path.rfind('.', end - 1)) {
    const ShownUnit& unit = unit_of(std::string_view(path).substr(0, end));
    if (const ShownUnit& tables = table_unit(unit); tables.text != unit.text) {
      path.erase(end - unit.suffix.size(), unit.suffix.size());
      return {fmt::format("{}, {}", path, tables.text), tables.factor / unit.factor};
    }
  }
  return {path, 1.0};
}

std::string derived(const Contacts& contacts) {
  std::string text = "\nDerived\n";
  const auto line = [&](const std::string& path, double value) {
    const auto [label, factor] = labelled(path);
    text += fmt::format("  {:<42} {}\n", label, significant(factor * value, 7));
  };
  Json derived;
  put_quantities<Mechanism>(derived, kDerived, contacts.mechanism);
  for (const auto& [key, value] : derived.items()) line(key, value);
  const Json json = object_of(contacts);
  line("centre_distance_mm", json["centre_distance_mm"]);
  for (const char* key : {"pitch_diameter_mm", "helix_angle_deg"})
    for (const auto& [part, value] : json[key].items())
      line(fmt::format("{}.{}", key, part), value);
  line("max_rollers", json["max_rollers"]);
  const Json threads = object_of(contacts.threads);
  for (const auto& [part, widths] : threads.items())
    for (const auto& [key, value] : widths.items())
      line(fmt::format("threads.{}.{}", part, key), value);
  for (const char* interface : {"screw", "nut"})
    for (const char* key :
         {"normal_angle_deg", "backlash_mm", "flank_clearance_mm", "body_crest_clearance_mm",
          "roller_crest_clearance_mm", "hertz_constant_N_per_mm1_5"})
      if (json.contains(interface) && json[interface].contains(key))
        line(fmt::format("contact.{}.{}", interface, key), json[interface][key]);
  return text;
}

template <bool missing>
constexpr auto unmet_paths = filled<[](const CommandNeeds& command) {
  std::vector<std::string> paths;
  for (const Problem& problem : command.unmet)
    if (problem.is_missing() == missing) paths.push_back(problem.path);
  return paths;
}>;

constexpr Quantity<CommandNeeds> kNeeds[] = {
    {"ready", always<[](auto& command) { return command.unmet.empty(); }>},
    {"missing", unmet_paths<true>, "what to add"},
    {"wrong", unmet_paths<false>, "what to change"},
    {"loads", of<&CommandNeeds::loads>, "static | running, of commands that have loads of threads"},
};

using Input = Within<CheckResult, input::EchoEntry>;

constexpr Quantity<Input> kInput[] = {
    {"path", always<its<&input::EchoEntry::path>>},
    {"value", always<its<&input::EchoEntry::value>>},
    {"default", always<its<&input::EchoEntry::is_default>>},
    {"written", filled<its<&input::EchoEntry::written>>, "as the file has it"},
    {"origin", filled<its<&input::EchoEntry::origin>>, "of a default that a name stands for"},
    {"basis", always<[](auto& i) { return basis_of(*i.item, *i.whole).first; }>,
     "given, assumed (as a comment of the file says) or default"},
    {"reason", filled<[](auto& i) { return basis_of(*i.item, *i.whole).second; }>,
     "why it was assumed"},
};

constexpr Quantity<CheckResult> kCheck[] = {
    {"commands",
     always_table<kNeeds,
                  [](auto& result) {
                    ByKey<CommandNeeds> needs;
                    for (const CommandNeeds& command : result.commands)
                      needs.emplace_back(name(command.command), command);
                    return needs;
                  }>,
     "by their names"},
    {"input", always_table<kInput, [](auto& result) { return within(result, result.fields); }>},
    {"verdict", of<&CheckResult::verdict>},
    {"derived", always_table<kDerived,
                             [](auto& result) -> const Mechanism& {
                               return result.geometry.contacts.mechanism;
                             }>},
};

constexpr std::size_t kTitleWidth = 30;

/// A line for each criterion that has a value or a limit; the others in one.
std::string verdict_table(const CaseVerdict& verdict) {
  std::string text = "\nVerdict\n" + wrapped(summary(verdict), "  ", kTableWidth);
  for (const Criterion& c : verdict.criteria) {
    if (!c.value && !c.limit && c.name != "convergence") continue;
    const auto [unit, factor] = shown(c);
    const auto* const documents = std::ranges::find(kShownUnits, unit, &ShownUnit::text);
    const bool is_known = documents != std::end(kShownUnits);
    const auto number = [&, factor = factor](double value) {
      const double shown = value * factor * (is_known ? table_factor(*documents) : 1.0);
      return std::abs(shown) < 1e4 ? fmt::format("{:.4g}", shown) : fmt::format("{:.0f}", shown);
    };
    std::string limit;
    if (c.limit)
      limit = fmt::format("{} {} ({})", c.sense == Sense::least ? ">=" : "<=", number(*c.limit),
                          origin(c));
    std::string where = printable(c.load_case);
    if (!c.reason.empty()) where += (where.empty() ? "" : ": ") + printable(c.reason);
    std::string line = padded("  " + std::string(c.title), kTitleWidth, true) +
                       padded(c.value ? number(*c.value) : "", 9, false) + ' ' +
                       padded(std::string(is_known ? table_unit(*documents).text : unit), 9, true) +
                       padded(limit, 33, true) + ' ' + padded(words(c.standing), 13, true);
    // What is too long for the line stands below it.
    if (width(line) + width(where) <= kTableWidth) line += std::exchange(where, "");
    text += ended(line);
    if (!where.empty()) text += wrapped(where, std::string(kTitleWidth, ' '), kTableWidth);
  }
  const std::string rest = not_computed(verdict);
  return rest.empty() ? text : text + wrapped("No value: " + printable(rest), "  ", kTableWidth);
}

std::string head(const CheckResult& result) {
  return readiness(result) + (result.verdict ? verdict_table(*result.verdict) : "") +
         warning_section(result.geometry.warnings);
}

}  // namespace

std::string check_table(const CheckResult& result) {
  return head(result) + derived(result.geometry.contacts);
}

std::string full_check_table(const CheckResult& result) {
  return head(result) + input_list(result) + derived(result.geometry.contacts);
}

template <>
Record<CheckResult> record_of() {
  return {"Check", "What a case is ready for, and what follows from it.", kCheck};
}

void put_check(Json& document, const CheckResult& result) {
  put_object(document, result);
  put_contacts(document, result.geometry.contacts);
}

}  // namespace prs
