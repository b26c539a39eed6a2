#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>

#include "prs/study/designs.h"

namespace prs {

/// A factor of a sampled plan on the axis of the response surface,
///
///     x = (value - centre) / half_range,
///
/// so that a uniform factor runs from -1 to 1 and a normal one has the standard deviation 1. Values
/// of a log-uniform factor are taken by their logarithm. Centre and half range come from the
/// factor's distribution, not from the draws; Yao et al. 2023, section 3.1, scale by the draws'
/// extremes, which differ from it by the order of 1 / samples.
struct NormalisedFactor {
  std::size_t factor = 0;  ///< Index in the study.
  double centre = 0.0;     ///< Value in the factor's unit, or the logarithm of its number.
  double half_range = 1.0;
  bool logarithmic = false;

  double operator()(double value) const;
};

/// Factors of the study that are numbers and vary. Empty unless the plan is sampled.
std::vector<NormalisedFactor> normalised_factors(const Study& study);

/// Effect of one factor on a response over the ranges.
struct FactorEffect {
  std::size_t factor = 0;  ///< Index in the study.
  /// b_i, the change of the response from the centre to the end of the factor's range (for a normal factor: by one
  /// standard deviation), in the unit of the response.
  double coefficient = 0.0;
  /// Standard error of the coefficient; absent if no design is left to estimate it.
  std::optional<double> standard_error;
  /// |b_i| / sum |b| [%]: A_i of Yao et al. 2023, section 3.1, whose sum of signed coefficients is
  /// read as one of magnitudes, as their figures 8 and 9 draw it (bars of either sign that add up
  /// to 100 %). Its sign is that of the coefficient.
  double contribution_percent = 0.0;
};

/// Linear polynomial closest to a response, y = b_0 + sum b_i x_i.
struct LinearFit {
  double intercept = 0.0;
  std::vector<FactorEffect> effects;  ///< Effects, the largest contribution first.
  double r_squared = 0.0;             ///< Share of the variance that the polynomial explains.
  std::optional<double> adjusted_r_squared;
};

/// R^2 below which a ranking by linear contributions misses much of the variation.
inline constexpr double kLowRSquared = 0.9;

/// Largest number of factors; with more, the fit would cost more per design than the solve.
inline constexpr std::size_t kMostFactorsOfSurface = 100;

/// Linear response surfaces of all responses of a study.
struct ResponseSurfaces {
  std::size_t designs = 0;  ///< Number of designs in the fit: converged, with a number for each response.
  std::string reason = {};  ///< Reason why there is no fit; empty if there is one.
  /// One per response; absent if the response does not vary. Empty if there is no fit.
  std::vector<std::optional<LinearFit>> fits = {};
};

/// Least squares by orthogonal triangularisation of [1 X Y], block after block of rows (Golub & Van Loan 2013,
/// sections 5.3 and 6.5), in memory that does not depend on the number of rows. The result depends only on the order of
/// the rows, not on their blocks.
class LinearRegression {
 public:
  LinearRegression() : LinearRegression(0, 0) {}
  LinearRegression(std::size_t factors, std::size_t responses);

  /// Adds a row of normalised factors and its responses, all of them finite.
  void add(std::span<const double> x, std::span<const double> y);

  std::size_t rows() const { return rows_; }

  /// First column of X that does not vary, or depends on those before it.
  std::optional<std::size_t> dependent_column() const;

  /// One fit per response, absent if that does not vary, with effects in the order of the columns of X. Needs more rows
  /// than factors, and no dependent column.
  std::vector<std::optional<LinearFit>> fits() const;

 private:
  /// Brings the pending rows into the triangle.
  static void reduce(Eigen::MatrixXd& triangle, Eigen::MatrixXd pending);
  /// The triangle of all rows so far.
  Eigen::MatrixXd triangle() const;

