#pragma once

#include <vector>

#include "prs/validation/validate.h"
#include "validation/reference_fe/comparison.h"

namespace prs::reference_fe {

/// Error bar of the reference's curves, opposite contacts included (SOURCE.md, "Curves").
inline constexpr ErrorBar kReferenceError{0.002, 0.001};
/// Working accuracy of the influence model.
inline constexpr ErrorBar kInfluenceError{0.005, 0.001};
/// What the refined model promises.
inline constexpr ErrorBar kRefinedError{0.05, 0.010};

/// The reference and the three models on the same curves.
struct Fidelities {
  std::vector<Curve> reference;
  std::vector<Curve> bars;
  std::vector<Curve> refined;
  std::vector<Curve> influence;
};

/// How large the gap of the bar model is, and whether the other two stay within their error bars.
std::vector<ComparedStatement> compare_statements(const Fidelities& fidelities);

}  // namespace prs::reference_fe
