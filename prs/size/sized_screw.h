#pragma once

#include <string>
#include <vector>

#include "prs/size/candidates.h"
#include "prs/size/requirement.h"

namespace prs {

/// A candidate as a case: a load case for each moving segment under force, then `back-driving`.
struct SizedCase {
  CompleteScrew screw;
  Case c;
  double shaft_length = 0.0;
  /// Of each segment that is shown, its load case.
  std::vector<std::optional<std::size_t>> load_case_of;

  std::size_t back_driving() const { return c.load_cases.size() - 1; }
};

/// Throws CaseError where `prs new` refuses the screw.
SizedCase sized_case(const SizeInput& in, const CandidateData& candidate);

/// Its speed along the axis in the sense that a case has: > 0 with tension where the screw drives.
double written_speed(const Requirement& r, double force, double speed);

/// Its file. `conductance` for the commented block `heat`; `by_maker`: with the capacities of the
/// row.
std::string sized_case_text(const SizeInput& in, const CandidateData& candidate,
                            const SizedCase& sized, const Heat::Conductance& conductance,
                            bool by_maker);

}  // namespace prs
