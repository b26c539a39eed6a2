#include <string_view>

#include "fe/cholesky.h"
#include "fe/supernodal_cholesky.h"

namespace fe {
namespace {

/// By columns, where CHOLMOD is not at hand.
class ByColumns : public SupernodalCholesky {
 public:
  explicit ByColumns(const SparseSymmetric& pattern) : factor_(pattern) {}

  FactorizationStatus factorize(const SparseSymmetric& matrix) override {
    return factor_.factorize(matrix);
  }

  void solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) override {
    x.resize(b.rows(), b.cols());
    Eigen::VectorXd column;
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      factor_.solve(b.col(j), column);
      x.col(j) = column;
    }
  }

 private:
  Cholesky factor_;
};

}  // namespace
}  // namespace fe

extern "C" const modules::Module* prs_built_in_module(std::string_view& file) {
  static const fe::CholmodModule module{
      {},
      [](const fe::SparseSymmetric& pattern) -> std::unique_ptr<fe::SupernodalCholesky> {
        return std::make_unique<fe::ByColumns>(pattern);
      },
      fe::fill_reducing_order};
  file = fe::CholmodModule::kName.file;
  return &module;
}
