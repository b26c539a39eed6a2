#include "fe/cholesky.h"

#include <cholmod.h>

#include <cassert>
#include <new>

namespace fe {
namespace {

/// Pivots below this share of the largest leave no digit in the solution.
constexpr double kSmallestPivotRatio = 1e-17;

void set_common(cholmod_common& common) {
  cholmod_start(&common);
  common.print = 0;
  common.error_handler = nullptr;
  common.quick_return_if_not_posdef = 1;
}

/// Throws std::bad_alloc where CHOLMOD had too little memory, or would need more than it can count.
void require_memory(const cholmod_common& common) {
  if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
    throw std::bad_alloc();
}

/// CHOLMOD's view of our arrays; it never writes to them.
cholmod_sparse view(const SparseSymmetric& m) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(m.size());
  a.nzmax = m.row.size();
  a.p = const_cast<int*>(m.column_start.data());
  a.i = const_cast<int*>(m.row.data());
  a.x = const_cast<double*>(m.value.data());
  a.stype = 1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = 1;
  a.packed = 1;
  return a;
}

cholmod_dense view(const double* data, std::size_t size) {
  cholmod_dense d{};
  d.nrow = d.nzmax = d.d = size;
  d.ncol = 1;
  d.x = const_cast<double*>(data);
  d.xtype = CHOLMOD_REAL;
  d.dtype = CHOLMOD_DOUBLE;
  return d;
}

}  // namespace

struct Cholesky::Impl {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* workspace_y = nullptr;
  cholmod_dense* workspace_e = nullptr;

  Impl() { set_common(common); }
  ~Impl() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&workspace_y, &common);
    cholmod_free_dense(&workspace_e, &common);
    cholmod_finish(&common);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
};

Cholesky::Cholesky(const SparseSymmetric& pattern, FactorizationKind kind)
    : impl_(std::make_unique<Impl>()) {
  cholmod_common& common = impl_->common;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder = 0;
  common.supernodal =
      kind == FactorizationKind::simplicial ? CHOLMOD_SIMPLICIAL : CHOLMOD_SUPERNODAL;
  cholmod_sparse a = view(pattern);
  impl_->factor = cholmod_analyze(&a, &common);
  if (impl_->factor == nullptr) throw std::bad_alloc();
}

Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

FactorizationStatus Cholesky::factorize(const SparseSymmetric& matrix) {
  cholmod_common& common = impl_->common;
  cholmod_factor* factor = impl_->factor;
  cholmod_sparse a = view(matrix);
  cholmod_factorize(&a, factor, &common);
  require_memory(common);
  if (common.status == CHOLMOD_NOT_POSDEF || factor->minor < factor->n)
    return FactorizationStatus::not_positive_definite;
  // LDL' goes on past a negative pivot: the pivots have the last word.
  if (!(cholmod_rcond(factor, &common) > kSmallestPivotRatio))
    return FactorizationStatus::not_positive_definite;
  if (!factor->is_ll && !factor->is_super) {
    const auto* start = static_cast<const int*>(factor->p);
    const auto* value = static_cast<const double*>(factor->x);
    for (std::size_t j = 0; j < factor->n; ++j)
      if (!(value[start[j]] > 0.0)) return FactorizationStatus::not_positive_definite;
  }
  return FactorizationStatus::ok;
}

void Cholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  cholmod_dense rhs = view(b.data(), static_cast<std::size_t>(b.size()));
  [[maybe_unused]] const int ok =
      cholmod_solve2(CHOLMOD_A, impl_->factor, &rhs, nullptr, &impl_->solution, nullptr,
                     &impl_->workspace_y, &impl_->workspace_e, &impl_->common);
  require_memory(impl_->common);
  assert(ok);
  x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(impl_->solution->x), b.size());
}

void Cholesky::solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) {
  cholmod_dense rhs = view(b.data(), static_cast<std::size_t>(b.rows()));
  rhs.ncol = static_cast<std::size_t>(b.cols());
  rhs.nzmax = rhs.nrow * rhs.ncol;
  [[maybe_unused]] const int ok =
      cholmod_solve2(CHOLMOD_A, impl_->factor, &rhs, nullptr, &impl_->solution, nullptr,
                     &impl_->workspace_y, &impl_->workspace_e, &impl_->common);
  require_memory(impl_->common);
  assert(ok);
  x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(impl_->solution->x), b.rows(),
                                        b.cols());
}

std::size_t Cholesky::factor_size() const {
  const cholmod_factor* f = impl_->factor;
  return f->is_super ? f->xsize : f->nzmax;
}

std::vector<int> fill_reducing_order(const SparseSymmetric& pattern) {
  std::vector<int> order(static_cast<std::size_t>(pattern.size()));
  cholmod_common common{};
  set_common(common);
  cholmod_sparse a = view(pattern);
  a.xtype = CHOLMOD_PATTERN;
  const int ok = cholmod_amd(&a, nullptr, 0, order.data(), &common);
  cholmod_finish(&common);
  if (!ok) throw std::bad_alloc();
  return order;
}

}  // namespace fe
