#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "fe/sparse_symmetric.h"

namespace fe {

enum class FactorizationStatus { ok, not_positive_definite };
enum class FactorizationKind { simplicial, supernodal };

/// Sparse Cholesky by CHOLMOD for a fixed pattern: the symbolic analysis happens once, at birth;
/// `factorize` takes new values for the same pattern. The matrix is factorized in the order given:
/// number the equations by `fill_reducing_order` first. Supernodal pays for patterns much larger
/// than one sector. All of it throws std::bad_alloc where memory does not suffice.
class Cholesky {
 public:
  explicit Cholesky(const SparseSymmetric& pattern,
                    FactorizationKind kind = FactorizationKind::simplicial);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  FactorizationStatus factorize(const SparseSymmetric& matrix);

  /// Solves A x = b with the last factorization, which must have been `ok`.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  /// The same for many right-hand sides at once, one in a column.
  void solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x);

  /// Nonzeros of the factor.
  std::size_t factor_size() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Approximate minimum degree order: entry k is the row that comes k-th.
std::vector<int> fill_reducing_order(const SparseSymmetric& pattern);

}  // namespace fe
