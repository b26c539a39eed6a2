#pragma once

#include "prs/mechanism/full_distribution.h"

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
  /// The first position without equilibrium; nothing else is then known.
  struct Failure {
    double carrier_angle = 0.0;  ///< [rad]
    std::string why;             ///< What the solver says, in words.
  };
  std::optional<Failure> failure;
  bool converged() const { return !failure; }

  int steps = 0;      ///< Positions for each spacing of the rollers.
  int positions = 0;  ///< Of the whole turn.
  double exponent = 0.0;
  std::vector<double> carrier_angle;  ///< Of each position [rad].
  PerInterface<OrbitLoads> loads;
  std::vector<double> axial_displacement;  ///< At the positions that differ [m].
  double axial_error = 0.0;                ///< Peak to peak [m].
};

/// Which positions of the carrier have loads of their own.
struct OrbitSymmetry {
  bool alike = false;  ///< All rollers are: one spacing is solved, the rest is a permutation.
  bool round = false;  ///< Nothing but the rollers has an azimuth: one position is solved.
};

/// The carrier at carrier_angle + 2 pi m/(steps N), m < steps N. `model` makes the mechanism at a
/// carrier angle.
Orbit orbit(const std::function<FullModel(double)>& model,
            const std::function<FullDistribution(const FullModel&)>& solver,
            const SpatialLoad::Orbit& wanted, double carrier_angle, OrbitSymmetry symmetry);

}  // namespace prs
