#pragma once

#include "prs/model/study.h"

namespace prs {

/// A factor of a grid as an axis of its maps, numbers ascending.
struct MapAxis {
  std::size_t factor = 0;           ///< Index among the study's factors.
  std::vector<std::size_t> levels;  ///< Indices of the factor's levels, one per node.
  std::vector<double> numbers;      ///< Numbers of the levels, in the factor's unit.
  bool logarithmic = false;         ///< Equidistant in their logarithm.
  /// Whether factor and companions have values between two nodes: quantities, not words or whole
  /// numbers.
  bool continuous = false;

  std::size_t nodes() const { return numbers.size(); }
  /// The factor's number at a place from 0, the first node, to nodes - 1: linear between two nodes,
  /// or linear in the logarithm.
  double number(double place) const;
  /// The place of a number; absent outside of the nodes.
  std::optional<double> place(double number) const;
};

/// A place on one axis: a node and the share of the way to the next one.
struct Between {
  std::size_t node = 0;
  double share = 0.0;
};
Between between(double place, std::size_t nodes);

/// From one number to another, linear, or linear in the logarithm.
double interpolated(double from, double to, double share, bool logarithmic);

/// The axes of the maps of a study: a grid over two factors of at least two different numbers each.
/// Absent for any other study.
std::optional<std::array<MapAxis, 2>> map_axes(const Study& study);

}  // namespace prs
