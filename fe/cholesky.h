#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "fe/factorization_status.h"
#include "fe/sparse_symmetric.h"

namespace fe {

/// Sparse LDL' by Eigen for a fixed pattern of the size of a sector: the symbolic analysis happens
/// once, at birth; `factorize` takes new values for the same pattern. The matrix is factorized in
/// the order given: number the equations by `fill_reducing_order` first. For much larger patterns
/// see SupernodalCholesky.
class Cholesky {
 public:
  explicit Cholesky(const SparseSymmetric& pattern);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Not positive definite: also where a pivot is below `smallest_pivot_ratio` times the largest.
  FactorizationStatus factorize(const SparseSymmetric& matrix,
                                double smallest_pivot_ratio = kSmallestPivotRatio);

  /// Solves A x = b with the last factorization, which must have been `ok`.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Approximate minimum degree order: entry k is the row that comes k-th.
std::vector<int> fill_reducing_order(const SparseSymmetric& pattern);

}  // namespace fe
