#pragma once

#include "prs/mechanism/travel.h"

namespace prs {

/// A vibrating mechanism at its equilibrium, with masses.
struct Vibrating {
  const FullModel& model;
  const FullDistribution& loads;  ///< Loads with Detail::complete.
  const Mechanism& mechanism;
  const Structure& structure;
  const Materials& materials;  ///< Materials, all with density.
  double slip_ratio = 0.0;     ///< Slip ratio of the rollers, with a drive.
};

/// A natural mode; its shares add up to 1.
struct Mode {
  double frequency = 0.0;          ///< [Hz]
  Eigen::Vector3d effective_mass;  ///< Effective mass along x, y, z [kg].
  PerPart<double> kinetic;         ///< Shares of the parts in the kinetic energy.
  double kinetic_of_masses = 0.0;  ///< Share of masses and drive.
  PerPart<double> strain;          ///< Shares of the parts in the strain energy, screw with torsion.
  PerInterface<double> contact_strain;
  double support_strain = 0.0;
  double prestress = 0.0;                                ///< Share of the prestress, < 0 in compression.
  PerInterface<std::vector<std::vector<double>>> shape;  ///< x, y, z of each node; screw, nut.
  std::vector<double> axial, radial;  ///< Motion of the middle of each roller; missing and idle ones: 0.
};

struct ModesResult {
  std::string left_out;                            ///< Reason why there are none.
  Eigen::Vector3d mass = Eigen::Vector3d::Zero();  ///< Mass along x, y, z [kg].
  int freedoms = 0;
  std::vector<int> idle_rollers;  ///< Numbers, from 1, of idle rollers, which do not take part.
  bool prestressed = false;
  int buckled = 0;  ///< Number of unstable modes, which are left out.
  std::vector<MotionOrder> orders;
  PerInterface<std::vector<double>> x;  ///< Positions of the nodes of screw and nut [m].
  std::vector<Mode> modes;              ///< Modes, sorted by frequency.

  /// Frequencies at positions of the travel.
  struct AlongTravel {
    std::vector<double> angle;                   ///< Theta [rad].
    std::vector<std::vector<double>> frequency;  ///< [Hz]
  };
  std::optional<AlongTravel> along_travel;
  std::string along_travel_left_out;  ///< Reason why they are missing, if they were requested.
};

/// The lowest modes of small vibration about the equilibrium: K phi = omega^2 M phi, K with the
/// tangents of the contacts, by Lanczos' method (Spectra) on M phi = omega^-2 K phi.
ModesResult modes(const Vibrating& v, const Modes& wanted);

}  // namespace prs
