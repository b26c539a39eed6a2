#pragma once

#include <Eigen/Core>

#include "prs/loads/slip_result.h"
#include "prs/model/heat.h"
#include "prs/model/part.h"

namespace prs {

/// A value each of screw, all rollers together and nut, in this order.
using OfParts = Eigen::Vector3d;

OfParts of_parts(const PerPart<double>& values);
PerPart<double> per_part(const OfParts& values);

/// Three lumped parts that exchange heat with each other and with their surroundings:
///
///     C dT/dt = Q - K (T - T_ambient 1),
///
/// K the symmetric matrix of the conductances [W/K], positive definite where every part has a way
/// to the surroundings; its rows add up to the conductances to ambient.
struct ThermalNetwork {
  Eigen::Matrix3d conductance;  ///< K [W/K]
  double ambient = 0.0;         ///< [K]

  /// Temperatures at which heat of these powers [W] flows off: T_ambient 1 + K^-1 Q [K].
  OfParts steady(const OfParts& heat) const;
};

ThermalNetwork thermal_network(const Heat& heat);

/// Heat that friction puts into each part [W]: each interface heats both its bodies by halves, a
/// torque of the carrier the part that it acts on.
OfParts heat_of(const PowerBySource& power);

/// Oil at the contacts of an interface has the mean temperature of its two bodies [K].
PerInterface<double> oil_temperatures(const OfParts& temperature);

/// d(oil temperatures)/d(temperatures of the parts): screw, nut against screw, rollers, nut.
Eigen::Matrix<double, 2, 3> oil_by_parts();

}  // namespace prs
