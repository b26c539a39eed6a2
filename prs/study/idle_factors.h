#pragma once

#include <functional>

#include "prs/study/designs.h"
#include "prs/study/sensitivity.h"

namespace prs {

/// Tells which factors no response follows, from designs that differ in one factor alone: each
/// value against the file's (`one_at_a_time`), the values of a line of a `grid`, and the pairs of
/// `sobol_indices`. Other plans have no such designs and report no factor.
///
/// The rows of a grid are not stored. For each factor a sum over all designs is: the row's hash,
/// times a random number for the values of the other factors, times a weight for the factor's own
/// value, the weights adding up to 0. The sum is 0 where the rows of each line are equal, and by
/// chance once in 2^64.
class FollowedFactors {
 public:
  explicit FollowedFactors(const Study& study);

  /// The responses of the next design, NaN where there is none.
  void add(std::span<const double> row, std::size_t design);

  /// Indices of the factors over whose values every response stayed the same to the last bit.
  std::vector<std::size_t> idle() const;

 private:
  /// What was seen of one factor.
  struct Seen {
    bool varies = false;
    bool compared = false;  ///< A design that has numbers.
    bool followed = false;
    std::uint64_t sum = 0;  ///< The sum above, for a grid.
    std::uint64_t last_weight = 0;
  };
  /// Compares a row with the reference.
  void compare(Seen& seen, std::span<const double> row) const;
  void add_to_grid(std::span<const double> row, std::size_t design);

  Study study_;
  std::vector<Seen> seen_;
  std::vector<double> reference_;  ///< The row that others differ from in one factor.
};

/// Idle factors of plans that draw all factors at once, from designs with the least and the largest
/// value drawn of a factor, all others as in the file, then as in design 1. Factors with a
/// tenth of the effects on a response, by `surfaces`, are not tried.
std::vector<std::size_t> idle_drawn_factors(
    const Study& study, const ResponseSurfaces* surfaces,
    const std::function<RowBlock(const std::vector<std::vector<Draw>>&)>& evaluate);

}  // namespace prs
