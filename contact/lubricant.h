#pragma once

#include <cmath>

namespace contact {

/// Oil, or base oil of a grease, at operating temperature. SI units.
template <class Real>
struct LubricantOf {
  Real viscosity{};                ///< eta_0, dynamic, at ambient pressure [Pa s]
  Real pressure_viscosity{};       ///< alpha, at ambient pressure [1/Pa]
  Real eyring_stress{};            ///< tau_0, shear stress where thinning begins [Pa]
  Real temperature_coefficient{};  ///< beta = -(d eta_0/dT)/eta_0 [1/K]; 0 where not known.
};
using Lubricant = LubricantOf<double>;

/// eta_p of Roelands' law [Pa s], ln eta_p = -9.67: only a thicker lubricant stiffens with
/// pressure.
inline constexpr double kRoelandsViscosity = 6.315e-5;

/// Viscosity under pressure over that at ambient pressure by Roelands (Sandu 2018, (2.29)),
///
///     exp((ln(eta_0/(Pa s)) + 9.67) ((1 + p/p_0)^z - 1)),  p_0 = 0.198 GPa,  z = 0.6.
///
/// `Real` may be a batch of pressures [Pa] >= 0.
template <class Real>
Real roelands_viscosity_ratio(double viscosity, const Real& pressure) {
  using std::exp, std::log1p, std::expm1;
  constexpr double kPressure = 0.198e9, kExponent = 0.6;
  return exp((std::log(viscosity) + 9.67) * expm1(kExponent * log1p(pressure / kPressure)));
}

}  // namespace contact
