#include "fe/cholesky.h"
#include "fe/cholmod.h"

/// Eigen's factorization behind the functions of CHOLMOD, for a program that is built without it.
namespace fe {

std::unique_ptr<SparseFactorization> simplicial_factorization(const SparseSymmetric& pattern) {
  return eigen_factorization(pattern);
}

std::unique_ptr<SparseFactorization> supernodal_factorization(const SparseSymmetric& pattern) {
  return eigen_factorization(pattern);
}

std::vector<int> minimum_degree_order(const SparseSymmetric& pattern) { return fill_reducing_order(pattern); }

std::string simplicial_factorization_name() { return eigen_factorization_name(); }

}  // namespace fe
