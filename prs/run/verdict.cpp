#include "prs/run/verdict.h"

#include <fmt/ranges.h>

#include "prs/life/analyze_life.h"
#include "prs/losses/slip_criteria.h"
#include "prs/measures/measures_criteria.h"
#include "prs/model/check_case.h"
#include "prs/run/analyses.h"
#include "prs/run/joint_criteria.h"

namespace prs {
namespace {

bool meets(double value, double limit, Sense sense) {
  const double rounding = kLimitRounding * std::abs(limit);
  return sense == Sense::least ? value >= limit - rounding : value <= limit + rounding;
}

void hold_against_limit(Criterion& c, const CriterionRow& row, const std::optional<double>& physical) {
  const double value = *c.value;
  const auto set = [&](double limit, LimitSource source, Standing standing) {
    c.limit = limit;
    c.source = source;
    c.standing = standing;
  };
  if (c.limit)
    set(*c.limit, LimitSource::stated, meets(value, *c.limit, c.sense) ? Standing::green : Standing::red);
  else if (physical && !meets(value, *physical, c.sense))
    set(*physical, LimitSource::physics, Standing::red);
  else if (row.recommended)
    set(*row.recommended, LimitSource::recommended,
        meets(value, *row.recommended, c.sense) ? Standing::green : Standing::amber);
  else if (physical)
    set(*physical, LimitSource::physics, Standing::green);
}

/// The limit that the case states, in the unit of the row.
std::optional<double> stated(const CriterionRow& row, const Limits& l) {
  if (row.limit) return l.*row.limit ? std::optional(*(l.*row.limit) * row.factor - row.zero) : std::nullopt;
  if (!row.name.ends_with("life") || !l.life) return {};
  return l.life->travel ? *l.life->travel * "km"_per_si : *l.life->duration / 3600.0;
}

Criterion judged(const FoundCriterion& found, const Limits& limits) {
  const CriterionRow& row = *found.row;
  Criterion c{row.name, found.title.empty() ? row.title : found.title, found.unit.empty() ? row.unit : found.unit,
              row.sense, found.value};
  c.limit = found.limit ? found.limit : stated(row, limits);
  if (row.name.ends_with("life") && limits.life && limits.life->travel) c.unit = "km";
  if (found.best && found.value && std::abs(*found.best - *found.value) > kLimitRounding * std::abs(*found.value))
    c.best = found.best;
  if (found.standing) {
    c.standing = *found.standing;
    c.source = row.source;
    c.load_case = found.where;
    c.reason = found.note.empty() ? found.why : std::string(row.before) + found.note;
  } else if (c.value) {
    c.load_case = found.where;
    c.reason = found.note;
    hold_against_limit(c, row, found.physical ? found.physical : row.physical);
    if (found.is_partial && c.standing == Standing::green) c.standing = Standing::not_computed;
  } else {
    if (c.limit) c.source = LimitSource::stated;
    c.reason = found.why;
    c.standing = found.applies ? Standing::not_computed : Standing::not_applicable;
  }
  return c;
}

/// Findings of commands, and why others have none: what to add, or what is wrong in the input. Criteria of a command
/// that is in neither are left out.
struct Evidence {
  std::vector<std::pair<Command, FoundCriterion>> found = {};
  std::map<Command, std::string> lacking = {};
  bool lacks_life = false;          ///< Whether the case has loads of a life that is not known.
  bool lacks_history = false;       ///< Whether these are a history, whose forces are then not known.
  bool lacks_temperatures = false;  ///< Whether parts warm up to temperatures that are not known.

  void add(Command command, const std::vector<FoundCriterion>& more) {
    for (const FoundCriterion& of : more) found.emplace_back(command, of);
  }
  const std::string* why_not(Command command) const {
    const auto why = lacking.find(command);
    return why == lacking.end() ? nullptr : &why->second;
  }

