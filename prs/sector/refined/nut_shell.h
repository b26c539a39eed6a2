#pragma once

#include "fe/shell.h"
#include "prs/model/structure.h"
#include "prs/sector/refined/nut_formulas.h"

namespace prs {

/// Nodes along the nut and the segments between them.
struct NutLine {
  std::vector<double> sections;        ///< Ascending axial positions of the nodes [m].
  std::vector<double> outer_radius;    ///< Outer radius between a node and the next [m].
  std::vector<double> axial_rigidity;  ///< E A between a node and the next, for a nut of bars [N].
  std::vector<int> contacts;           ///< Nodes of the contacts, thread 1 first.
  int thrust = 0;                      ///< Node of the thrust section.

  double length(std::size_t segment) const { return sections[segment + 1] - sections[segment]; }
};

/// Ring on which a face of the nut can lean [m].
struct ThrustRing {
  double inner_radius = 0.0;
  double outer_radius = 0.0;
};

/// Radii of the nut's threads [m].
struct NutBore {
  /// Inner radius of the section that carries axial force, between a node of the line and the next.
  std::vector<double> root;
  /// Pitch radius, that of the contacts. Hoop stress is carried from here outwards: the ridges are closed rings that
  /// fill half of the groove depth.
  double pitch = 0.0;
};

/// The step of the outer radius at the thrust section, or the whole face of an end, as far as the stated shoulder
/// covers it; none inside the nut. Throws CaseError if the shoulder misses the face.
std::optional<ThrustRing> thrust_ring(const NutLine& line, const Structure::Nut& nut, const NutBore& bore);

/// Sets for each segment of the line the first one equal to it.
void set_alike_segments(const NutLine& line, const NutBore& bore, std::vector<int>& same);

/// Loads on the nut: equal ones at all contacts.
struct NutLoad {
  double sense = 1.0;         ///< s, sense of the axial force along x.
  double normal_angle = 0.0;  ///< psi [rad]
};

/// The nut of one sector as a shell.
struct NutShell {
  std::vector<fe::ShellMatrix> segments;  ///< Shells between the nodes of the line.
  /// Distance from the radius of the nodes, at which the thrust section is held, to the contacts [m].
  double contact_arm = 0.0;
  bool straight_thrust_section = false;  ///< Whether the thrust section does not tilt.
  bool radially_rigid = false;           ///< Whether v = 0 at all nodes.
};

/// One shell between neighbouring nodes, with its freedoms at the radius where the housing pushes: the centre of
/// pressure on a thrust ring; without one the middle of the wall, held on all of it.
///
/// Effects: `hoop` lets the wall move radially, `poisson` couples that with axial strain, `flange` applies forces at
/// their places; without it they act at the wall's centroid and nothing tilts.
NutShell nut_shell(const NutShape& shape, const NutNumbers<double>& numbers);
NutShell nut_shell(const NutLine& line, const std::optional<ThrustRing>& ring, const NutBore& bore, const NutLoad& load,
                   const Material& material, int rollers, const RefinedEffects& effects);

}  // namespace prs
