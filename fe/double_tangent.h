#pragma once

#include <vector>

#include "fe/cholesky.h"
#include "fe/equations.h"
#include "fe/index.h"

namespace fe {

/// The tangent in doubles and its factorization: what steps of Newton's method are solved with.
class DoubleTangent {
 public:
  explicit DoubleTangent(const Equations& equations)
      : equations_(&equations), tangent_(equations.linear_stiffness()), cholesky_(tangent_) {}

  /// As Cholesky::factorize has it.
  double smallest_pivot_ratio = kSmallestPivotRatio;

  void tangent(const State& q, double least) { equations_->tangent_stiffness(q, tangent_, least); }
  void secant(const std::vector<double>& stiffness) {
    equations_->secant_stiffness(stiffness, tangent_);
  }
  void shift_by(double change) {
    const SparseSymmetric& linear = equations_->linear_stiffness();
    for (int j = 0; j < tangent_.size(); ++j) {
      const int diagonal = at(tangent_.column_start, j + 1) - 1;
      at(tangent_.value, diagonal) += change * at(linear.value, diagonal);
    }
  }
  FactorizationStatus factorize() { return cholesky_.factorize(tangent_, smallest_pivot_ratio); }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { cholesky_.solve(b, x); }
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
  Cholesky cholesky_;
};

}  // namespace fe