  /// All that was found of a criterion; nothing where there is a value of `preload` alone.
  std::optional<FoundCriterion> sum(const CriterionRow& row) const {
    std::optional<FoundCriterion> sum;
    bool is_known = false;
    for (const auto& [command, part] : found) {
      if (part.row != &row) continue;
      is_known = is_known || command != Command::preload;
      if (sum)
        sum->add(part);
      else
        sum = part;
    }
    if (!is_known) return std::nullopt;
    if (sum->why.empty()) sum->why = row.why;
    if (const std::string* const why = row.of_preload ? why_not(Command::preload) : nullptr)
      return FoundCriterion(row, *why);
    if (row.of_drive && sum->value && lacking.contains(Command::response))
      sum->note += sum->note.empty() ? "without `response`" : ", without `response`";
    const bool may_be_worse = lacks_life && (row.of_life || (row.of_history && lacks_history));
    for (const auto& [lacks, words] :
         {std::pair(may_be_worse, ", without `life`"),
          std::pair(row.of_life && lacks_temperatures, ", without the temperatures of operation")})
      if (lacks && sum->value) {
        sum->note += words + (sum->note.empty() ? 2 : 0);
        sum->is_partial = true;
      }
    return sum;
  }
  FoundCriterion sum(CriterionKey key) const { return *sum(*key.row); }
};

void add(const CriterionRow& row, const Evidence& evidence, const Limits& limits, CaseVerdict& verdict) {
  std::optional<FoundCriterion> found = evidence.sum(row);
  if (!found && row.needed.word.empty()) return;
  if (!found) {
    const std::string* const why = evidence.why_not(row.needed);
    verdict.is_complete = verdict.is_complete && why;
    if (!why) return;
    found = FoundCriterion(row, *why);
  }
  Criterion c = judged(*found, limits);
  if (c.limit || row.is_plain) verdict.criteria.push_back(std::move(c));
}

/// The attempt of a command that has a result; null without one.
const Attempt* done(std::span<const Attempt> attempts, Command command) {
  for (const Attempt& attempt : attempts)
    if (attempt.command == command && attempt.delivery) return &attempt;
  return nullptr;
}

/// The attempt whose loads at rest count: `measures` has those of `solve`; those of `contact` are equal shares, where
/// nothing is solved.
const Attempt* at_rest_of(std::span<const Attempt> attempts) {
  for (const Command command : {Command::measures, Command::solve})
    if (const Attempt* const found = done(attempts, command)) return found;
  const Attempt* const equal = done(attempts, Command::contact);
  return equal && !equal->delivery->result<Result>()->load_cases.empty() ? equal : nullptr;
}

void add_impossible(Evidence& evidence, const CaseVerdict& verdict) {
  FoundCriterion input("input");
  input.standing = Standing::red;
  input.note = verdict.impossible;
  evidence.add(Command::check, {input});
}

/// Adds why commands have no result, and errors that they found in the input. A case without any thread loads is
/// impossible.
void add_lacking(const input::CaseInput& in, std::span<const Attempt> attempts, Evidence& evidence,
                 CaseVerdict& verdict) {
  for (const Command command : {Command::solve, Command::slip, Command::life, Command::measures})
    if (const std::vector<std::string> paths = input::missing(in, command); !paths.empty())
      evidence.lacking[command] = fmt::format("add {}", fmt::join(paths, ", "));
  if (const std::string_view what = left_out(in.values); !what.empty()) verdict.not_built.emplace_back(what);
  std::map<Command, std::string> wrong;
  for (const Attempt& attempt : attempts) {
    if (attempt.lacking == Attempt::Lacking::program && left_out(in.values).empty())
      verdict.not_built.emplace_back(name(attempt.command));
    if (attempt.lacking == Attempt::Lacking::time) verdict.skipped.emplace_back(name(attempt.command));
    if (attempt.delivery) continue;
    evidence.lacking[attempt.command] = attempt.failure;
    if (attempt.lacking == Attempt::Lacking::input) wrong[attempt.command] = attempt.failure;
  }
  for (const auto& [command, what] : wrong) {
    if (command != Command::solve && command != Command::measures) {
      verdict.failed.emplace_back(name(command));
      continue;
    }
    verdict.impossible = what;
    evidence.lacking[command] = fmt::format("`{}` found an error", name(command));
  }
  if (!verdict.impossible.empty()) add_impossible(evidence, verdict);
}

/// Adds that nothing is known of the tolerances of references where `compare` has no result.
void add_unseen_references(const input::CaseInput& in, Evidence& evidence) {
  const std::string* const why = evidence.why_not(Command::compare);
  const auto is_tolerance = [](const input::EchoEntry& f) {
    return f.path.starts_with("references[") && f.path.ends_with(".tolerance");
  };
  if (!why || std::ranges::none_of(in.fields, is_tolerance)) return;
  FoundCriterion found("references", *why);
  found.limit = 1.0;
  evidence.add(Command::compare, {found});
}

/// Loads under preload; where they cannot be had, `evidence` says why.
std::optional<PreloadedLoads> preloaded_of(const input::CaseInput& in, const Contacts& contacts, const Result* slip,
                                           Evidence& evidence, CaseVerdict& verdict) {
  if (!in.values.preload || !input::unmet(in, Command::preload).empty()) return std::nullopt;
  if (!analysis_of(Command::preload).is_built) {
    verdict.not_built.emplace_back(name(Command::preload));
    return std::nullopt;
  }
  try {
    return loads_under_preload(in.values, contacts, slip);
  } catch (const CaseError& error) {
    evidence.lacking[Command::preload] = error.what();
    return std::nullopt;
  }
}

/// Measures without the load cases that have no force, where these alone keep `measures` from being tried.
std::optional<MeasuresResult> measures_where_none_was_tried(const Case& c, std::span<const Attempt> attempts,
                                                            Evidence& evidence, CaseVerdict& verdict) {
  const auto is_at_rest = [](const Attempt& a) {
    return a.command == Command::measures || a.command == Command::solve;
  };
  if (std::ranges::any_of(attempts, is_at_rest) || c.model.bodies->meshes || !left_out(c).empty()) return std::nullopt;
  try {
    return measures_under_load(c);
  } catch (const CaseError& error) {
    verdict.impossible = error.problem().text();
    add_impossible(evidence, verdict);
    return std::nullopt;
  }
}

/// Adds values of the input that hardly any screw has; warnings say what is usual.
void add_unusual(const input::CaseInput& in, Evidence& evidence) {
  std::vector<std::string> paths;
  for (const Warning& warning : in.warnings)
    if (warning.code == "unusual_value") paths.push_back(warning.path);
  if (const auto& life = in.values.life;
      life && life->dynamic_capacity > life->static_capacity && life->static_capacity)
    paths.emplace_back("life.static_capacity, which is below the dynamic one");
  if (paths.empty()) return;
  FoundCriterion input("input");
  input.standing = Standing::amber;
  input.note = fmt::format("unusual: {}", fmt::join(paths, ", "));
  evidence.add(Command::check, {input});
}

/// Whether the case has loads of a life that was not computed or did not converge.
bool lacks_life(const Case& c, std::span<const Attempt> attempts, const Evidence& evidence) {
  if (!c.life || (c.life->spectrum.empty() && !c.life->history)) return false;
  const Attempt* const life = done(attempts, Command::life);
  return life ? !life->delivery->result<LifeResult>()->converged() : evidence.why_not(Command::life) != nullptr;
}

/// Adds static safeties under forces of which no analysis has thread loads: of the drive, and of a spectrum or a
/// history whose life is not known.
void add_under_forces(const JudgedCase& of, const Contacts& contacts, const Result* slip, Evidence& evidence) {
  const Case& c = of.c;
  constexpr CriterionKey kTension("largest_tension"), kCompression("largest_compression");
  std::vector<std::pair<Direction, FoundCriterion>> forces;
  for (const auto& [command, found] : evidence.found)
    for (const Direction d : kDirections)
      if ((command == Command::response || (command == Command::life && evidence.lacks_life)) && found.value &&
          found.row == (d == Direction::tension ? kTension : kCompression).row)
        forces.emplace_back(d, found);
  if (evidence.lacks_life)
    for (const Direction d : kDirections) {
      FoundCriterion largest("largest_tension");
      for (const SpectrumLoad& load : c.life->spectrum)
        if (load.direction == d && load.force > 0.0) largest.take(load.force, "life.spectrum");
      if (largest.value) forces.emplace_back(d, largest);
    }
  std::optional<PerPart<double>> hottest;
  for (std::size_t k = 0; of.is_warm && k < c.load_cases.size(); ++k)
    if (const auto t = temperature_of(*slip, c, k); t && (!hottest || t->roller > hottest->roller)) hottest = t;
  const bool solves = analysis_of(Command::life).is_built && !c.model.bodies->meshes && left_out(c).empty();
  for (const auto& [direction, force] : forces)
    evidence.add(Command::check, criteria_under(of, contacts, hottest, solves, direction, force));
}

/// Adds what each analysis found; at rest at the temperatures of the losses, and under preload.
void add_found(const input::CaseInput& in, std::span<const Attempt> attempts, Evidence& evidence,
               CaseVerdict& verdict) {
  const Case& c = in.values;
  const Attempt* const slipped = done(attempts, Command::slip);
  const Result* const slip = slipped ? slipped->delivery->result<Result>() : nullptr;
  const Attempt* const at_rest = at_rest_of(attempts);
  const MeasuresResult* measures = at_rest ? at_rest->delivery->result<MeasuresResult>() : nullptr;
  const std::optional<MeasuresResult> under_load =
      at_rest ? std::nullopt : measures_where_none_was_tried(c, attempts, evidence, verdict);
  if (under_load) measures = &*under_load;
  const std::optional<MeasuresResult> warm = measures ? warm_measures(c, *measures, slip) : std::nullopt;
  if (warm) measures = &*warm;

  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  evidence.add(Command::check, case_criteria(c, contacts));
  evidence.lacks_life = lacks_life(c, attempts, evidence);
  evidence.lacks_history = c.life && c.life->history && !done(attempts, Command::life);
  evidence.lacks_temperatures =
      (measures || at_rest) && warms(c.heat) && !warm && (slip || evidence.why_not(Command::slip));
  JudgedCase of{.c = c, .limits = in.limits.value_or(Limits{}), .is_warm = warm.has_value()};
  std::optional<PreloadedLoads> preloaded;
  if (at_rest || under_load) {
    const Result& loads = measures ? measures->analysis : *at_rest->delivery->result<Result>();
    preloaded = preloaded_of(in, loads.contacts, slip, evidence, verdict);
    if (preloaded)
      for (const LoadCaseResult& r : preloaded->loads.load_cases) of.preloaded.insert(r.load_case.name);
    if (warm || under_load)
      evidence.add(Command::measures, measures_criteria(*measures, of));
    else
      evidence.add(at_rest->command, at_rest->delivery->criteria(of));
  }
  if (const std::string* const why = c.preload ? evidence.why_not(Command::preload) : nullptr)
    evidence.add(Command::solve, {convergence(fmt::format("preload ({})", *why))});
  if (preloaded) evidence.add(Command::preload, preloaded_criteria(*preloaded, of, measures));
  for (const Attempt& attempt : attempts)
    if (attempt.delivery && attempt.delivery->criteria && !attempt.delivery->result<MeasuresResult>() &&
        attempt.command != Command::solve && attempt.command != Command::contact)
      evidence.add(attempt.command, attempt.delivery->criteria(of));

  add_under_forces(of, contacts, slip, evidence);
  if (measures)
    evidence.add(Command::measures, {buckling_safety(c, *measures, evidence.sum("largest_compression"),
                                                     evidence.lacking.contains(Command::response) ||
                                                         (evidence.lacks_life && evidence.lacks_history)),
                                     critical_speed_share(c, *measures, evidence.sum("largest_speed"))});
  evidence.add(Command::check, {speed_times_diameter(c, evidence.sum("largest_speed"))});
  if (in.motor)
    evidence.add(Command::check,
                 motor_criteria(c, *in.motor, slip, measures ? measures->measures.equivalent_inertia : std::nullopt,
                                evidence.why_not(Command::slip)));
}

/// `static safety, peak pressure` of those that `of` holds for.
std::string titles(const CaseVerdict& verdict, auto of, auto words, std::string_view between) {
  std::vector<std::string> found;
  for (const Criterion& c : verdict.criteria)
    if (of(c)) {
      std::string title(c.title);
      title.front() = static_cast<char>(title.front() | 0x20);
      found.push_back(title + words(c));
    }
  return fmt::format("{}", fmt::join(found, between));
}
std::string titles(const CaseVerdict& verdict, auto of) {
  return titles(
      verdict, of, [](const Criterion&) { return ""; }, ", ");
}

bool is_unknown(const Criterion& c) { return c.standing == Standing::not_computed && c.limit; }

}  // namespace

Standing CaseVerdict::standing() const {
  const auto any = [&](auto of) { return std::ranges::any_of(criteria, of); };
  const auto has = [&](Standing s) { return any([&](const Criterion& c) { return c.standing == s; }); };
  if (has(Standing::red)) return Standing::red;
  if (has(Standing::amber) || any(is_unknown) || !not_built.empty() || !skipped.empty() || !failed.empty())
    return Standing::amber;
  return has(Standing::green) ? Standing::green : Standing::no_limit;
}

CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts) {
  CaseVerdict verdict;
  Evidence evidence;
  add_lacking(in, attempts, evidence, verdict);
  add_unusual(in, evidence);
  add_found(in, attempts, evidence, verdict);
  add_unseen_references(in, evidence);
  for (const CriterionRow& row : kCriteria)
    if (!row.title.empty()) add(row, evidence, in.limits.value_or(Limits{}), verdict);
  return verdict;
}

