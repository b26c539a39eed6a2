#include "modules/estimation/profile.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace modules::fit {
namespace {

constexpr double kAtEnd = 1e-5;  // Tolerance of the profile's height above its target, in standard deviations.
constexpr double kFirst = 1.05;  // First place to look at, over where a straight profile ends.
constexpr int kMostPlaces = 30;

/// The objective where an unknown is held, the others following.
struct Profile {
  Search search;
  const Normal& least;
  double target = 0.0;  ///< sqrt(S_p - S) at an end.

  /// sqrt(S_p - S) less the target: nearly straight. Throws std::domain_error where there is none.
  double operator()(double z) {
    const Index j = *search.held;
    std::vector<Index> others = least.free;  // Unknowns that follow along the last direction.
    std::erase(others, j);
    const VectorXd step = -(inverse(least.matrix, others) * least.matrix.col(j)) * (z - search.z[j]);
    search.z = search.model.moved(search.z, step);
    search.z[j] = z;
    const std::optional<double> norm = settle_near(search);
    if (!norm) throw std::domain_error("no profile");
    const StatePtr state = search.function.with_slopes(search.z);
    const double rise = objective(search.model, *state, search.spread) - *norm * *norm - least.objective;
    return std::sqrt(std::max(0.0, rise)) - target;
  }
};

/// End of the profile on a side of the middle, and whether it lies beyond a bound.
struct End {
  std::optional<double> z = {};
  bool is_beyond = false;
};
End end_of(Profile& profile, double deviation, double sense) {
  const Search& search = profile.search;
  const double middle = search.z[*search.held], edge = sense < 0.0 ? middle : 1.0 - middle;
  const bool is_bounded = search.model.unknown(*search.held).is_bounded;
  double z = middle, y = 0.0;
  const auto height = [&](double distance) {
    const bool at_edge = is_bounded && distance >= edge;
    z = middle + sense * (at_edge ? edge : distance);
    y = profile(z);
    if (at_edge && y < 0.0) throw End{.is_beyond = true};
    return y;
  };
  const auto is_end = [&](double, double) { return std::abs(y) <= kAtEnd; };
  std::uintmax_t places = kMostPlaces;
  try {
    double inside = 0.0, below = -profile.target, outside = kFirst * profile.target * deviation;
    double above = height(outside);
    for (int k = 0; k < kMostPlaces && above < 0.0; ++k) {
      inside = outside, below = above;
      above = height(outside *= kFirst);
    }
    boost::math::tools::toms748_solve(height, inside, outside, below, above, is_end, places);
  } catch (const End& end) {
    return end;
  } catch (const std::exception&) {  // No answer, or no bracket.
    return {};
  }
  return {.z = is_end(0.0, 0.0) ? std::optional(z) : std::nullopt};
}

}  // namespace

void set_profile(Search& search, const Normal& least, const Covariance& covariance, Index j, UnknownResult& result) {
  const double full = covariance.full(j, j), first = covariance.first(j, j);
  const double t = quantile(search.model.problem.level, result.estimate->degrees_of_freedom);
  for (const double sense : {-1.0, 1.0}) {
    Profile profile{search, least, t * std::sqrt(full / first)};
    profile.search.held = j;
    const End end = end_of(profile, std::sqrt(first), sense);
    if (end.z) (sense < 0.0 ? result.profile_low : result.profile_high) = search.model.value(j, *end.z);
    result.profile_failed = result.profile_failed || (!end.z && !end.is_beyond);
    search.iterations = profile.search.iterations;
  }
}

}  // namespace modules::fit
