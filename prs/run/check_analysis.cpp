#include "prs/run/check_analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "modules/module.h"
#include "prs/input/assumptions.h"
#include "prs/input/optimize_reader.h"
#include "prs/input/study_reader.h"
#include "prs/losses/life_analysis.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_case_result.h"
#include "prs/loads/load_json.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/warnings.h"
#include "prs/measures/analyze_measures.h"
#include "prs/model/case_error.h"
#include "prs/model/void_inputs.h"
#include "prs/run/commands.h"
#include "prs/slip/slip.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

/// What `solve` finds unusual about the largest loads, and `life` about those of its block.
std::vector<Warning> solved_load_warnings(const input::Source& source, const input::CaseInput& in,
                                          double largest) {
  Case c = in.values;
  std::erase_if(c.load_cases,
                [&](const LoadCase& load) { return std::abs(load.axial_force) < largest; });
  std::vector<Warning> warnings = all_warnings({}, analyze(c).load_cases);
  if (input::unmet(in, Command::life).empty())
    std::ranges::move(life_of(source, in).warnings, std::back_inserter(warnings));
  return warnings;
}

/// With equal shares, the least that its most loaded threads carry.
std::vector<Warning> equal_share_warnings(const LoadCase& load, const Contacts& contacts) {
  if (!contacts.interfaces.screw.has_hertz() || !contacts.interfaces.nut.has_hertz()) return {};
  LoadCaseResult loaded = equal_share_result(load, contacts);
  add_warnings(loaded, contacts);
  for (Warning& warning : loaded.warnings) warning.what += ", even with equal shares";
  return all_warnings({}, {std::move(loaded)});
}

/// Where solving takes no more than the share of one roller, those of `solve` and `life`.
void warn_of_loads(const input::Source& source, const input::CaseInput& in, Result& geometry) {
  const Case& c = in.values;
  const auto force = [](const LoadCase& load) { return std::abs(load.axial_force); };
  const auto largest = std::ranges::max_element(c.load_cases, {}, force);
  const bool is_quick = c.model.mechanism == ModelOptions::Mechanism::sector &&
                        c.model.bodies != ModelOptions::Bodies::influence;
  std::vector<Warning> warnings;
  try {
    if (is_quick && input::unmet(in, Command::solve).empty())
      warnings = solved_load_warnings(source, in, force(*largest));
    else if (largest != c.load_cases.end())
      warnings = equal_share_warnings(*largest, geometry.contacts);
  } catch (const CaseError&) {  // The command that cannot run says why.
  } catch (const input::InputError&) {
  }
  for (Warning& warning : warnings)
    if (std::ranges::find(geometry.warnings, warning) == geometry.warnings.end())
      geometry.warnings.push_back(std::move(warning));
}

/// The loads of threads that a command takes.
std::optional<ModelOptions::Loads> loads_of(const Case& c, Command command) {
  const auto any = [&](bool (*runs)(const ModelOptions&, LoadCase::Share)) {
    return std::ranges::any_of(c.load_cases,
                               [&](const LoadCase& load) { return runs(c.model, load.share); });
  };
  bool running = false;
  if (command == Command::solve)
    running = any(solve_takes_running_loads);
  else if (command == Command::slip)
    running = any(slip_takes_running_loads);
  else if (command == Command::life)
    running = c.life && life_takes_running_loads(c);
  else if (command != Command::contact && command != Command::compare &&
           command != Command::preload && command != Command::measures)
    return std::nullopt;
  return running ? ModelOptions::Loads::running : ModelOptions::Loads::at_rest;
}

