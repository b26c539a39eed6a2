#pragma once

namespace contact {

/// Kinematic viscosity of an oil against temperature (Walther 1931; ASTM D341):
///
///     log10 log10(nu/(mm^2/s) + 0.7) = intercept - slope log10(T/K).
///
/// Valid between 2 mm^2/s and 2e7 mm^2/s for mineral and most synthetic oils, above their cloud
/// point and below their boiling point. Below 2 mm^2/s the standard adds terms that are left out
/// here; the line then still falls with temperature, towards 0.3 mm^2/s, which it never reaches.
struct WaltherLine {
  double intercept = 0.0;  ///< A
  double slope = 0.0;      ///< B, > 0
};

/// Between these, both excluded, the line may pass through a point and be evaluated [m^2/s].
inline constexpr double kLeastKinematicViscosity = 0.3e-6;
inline constexpr double kGreatestKinematicViscosity = 20.0;

/// Density of a mineral oil near 40 degC [kg/m^3], for uses where only the shape of the Walther
/// line depends on it.
inline constexpr double kTypicalOilDensity = 870.0;

/// The line through two points: absolute temperatures [K], different, and kinematic viscosities
/// [m^2/s], both above 0.3 mm^2/s so that the logarithms exist:
///
///     slope = (y_1 - y_2)/log10(T_2/T_1),  y = log10 log10(nu/(mm^2/s) + 0.7).
WaltherLine walther_line(double temperature_1, double viscosity_1, double temperature_2,
                         double viscosity_2);

/// Kinematic viscosity [m^2/s] at an absolute temperature [K]:
///
///     nu/(mm^2/s) = 10^(10^(intercept - slope log10(T/K))) - 0.7.
///
/// Infinite where that exceeds the numbers.
double kinematic_viscosity(const WaltherLine& line, double temperature);

/// beta = -(d nu/dT)/nu of the line at an absolute temperature [1/K]:
///
///     beta = slope/T (1 + 0.7 mm^2/s/nu) ln(nu/(mm^2/s) + 0.7).
double temperature_coefficient(const WaltherLine& line, double temperature);

/// What an oil is made of, as far as its viscosity under pressure depends on it.
enum class BaseOil { mineral, polyalphaolefin, ester };

/// Estimate of the pressure-viscosity coefficient [1/Pa] from the kinematic viscosity at the same
/// temperature [m^2/s],
///
///     alpha = s (nu/(mm^2/s))^t 1e-9/Pa,
///
/// with s = 9.904, t = 0.139 for mineral oils, 7.382, 0.1335 for polyalphaolefins and 6.605, 0.136
/// for esters (Gold, Schmidt, Dicke, Loos, Assmann, J. Synth. Lubr. 18, 2001, 51). For paraffinic
/// mineral oils this lies up to 30 % below what high-pressure viscometers give.
double gold_pressure_viscosity(BaseOil oil, double kinematic_viscosity);

}  // namespace contact
