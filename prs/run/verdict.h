#pragma once

#include "prs/model/criterion.h"
#include "prs/record/analysis.h"

/// Whether a case meets its limits: the one definition that `prs check`, the report and the page
/// read. Each criterion has the worst value of all load cases, with the real thread loads.

namespace prs {

struct CaseVerdict {
  std::vector<Criterion> criteria = {};
  bool is_complete = true;  ///< All commands were asked that the case is ready for.
  /// Commands that the case is ready for and the program leaves out (PRS_FULL).
  std::vector<std::string> not_built = {};
  /// Commands that the case is ready for and that were not run, as they take long.
  std::vector<std::string> skipped = {};
  /// Commands that the case is ready for and that found something wrong with it.
  std::vector<std::string> failed = {};
  /// Reason of `solve` or `measures` why no screw can be like this; empty for a possible one.
  std::string impossible = {};

  /// The worst: red, amber, green; red of an impossible screw, amber where a stated limit has no value, or a command
  /// failed, was skipped or is not built. `no_limit` where nothing is held against a limit.
  Standing standing() const;
};

/// A command that was run for a case: what it found, or what it found wrong.
struct Attempt {
  Command command = Command::check;
  const Delivery* delivery = nullptr;
  std::string failure = {};
  enum class Lacking { input, program, module, time } lacking = Lacking::input;  ///< `program`: left out (PRS_FULL).
};

/// The verdict on a case by what was run of it.
CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts);

std::string words(const Criterion& c);  ///< Words for its standing: `met`, `below recommended`, `not computed`

/// How tables and pages show value and limit: shown = value * factor.
struct ShownCriterion {
  std::string_view unit;
  double factor = 1.0;
};
ShownCriterion shown(const Criterion& criterion);

/// One sentence with the verdict: `Not met: static safety, peak pressure. ..`.
std::string summary(const CaseVerdict& verdict);
/// Criteria without a value or without anything to apply to: `temperature (add heat), ..`.
std::string not_computed(const CaseVerdict& verdict);
/// `limits.static_safety`, `physical limit`, `recommended`.
std::string origin(const Criterion& criterion);

Record<CaseVerdict> record_of(Type<CaseVerdict>);
Record<Criterion> record_of(Type<Criterion>);

}  // namespace prs
