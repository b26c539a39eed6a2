#pragma once

#include "fe/cholesky.h"
#include "fe/equations.h"

namespace fe {

/// The tangent in doubles and its factorization, which solve the steps of Newton's method.
class DoubleTangent {
 public:
  explicit DoubleTangent(const Equations& equations)
      : equations_(&equations), tangent_(equations.linear_stiffness()), cholesky_(tangent_) {}

  /// See Cholesky::factorize.
  double smallest_pivot_ratio = kSmallestPivotRatio;

  void tangent(const State& q, double least) {
    stiffness_.resize(equations_->springs().size());
    for (std::size_t k = 0; k < stiffness_.size(); ++k)
      stiffness_[k] = std::max(equations_->response(q, static_cast<int>(k)).tangent, least);
    secant(stiffness_);
  }
  void secant(const std::vector<double>& stiffness) {
    stiffness_ = stiffness;
    equations_->secant_stiffness(stiffness_, tangent_);
  }
  void shift_by(double change) {
    stiffness_.clear();
    const SparseSymmetric& linear = equations_->linear_stiffness();
    for (int j = 0; j < tangent_.size(); ++j) {
      const int diagonal = at(tangent_.column_start, j + 1) - 1;
      at(tangent_.value, diagonal) += change * at(linear.value, diagonal);
    }
  }
  FactorizationStatus factorize() {
    const FactorizationStatus status = cholesky_.factorize(tangent_, smallest_pivot_ratio);
    factorized_ = status == FactorizationStatus::ok ? stiffness_ : std::vector<double>();
    return status;
  }
  /// Whether no spring's stiffness differs from that in the factorization by more than this share
  /// of it: a solve with the factorization then leaves at most this share of an error, in energy.
  bool factorized_within(double share) const {
    if (factorized_.empty() || factorized_.size() != stiffness_.size()) return false;
    for (std::size_t k = 0; k < stiffness_.size(); ++k)
      if (!(std::abs(stiffness_[k] - factorized_[k]) <= share * factorized_[k])) return false;
    return true;
  }
  /// Call it after a change of the linear part.
  void forget() { factorized_.clear(); }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { cholesky_.solve(b, x); }
  /// Whether x solves for b at all: no entry of the residual is above a tenth of the largest one of b.
  bool solved(const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    Eigen::VectorXd left = b;
    for (int j = 0; j < tangent_.size(); ++j)
      for (int k = at(tangent_.column_start, j); k < at(tangent_.column_start, j + 1); ++k) {
        const int i = at(tangent_.row, k);
        left[i] -= at(tangent_.value, k) * x[j];
        if (i != j) left[j] -= at(tangent_.value, k) * x[i];
      }
    return left.cwiseAbs().maxCoeff() <= 0.1 * b.cwiseAbs().maxCoeff();
  }

  const SparseSymmetric& matrix() const { return tangent_; }
  const Cholesky& cholesky() const { return cholesky_; }

 private:
  const Equations* equations_;
  SparseSymmetric tangent_;
  /// Spring stiffnesses in the matrix, and in its factorization; none where it is shifted.
  std::vector<double> stiffness_, factorized_;
  Cholesky cholesky_;
};

}  // namespace fe
