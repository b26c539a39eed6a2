#pragma once

#include <array>
#include <vector>

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
    int first_spring = 0;                     ///< Of the screw's contacts; those at the nut follow.

    int spring(Interface i, std::size_t thread) const {
      return first_spring +
             static_cast<int>(thread + (i == Interface::screw ? 0 : contacts.screw.size()));
    }
  };
  /// A constraint or an elastic link by which a ring guides a roller.
  struct Guide {
    std::size_t roller = 0;  ///< Of FullModel::present.
    std::size_t ring = 0;    ///< 0 near, 1 far.
    double x = 0.0;          ///< Where it acts [m].
    int constraint = -1;
    int link = -1;
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
  std::vector<Roller> rollers;  ///< Of FullModel::present.
  std::vector<Guide> guides;
  std::array<int, 2> rings{-1, -1};           ///< (-, y, z as u and v) of floating rings.
  std::array<const SpatialNode*, 2> seats{};  ///< Of the rings on screw or nut; null: housing.
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

FullStructure full_structure(const FullModel& model);

}  // namespace prs
