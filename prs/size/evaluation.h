#pragma once

#include "prs/size/size.h"

namespace prs {

/// A candidate compared with the requirement, unranked. Throws CaseError if `prs new` refuses it.
SizedCandidate evaluated(const SizeInput& in, const CandidateData& data);

/// Forces over speed of an evaluated candidate; none without mean load.
std::optional<SizeCurve> force_over_speed(const SizeInput& in, const SizedCandidate& candidate);

}  // namespace prs
