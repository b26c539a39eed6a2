#include "fe/cholmod.h"

#include <cholmod.h>

#include <cassert>
#include <limits>
#include <new>

namespace fe {
namespace {

void set_common(cholmod_common& common) {
  cholmod_start(&common);
  common.print = 0;
  common.error_handler = nullptr;
  common.quick_return_if_not_posdef = 1;
}

/// Throws std::bad_alloc if CHOLMOD had too little memory, or would need more than it can count.
void require_memory(const cholmod_common& common) {
  if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
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

/// CHOLMOD's view of the columns of a matrix; it never writes to them.
cholmod_dense view(const Eigen::Ref<const Eigen::MatrixXd>& b) {
  cholmod_dense d{};
  d.nrow = static_cast<std::size_t>(b.rows());
  d.ncol = static_cast<std::size_t>(b.cols());
  d.d = static_cast<std::size_t>(b.outerStride());
  d.nzmax = d.d * d.ncol;
  d.x = const_cast<double*>(b.data());
  d.xtype = CHOLMOD_REAL;
  d.dtype = CHOLMOD_DOUBLE;
  return d;
}

/// A factorization by CHOLMOD with a workspace of its own, so that threads are independent.
class Cholmod : public SparseFactorization {
 public:
  Cholmod(const SparseSymmetric& pattern, int kind) {
    set_common(common_);
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_NATURAL;
    common_.postorder = 0;
    common_.supernodal = kind;
    cholmod_sparse a = view(pattern);
    factor_ = cholmod_analyze(&a, &common_);
    if (factor_ == nullptr) {
      cholmod_finish(&common_);
      throw std::bad_alloc();
    }
  }
  ~Cholmod() override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_free_dense(&solution_, &common_);
    cholmod_free_dense(&workspace_y_, &common_);
    cholmod_free_dense(&workspace_e_, &common_);
    cholmod_finish(&common_);
  }

  FactorizationStatus factorize(const SparseSymmetric& matrix, double smallest_pivot_ratio) override {
    cholmod_sparse a = view(matrix);
    cholmod_factorize(&a, factor_, &common_);
    require_memory(common_);
    const bool ok = common_.status != CHOLMOD_NOT_POSDEF && factor_->minor == factor_->n &&
                    (factor_->is_super ? cholmod_rcond(factor_, &common_) > smallest_pivot_ratio
                                       : pivots_are_above(smallest_pivot_ratio));
    return ok ? FactorizationStatus::ok : FactorizationStatus::not_positive_definite;
  }

  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) const override {
    cholmod_dense rhs = view(b);
    [[maybe_unused]] const int ok =
        cholmod_solve2(CHOLMOD_A, factor_, &rhs, nullptr, &solution_, nullptr, &workspace_y_, &workspace_e_, &common_);
    require_memory(common_);
    assert(ok);
    x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution_->x), b.rows(), b.cols());
  }

 private:
  /// Whether all pivots of LDL' are above that share of the largest; false if one is NaN.
  bool pivots_are_above(double smallest_ratio) const {
    const int* first = static_cast<const int*>(factor_->p);
    const double* value = static_cast<const double*>(factor_->x);
    double least = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (std::size_t j = 0; j < factor_->n; ++j) {
      const double pivot = value[first[j]];
      if (!(pivot > 0.0)) return false;
      least = std::min(least, pivot);
      largest = std::max(largest, pivot);
    }
    return least > smallest_ratio * largest;
  }

  mutable cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  mutable cholmod_dense* solution_ = nullptr;
  mutable cholmod_dense* workspace_y_ = nullptr;
  mutable cholmod_dense* workspace_e_ = nullptr;
};

}  // namespace

std::unique_ptr<SparseFactorization> simplicial_factorization(const SparseSymmetric& pattern) {
  return std::make_unique<Cholmod>(pattern, CHOLMOD_SIMPLICIAL);
}

std::unique_ptr<SparseFactorization> supernodal_factorization(const SparseSymmetric& pattern) {
  return std::make_unique<Cholmod>(pattern, CHOLMOD_SUPERNODAL);
}

std::vector<int> minimum_degree_order(const SparseSymmetric& pattern) {
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

std::string simplicial_factorization_name() {
  int version[3];
  cholmod_version(version);  // version of the loaded library
  std::string text = "CHOLMOD ";
  for (const int number : version) text += std::to_string(number) + '.';
  text.back() = ',';
  return text + " simplicial LDL'";
}

}  // namespace fe
