#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fe/sparse_symmetric.h"

namespace fe {

/// Factorization of a symmetric matrix into sparse triangles, with fixed pattern and order. All members throw
/// std::bad_alloc if memory does not suffice.
class SparseFactorization {
 public:
  SparseFactorization() = default;
  virtual ~SparseFactorization() = default;
  SparseFactorization(const SparseFactorization&) = delete;
  SparseFactorization& operator=(const SparseFactorization&) = delete;

  /// Factorizes. The result is not positive definite also if a pivot is below `smallest_pivot_ratio` times the largest.
  virtual FactorizationStatus factorize(const SparseSymmetric& matrix,
                                        double smallest_pivot_ratio = kSmallestPivotRatio) = 0;

  /// Solves A x = b for the columns of b with the last factorization, which must have been `ok`; x
  /// has the size of b.
  virtual void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) const = 0;
};

/// Sparse LDL' for a fixed pattern of the size of a sector, by CHOLMOD. The symbolic analysis happens once, at
/// construction; `factorize` takes new values for the same pattern. The matrix is factorized in the order given: number
/// the equations by `fill_reducing_order` first.
class Cholesky {
 public:
  explicit Cholesky(const SparseSymmetric& pattern);

  /// The functions of SparseFactorization.
  FactorizationStatus factorize(const SparseSymmetric& matrix, double smallest_pivot_ratio = kSmallestPivotRatio) {
    return factorization_->factorize(matrix, smallest_pivot_ratio);
  }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
    x.resize(b.size());
    factorization_->solve(b, x);
  }

  /// Library, version and kind: `CHOLMOD 3.0.14, simplicial LDL'`.
  static std::string_view name();

 private:
  std::unique_ptr<SparseFactorization> factorization_;
};

/// Selects Eigen's factorization from now on, for comparing both; not while other threads solve.
void factorize_by_eigen(bool always);

/// Eigen's simplicial LDL', and its name.
std::unique_ptr<SparseFactorization> eigen_factorization(const SparseSymmetric& pattern);
std::string eigen_factorization_name();

/// Approximate minimum degree order, by Eigen: entry k is the row eliminated k-th.
std::vector<int> fill_reducing_order(const SparseSymmetric& pattern);

}  // namespace fe