  Eigen::Index factors_ = 0;
  Eigen::Index responses_ = 0;
  std::size_t rows_ = 0;
  Eigen::VectorXd first_;     ///< Responses of the first row, which are subtracted from all others.
  Eigen::VectorXd largest_;   ///< Largest magnitudes of the responses.
  Eigen::MatrixXd triangle_;  ///< R of [1 X Y] = Q R, for all rows except the pending ones.
  Eigen::MatrixXd pending_;
  Eigen::Index pending_rows_ = 0;
};

/// Fits with the study's factors, ranked, or the reason why there are none.
ResponseSurfaces response_surfaces(const LinearRegression& regression, const std::vector<NormalisedFactor>& factors,
                                   const Study& study);

/// An estimate and the half width of its 95 % confidence interval.
struct Estimate {
  double value = 0.0;
  std::optional<double> half_width;  ///< Absent if there are too few samples.
};

/// Sobol indices of one response to one factor: shares of the response's variance.
struct FactorIndices {
  std::size_t factor = 0;  ///< Index among the study's factors.
  Estimate first;          ///< S_i, due to the factor alone.
  Estimate total;          ///< S_Ti, due to the factor alone and with others.
};

/// Sobol indices of one response.
struct ResponseIndices {
  std::size_t samples = 0;   ///< Number of samples in the estimate.
  std::size_t left_out = 0;  ///< Samples in which a design has no number.
  double variance = 0.0;     ///< Variance of the response, in its unit squared.
  /// Indices, the largest total one first; empty if the response does not vary.
  std::vector<FactorIndices> factors;
};

/// Estimates the indices of a function of d independent factors from samples of d + 2 values: f_A
/// and f_B at two independent points, f_i at point A with factor i from point B. Saltelli et al.
/// 2010, Comput. Phys. Commun. 181, table 2: formulas (b) with f_B counted from its mean, and (f)
/// of Jansen,
///
///     S_i = cov(f_B, f_i - f_A) / V,   S_Ti = <(f_A - f_i)^2> / (2 V),
///
/// with V the variance of all f_A and f_B. Consecutive samples make up to 32 batches; leaving out
/// one after the other (jackknife) gives the standard error, Student's t the interval. The points
/// of a quasi-random sequence are spread more evenly in the whole than in its batches, so that
/// intervals are wider than necessary, not narrower.
class VarianceIndices {
 public:
  /// `samples`: number of samples to come, failed ones included.
  VarianceIndices(std::size_t factors, std::size_t samples);

  /// Adds the next sample: f_A, f_B, f_1 .. f_d. It is counted as left out unless all are finite.
  void add(std::span<const double> values);

  ResponseIndices result() const;

 private:
  /// Sums over samples of values minus f_A of the first one. D_i = f_i - f_A.
  struct Sums {
    double samples = 0.0;
    double a = 0.0, b = 0.0;    ///< f_A, f_B
    double aa = 0.0, bb = 0.0;  ///< f_A^2, f_B^2
    Eigen::ArrayXd d, bd, dd;   ///< D_i, f_B D_i, D_i^2

    void add(const Sums& other, double sign);
    double variance() const;
    double first(Eigen::Index factor) const;
    double total(Eigen::Index factor) const;
  };

  Sums empty() const;
  Estimate estimate(const Sums& all, double (Sums::*index)(Eigen::Index) const, Eigen::Index factor) const;

  std::size_t factors_ = 0;
  std::size_t samples_ = 0;
  std::size_t next_ = 0;
  std::size_t left_out_ = 0;
  std::optional<double> origin_;
  double largest_ = 0.0;  ///< Largest magnitude of a value.
  std::vector<Sums> batches_;
};

/// Finds the factors that no response follows, from designs that differ in one factor alone: each value against the
/// file's (`one_at_a_time`), the values of a line of a `grid`, and the pairs of `sobol_indices`. Other plans have no
/// such designs and report no factor.
///
/// The rows of a grid are not stored. For each factor a sum over all designs is: the row's hash, times a random number
/// for the values of the other factors, times a weight for the factor's own value, the weights adding up to 0. The sum
/// is 0 if the rows of each line are equal, and by chance once in 2^64.
class FollowedFactors {
 public:
  explicit FollowedFactors(const Study& study);

  /// Adds the responses of the next design, NaN if there are none.
  void add(std::span<const double> row, std::size_t design);

  /// Indices of the factors over whose values every response was equal bit by bit.
  std::vector<std::size_t> idle() const;

 private:
  /// Findings on one factor.
  struct Seen {
    bool varies = false;
    bool compared = false;  ///< Whether a design with numbers was compared.
    bool followed = false;
    std::uint64_t sum = 0;  ///< The sum above, for a grid.
    std::uint64_t last_weight = 0;
  };
  /// Compares a row with the reference.
  void compare(Seen& seen, std::span<const double> row) const;
  void add_to_grid(std::span<const double> row, std::size_t design);

  Study study_;
  std::vector<Seen> seen_;
  std::vector<double> reference_;  ///< The row from which others differ in one factor.
};

/// Idle factors of plans that draw all factors at once, from designs with the smallest and the largest value drawn of a
/// factor, all others as in the file, then as in design 1. Factors with a tenth of the effects on a response, by
/// `surfaces`, are not tried.
std::vector<std::size_t> idle_drawn_factors(
    const Study& study, const ResponseSurfaces* surfaces,
    const std::function<RowBlock(const std::vector<std::vector<Draw>>&)>& evaluate);

}  // namespace prs
