#pragma once

#include <deque>
#include <memory>

#include "modules/estimation/model.h"

namespace modules::fit {

/// A flag for each curve (rows) and unknown.
using Mask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// d(f + o)/dz of each curve.
struct Slopes {
  std::vector<MatrixXd> by_z;      ///< Empty: a row has no answer on either side.
  MatrixXd change;                 ///< Largest change over the response: a row per curve.
  std::vector<Index> even;         ///< Unknowns about which every curve is even here.
  std::optional<Failure> failure;  ///< The last one, also where the other side had an answer.

  explicit operator bool() const { return !by_z.empty(); }
};

/// Values at one place of the unknowns, and slopes once something needs them.
struct State {
  VectorXd z;
  std::vector<VectorXd> values;            ///< Values of each fitted curve, with its offset.
  Slopes slopes = {};                      ///< Empty until they are needed.
  std::vector<MatrixXd> information = {};  ///< J'J over the squares of stated deviations.
};
using StatePtr = std::shared_ptr<State>;

/// The function of a problem with its derivatives by differences. Remembers the last states, which
/// curves each unknown moves, and the steps.
class Differences {
 public:
  explicit Differences(const Model& model);

  /// Null where the function has no answer.
  StatePtr at(const VectorXd& z);
  StatePtr with_slopes(const VectorXd& z);
  /// Slopes of the curves that have values, by the unknowns of the mask.
  Slopes slopes(const VectorXd& z, const std::vector<VectorXd>& values, const Mask& wanted) const;

  /// Takes from a state which curves each unknown moves; returns one that moves none.
  std::optional<std::size_t> look_at(const State& state);
  /// Whether an unknown moves a curve here that it moved nowhere before: what a curve feels only
  /// beyond a threshold counts from then on.
  bool reaches_more(const VectorXd& z);
  /// Whether the step of an unknown near an end of its bounds, which may be wide, had to shrink: where a
  /// quarter of it has slopes that differ by more than a hundredth.
  bool takes_smaller_steps(const VectorXd& z, const Spread& spread);

  std::optional<Failure> failure;  ///< Last one since it was reset.

 private:
  const Model& model_;
  Mask fitted_, reached_;  ///< Fitted curves; of them what the unknowns move.
  VectorXd looked_at_;     ///< Place at which slopes of all curves were taken last.
  VectorXd step_;          ///< Step of differences in z.
  std::deque<StatePtr> known_;
};

}  // namespace modules::fit
