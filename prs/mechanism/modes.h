#pragma once

#include "prs/mechanism/travel.h"

namespace prs {

/// What vibrates: a mechanism at its equilibrium, with masses.
struct Vibrating {
  const FullModel& model;
  const FullDistribution& loads;  ///< Loads with Detail::complete.
  const Mechanism& mechanism;
  const Structure& structure;
  const Materials& materials;  ///< All with density.
  double slip_ratio = 0.0;     ///< Slip ratio of the rollers that a drive turns.
};

/// A natural mode; shares add up to 1.
struct Mode {
  double frequency = 0.0;          ///< [Hz]
  Eigen::Vector3d effective_mass;  ///< Along x, y, z [kg].
  PerPart<double> kinetic;         ///< Shares of the kinetic energy in the parts,
  double kinetic_of_masses = 0.0;  ///< and in masses and drive.
  PerPart<double> strain;          ///< Shares of the strain energy, screw with torsion.
  PerInterface<double> contact_strain;
  double support_strain = 0.0;
  double prestress = 0.0;                                ///< < 0 in compression.
  PerInterface<std::vector<std::vector<double>>> shape;  ///< x, y, z of each node; screw, nut.
  std::vector<double> axial, radial;                     ///< Motion of the middle of each roller; missing and idle: 0.
};

struct ModesResult {
  std::string left_out;                            ///< Why there are none.
  Eigen::Vector3d mass = Eigen::Vector3d::Zero();  ///< Along x, y, z [kg].
  int freedoms = 0;
  std::vector<int> idle_rollers;  ///< From 1; they have no part in it.
  bool prestressed = false;
  int buckled = 0;  ///< Modes that grow, left out.
  std::vector<MotionOrder> orders;
  PerInterface<std::vector<double>> x;  ///< Positions of the nodes of screw and nut [m].
  std::vector<Mode> modes;              ///< By frequency.

  /// At positions of the travel.
  struct AlongTravel {
    std::vector<double> angle;                   ///< Theta [rad].
    std::vector<std::vector<double>> frequency;  ///< [Hz]
  };
  std::optional<AlongTravel> along_travel;
  std::string along_travel_left_out;  ///< Why not, where it was wanted.
};

/// The lowest modes of small vibration about the equilibrium: K phi = omega^2 M phi, K with the
/// tangents of the contacts, by Lanczos' method (Spectra) on M phi = omega^-2 K phi.
ModesResult modes(const Vibrating& v, const Modes& wanted);

}  // namespace prs
