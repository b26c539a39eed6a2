#pragma once

#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

// The parts as bodies of revolution that are bounded by the pitch diameters, where a thread is as
// wide as its groove: what crests add, roots lack, but for the difference of their radii.

/// Volume and polar moment of volume of a body about its axis.
struct RoundBody {
  double volume = 0.0;        ///< [m^3]
  double polar_moment = 0.0;  ///< Integral of r^2 dV [m^5]; times the density, the inertia.
};

/// Cylinder or tube of a length: pi/4 (D^2 - d^2) L and pi/32 (D^4 - d^4) L.
RoundBody tube(double outer_diameter, double inner_diameter, double length);

/// Nut with its flanges, bored to the pitch diameter over its whole length.
RoundBody nut_body(const Mechanism& mechanism, const Structure::Nut& nut);

/// One roller as in the sector model: its pitch diameter over the threads with half a pitch of
/// run-out at both ends, N p together, and both end pieces.
RoundBody roller_body(const Mechanism& mechanism, const Structure::Roller& roller);

/// Screw of a length, from its bore to the pitch diameter.
RoundBody screw_body(const Mechanism& mechanism, const Structure::Screw& screw, double length);

/// Volume of the cylinder around the nut [m^3]: its largest diameter over its length.
double envelope_volume(const Structure::Nut& nut);

}  // namespace prs
