#pragma once

#include <vector>

#include "fe/beam.h"
#include "fe/power_law_spring.h"
#include "fe/shell.h"

namespace fe {

/// Freedoms of a plane node: axial displacement u [m], transverse displacement v [m], rotation
/// theta [rad], positive from x to y.
enum class Dof { u, v, theta };
inline constexpr int kDofsPerNode = 3;

/// A point rigidly attached to a node at the offset (dx, dy) [m]; it moves by
/// (u - theta dy, v + theta dx).
struct RigidArm {
  int node = 0;
  double dx = 0.0;
  double dy = 0.0;
};

struct BarElement {
  int first = 0;
  int second = 0;
  Bar bar;
};

struct BeamElement {
  int first = 0;
  int second = 0;
  Beam beam;
};

/// A length of a shell of revolution about the x axis; v is its radial displacement.
struct ShellElement {
  int first = 0;
  int second = 0;
  ShellMatrix stiffness;
};

/// A power-law spring between two points. Its approach is the displacement of `from` relative to
/// `to`, projected on the unit vector (nx, ny) that points from `from` into `to`.
struct SpringElement {
  RigidArm from;
  RigidArm to;
  double nx = 1.0;
  double ny = 0.0;
  PowerLawSpring law;
};

/// A linear spring from one freedom to the ground [N/m or N m/rad].
struct ElasticSupport {
  int node = 0;
  Dof dof = Dof::u;
  double stiffness = 0.0;
};

struct FixedSupport {
  int node = 0;
  Dof dof = Dof::u;
};

/// A force [N] or moment [N m] on one freedom.
struct NodalLoad {
  int node = 0;
  Dof dof = Dof::u;
  double value = 0.0;
};

/// A freedom in a linear form.
struct Term {
  int node = 0;
  Dof dof = Dof::u;
  double coefficient = 1.0;
};
using LinearForm = std::vector<Term>;

/// A power-law spring whose approach is a linear form of freedoms. A spatial node is two plane
/// ones: (u, y, y') and (held, z, z').
struct FormSpring {
  LinearForm approach;
  PowerLawSpring law;
};

/// A linear spring over a linear form of freedoms, with the energy k/2 (form - rest)^2.
struct ElasticLink {
  LinearForm form;
  double rest = 0.0;       ///< [m or rad]
  double stiffness = 0.0;  ///< k [N/m or N m/rad]
};

/// A freedom that follows others: it equals the form plus `offset`. The form names free freedoms, and those of earlier
/// constraints.
struct Constraint {
  int node = 0;
  Dof dof = Dof::u;
  LinearForm form;
  double offset = 0.0;  ///< [m or rad]
};

/// A plane structure of bars, beams, shells and unilateral springs: the data that stay constant in a solve. Bars
/// stiffen u, forms the freedoms they name, springs between nodes u, and v and theta where beams or shells do. A
/// freedom without stiffness takes no part in the equations.
struct Model {
  int nodes = 0;
  std::vector<BarElement> bars;
  std::vector<BeamElement> beams;
  std::vector<ShellElement> shells;
  std::vector<SpringElement> springs;
  std::vector<FormSpring> form_springs;  ///< Numbered after `springs`.
  std::vector<ElasticSupport> elastic_supports;
  std::vector<ElasticLink> elastic_links;
  std::vector<FixedSupport> fixed_supports;
  std::vector<Constraint> constraints;

  int add_node() { return nodes++; }
};

}  // namespace fe
