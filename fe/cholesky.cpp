#include "fe/cholesky.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>

namespace fe {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix upper_of(const SparseSymmetric& m) {
  return Eigen::Map<const Matrix>(m.size(), m.size(), static_cast<Eigen::Index>(m.row.size()),
                                  m.column_start.data(), m.row.data(), m.value.data());
}

}  // namespace

struct Cholesky::Impl {
  Matrix matrix;
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> factor;
};

Cholesky::Cholesky(const SparseSymmetric& pattern) : impl_(std::make_unique<Impl>()) {
  impl_->matrix = upper_of(pattern);
  impl_->factor.analyzePattern(impl_->matrix);
}

Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

FactorizationStatus Cholesky::factorize(const SparseSymmetric& matrix,
                                        double smallest_pivot_ratio) {
  std::copy(matrix.value.begin(), matrix.value.end(), impl_->matrix.valuePtr());
  impl_->factor.factorize(impl_->matrix);
  if (impl_->factor.info() != Eigen::Success) return FactorizationStatus::not_positive_definite;
  const Eigen::VectorXd pivots = impl_->factor.vectorD();
  // False where one is no number.
  const bool positive = (pivots.array() > smallest_pivot_ratio * pivots.maxCoeff()).all();
  return positive ? FactorizationStatus::ok : FactorizationStatus::not_positive_definite;
}

void Cholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  x = impl_->factor.solve(b);
}

std::vector<int> fill_reducing_order(const SparseSymmetric& pattern) {
  Eigen::AMDOrdering<int>::PermutationType order;
  const Matrix upper = upper_of(pattern);
  Eigen::AMDOrdering<int>()(upper.selfadjointView<Eigen::Upper>(), order);
  return {order.indices().begin(), order.indices().end()};
}

}  // namespace fe
