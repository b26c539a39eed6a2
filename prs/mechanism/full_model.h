#pragma once

#include "fe/model.h"
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

/// A node of screw or nut at x: (u, y, y') and (-, z, z') as two plane nodes. The wall of a nut has
/// u, its radial displacement and tilt of its own, and those of its harmonics.
struct SpatialNode {
  double x = 0.0;
  int y_plane = 0;
  int z_plane = 0;
  int axial = 0;  ///< Node whose u it is: `y_plane`, or that of the wall.
  int wall = -1;  ///< (u, v, theta) of the wall; those of its harmonics follow. -1: none.
};

/// The full mechanism as a structure of beams, springs and constraints. Displacements are counted
/// from the rigid motion that takes the whole mechanism with the seat of the nut.
struct FullStructure {
  struct Roller {
    std::vector<int> nodes;                   ///< Along x.
    std::vector<double> x;                    ///< Theirs [m].
    PerInterface<std::vector<int>> contacts;  ///< Node of each thread.
    std::array<std::vector<int>, 2> guided;   ///< Nodes that the near and the far ring guide.
    int first_spring = 0;                     ///< First spring of the screw's contacts; those at the nut follow.

    int spring(Interface i, std::size_t thread) const {
      return first_spring + static_cast<int>(thread + (i == Interface::screw ? 0 : contacts.screw.size()));
    }
  };
  /// A constraint, an elastic link or two stops by which a ring guides a roller.
  struct Guide {
    std::size_t roller = 0;  ///< Index into FullModel::present.
    std::size_t ring = 0;    ///< 0 near, 1 far.
    double x = 0.0;          ///< Position at which it acts [m].
    int constraint = -1;
    int link = -1;
    int stop = -1;  ///< Spring of the stop outwards, whose approach is v against the ring; that inwards follows.
  };
  /// What holds a freedom: a constraint or an elastic link, or nothing.
  struct Held {
    int node = 0;
    fe::Dof dof = fe::Dof::u;
    int constraint = -1;
    int link = -1;
  };
  /// A bearing, or the seat of the nut.
  struct Support {
    double x = 0.0;
    Held u, y, z, y_slope, z_slope;
  };

  fe::Model model;
  std::vector<SpatialNode> screw, nut;
  std::vector<Roller> rollers;  ///< Those of FullModel::present.
  std::vector<Guide> guides;
  std::array<int, 2> rings{-1, -1};           ///< (-, y, z as u and v) of floating rings.
  std::array<const SpatialNode*, 2> seats{};  ///< Seats of the rings on screw or nut; null: housing.
  Support housing;
  std::vector<Support> bearings;  ///< As FullModel::bearings; several may hold one freedom.
  int loaded = 0;                 ///< In `screw`.
  std::vector<fe::NodalLoad> loads;
  std::vector<std::vector<fe::NodalLoad>> per_force;  ///< Loads per force of each spring.

  FullStructure() = default;
  FullStructure(FullStructure&&) = default;
  FullStructure& operator=(FullStructure&&) = default;
};

/// Displacement at x of the rigid motion that is taken out, across the axis [m].
Lateral rigid_offset(const FullModel& model, double x);
/// Its slopes y' and z' [rad].
Lateral rigid_slope(const FullModel& model);

/// Stations that a structure has besides those that its loads and supports need.
struct FullMesh {
  std::vector<double> screw, nut;  ///< x [m]
  double longest = 0.0;            ///< Longer pieces of screw and nut are divided evenly [m].
};

/// The structure; with a mesh, nodes of screw and nut that lie closer than `kNearNodes` are not joined by a beam
/// whose stiffness would drown the rest: one follows the other, and what a beam between them gives
/// way by is a freedom of its own.
FullStructure full_structure(const FullModel& model, const std::optional<FullMesh>& mesh = {});
inline constexpr double kNearNodes = 2e-4;  // [m]

/// The section of a body at x.
const RollerSection<double>& section_at(const std::vector<BodyPiece>& pieces, double x);

/// Motions of rigid parts that nothing resists: no contact, guide, bearing or spring.
struct FreeMotions {
  int count = 0;
  std::vector<std::string> parts;  ///< Those that move: screw, ring, roller 3.
};

/// The rows of contacts, constraints and springs over the rigid motions of the screw, of each
/// roller and of each floating ring, each row scaled to one and rotations taken in 1/r_R; the
/// motions are those of singular values below 1e-9 of the largest. `closed` tells which contacts
/// and stops count, all where it is empty.
FreeMotions free_motions(const FullModel& model, const FullStructure& structure, const std::vector<bool>& closed = {});

/// What no forces of contacts, which only push, and of guides, bearings and springs, which do both,
/// can take of the loads on the rigid parts: the smallest by least squares, moments over r_R, as a
/// share of the axial force. 0 where an equilibrium exists (Farkas).
double load_left(const FullModel& model, const FullStructure& structure);

/// The axial force from which on the rest of the load is held [N], up to a thousand times the given
/// one; absent where none holds it.
std::optional<double> holding_force(const FullModel& model);

/// What to tell of a mechanism and of a load that nothing holds.
std::string why_free(const FreeMotions& motions);
std::string why_not_held(const FullModel& model, const FullStructure& structure);

}  // namespace prs
