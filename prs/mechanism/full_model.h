#pragma once

#include "fe/shell.h"
#include "prs/sector/sector_model.h"
#include "prs/threads/motion_orders.h"

namespace prs {

/// The nut's wall as it goes out of round, w(x) cos(n phi) and w(x) sin(n phi) alike.
struct NutHarmonic {
  int order = 2;                          ///< n
  std::vector<fe::ShellMatrix> segments;  ///< Segments of the whole nut, between the nodes of its line.
};

/// Harmonics up to this one: the wall of the screw of lesson 1 dies out over a fifth of its radius
/// beyond.
inline constexpr int kHighestNutHarmonic = 5;

/// Those of n = 2 .. `highest` that equal rollers do not excite, no multiples of their number: what
/// those do is in the sector's model. The ends of the nut, its flanges and its thrust section move
/// freely in them.
std::vector<NutHarmonic> nut_harmonics(const NutLine& line, const NutBore& bore, const Material& material, int rollers,
                                       int highest = kHighestNutHarmonic);

/// Values by roller and thread; missing rollers have their place.
using RollerThreads = std::vector<std::vector<double>>;

/// A uniform length of screw, nut or roller.
struct BodyPiece {
  double from = 0.0, to = 0.0;  ///< x [m]
  RollerSection<double> section;
};

/// The wall of the whole nut in place of its bars.
struct NutWall {
  NutLine line;                        ///< Line with the contacts of all rollers.
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

  SectorModel sector;                 ///< One roller's share: laws, sense, pitch, sections of the rollers.
  PerInterface<double> smallest_gap;  ///< What was taken off the gaps [m].
  double centre_distance = 0.0;       ///< a [m]
  int rollers = 0;                    ///< Missing ones included.
  std::vector<Roller> present;
  std::vector<BodyPiece> screw, nut;  ///< Along x, without gaps between them; at least one.
  std::optional<NutWall> nut_wall;    ///< Wall of refined bodies.
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

/// How far the parts have turned from where the file states them, and travelled [rad].
struct Turn {
  double screw = 0.0, nut = 0.0;
  double carrier = 0.0;
  double travel = 0.0;  ///< Travel of the screw against the nut, along x [m].

  /// Turn of the part to which gears tie the rollers, by the starts.
  double geared(Mechanism::Type type) const { return type == Mechanism::Type::standard ? nut : screw; }
};

/// The turn when the screw has turned by theta against the nut: one of both turns, the carrier by the slip
/// ratio.
Turn turn_of(const Mechanism& mechanism, const Travel& travel, double theta);

/// The turn of a load case: that of its travel's start.
Turn turn_of(const Mechanism& mechanism, const LoadCase& load_case);

/// The mechanism under one load case. The case must have passed `check_case`. Gaps are those of
/// `initial_gaps`, with the index errors, eccentricities and deviations of each roller, less the
/// smallest of each interface over all rollers present.
FullModel full_model(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws, const LoadCase& load_case,
                     const Deviations& deviations, const Turn& turn);
/// Turned as the load case has it.
inline FullModel full_model(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                            const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                            const LoadCase& load_case, const Deviations& deviations) {
  return full_model(mechanism, structure, materials, options, laws, load_case, deviations,
                    turn_of(mechanism, load_case));
}

/// The same seen from axes that have turned by `angle` from y towards z, for parts that stand
/// around the axis alike.
void turn_axes(FullModel& model, double angle);

}  // namespace prs
