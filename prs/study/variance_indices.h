#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace prs {

/// An estimate and the half width of its 95 % confidence interval.
struct Estimate {
  double value = 0.0;
  std::optional<double> half_width;  ///< Absent where the samples are too few to tell.
};

/// Sobol indices of one response to one factor: shares of the response's variance.
struct FactorIndices {
  std::size_t factor = 0;  ///< Index among the study's factors.
  Estimate first;          ///< S_i, due to the factor alone.
  Estimate total;          ///< S_Ti, due to the factor alone and with others.
};

/// Sobol indices of one response.
struct ResponseIndices {
  std::size_t samples = 0;   ///< Samples in the estimate.
  std::size_t left_out = 0;  ///< Samples with a design without a number for it.
  double variance = 0.0;     ///< Variance of the response, in its unit squared.
  /// The largest total index first; empty where the response does not vary.
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
  /// The number of samples to come, failed ones included.
  VarianceIndices(std::size_t factors, std::size_t samples);

  /// The next sample: f_A, f_B, f_1 .. f_d. Left out and counted unless all are finite.
  void add(std::span<const double> values);

  ResponseIndices result() const;

 private:
  /// Sums over samples, of values counted from f_A of the first one. D_i = f_i - f_A.
  struct Sums {
    double samples = 0.0;
    double a = 0.0, b = 0.0;        ///< f_A, f_B
    double aa = 0.0, bb = 0.0;      ///< f_A^2, f_B^2
    std::vector<double> d, bd, dd;  ///< D_i, f_B D_i, D_i^2

    void add(const Sums& other, double sign);
    double variance() const;
    double first(std::size_t factor) const;
    double total(std::size_t factor) const;
  };

  Sums empty() const;
  Estimate estimate(const Sums& all, double (Sums::*index)(std::size_t) const,
                    std::size_t factor) const;

  std::size_t factors_ = 0;
  std::size_t samples_ = 0;
  std::size_t next_ = 0;
  std::size_t left_out_ = 0;
  std::optional<double> origin_;
  double largest_ = 0.0;  ///< Largest magnitude of a value.
  std::vector<Sums> batches_;
};

}  // namespace prs
