#pragma once

#include "modules/estimation/normal.h"

namespace modules::fit {

/// A search for the least objective, and where it has come.
struct Search {
  const Model& model;
  Differences& function;
  VectorXd z;
  Spread spread;
  std::optional<Index> held = {};  ///< An unknown that stays; then deviations stay, too.
  std::size_t iterations = 0;
  std::optional<Failure> failure = {};  ///< Row without an answer, for which the search failed or took back steps.
};

/// Looks for the least objective from its place on, deviations with it.
Status run(Search& search);

/// Does what `run` does, from near the minimum: Ceres' search where Newton's steps alone lead nowhere. Returns the
/// length of the step that is left, in standard deviations; none where it did not come to rest.
std::optional<double> settle_near(Search& search);

}  // namespace modules::fit
