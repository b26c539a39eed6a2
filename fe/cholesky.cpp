#include "fe/cholesky.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <atomic>

#include "fe/cholmod.h"

namespace fe {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix upper_of(const SparseSymmetric& m) {
  return Eigen::Map<const Matrix>(m.size(), m.size(), static_cast<Eigen::Index>(m.row.size()), m.column_start.data(),
                                  m.row.data(), m.value.data());
}

class EigenFactorization : public SparseFactorization {
 public:
  explicit EigenFactorization(const SparseSymmetric& pattern) : matrix_(upper_of(pattern)) {
    factor_.analyzePattern(matrix_);
  }

  FactorizationStatus factorize(const SparseSymmetric& matrix, double smallest_pivot_ratio) override {
    std::copy(matrix.value.begin(), matrix.value.end(), matrix_.valuePtr());
    factor_.factorize(matrix_);
    if (factor_.info() != Eigen::Success) return FactorizationStatus::not_positive_definite;
    const Eigen::VectorXd pivots = factor_.vectorD();
    // false if a pivot is NaN.
    const bool positive = (pivots.array() > smallest_pivot_ratio * pivots.maxCoeff()).all();
    return positive ? FactorizationStatus::ok : FactorizationStatus::not_positive_definite;
  }

  void solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) const override {
    x = factor_.solve(b);
  }

 private:
  Matrix matrix_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> factor_;
};

std::atomic<bool> eigen_always = false;

}  // namespace

Cholesky::Cholesky(const SparseSymmetric& pattern)
    : factorization_(eigen_always ? eigen_factorization(pattern) : simplicial_factorization(pattern)) {}

std::string_view Cholesky::name() {
  static const std::string cholmod = simplicial_factorization_name(), eigen = eigen_factorization_name();
  return eigen_always ? eigen : cholmod;
}

void factorize_by_eigen(bool always) { eigen_always = always; }

std::unique_ptr<SparseFactorization> eigen_factorization(const SparseSymmetric& pattern) {
  return std::make_unique<EigenFactorization>(pattern);
}

std::string eigen_factorization_name() {
  std::string text = "Eigen ";
  for (const int number : {EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION})
    text += std::to_string(number) + '.';
  text.back() = ',';
  return text + " simplicial LDL'";
}

std::vector<int> fill_reducing_order(const SparseSymmetric& pattern) {
  Eigen::AMDOrdering<int>::PermutationType order;
  const Matrix upper = upper_of(pattern);
  Eigen::AMDOrdering<int>()(upper.selfadjointView<Eigen::Upper>(), order);
  return {order.indices().begin(), order.indices().end()};
}

}  // namespace fe
