#pragma once

namespace fe {

enum class FactorizationStatus { ok, not_positive_definite };

/// Pivots below this share of the largest leave no digit in the solution.
inline constexpr double kSmallestPivotRatio = 1e-17;

}  // namespace fe
