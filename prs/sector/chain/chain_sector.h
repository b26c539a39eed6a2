#pragma once

#include "prs/sector/chain/roller_chain.h"

namespace prs {

/// Freedoms of a nut node are u, v and r theta, r the radius that rotations are scaled by.
template <class Real>
struct NutSegment {
  /// Stiffness of what lies between two contacts, over the first and the second node: upper
  /// triangles row by row, and the full coupling [N/m].
  Real first[6] = {};
  Real coupling[9] = {};
  Real second[6] = {};
  /// The same over what deforms it: (q_2 - q_1, (q_1 + q_2)/2), upper triangle row by row.
  Real deformation[21] = {};
};

/// What else holds a contact's node.
template <class Real>
struct NutSupport {
  Real stiffness[6] = {};  ///< Upper triangle row by row; infinite: held [N/m].
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
  SectorNumbers<double> numbers;
  RollerChain<double> roller{};
  double nut_rotation_part = 0.0;                ///< Of r theta of the nut in its approach.
  PerInterface<std::vector<double>> compliance;  ///< In series; bars: empty for zeros.
  PerInterface<std::vector<double>> gaps;

  std::vector<double> nut;     ///< Bars: to the next contact [N/m].
  std::vector<double> ground;  ///< Bars: to the thrust section; infinite: held [N/m].

  std::vector<NutSegment<double>> segments;  ///< Shell: what lies between contacts, each kind once.
  std::vector<int> segment_of;               ///< Shell: to the next contact.
  std::vector<NutSupport<double>> supports;  ///< Shell: of each contact.
};

}  // namespace prs
