#include "modules/estimation/minimise.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

namespace modules::fit {
namespace {

class Cost : public ceres::CostFunction {
 public:
  Cost(const Residuals& residuals, std::size_t count, std::size_t unknowns) : residuals_(residuals) {
    set_num_residuals(static_cast<int>(count));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns));
  }
  bool Evaluate(const double* const* z, double* residuals, double** derivatives) const override {
    return residuals_(z[0], residuals, derivatives != nullptr ? derivatives[0] : nullptr);
  }

 private:
  const Residuals& residuals_;
};

/// Switches the library's log off; once, since all threads share its flags.
void keep_quiet() {
  [[maybe_unused]] static const bool is_quiet = [] {
    FLAGS_minloglevel = google::GLOG_FATAL;
    FLAGS_logtostderr = true;  // No files.
    return true;
  }();
}

}  // namespace

std::size_t minimise(const Residuals& residuals, std::size_t count, const std::vector<bool>& bounded, bool roughly,
                     std::vector<double>& z) {
  keep_quiet();
  ceres::Problem problem;
  problem.AddResidualBlock(new Cost(residuals, count, z.size()), nullptr, z.data());
  for (std::size_t j = 0; j < z.size(); ++j) {
    if (!bounded[j]) continue;
    problem.SetParameterLowerBound(z.data(), static_cast<int>(j), 0.0);
    problem.SetParameterUpperBound(z.data(), static_cast<int>(j), 1.0);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = roughly ? 12 : 200;
  options.max_num_consecutive_invalid_steps = 40;       // Rows without an answer; each halves the step or more.
  options.function_tolerance = roughly ? 1e-4 : 1e-15;  // Ceres' default stops too early.
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.iterations.size();
}

}  // namespace modules::fit
