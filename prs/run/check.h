#pragma once

#include "modules/response/response.h"
#include "prs/compare/compare_models.h"
#include "prs/life/analyze_life.h"
#include "prs/measures/measures.h"
#include "prs/model/motor_duty.h"
#include "prs/record/analysis.h"

/// Whether a case meets its limits: the one definition that `prs check`, the report and the page
/// read. Each criterion has the worst value of all load cases, with the real thread loads.
///
/// Where the case states a limit (`limits`), the criterion is green if the limit is met and red if
/// it is missed. Where it states none, the criterion is red if physics does not allow the value,
/// amber if the value falls short of the recommended one, and green otherwise. A criterion without
/// any of these limits is a plain number. A value that cannot be computed never meets a limit.

namespace prs {

/// Recommended where the case states nothing: makers ask for a static safety of 1 to 3, catalogues
/// allow half of the buckling load and 80 % of the critical speed.
inline constexpr double kRecommendedStaticSafety = 1.5;
inline constexpr double kRecommendedBucklingSafety = 2.0;
inline constexpr double kRecommendedCriticalSpeedShare = 0.8;
inline constexpr int kRecommendedContacts = 8;            ///< Contacts of a roller; catalogues have 20 and more.
inline constexpr double kRecommendedTemperature = 120.0;  ///< Grease and seals do not last above [degC].

enum class Sense { least, greatest };
std::string_view name(Sense sense);

enum class LimitSource { stated, physics, recommended };
std::string_view name(LimitSource source);  ///< As documents have it: `case` for stated.

enum class Standing { green, amber, red, no_limit, not_computed, not_applicable };
std::string_view name(Standing standing);

struct Criterion {
  std::string_view name;   ///< Its key in `limits`, where it has one.
  std::string_view title;  ///< `Static safety`
  std::string_view unit;   ///< Unit of value and limit; empty for ratios and fractions.
  Sense sense = Sense::least;
  std::optional<double> value;  ///< The worst.
  std::optional<double> best;   ///< Best of all load cases, if there are several.
  std::optional<double> limit;
  std::optional<LimitSource> source;
  Standing standing = Standing::no_limit;
  std::string load_case;  ///< Load case with the worst value.
  std::string reason;     ///< What limits it, or why there is no value.
};

struct CaseVerdict {
  std::vector<Criterion> criteria = {};
  bool is_complete = true;  ///< All commands were asked that the case is ready for.
  /// Commands that the case is ready for and the program leaves out (PRS_FULL).
  std::vector<std::string> not_built = {};
  /// Commands that the case is ready for and that found something wrong with it.
  std::vector<std::string> failed = {};
  /// Why no screw can be like this, as `solve` and `measures` say it; empty of a possible one.
  std::string impossible = {};

  /// The worst: red, amber, green; red of an impossible screw, amber where a stated limit has no value, or a command
  /// failed or is not built. `no_limit` where nothing is held against a limit.
  Standing standing() const;
};

/// What a case states and what its commands found.
struct VerdictFacts {
  const Case& c;
  Limits limits = {};
  const Contacts* contacts = nullptr;
  const Result* loads = nullptr;
  const Result* slip = nullptr;
  const Result* films = nullptr;  ///< Slip at the mean temperatures of a duty.
  /// Load cases at rest under preload, which `loads` lack, and the static limits of each.
  const Result* preloaded = nullptr;
  std::vector<StaticForces> preloaded_forces = {};
  const LifeResult* life = nullptr;
  const MeasuresResult* measures = nullptr;
  const ResponseResult* response = nullptr;
  const ModelComparison* comparison = nullptr;  ///< Models against references.
  /// Why commands were not run: what to add, or what they found wrong. One that is neither here nor
  /// above was not asked; what it would have given is left out.
  std::map<Command, std::string> lacking = {};
  std::map<Command, std::string> wrong = {};  ///< What commands found wrong with the case.
  std::vector<std::string> not_built = {};    ///< See CaseVerdict.
  std::optional<MotorDuty> motor = {};
};

CaseVerdict verdict_of(const VerdictFacts& facts);

std::string words(const Criterion& c);  ///< Its standing: `met`, `below recommended`, `not computed`

/// How tables and pages show value and limit: shown = value * factor.
struct ShownCriterion {
  std::string_view unit;
  double factor = 1.0;
};
ShownCriterion shown(const Criterion& criterion);

/// What the verdict comes to: `Not met: static safety, peak pressure. ..`.
std::string summary(const CaseVerdict& verdict);
/// Criteria without a value or without anything to apply to: `temperature (add heat), ..`.
std::string not_computed(const CaseVerdict& verdict);
/// `limits.static_safety`, `physical limit`, `recommended`.
std::string origin(const Criterion& criterion);

Record<CaseVerdict> record_of(Type<CaseVerdict>);
Record<Criterion> record_of(Type<Criterion>);

/// What a case must get before a command runs; nothing where it does.
struct CommandNeeds {
  Command command = Command::check;
  std::vector<Problem> unmet;
  std::optional<ModelOptions::Loads> loads;  ///< Loads that a command with loads of threads takes.
  bool is_built = true;  ///< False where the program leaves out the command, or what the case asks for (PRS_FULL).
};

/// The resolved case, what follows from it, what is unusual, and what it is ready for.
struct CheckResult {
  std::vector<input::EchoEntry> fields;
  std::map<std::string, std::string> assumed;  ///< See `input::assumptions`.
  std::vector<CommandNeeds> commands;
  Result geometry;  ///< Contacts and warnings alone.
  std::optional<CaseVerdict> verdict = {};
};

/// Without contacts and threads.
Record<CheckResult> record_of(Type<CheckResult>);

/// What a value rests on, `given`, `assumed` or `default`, and the reason of an assumed one.
std::pair<std::string_view, std::string_view> basis_of(const input::EchoEntry& field, const CheckResult& result);

/// Numbers that follow from the mechanism, by their keys in documents.
Json derived_of(const Mechanism& mechanism);

/// `check` with the verdict, for which it runs what the case is ready for.
const Analysis<CheckResult>& check_analysis();

/// `check` without the verdict.
Delivery run_check(const input::Source& source, const input::CaseInput& in);

/// A command that was run for a case: what it found, or what it found wrong.
struct Attempt {
  Command command = Command::check;
  const Delivery* delivery = nullptr;
  std::string failure = {};
  enum class Lacking { input, program, module, time } lacking = Lacking::input;  ///< `program`: left out (PRS_FULL).
};

/// The verdict on a case by what was run of it.
CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts);

}  // namespace prs
