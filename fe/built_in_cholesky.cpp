#include "fe/cholesky.h"

/// Eigen's, where CHOLMOD is not at hand.
extern "C" const modules::Module* prs_built_in_module(std::string_view& file) {
  static const fe::CholmodModule module{
      {}, fe::eigen_factorization, fe::eigen_factorization, fe::fill_reducing_order, fe::eigen_factorization_name};
  file = fe::CholmodModule::kName.file;
  return &module;
}
