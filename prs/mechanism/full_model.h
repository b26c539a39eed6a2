#pragma once

#include "prs/mechanism/nut_harmonics.h"
#include "prs/sector/roller_push.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// Values by roller and thread; missing rollers have their place.
using RollerThreads = std::vector<std::vector<double>>;

/// A uniform length of screw, nut or roller.
struct BodyPiece {
  double from = 0.0, to = 0.0;  ///< x [m]
  RollerSection<double> section;
};

/// The wall of the whole nut in place of its bars.
struct NutWall {
  NutLine line;                        ///< With the contacts of all rollers.
  NutShell shell;                      ///< Round.
  std::vector<NutHarmonic> harmonics;  ///< Out of round.
};

/// All rollers on a spatial screw and nut as numbers, all that the solver reads. x along the axis
/// from the nut's end that faces the screw's loaded end; roller j stands at the azimuth phi_j from
/// y towards z. SI units.
struct FullModel {
  struct Roller {
    int number = 0;                          ///< From 0.
    double azimuth = 0.0;                    ///< phi_j [rad]
    std::vector<double> contact_x;           ///< [m]
    PerInterface<std::vector<double>> gaps;  ///< Along the normals [m].
    std::array<double, 2> ring_offset{};     ///< delta, outwards, near and far [m].
  };
  struct Ends {
    double first = 0.0, last = 0.0;  ///< x [m]
  };

  SectorModel sector;  ///< One roller's share: laws, sense, pitch, sections of the rollers.
  double centre_distance = 0.0;  ///< a [m]
  int rollers = 0;               ///< Missing ones included.
  std::vector<Roller> present;
  std::vector<BodyPiece> screw, nut;  ///< Along x, without gaps between them; at least one.
  std::optional<NutWall> nut_wall;    ///< Of refined bodies.
  double loaded_section = 0.0;        ///< x_L [m]
  double thrust = 0.0;                ///< x of the held section of the nut [m].
  Ends roller_ends;                   ///< Outer faces of the rollers' ends.

  Rings::Carrier carrier = Rings::Carrier::nut;
  double ring_stiffness = kRigid;  ///< [N/m]; below `kRigid` the rings float.
  Housing housing;
  std::vector<Bearing> bearings;
  double axial_force = 0.0;  ///< F > 0 [N]
  SpatialLoad load;
  std::vector<RollerPush> push;  ///< On each roller present, where the screw runs.

  double sense() const { return sector.sense; }
  /// What the contacts do not feel of the displacement along the load [m/N].
  double offset_compliance() const { return sector.offset_compliance / rollers; }
  int threads() const { return sector.contacts(); }
  bool floating_rings() const { return ring_stiffness < kRigid; }
};

/// The mechanism under one load case. The case must have passed `check_case`. Gaps are those of
/// `initial_gaps`, with the index errors, eccentricities and deviations of each roller, less the
/// smallest of each interface over all rollers present.
FullModel full_model(const Mechanism& mechanism, const Structure& structure,
                     const Materials& materials, const ModelOptions& options,
                     const PerInterface<ContactLaw>& laws, const LoadCase& load_case,
                     const Deviations& deviations);

}  // namespace prs
