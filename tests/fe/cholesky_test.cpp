#include "fe/cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <memory>
#include <random>

#include "fe/cholmod.h"

namespace fe {
namespace {

/// Random symmetric matrix on a sparse pattern, its diagonal raised by `diagonal`.
struct RandomSymmetric {
  SparseSymmetric sparse;
  Eigen::MatrixXd dense;

  RandomSymmetric(int n, double fill, double diagonal, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    dense = Eigen::MatrixXd::Zero(n, n);
    sparse.column_start.push_back(0);
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i <= j; ++i) {
        if (i != j && std::abs(uniform(random)) > fill) continue;
        const double value = i == j ? diagonal + uniform(random) : uniform(random);
        sparse.row.push_back(i);
        sparse.value.push_back(value);
        dense(i, j) = dense(j, i) = value;
      }
      sparse.column_start.push_back(static_cast<int>(sparse.row.size()));
    }
  }
};

/// Every factorization: CHOLMOD's two and Eigen's.
class CholeskyKinds : public testing::TestWithParam<std::unique_ptr<SparseFactorization> (*)(const SparseSymmetric&)> {
 protected:
  static Eigen::VectorXd solution(const SparseFactorization& f, const Eigen::VectorXd& b) {
    Eigen::VectorXd x(b.size());
    f.solve(b, x);
    return x;
  }
};
INSTANTIATE_TEST_SUITE_P(All, CholeskyKinds,
                         testing::Values(simplicial_factorization, supernodal_factorization, eigen_factorization));

TEST_P(CholeskyKinds, SolvesAsDenseFactorization) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const int n = 3 + 7 * static_cast<int>(seed);
    const RandomSymmetric a(n, 0.1, n, seed);
    const auto cholesky = GetParam()(a.sparse);
    ASSERT_EQ(cholesky->factorize(a.sparse), FactorizationStatus::ok);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
    const Eigen::VectorXd x = solution(*cholesky, b);
    EXPECT_LT((x - a.dense.ldlt().solve(b)).norm(), 1e-13 * x.norm());
  }
}

TEST_P(CholeskyKinds, TellsIndefiniteFromDefinite) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomSymmetric a(30, 0.2, 0.5, seed);
    const bool positive = Eigen::LLT<Eigen::MatrixXd>(a.dense).info() == Eigen::ComputationInfo::Success;
    const auto cholesky = GetParam()(a.sparse);
    EXPECT_EQ(cholesky->factorize(a.sparse) == FactorizationStatus::ok, positive) << seed;
  }
}

TEST_P(CholeskyKinds, RecoversAfterAnIndefiniteMatrix) {
  RandomSymmetric a(30, 0.2, 30.0, 1);
  const auto cholesky = GetParam()(a.sparse);
  SparseSymmetric negative = a.sparse;
  for (double& v : negative.value) v = -v;
  EXPECT_EQ(cholesky->factorize(negative), FactorizationStatus::not_positive_definite);
  EXPECT_EQ(cholesky->factorize(a.sparse), FactorizationStatus::ok);
}

TEST_P(CholeskyKinds, SingularMatrixIsNotPositiveDefinite) {
  SparseSymmetric singular;  // [[1, -1], [-1, 1]]
  singular.column_start = {0, 1, 3};
  singular.row = {0, 0, 1};
  singular.value = {1.0, -1.0, 1.0};
  const auto cholesky = GetParam()(singular);
  EXPECT_EQ(cholesky->factorize(singular), FactorizationStatus::not_positive_definite);
}

TEST_P(CholeskyKinds, SmallPivotsAreRefusedByTheRatioGiven) {
  RandomSymmetric a(30, 0.0, 5.0, 1);
  a.sparse.value.front() = 1e-9;
  const auto cholesky = GetParam()(a.sparse);
  EXPECT_EQ(cholesky->factorize(a.sparse, 1e-8), FactorizationStatus::not_positive_definite);
  EXPECT_EQ(cholesky->factorize(a.sparse, 0.0), FactorizationStatus::ok);
}

TEST(Cholesky, IsCholmodsOrEigensAsItsNameSays) {
  EXPECT_TRUE(Cholesky::name().starts_with("CHOLMOD "));
  EXPECT_TRUE(Cholesky::name().ends_with("simplicial LDL'"));
  factorize_by_eigen(true);
  EXPECT_TRUE(Cholesky::name().starts_with("Eigen "));
  factorize_by_eigen(false);
}

TEST(FillReducingOrder, IsAPermutation) {
  const RandomSymmetric a(80, 0.05, 80.0, 3);
  for (std::vector<int> order : {fill_reducing_order(a.sparse), minimum_degree_order(a.sparse)}) {
    std::sort(order.begin(), order.end());
    for (int i = 0; i < 80; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
  }
}

}  // namespace
}  // namespace fe
