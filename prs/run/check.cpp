#include "prs/run/check.h"

#include <fmt/ranges.h>

#include "modules/fit/fit_reader.h"
#include "modules/module.h"
#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/input/optimize_reader.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_case_result.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/load_record.h"
#include "prs/losses/life_analysis.h"
#include "prs/model/check_case.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/record/table_layout.h"
#include "prs/run/analyses.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_warnings.h"
#include "prs/text.h"
#include "prs/threads/geometry_warnings.h"
#include "prs/threads/motion_orders.h"

namespace prs {
namespace {

using input::CaseInput;
using input::EchoEntry;
using input::Source;

/// Numbers that follow from the mechanism.
constexpr Quantity<Mechanism> kDerived[] = {
    {"axial_pitch_mm", always<axial_pitch>},
    {"contact_length_mm", always<[](auto& m) { return (m.contacts_per_roller - 1) * axial_pitch(m); }>},
    {"roller_spacing_mm",
     always<[](auto& m) { return 2.0 * *m.centre_distance * std::sin(std::numbers::pi / m.rollers); }>},
    {"turns_until_repeat", of<[](const Mechanism& m) { return turns_until_repeat(m, slip_ratio(m, Travel{})); }>},
};

std::vector<const Problem*> problems_of(const CheckResult& result) {
  std::vector<const Problem*> all;
  for (const CommandNeeds& command : result.commands)
    for (const Problem& problem : command.unmet)
      if (command.is_built && std::ranges::none_of(all, [&](const Problem* p) { return p->path == problem.path; }))
        all.push_back(&problem);
  return all;
}

std::vector<std::string> unmet_paths(const CommandNeeds& command, bool missing) {
  std::vector<std::string> paths;
  for (const Problem& problem : command.unmet)
    if (problem.is_missing() == missing) paths.push_back(problem.path);
  return paths;
}

/// A row per command; below, each thing to add or change once.
std::string readiness(const CheckResult& result) {
  std::string text = "Commands\n";
  for (const CommandNeeds& command : result.commands) {
    if (command.command == Command::check) continue;
    std::string what = command.is_built ? "ready" : "not built; scripts/install.sh builds all";
    if (command.is_built && !command.unmet.empty()) {
      const auto missing = unmet_paths(command, true), wrong = unmet_paths(command, false);
      what = missing.empty() ? "" : fmt::format("add {}", fmt::join(missing, ", "));
      if (!wrong.empty()) what += fmt::format("{} {}", what.empty() ? "change" : "; change", fmt::join(wrong, ", "));
    }
    if (!command.failure.empty()) what = "found an error, see below";
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

/// A reason stands below the first of the values that share it.
std::string input_list(const CheckResult& result) {
  std::string text = "\nInput\n";
  std::string_view told;
  for (const EchoEntry& f : result.fields) {
    const auto [basis, reason] = basis_of(f, result);
    text += fmt::format("  {:<42} {}   ({}{}{})\n", f.path, printable(f.value), basis, f.origin.empty() ? "" : " ",
                        f.origin);
    if (!reason.empty() && reason != told) text += wrapped(printable(reason), std::string(6, ' '), kTableWidth);
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
  const Json lengths = derived_of(contacts.mechanism);
  for (const auto& [key, value] : lengths.items()) line(key, value);
  const Json json = object_of(contacts);
  line("centre_distance_mm", json["centre_distance_mm"]);
  for (const char* key : {"pitch_diameter_mm", "helix_angle_deg"})
    for (const auto& [part, value] : json[key].items()) line(fmt::format("{}.{}", key, part), value);
  line("max_rollers", json["max_rollers"]);
  const Json threads = object_of(contacts.threads);
  for (const auto& [part, widths] : threads.items())
    for (const auto& [key, value] : widths.items()) line(fmt::format("threads.{}.{}", part, key), value);
  for (const char* interface : {"screw", "nut"})
    for (const char* key : {"normal_angle_deg", "backlash_mm", "flank_clearance_mm", "body_crest_clearance_mm",
                            "roller_crest_clearance_mm", "hertz_constant_N_per_mm1_5"})
      if (json.contains(interface) && json[interface].contains(key))
        line(fmt::format("contact.{}.{}", interface, key), json[interface][key]);
  return text;
}

constexpr Quantity<CommandNeeds> kNeeds[] = {
    {"ready",
     always<[](auto& command) { return command.is_built && command.unmet.empty() && command.failure.empty(); }>},
    {"not_built",
     filled<[](auto& command) { return std::string(command.is_built ? "" : "scripts/install.sh builds all"); }>,
     "how to get a command that this program leaves out"},
    {"missing", filled<[](auto& command) { return unmet_paths(command, true); }>, "what to add"},
    {"wrong", filled<[](auto& command) { return unmet_paths(command, false); }>, "what to change"},
    {"error", filled<[](auto& command) { return command.failure; }>, "that the command found in a complete input"},
    {"loads", of<&CommandNeeds::loads>, "static | running, of commands that have loads of threads"},
};

using Input = Within<CheckResult, EchoEntry>;

constexpr Quantity<Input> kInput[] = {
    {"path", always<its<&EchoEntry::path>>},
    {"value", always<its<&EchoEntry::value>>},
    {"default", always<its<&EchoEntry::is_default>>},
    {"written", filled<its<&EchoEntry::written>>, "as the file has it"},
    {"origin", filled<its<&EchoEntry::origin>>, "of a default that a name stands for"},
    {"basis", always<[](auto& i) { return basis_of(*i.item, *i.whole).first; }>,
     "given, assumed (as a comment of the file says) or default"},
    {"reason", filled<[](auto& i) { return basis_of(*i.item, *i.whole).second; }>, "why it was assumed"},
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
    {"derived",
     always_table<kDerived, [](auto& result) -> const Mechanism& { return result.geometry.contacts.mechanism; }>},
};

constexpr std::size_t kTitleWidth = 30;

/// A line for each criterion that has a value or a limit; the others in one.
std::string verdict_table(const CaseVerdict& verdict) {
  std::string text = "\nVerdict\n" + wrapped(summary(verdict), "  ", kTableWidth);
  for (const Criterion& c : verdict.criteria) {
    if (!c.value && !c.limit && c.name != "convergence" && c.name != "input") continue;
    const auto [unit, factor] = shown(c);
    const auto* const documents = std::ranges::find(kShownUnits, unit, &ShownUnit::text);
    const bool is_known = documents != std::end(kShownUnits);
    const auto number = [&, factor = factor](double value) {
      const double shown = value * factor * (is_known ? table_factor(*documents) : 1.0);
      return std::abs(shown) < 1e4 ? fmt::format("{:.4g}", shown) : fmt::format("{:.0f}", shown);
    };
    std::string limit;
    if (c.limit) limit = fmt::format("{} {} ({})", c.sense == Sense::least ? ">=" : "<=", number(*c.limit), origin(c));
    std::string where = printable(c.load_case);
    if (!c.reason.empty()) where += (where.empty() ? "" : ": ") + printable(c.reason);
    std::string line = padded("  " + std::string(c.title), kTitleWidth, true) +
                       padded(c.value ? number(*c.value) : "", 9, false) + ' ' +
                       padded(std::string(is_known ? table_unit(*documents).text : unit), 9, true) +
                       padded(limit, 33, true) + ' ' + padded(words(c), 13, true);
    // The place is below the line if it is too long for it.
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

/// Readiness by command and what to add, warnings, derived values.
std::string check_table(const CheckResult& result) { return head(result) + derived(result.geometry.contacts); }

/// The table with every value of the input: given, assumed or a default.
std::string full_check_table(const CheckResult& result) {
  return head(result) + input_list(result) + derived(result.geometry.contacts);
}

void put_check(Json& document, const CheckResult& result) {
  put_object(document, result);
  put_contacts(document, result.geometry.contacts);
}

/// Results of `solve` for the largest loads.
std::vector<LoadCaseResult> solved_largest(const CaseInput& in, double largest) {
  Case c = in.values;
  std::erase_if(c.load_cases, [&](const LoadCase& load) { return std::abs(load.axial_force) < largest; });
  c.heat.reset();  // The duty may name load cases that were removed.
  return analyze(c).load_cases;
}

bool has_life(const CaseInput& in) {
  return analysis_of(Command::life).is_built && input::unmet(in, Command::life).empty();
}

/// Effect of a start of the screw out of position, which perfect parts hide: on the largest load and on the life,
/// each for the sense that is worse for it; on the life of a spectrum alone. `whole`: life of perfect parts, if known.
std::optional<Warning> perfect_parts(const Source& source, const CaseInput& in, double largest,
                                     std::optional<double> whole) {
  constexpr double kOff = 3e-6;  ///< [m]
  const int starts = in.values.mechanism.starts.screw;
  const auto has_error = [&](Part part) {
    const PitchError& e = in.values.deviations.pitch_error[part];
    return e.linear != 0.0 || e.periodic || !e.list.empty() || !e.lists.empty();
  };
  if (starts == 1 || std::ranges::any_of(kParts, has_error)) return std::nullopt;
  const auto with_start = [&](double off) {
    CaseInput changed = in;
    std::vector<double>& list = changed.values.deviations.pitch_error.screw.list;
    for (int k = 0; k < in.values.mechanism.contacts_per_roller; ++k) list.push_back(k % starts == 0 ? off : 0.0);
    return changed;
  };
  const auto largest_load = [&](const CaseInput& at) {
    double most = 0.0;
    for (const LoadCaseResult& loaded : solved_largest(at, largest))
      if (loaded.threads)
        for (const Interface i : kInterfaces) most = std::max(most, std::ranges::max((*loaded.threads)[i].normal_load));
    return most;
  };
  const double perfect = largest_load(in), ahead = largest_load(with_start(kOff)),
               behind = largest_load(with_start(-kOff));
  if (!(std::max(ahead, behind) > perfect) || perfect == 0.0) return std::nullopt;
  std::string life;
  // A measured history or a duty would take this note most of the time of a check.
  if (whole && !in.values.life->history && !(in.values.heat && !in.values.heat->duty.empty())) {
    const auto life_with = [&](double off) { return life_of(source, with_start(off)).system_life; };
    const double left = std::min(life_with(kOff), life_with(-kOff));
    if (left > 0.0 && left < *whole)
      life = fmt::format(" and takes {:.0f} % of the life", 100.0 * (1.0 - left / *whole));
  }
  return Warning{"deviations.pitch_error", "perfect_parts",
                 fmt::format("parts are perfect: one start of the screw out of position by {{{:g} um}} "
                             "raises the largest load of a thread by {{value}}{}",
                             1e6 * kOff, life),
                 "state the errors of your grade"}
      .with(std::max(ahead, behind) / perfect - 1.0, {}, "%"_unit)
      .as_assumption();
}

/// Warnings on a load with equal shares, the least that the most loaded threads carry.
std::vector<Warning> equal_share_warnings(const LoadCase& load, const Contacts& contacts) {
  if (!contacts.interfaces.screw.has_hertz() || !contacts.interfaces.nut.has_hertz()) return {};
  LoadCaseResult loaded = equal_share_result(load, contacts);
  add_warnings(loaded, contacts);
  for (Warning& warning : loaded.warnings) warning.what += ", even with equal thread loads";
  return all_warnings({}, {std::move(loaded)});
}

/// Adds the warnings of `solve` about the largest loads and of `life` about those of its block if solving takes no more
/// than the share of one roller. `life`: result of that command; null: computed here.
void warn_of_loads(const Source& source, const CaseInput& in, const LifeResult* life, Result& geometry) {
  const Case& c = in.values;
  const auto force = [](const LoadCase& load) { return std::abs(load.axial_force); };
  const auto largest = std::ranges::max_element(c.load_cases, {}, force);
  const bool is_quick = c.model.side_by_side();
  std::vector<Warning> warnings;
  try {
    if (is_quick && input::unmet(in, Command::solve).empty()) {
      warnings = all_warnings({}, solved_largest(in, force(*largest)));
      std::optional<LifeResult> computed;
      if (has_life(in) && !life) life = &computed.emplace(life_of(source, in));
      if (life) append(warnings, life->warnings);
      if (std::optional<Warning> note =
              perfect_parts(source, in, force(*largest), life ? std::optional(life->system_life) : std::nullopt))
        warnings.push_back(std::move(*note));
    } else if (largest != c.load_cases.end())
      warnings = equal_share_warnings(*largest, geometry.contacts);
  } catch (const CaseError&) {  // The command that cannot run reports the reason.
  } catch (const input::InputError&) {
  }
  for (Warning& warning : warnings)
    if (!contains(geometry.warnings, warning)) geometry.warnings.push_back(std::move(warning));
}

/// Reads and checks the study, the optimization and the fit of the source too; without warnings.
CheckResult readiness_of(const Source& source, const CaseInput& in) {
  if (in.study) input::read_study_input(source);
  if (in.optimize) input::read_optimize_input(source);
  // A page has no curves.
  if (in.fits && !source.files && analysis_of(Command::fit).is_built) read_fit_input(source);
  const Case& c = in.values;
  CheckResult result{in.fields, input::assumptions(in.fields, source), {}, {}};
  for (const AnyAnalysis& analysis : analyses()) {
    CommandNeeds& needs = result.commands.emplace_back();
    const bool takes_bodies = analysis.command != Command::check && analysis.command != Command::contact;
    const bool is_built = analysis.is_built && !(takes_bodies && !left_out(c).empty());
    needs = {analysis.command, input::unmet(in, analysis.command), {}, is_built};
    if (const auto runs = needs.command.takes_running_loads; runs && needs.unmet.empty())
      needs.loads = runs(c) ? ModelOptions::Loads::running : ModelOptions::Loads::at_rest;
  }
  result.geometry.contacts = find_contacts(c.mechanism, c.materials);
  return result;
}

void add_case_warnings(const Source& source, const CaseInput& in, const LifeResult* life, Result& geometry) {
  const Case& c = in.values;
  geometry.warnings = geometry_warnings(c, geometry.contacts, c.load_cases);
  // Effects of unusual values are not reported twice.
  if (in.warnings.empty()) warn_of_loads(source, in, life, geometry);
  if (std::optional<Warning> note = unknown_film_ratio(c)) geometry.warnings.push_back(std::move(*note));
  for (Warning& note : void_input_warnings(c)) geometry.warnings.push_back(std::move(note));
}

CheckResult checked(const Source& source, const CaseInput& in) {
  CheckResult result = readiness_of(source, in);
  add_case_warnings(source, in, nullptr, result.geometry);
  return result;
}

/// Result of the check with the verdict, for which all commands with complete inputs are run. `measures` includes the
/// results of `solve`.
CheckResult checked_with_verdict(const Source& source, const CaseInput& in) {
  CheckResult result = readiness_of(source, in);
  std::vector<Attempt> attempts;
  std::vector<std::unique_ptr<const Delivery>> deliveries;
  const bool takes_long = in.values.model.bodies->meshes;
  const auto attempt = [&](Command command) {
    if (!input::unmet(in, command).empty()) return false;
    const std::string_view lacking = left_out(in.values);
    if (!lacking.empty()) {
      attempts.push_back({command, nullptr, modules::NotBuilt(std::string(lacking)).what(), Attempt::Lacking::program});
      return true;
    }
    if (takes_long) {
      attempts.push_back({command, nullptr,
                          fmt::format("`{}` takes long: see `prs report`", in.values.model.bodies->name),
                          Attempt::Lacking::time});
      return true;
    }
    try {
      deliveries.push_back(std::make_unique<const Delivery>(analysis_of(command).run(source, in)));
      attempts.push_back({command, deliveries.back().get()});
    } catch (const input::InputError& error) {
      attempts.push_back({command, nullptr, error.what()});
    } catch (const modules::NotBuilt& error) {
      attempts.push_back({command, nullptr, error.what(), Attempt::Lacking::program});
    } catch (const modules::Missing& error) {
      attempts.push_back({command, nullptr, error.what(), Attempt::Lacking::module});
    }
    return attempts.back().delivery != nullptr;
  };
  const bool has_references =
      std::ranges::any_of(in.fields, [](const EchoEntry& f) { return f.path.starts_with("references["); });
  const bool has_loads = attempt(Command::measures) && !takes_long;
  for (const AnyAnalysis& analysis : analyses()) {
    const Command command = analysis.command;
    const bool is_had = command == Command::measures || command == Command::contact ||
                        (command == Command::solve && has_loads) || (command == Command::compare && !has_references);
    if (analysis.is_judged && !is_had) attempt(command);
  }
  for (const Attempt& made : attempts)
    if (!made.delivery && made.lacking == Attempt::Lacking::input)
      std::ranges::find(result.commands, made.command, &CommandNeeds::command)->failure = made.failure;
  const LifeResult* life = nullptr;
  for (const auto& delivery : deliveries)
    if (const auto* found = delivery->result<LifeResult>()) life = found;
  add_case_warnings(source, in, life, result.geometry);
  result.verdict = verdict_by(in, attempts);
  return result;
}

}  // namespace

PRS_RECORD(CheckResult, "Check", "What a case is ready for, and what follows from it.", kCheck);

const Analysis<CheckResult>& check_analysis() {
  static const std::vector<Place> places = with_contacts({{"verdict", describe<CaseVerdict>, false}});
  static const Analysis<CheckResult> analysis{
      .command = Command::check,
      .help = "Validate a case: what it is ready for, its verdict, what is unusual, derived values",
      .file = "check.json",
      .run = checked_with_verdict,
      .places = places,
      .put = put_check,
      .table = check_table,
      .full_table = full_check_table,
      .pictures =
          [](const CheckResult& r, const Case&) {
            Pictures pictures = contact_pictures(r.geometry);
            for (Picture& picture : pictures) picture.drawn = Picture::Drawn::by_name;
            return pictures;
          },
      .wrong_input = [](const CheckResult& r) { return r.verdict ? r.verdict->impossible : std::string(); },
      .warnings = [](auto& r) -> decltype(auto) { return (r.geometry.warnings); }};
  return analysis;
}

std::pair<std::string_view, std::string_view> basis_of(const EchoEntry& f, const CheckResult& result) {
  if (f.is_default) return {"default", {}};
  const auto found = result.assumed.find(f.path);
  if (found == result.assumed.end()) return {"given", {}};
  return {"assumed", found->second};
}

Json derived_of(const Mechanism& mechanism) {
  Json derived;
  put_quantities<Mechanism>(derived, kDerived, mechanism);
  return derived;
}

Delivery run_check(const Source& source, const CaseInput& in) {
  return delivered(source, in, check_analysis(), checked);
}

}  // namespace prs
