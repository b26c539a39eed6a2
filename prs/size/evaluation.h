#pragma once

#include "prs/size/size.h"
#include "prs/size/sized_screw.h"

namespace prs {

/// A candidate against the requirement, unranked. Throws CaseError where `prs new` refuses it.
SizedCandidate evaluated(const SizeInput& in, const CandidateData& data);

/// Forces over speed of an evaluated candidate; none without mean load or speed limit.
std::optional<SizeCurve> force_over_speed(const SizeInput& in, const CandidateData& data,
                                          const SizedCandidate& candidate);

/// Conductances of a screw: those of the requirement, the others by the rule of `prs new` at the
/// mean load.
Heat::Conductance conductance_of(const SizeInput& in, const SizedCase& sized);

}  // namespace prs
