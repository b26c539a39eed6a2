#pragma once

#include <limits>
#include <vector>

#include "prs/sector/chain/roller_beam.h"
#include "prs/model/part.h"

namespace prs {

/// Stiffness of a support that does not give.
inline constexpr double kHeld = std::numeric_limits<double>::infinity();

/// Freedoms of a nut node are u, v and r theta, r the radius that rotations are scaled by.
struct NutSegment {
  /// Stiffness of what lies between two contacts, over the first and the second node: upper
  /// triangles row by row, and the full coupling [N/m].
  double first[6] = {};
  double coupling[9] = {};
  double second[6] = {};
  /// The same over what deforms it: (q_2 - q_1, (q_1 + q_2)/2), upper triangle row by row.
  double deformation[21] = {};
};

/// A sector as a chain of stations, everything between the contacts condensed. SI units.
struct ChainSector {
  enum class Kind {
    bars,             ///< Screw u; nut u; roller u, v, theta.
    shell,            ///< Nut u, v, theta.
    apart_nut_first,  ///< As well a roller node for each contact, along x that of the nut first.
    apart_screw_first,
  };

  Kind kind = Kind::bars;
  int contacts = 0;
  double rollers = 1.0;
  double sense = 1.0;              ///< s
  double free_compliance = 0.0;    ///< Of the screw before the first contact [m/N].
  double offset_compliance = 0.0;  ///< As in `Sector` [m/N].

  PerInterface<double> axial_part;   ///< s cos(psi)
  PerInterface<double> radial_part;  ///< sin(psi)
  double nut_rotation_part = 0.0;    ///< Of r theta of the nut in its approach.
  PerInterface<double> hertz_constant;
  PerInterface<std::vector<double>> compliance;  ///< In series; bars: empty for zeros.
  PerInterface<std::vector<double>> gaps;

  double screw = 0.0;  ///< Between contacts [N/m].
  RollerBeam<double> thread{};
  RollerBeam<double> tooth{};  ///< Between the two contacts of a tooth.
  RollerEnd<double> ends[2] = {};
  double bending_support = 0.0;  ///< Infinite where the roller does not bend.

  std::vector<double> nut;     ///< Bars: to the next contact [N/m].
  std::vector<double> ground;  ///< Bars: to the thrust section; infinite: held [N/m].

  std::vector<NutSegment> segments;  ///< Shell: to the next contact.
  struct NutSupport {
    double stiffness[6] = {};  ///< Upper triangle row by row; infinite: held [N/m].
  };
  std::vector<NutSupport> supports;  ///< Shell: what else holds a contact's node.
};

}  // namespace prs
