#pragma once

#include "fe/model.h"
#include "prs/mechanism/full_model.h"

namespace prs {

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
  /// Support of a freedom: a constraint, an elastic link, or none.
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
  std::vector<Roller> rollers;  ///< Rollers of FullModel::present.
  std::vector<Guide> guides;
  std::array<int, 2> rings{-1, -1};           ///< (-, y, z as u and v) of floating rings.
  std::array<const SpatialNode*, 2> seats{};  ///< Seats of the rings on screw or nut; null: housing.
  Support housing;
  std::vector<Support> bearings;  ///< Supports by FullModel::bearings; several may hold one freedom.
  int loaded = 0;                 ///< Index in `screw` of the loaded node.
  std::vector<fe::NodalLoad> loads;
  std::vector<std::vector<fe::NodalLoad>> per_force;  ///< Loads per force of each spring.

  FullStructure() = default;
  FullStructure(FullStructure&&) = default;
  FullStructure& operator=(FullStructure&&) = default;
};

/// Displacement at x of the rigid motion that is taken out, across the axis [m].
Lateral rigid_offset(const FullModel& model, double x);
/// Slopes y' and z' of that rigid motion [rad].
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
  std::vector<std::string> parts;  ///< Parts that move: screw, ring, roller 3.
};

/// The rows of contacts, constraints and springs over the rigid motions of the screw, of each
/// roller and of each floating ring, each row scaled to one and rotations taken in 1/r_R; the
/// motions are those of singular values below 1e-9 of the largest. `closed` says which contacts
/// and stops count, all where it is empty.
FreeMotions free_motions(const FullModel& model, const FullStructure& structure, const std::vector<bool>& closed = {});

/// Smallest part of the loads on the rigid parts that no forces of contacts, which only push, and of guides,
/// bearings and springs, which push and pull, can balance, by least squares, moments over r_R, as a share of the
/// axial force. 0 where an equilibrium exists (Farkas).
double load_left(const FullModel& model, const FullStructure& structure);

/// The axial force from which on the rest of the load is held [N], up to a thousand times the given
/// one; absent where none holds it.
std::optional<double> holding_force(const FullModel& model);

/// Sentences about a mechanism and about a load that nothing holds.
std::string why_free(const FreeMotions& motions);
std::string why_not_held(const FullModel& model, const FullStructure& structure);

}  // namespace prs
