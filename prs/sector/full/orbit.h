#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "prs/sector/full/full_distribution.h"

namespace prs {

/// What a turn of the carrier does to the threads of each roller.
struct OrbitLoads {
  std::vector<double> first_roller;  ///< Its largest N at each position [N].
  RollerThreads equivalent;          ///< (mean N^exponent)^(1/exponent) [N]
  RollerThreads peak;                ///< Largest N of each contact [N].
  double largest_equivalent = 0.0;   ///< [N]
  double largest = 0.0;              ///< N, of any position [N].
  double least = 0.0;                ///< [N]
  double carrier_angle = 0.0;        ///< At the largest load [rad].
  int roller = 0, thread = 0;        ///< Of the largest load, from 1.
};

struct Orbit {
  int steps = 0;      ///< Positions for each spacing of the rollers.
  int positions = 0;  ///< Of the whole turn.
  double exponent = 0.0;
  std::vector<double> carrier_angle;  ///< Of each position [rad].
  PerInterface<OrbitLoads> loads;
  std::vector<double> axial_displacement;  ///< At the positions that differ [m].
  double axial_error = 0.0;                ///< Peak to peak [m].
};

/// The carrier at carrier_angle + 2 pi m/(steps N), m < steps N. Where all rollers are alike, one
/// spacing is solved and the rest is a permutation. `model` makes the mechanism at a carrier angle.
/// Nothing where a position has no equilibrium.
std::optional<Orbit> orbit(const std::function<FullModel(double)>& model,
                           const std::function<FullDistribution(const FullModel&)>& solver,
                           const SpatialLoad::Orbit& wanted, double carrier_angle, bool alike);

}  // namespace prs
