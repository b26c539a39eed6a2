#pragma once

#include "fe/shell.h"
#include "prs/sector/sector_model.h"
#include "prs/threads/motion_orders.h"

namespace prs {

/// Out-of-round deformation of the nut's wall, with equal stiffness for w(x) cos(n phi) and w(x) sin(n phi).
struct NutHarmonic {
  int order = 2;                          ///< n
  std::vector<fe::ShellMatrix> segments;  ///< Segments of the whole nut, between the nodes of its line.
};

/// Highest harmonic computed: beyond, deformations of the wall of the screw of lesson 1 decay within a fifth of its
/// radius.
inline constexpr int kHighestNutHarmonic = 5;

/// Harmonics 2 to `highest` that identical rollers do not excite; multiples of their number are in the sector's model.
/// The ends of the nut, its flanges and its thrust section move freely in them.
std::vector<NutHarmonic> nut_harmonics(const NutLine& line, const NutBore& bore, const Material& material, int rollers,
                                       int highest = kHighestNutHarmonic);

/// Values by roller and thread; missing rollers have entries.
using RollerThreads = std::vector<std::vector<double>>;

/// A uniform length of screw, nut or roller.
struct BodyPiece {
  double from = 0.0, to = 0.0;  ///< x [m]
  RollerSection<double> section;
};

/// The wall of the whole nut in place of its bars.
struct NutWall {
  NutLine line;                        ///< Line with the contacts of all rollers.
  NutShell shell;                      ///< Axisymmetric deformation.
  std::vector<NutHarmonic> harmonics;  ///< Out-of-round deformations.
};

/// All rollers on a spatial screw and nut as numbers: all that the solver reads. x along the axis from the nut's end
/// that faces the screw's loaded end; roller j is at the azimuth phi_j from y towards z. SI units.
struct FullModel {
  struct Roller {
    int number = 0;                          ///< Index of the roller.
    double azimuth = 0.0;                    ///< phi_j [rad]
    std::vector<double> contact_x;           ///< [m]
    PerInterface<std::vector<double>> gaps;  ///< Gaps along the normals [m].
    std::array<double, 2> ring_offset{};     ///< delta, outward offset of the near and the far end [m].
  };
  struct Ends {
    double first = 0.0, last = 0.0;  ///< x [m]
  };

  SectorModel sector;                 ///< One roller's share: laws, sense, pitch, sections of the rollers.
  PerInterface<double> smallest_gap;  ///< Value subtracted from the gaps [m].
  double centre_distance = 0.0;       ///< a [m]
  int rollers = 0;                    ///< Number of rollers, missing ones included.
  std::vector<Roller> present;
  std::vector<BodyPiece> screw, nut;  ///< Pieces along x, without gaps between them; at least one.
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
  std::vector<RollerPush> push;  ///< Push on each present roller, if the screw runs.

  double sense() const { return sector.sense; }
  /// Displacement along the load that does not act on the contacts, per force [m/N].
  double offset_compliance() const { return sector.offset_compliance / rollers; }
  int threads() const { return sector.contacts(); }
  bool floating_rings() const { return ring_stiffness < kRigid; }
};

/// Turns of the parts from the positions that the file states, and travel [rad].
struct Turn {
  double screw = 0.0, nut = 0.0;
  double carrier = 0.0;
  double travel = 0.0;  ///< Travel of the screw against the nut, along x [m].

  /// Turn of the part with which the gears mesh the rollers, by the starts.
  double geared(Mechanism::Type type) const { return carrier_part(type) == Part::nut ? nut : screw; }
};

/// Turns after the screw has turned by theta against the nut: one of both parts turns, the carrier by the slip ratio.
Turn turn_of(const Mechanism& mechanism, const Travel& travel, double theta);

/// Turns of a load case: those at the start of its travel.
Turn turn_of(const Mechanism& mechanism, const LoadCase& load_case);

/// The mechanism under one load case. The case must have passed `check_case`. Gaps are those of `initial_gaps`, with
/// the index errors, eccentricities and deviations of each roller, less the smallest of each interface over all present
/// rollers.
FullModel full_model(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws, const LoadCase& load_case,
                     const Deviations& deviations, const Turn& turn);
/// The mechanism with the turns of the load case.
inline FullModel full_model(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                            const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                            const LoadCase& load_case, const Deviations& deviations) {
  return full_model(mechanism, structure, materials, options, laws, load_case, deviations,
                    turn_of(mechanism, load_case));
}

/// Expresses the model in axes turned by `angle` from y towards z, for parts with rotational symmetry.
void turn_axes(FullModel& model, double angle);

}  // namespace prs
