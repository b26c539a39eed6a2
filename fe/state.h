#pragma once

#include <Eigen/Core>

namespace fe {

/// Displacements as an unevaluated sum head + tail. Stiff elements multiply differences of nearly
/// equal displacements by large numbers; the tail keeps the digits that the head alone would lose,
/// so that equilibrium holds to rounding of the forces and not of the displacements.
struct State {
  Eigen::VectorXd head;
  Eigen::VectorXd tail;

  State() = default;
  State(Eigen::VectorXd q)  // NOLINT: a plain vector is a state without tail
      : head(std::move(q)), tail(Eigen::VectorXd::Zero(head.size())) {}

  /// Displacement i; -1 stands for a freedom that does not move.
  double operator[](int i) const { return i < 0 ? 0.0 : head[i]; }

  /// Compensation of displacement i: the part that rounding took from the head.
  double compensation(int i) const { return i < 0 ? 0.0 : tail[i]; }

  /// Displacement j less displacement i.
  double difference(int i, int j) const {
    if (i < 0 || j < 0) return (*this)[j] - (*this)[i];
    return (head[j] - head[i]) + (tail[j] - tail[i]);
  }

  /// Sets this to from - length * step, the tail taking what the head rounds away.
  void set_to_step(const State& from, double length, const Eigen::VectorXd& step) {
    for (Eigen::Index i = 0; i < step.size(); ++i) {
      const double change = from.tail[i] - length * step[i];
      const double sum = from.head[i] + change;
      const double rounded = sum - from.head[i];
      tail[i] = (from.head[i] - (sum - rounded)) + (change - rounded);
      head[i] = sum;
    }
  }
};

}  // namespace fe
