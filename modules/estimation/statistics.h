#pragma once

#include <span>

#include "modules/estimation/model.h"

namespace modules::fit {

/// Loss of each r: rho(r^2), rho'(r^2) and psi(r) = rho'(r^2) r with its derivative by r.
struct Robust {
  ArrayXd scaled, rho, weight, psi, slope;  ///< `scaled`: r
};
Robust robust(const Loss& loss, const ArrayXd& r);

/// Mean of psi(r) r over normal errors of deviation 1.
double consistency(const Loss& loss);

double chi_square_beyond(double x, double degrees);  ///< Probability beyond x.
/// Quantile of Student's distribution, or of the normal one.
double quantile(double level, std::optional<double> degrees);

/// Runs of equal sign, in order, without zeros (Wald and Wolfowitz 1940).
std::optional<Runs> runs_of(std::span<const double> residuals);

/// Radical inverse of k in the j-th prime, from 0 (Halton 1960).
double halton(std::size_t k, std::size_t j);

/// Spectrum of the columns of a matrix, each divided by its length: singular values, falling, and
/// right vectors. Columns shorter than kNoEffect are left out, directions below kLeastRatio are not
/// identifiable.
struct Spectrum {
  static constexpr double kLeastRatio = 1e-4, kNoEffect = 1e-3;

  VectorXd length;
  std::vector<Index> columns;  ///< Indices of the remaining columns.
  VectorXd ratios;             ///< Singular values over the first one.
  MatrixXd vectors;            ///< Vectors in rows of `columns`.
};
Spectrum spectrum_of(const MatrixXd& rows);

/// A^-1 of normal equations A over the columns `free`, on identifiable directions alone; 0 elsewhere.
MatrixXd inverse(const MatrixXd& normal, const std::vector<Index>& free);

/// Weights and information of a curve.
struct Weighed {
  MatrixXd information;         ///< J'J over sigma^2.
  double a = 1.0, b = 1.0;      ///< Mean of psi', and sum of psi^2 over q.
  double redundancy = 0.0;      ///< q
  bool has_own_spread = false;  ///< Whether it has an estimated sigma or a robust loss.
  bool is_estimated = false;
};

/// Covariance of z, with the effect of estimated weights (Kenward and Roger 1997); C0 without it.
struct Covariance {
  MatrixXd first, full, inverse;
  const std::vector<Weighed>* curves = nullptr;

  /// Estimate of g'z: its deviation and, after Satterthwaite (1946), degrees of freedom.
  Estimate of(const VectorXd& g, double value, double level) const;
};
Covariance covariance_of(const std::vector<Weighed>& curves, const MatrixXd& prior, const MatrixXd& inverse);

}  // namespace modules::fit
