#pragma once

#include "fe/cholesky.h"

/// CHOLMOD of SuiteSparse. The engine of live pages is built without it (PRS_CHOLMOD), and has Eigen's
/// factorization behind the same functions. All of them throw std::bad_alloc if memory does not suffice.
namespace fe {

/// LDL' without blocks, for patterns of the size of a sector.
std::unique_ptr<SparseFactorization> simplicial_factorization(const SparseSymmetric& pattern);

/// LL' by dense blocks, for much larger patterns.
std::unique_ptr<SparseFactorization> supernodal_factorization(const SparseSymmetric& pattern);

/// Approximate minimum degree order for large patterns: entry k is the row eliminated k-th.
std::vector<int> minimum_degree_order(const SparseSymmetric& pattern);

/// Library, version and kind of `simplicial_factorization`.
std::string simplicial_factorization_name();

}  // namespace fe