/// Reads and checks the study and the optimization of the source too.
CheckResult checked(const input::Source& source, const input::CaseInput& in) {
  if (in.study) input::read_study_input(source);
  if (in.optimize) input::read_optimize_input(source);
  const Case& c = in.values;
  CheckResult result{in.fields, input::assumptions(in.fields, source), {}, {}};
  for (const AnyAnalysis& analysis : analyses())
    result.commands.push_back(
        {analysis.command, input::unmet(in, analysis.command), loads_of(c, analysis.command)});
  Result& geometry = result.geometry;
  geometry.contacts = find_contacts(c.mechanism, c.materials);
  geometry.warnings = geometry_warnings(c, geometry.contacts, c.load_cases);
  // What odd values bring about is not told again.
  if (in.warnings.empty()) warn_of_loads(source, in, geometry);
  if (std::optional<Warning> note = unknown_film_ratio(c))
    geometry.warnings.push_back(std::move(*note));
  for (Warning& note : void_input_warnings(c)) geometry.warnings.push_back(std::move(note));
  return result;
}

/// The same with the verdict, for which it runs what the case is ready for. `measures` has what
/// `solve` gives.
CheckResult checked_with_verdict(const input::Source& source, const input::CaseInput& in) {
  CheckResult result = checked(source, in);
  std::vector<Attempt> attempts;
  std::vector<std::unique_ptr<const Delivery>> deliveries;
  const bool takes_long = in.values.model.bodies == ModelOptions::Bodies::influence;
  const auto attempt = [&](Command command) {
    if (!input::unmet(in, command).empty()) return false;
    if (takes_long) {
      attempts.push_back({command, nullptr, "`influence` takes long: see `prs report`"});
      return true;
    }
    try {
      deliveries.push_back(std::make_unique<const Delivery>(analysis_of(command).run(source, in)));
      attempts.push_back({command, deliveries.back().get()});
    } catch (const input::InputError& error) {
      attempts.push_back({command, nullptr, error.what()});
    } catch (const modules::Missing& error) {
      attempts.push_back({command, nullptr, error.what()});
    }
    return attempts.back().delivery != nullptr;
  };
  if (!attempt(Command::measures) || takes_long) attempt(Command::solve);
  for (const Command command : {Command::slip, Command::life}) attempt(command);
  result.verdict = verdict_by(in, attempts);
  return result;
}

void put_facts(const Delivery& delivery, Command command, VerdictFacts& facts) {
  if (const auto* result = delivery.result<Result>()) {
    facts.contacts = &result->contacts;
    // Equal shares, where nothing is solved.
    if (command == Command::slip)
      facts.slip = result;
    else if (command == Command::solve || (!facts.loads && !result->load_cases.empty()))
      facts.loads = result;
  } else if (const auto* measures = delivery.result<MeasuresResult>()) {
    facts.measures = measures;
    facts.loads = &measures->analysis;
    facts.contacts = &measures->analysis.contacts;
  } else if (const auto* life = delivery.result<LifeResult>()) {
    facts.life = life;
  } else if (const auto* check = delivery.result<CheckResult>()) {
    facts.contacts = &check->geometry.contacts;
  }
}

}  // namespace

const Analysis<CheckResult>& check_analysis() {
  static const std::vector<Place> places =
      with_contacts({{"verdict", describe<CaseVerdict>, false}});
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
      .warnings = [](auto& r) -> decltype(auto) { return (r.geometry.warnings); }};
  return analysis;
}

Delivery run_check(const input::Source& source, const input::CaseInput& in) {
  return delivered(source, in, check_analysis(), checked);
}

CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts) {
  VerdictFacts facts{in.values, in.limits.value_or(Limits{})};
  const Contacts contacts = find_contacts(in.values.mechanism, in.values.materials);
  facts.contacts = &contacts;
  for (const Command command : {Command::solve, Command::slip, Command::life, Command::measures})
    if (const std::vector<std::string> paths = input::missing(in, command); !paths.empty())
      facts.lacking[command] = fmt::format("add {}", fmt::join(paths, ", "));
  for (const Attempt& attempt : attempts)
    if (!attempt.delivery)
      facts.lacking[attempt.command] = attempt.failure;
    else
      put_facts(*attempt.delivery, attempt.command, facts);
  return verdict_of(facts);
}

}  // namespace prs
