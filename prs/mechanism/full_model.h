#pragma once

#include "fe/model.h"
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
  double geared(Mechanism::Type type) const { return type == Mechanism::Type::standard ? nut : screw; }
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

/// A node of screw or nut at x: (u, y, y') and (-, z, z') as two plane nodes. The wall of a nut has its own u, radial
/// displacement and tilt, and those of its harmonics.
struct SpatialNode {
  double x = 0.0;
  int y_plane = 0;
  int z_plane = 0;
  int axial = 0;  ///< Node with its u: `y_plane`, or that of the wall.
  int wall = -1;  ///< Node (u, v, theta) of the wall; nodes of its harmonics follow. -1: none.
};

/// The full mechanism as a structure of beams, springs and constraints. Displacements are relative to the rigid motion
/// of the whole mechanism with the seat of the nut.
struct FullStructure {
  struct Roller {
    std::vector<int> nodes;                   ///< Nodes along x.
    std::vector<double> x;                    ///< x of the nodes [m].
    PerInterface<std::vector<int>> contacts;  ///< Node of each thread.
    std::array<std::vector<int>, 2> guided;   ///< Nodes that the near and the far ring guide.
    int first_spring = 0;                     ///< First spring of the screw's contacts; those at the nut follow.

    int spring(Interface i, std::size_t thread) const {
      return first_spring + static_cast<int>(thread + (i == Interface::screw ? 0 : contacts.screw.size()));
    }
  };
  /// Guidance of a roller by a ring: a constraint, an elastic link or two stops.
  struct Guide {
    std::size_t roller = 0;  ///< Index into FullModel::present.
    std::size_t ring = 0;    ///< 0 near, 1 far.
    double x = 0.0;          ///< Point of action [m].
    int constraint = -1;
    int link = -1;
    int stop = -1;  ///< Spring of the outward stop, whose approach is v against the ring; the inward one follows.
  };
  /// Support of a freedom: a constraint or an elastic link, or none.
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
  std::vector<Roller> rollers;  ///< Rollers as in FullModel::present.
  std::vector<Guide> guides;
  std::array<int, 2> rings{-1, -1};           ///< (-, y, z as u and v) of floating rings.
  std::array<const SpatialNode*, 2> seats{};  ///< Seats of the rings on screw or nut; null: housing.
  Support housing;
  std::vector<Support> bearings;  ///< Bearings as in FullModel; several may hold one freedom.
  int loaded = 0;                 ///< Index in `screw`.
  std::vector<fe::NodalLoad> loads;
  std::vector<std::vector<fe::NodalLoad>> per_force;  ///< Loads per force of each spring.

  FullStructure() = default;
  FullStructure(FullStructure&&) = default;
  FullStructure& operator=(FullStructure&&) = default;
};

/// Lateral displacement at x of the subtracted rigid motion [m].
Lateral rigid_offset(const FullModel& model, double x);
/// Slopes y' and z' of the subtracted rigid motion [rad].
Lateral rigid_slope(const FullModel& model);

/// Additional stations of a structure, besides those for its loads and supports.
struct FullMesh {
  std::vector<double> screw, nut;  ///< x [m]
  double longest = 0.0;            ///< Largest length of pieces of screw and nut; longer ones are divided evenly [m].
};

/// The structure; with a mesh, nodes of screw and nut closer than `kNearNodes` are not joined by a beam, whose large
/// stiffness would cost digits: one follows the other, and the deformation of a beam between them is a freedom of its
/// own.
FullStructure full_structure(const FullModel& model, const std::optional<FullMesh>& mesh = {});
inline constexpr double kNearNodes = 2e-4;  // [m]

/// Section of a body at x.
const RollerSection<double>& section_at(const std::vector<BodyPiece>& pieces, double x);

/// Motions of rigid parts that nothing resists: no contact, guide, bearing or spring.
struct FreeMotions {
  int count = 0;
  std::vector<std::string> parts;  ///< Moving parts: screw, ring, roller 3.
};

/// Motions without resistance, by the rows of contacts, constraints and springs over the rigid motions of the screw, of
/// each roller and of each floating ring, each row scaled to one and rotations taken in 1/r_R: those of singular values
/// below 1e-9 of the largest. `closed` selects the contacts and stops that count, all if empty.
FreeMotions free_motions(const FullModel& model, const FullStructure& structure, const std::vector<bool>& closed = {});

/// Load on the rigid parts that no forces of contacts, which only push, and of guides, bearings and springs, which do
/// both, can balance: the smallest by least squares, moments over r_R, as a share of the axial force. 0 if an
/// equilibrium exists (Farkas).
double load_left(const FullModel& model, const FullStructure& structure);

/// Smallest axial force with which the other loads are held [N], up to a thousand times the given one; absent if no
/// force holds them.
std::optional<double> holding_force(const FullModel& model);

/// Explanation of a mechanism and a load that nothing holds.
std::string why_free(const FreeMotions& motions);
std::string why_not_held(const FullModel& model, const FullStructure& structure);

}  // namespace prs
