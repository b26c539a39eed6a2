#pragma once

#include <Eigen/Core>

#include "fe/sparse_symmetric.h"

namespace fe {

/// A symmetric matrix as a product of sparse triangles. The pattern is fixed and its order is kept.
/// All of it throws std::bad_alloc where memory does not suffice.
class SparseFactorization {
 public:
  SparseFactorization() = default;
  virtual ~SparseFactorization() = default;
  SparseFactorization(const SparseFactorization&) = delete;
  SparseFactorization& operator=(const SparseFactorization&) = delete;

  /// Not positive definite: also where a pivot is below `smallest_pivot_ratio` times the largest.
  virtual FactorizationStatus factorize(const SparseSymmetric& matrix,
                                        double smallest_pivot_ratio = kSmallestPivotRatio) = 0;

  /// Solves A x = b for the columns of b with the last factorization, which must have been `ok`; x
  /// has the size of b.
  virtual void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) const = 0;
};

}  // namespace fe
