#pragma once

#include <Eigen/Dense>

#include "modules/estimation/fit.h"

namespace modules::fit {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Standard deviation of each curve's readings; 1 where stated ones are in the weights.
using Spread = std::vector<double>;

struct Readings {
  VectorXd measured, weight;  ///< Weight: 1 over the stated deviation, else 1.
  Loss loss;
  bool is_fitted = false, is_estimated = false;
  double floor = 0.0;  ///< Least estimated deviation.
};

/// Constant data of a fit. The unknowns are in u: the value, or its logarithm.
struct Model {
  const Problem& problem;
  std::vector<Unknown> unknowns;
  std::vector<Readings> curves;
  std::vector<std::size_t> fitted;  ///< Curves.
  MatrixXd prior;                   ///< Information of the priors, by z.

  Index count() const { return static_cast<Index>(unknowns.size()); }
  const Unknown& unknown(Index j) const { return unknowns[static_cast<std::size_t>(j)]; }
  double range(Index j) const { return unknown(j).to - unknown(j).from; }
  double u(Index j, double z) const { return unknown(j).from + z * range(j); }
  /// In the unknown's own unit.
  double value(Index j, double z) const;
  Estimate shown(Index j, const Estimate& of_u) const;
  /// Offset that is added to the curve.
  double offset(std::size_t curve, const VectorXd& z) const;
  Request request(const VectorXd& z, std::vector<bool> curves) const;
  /// z + step within the bounds.
  VectorXd moved(const VectorXd& z, const VectorXd& step) const;
};

Model model_of(const Problem& problem);

/// Deviations before any fit, by the scatter of the readings.
Spread first_spread(const Model& model);

/// Place of the k-th start, the first that of the problem.
VectorXd start_of(const Model& model, std::size_t k);

VectorXd vector_of(const std::vector<double>& values);

}  // namespace modules::fit