std::string words(const Criterion& c) {
  const Standing standing = c.standing;
  if (standing == Standing::green) return "met";
  if (standing == Standing::amber && !c.value) return "unusual";
  if (standing == Standing::amber) return c.sense == Sense::least ? "below recommended" : "above recommended";
  if (standing == Standing::red) return "not met";
  std::string text(name(standing));
  std::ranges::replace(text, '_', ' ');
  return text;
}

ShownCriterion shown(const Criterion& c) {
  if (c.name == "efficiency" || c.name == "critical_speed_share") return {"%", "%"_per_si};
  if (c.unit == "MPa") return {"GPa", 1e-3};
  return {c.unit == "N/um" ? "N/µm" : c.unit == "degC" ? "°C" : c.unit};
}

std::string summary(const CaseVerdict& verdict) {
  const auto of = [&](Standing s) { return titles(verdict, [&](const Criterion& c) { return c.standing == s; }); };
  std::string text;
  const auto tell = [&](std::string_view words, const std::string& what) {
    if (!what.empty()) text += fmt::format("{}{}: {}.", text.empty() ? "" : " ", words, what);
  };
  tell("Not met", of(Standing::red));
  tell("Not as recommended", of(Standing::amber));
  tell("Not computed, so not met", titles(verdict, is_unknown));
  tell("Not assessed because of an error in the input", fmt::format("{}", fmt::join(verdict.failed, ", ")));
  tell("Not judged, because not built", fmt::format("{}", fmt::join(verdict.not_built, ", ")));
  tell("Not judged, because these take long and `prs report` runs them",
       fmt::format("{}", fmt::join(verdict.skipped, ", ")));
  if (!verdict.is_complete)
    text += text.empty() ? "Other criteria follow." : " Other criteria follow.";
  else if (text.empty())
    text = verdict.standing() == Standing::green ? "All limits that could be checked are met."
                                                 : "Nothing to hold against a limit.";
  return text;
}

