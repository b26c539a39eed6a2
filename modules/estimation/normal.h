#pragma once

#include "modules/estimation/differences.h"
#include "modules/estimation/statistics.h"

namespace modules::fit {

constexpr double kLeastSlope = 0.05;  ///< Least slope of a loss, as a mean over its curve.

/// The normal equations at a state.
struct Normal {
  std::vector<Weighed> curves;
  MatrixXd matrix;    ///< A
  VectorXd gradient;  ///< dS/dz over 2
  double objective = 0.0;
  std::vector<Index> free = {};
  MatrixXd inverse = {};
};

/// The loss of each residual of a fitted curve, over its deviation.
Robust robust_at(const Model& model, const State& state, std::size_t curve, const Spread& spread);
double objective(const Model& model, const State& state, const Spread& spread);

/// `held`: an unknown that stays.
Normal normal_at(const Model& model, const State& state, const Spread& spread, std::optional<Index> held = {});
/// Inverts the matrix over these unknowns; the redundancies follow.
void invert(Normal& normal, const Model& model, std::vector<Index> free);

/// -1 or 1: at its lower or upper bound, and beyond it the objective would be less.
int pushed_out(const Model& model, const VectorXd& z, const VectorXd& gradient, Index j);

/// Newton's step and its length in standard deviations.
struct Step {
  VectorXd z;
  double norm = 0.0;
};
Step newton_step(const Normal& normal);
/// Newton's step; what would leave its bounds stops there, and the others allow for that.
VectorXd step_within_bounds(const Model& model, const Normal& normal, const VectorXd& z);

/// Estimates deviations at a state; returns their largest relative change.
double set_spread(const Model& model, const State& state, Spread& spread);
constexpr double kSpreadSettled = 1e-8;  ///< Relative change of a deviation that no longer counts.

}  // namespace modules::fit
