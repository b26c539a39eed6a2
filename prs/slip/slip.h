#pragma once

#include "prs/loads/analyze.h"
#include "prs/slip/slip_model.h"

namespace prs {

/// The whole chain with slip: the results of `analyze`, or for equal shares of `analyze_contacts`, and for each load
/// case the stationary slip and the friction losses. The case must have passed `check_case` and the requirements of
/// `slip`. Throws CaseError if the geometry gives no contact, or measured pitches bring its threads out of mesh.
/// `oils`: replace the lubricant at the temperature of the file.
Result analyze_slip(const Conditions& c, Contacts contacts, AnalysisOptions options = {},
                    const std::optional<Oils>& oils = {});
inline Result analyze_slip(const Case& c, AnalysisOptions options = {}) {
  return analyze_slip(c, checked_contacts(c, options.detail), options);
}

/// Slip of one load case without travel or modes.
std::optional<SlipResult> slip_alone(Conditions c, const Contacts& contacts, const LoadCase& load,
                                     const std::optional<Oils>& oils = {});

/// Throws CaseError if the geometry gives no contact or measured pitches bring its threads out of mesh.
void require_rolling(const Conditions& c, const Contacts& contacts);

/// Whether all threads of a roller stay in their initial grooves, for all measured pitches.
bool rolls(const Mechanism& mechanism);

/// Slip of one load case, without the comparison with equal shares.
SlipResult slip_result(const SlipModel& model);

/// Numbers of the threads to compute.
struct SlipDetail {
  bool threads = true;  ///< All except films.
  bool films = true;
};

/// Fills a result, which keeps its memory, from a known equilibrium.
void set_slip_result(SlipResult& slip, const SlipModel& model, const SlipEquilibrium& found, const SlipDetail& detail);

}  // namespace prs