std::string not_computed(const CaseVerdict& verdict) {
  const auto has_neither = [](const Criterion& c) {
    return !c.limit && (c.standing == Standing::not_computed || c.standing == Standing::not_applicable);
  };
  return titles(
      verdict, has_neither, [](const Criterion& c) { return fmt::format(" ({})", c.reason); }, "; ");
}

std::string origin(const Criterion& c) {
  if (c.source == LimitSource::stated &&
      (c.name.starts_with("motor_") || c.name == "brake" || c.name == "back_driving"))
    return "motor";
  if (c.name == "references") return "references[].tolerance";
  if (c.source == LimitSource::stated)
    return fmt::format("limits.{}", c.name.substr(c.name.starts_with("bearing_") ? 8 : 0));
  return c.source == LimitSource::physics ? "physical limit" : "recommended";
}

namespace {

template <std::string Criterion::*text>
constexpr auto text_of =
    of<[](const Criterion& c) { return (c.*text).empty() ? std::nullopt : std::optional(c.*text); }>;

constexpr Quantity<Criterion> kCriterion[] = {
    {"name", of<&Criterion::name>, "key in `limits`, where it has one"},
    {"title", of<&Criterion::title>, "in words"},
    {"unit", of<&Criterion::unit>, "of value and limit; empty for ratios and fractions"},
    {"sense", of<&Criterion::sense>, "least | greatest: which the limit is"},
    {"value", of<&Criterion::value>, "the worst of all load cases, with the real thread loads"},
    {"best", of<&Criterion::best>, "the best value of all load cases and places"},
    {"limit", of<&Criterion::limit>, "that it is held against"},
    {"limit_source", of<&Criterion::source>,
     "case | physics | recommended: `limits` of the case, what physics allows, or what is usual"},
    {"state", of<&Criterion::standing>, "green | amber | red | no_limit | not_computed | not_applicable"},
    {"load_case", text_of<&Criterion::load_case>, "where the worst value stands"},
    {"reason", text_of<&Criterion::reason>, "what limits it, or why there is no value"},
};

constexpr Quantity<CaseVerdict> kVerdict[] = {
    {"state", of<&CaseVerdict::standing>, "the worst: green | amber | red | no_limit"},
    {"criteria", of<&CaseVerdict::criteria>, "each with its worst value"},
    {"not_built", filled<[](const CaseVerdict& v) { return v.not_built; }>,
     "commands that the case is ready for and this program leaves out; scripts/install.sh builds all"},
    {"skipped", filled<[](const CaseVerdict& v) { return v.skipped; }>,
     "commands that the case is ready for and that were not run, as they take long; `prs report` runs them"},
    {"failed", filled<[](const CaseVerdict& v) { return v.failed; }>,
     "commands that the case is ready for and that found something wrong with it"},
};

}  // namespace

PRS_RECORD(CaseVerdict, "Verdict", "Whether the case meets its limits.", kVerdict);
PRS_RECORD(Criterion, "Criterion", "A value, the limit that it is held against, and how it stands to it.", kCriterion);

}  // namespace prs
