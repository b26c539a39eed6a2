#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "fe/factorization_status.h"
#include "fe/sparse_symmetric.h"
#include "modules/module.h"

namespace fe {

/// Cholesky by dense blocks, for patterns much larger than one sector. As in `Cholesky`, the
/// pattern is fixed and its order is kept. All of it throws std::bad_alloc where memory does not
/// suffice.
class SupernodalCholesky {
 public:
  SupernodalCholesky() = default;
  virtual ~SupernodalCholesky() = default;
  SupernodalCholesky(const SupernodalCholesky&) = delete;
  SupernodalCholesky& operator=(const SupernodalCholesky&) = delete;

  virtual FactorizationStatus factorize(const SparseSymmetric& matrix) = 0;

  /// Solves A x = b for the columns of b with the last factorization, which must have been `ok`.
  virtual void solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) = 0;
};

struct CholmodModule : modules::Module {
  static constexpr modules::Name kName{"prs_cholmod.so", "CHOLMOD", "libsuitesparse-dev", ""};

  std::unique_ptr<SupernodalCholesky> (*factorization)(const SparseSymmetric& pattern);

  /// Approximate minimum degree order: entry k is the row that comes k-th.
  std::vector<int> (*fill_reducing_order)(const SparseSymmetric& pattern);
};

}  // namespace fe
