#pragma once

#include "prs/configurations/complete_screw.h"
#include "prs/model/heat.h"

namespace prs {

/// Thermal conductivity of bearing steel [W/(m K)].
inline constexpr double kSteelConductivity = 46.0;

/// Conductances of a screw of which only sizes are known, in still air and without a housing: a
/// first guess that is on the safe side. With h = `kStillAir` and k = `kSteelConductivity`:
///
///     nut      h times its surface but the bore
///     screw    two fins of the shaft's length beyond the nut, sqrt(h P k A) tanh(L sqrt(h P/(k
///     A))) contact  2 k sqrt(a b) for each ellipse under equal shares of the proposed load, both
///     bodies
///              half spaces (Holm, Electric Contacts, 1967; a circle of the same area)
///
/// Grease in the gaps and the motion of the contacts, which both conduct more, are left out.
Heat::Conductance estimated_conductance(const CompleteScrew& screw, double shaft_length);

}  // namespace prs
