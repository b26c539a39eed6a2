#pragma once

#include <string_view>
#include <vector>

#include "simd/instruction_set.h"

namespace contact {

/// Isotropic elasticity of one body.
struct Elasticity {
  double youngs_modulus = 0.0;  ///< E [Pa]
  double poisson_ratio = 0.0;   ///< nu [-]
};

/// Contact modulus E* [Pa] of two bodies, from the sum of their plane-strain compliances:
///
///     1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
///
/// Yao 2023's E' (46) is E*; Sandu 2018's E' (1.78) is 2 E*.
double contact_modulus(const Elasticity& body_1, const Elasticity& body_2);

/// Whether a Hertz contact could be computed, and if not, why.
enum class HertzStatus {
  ok,
  not_computed,
  not_finite,          ///< A curvature or the modulus is NaN or infinite.
  no_point_contact,    ///< The smaller relative curvature is zero: the bodies touch along a line.
  conforming_surface,  ///< The smaller relative curvature is negative: the bodies overlap nearby.
  no_stiffness,        ///< The contact modulus is not positive.
};

std::string_view name(HertzStatus status);

/// Load-independent constants of an elliptic Hertz contact.
struct HertzConstants {
  HertzStatus status = HertzStatus::not_computed;
  double ellipticity = 0.0;               ///< b/a, 0 < b/a <= 1 [-]
  double hertz_constant = 0.0;            ///< k_0 of N = k_0 delta^1.5 [N/m^1.5]
  double semi_major_per_cbrt_load = 0.0;  ///< a/N^(1/3) [m/N^(1/3)]
  double semi_minor_per_cbrt_load = 0.0;  ///< b/N^(1/3) [m/N^(1/3)]

  bool ok() const { return status == HertzStatus::ok; }
};

template <class Real>
struct HertzNumbers;
/// The constants that the formulas give.
HertzConstants hertz_constants_of(const HertzNumbers<double>& numbers);

/// Contact ellipse of two elastic bodies whose *relative* principal curvatures are kappa_1 and
/// kappa_2 [1/m], the eigenvalues of the sum of the two curvature tensors in the common tangent
/// plane (no factor 1/2; either order). The major axis lies along the smaller one.
///
/// E* = `contact_modulus` [Pa]; the elliptic integrals have the parameter m = 1 - (b/a)^2:
///
///     kappa_1/kappa_2 = (b/a)^2 D/B,   b^3 = 3 N (b/a) B/(pi kappa_2 E*),
///     delta = 3 N K/(2 pi a E*),       N = k_0 delta^1.5.
///
/// Same as Sandu 2018 (1.80)-(1.82) and Yao 2023 (47)-(50) with exact ellipticity. Valid for
/// smooth half-spaces: a, b small against the radii of both bodies. The ellipticity is exact to
/// about 1e-15 for any ratio of the curvatures. Raises nothing; `status` says what is wrong with
/// the input, and all numbers are then zero.
HertzConstants hertz_constants(double kappa_1, double kappa_2, double contact_modulus);

/// Ellipticity b/a of the contact ellipse for kappa_1/kappa_2 = `curvature_ratio`, 0 < ratio <= 1:
/// the root of kappa_1/kappa_2 = (b/a)^2 D/B (Yao 2023, (47)). Fits to it: Sandu 2018, table 1.5.
double ellipticity(double curvature_ratio);

/// One Hertz contact under load (Sandu 2018, (1.80) to (1.83)).
struct HertzContact {
  double normal_load = 0.0;    ///< N [N], >= 0
  double approach = 0.0;       ///< delta of two distant points of the bodies [m]
  double semi_major = 0.0;     ///< a [m]
  double semi_minor = 0.0;     ///< b [m], <= a
  double peak_pressure = 0.0;  ///< p_0 = 3 N/(2 pi a b) [Pa]

  /// Pressure [Pa] at a point of the tangent plane, coordinates along the major and the minor axis
  /// from the centre [m]: p_0 sqrt(1 - (x/a)^2 - (y/b)^2) inside the ellipse, else zero (Yao 2023,
  /// (40)).
  double pressure(double along_major, double along_minor) const;
};

/// The contact under the normal load N [N]; a load <= 0 leaves it open (all zero).
HertzContact at_load(const HertzConstants& constants, double normal_load);

/// Ellipses and pressures under many loads, as many side by side as a batch has numbers.
void set_ellipses(const HertzConstants& constants, const std::vector<double>& normal_load,
                  std::vector<double>& semi_major, std::vector<double>& semi_minor,
                  std::vector<double>& peak_pressure, simd::InstructionSet set);

}  // namespace contact
