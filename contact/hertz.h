#pragma once

#include <cstdint>
#include <string_view>

#include "simd/lanes.h"

namespace contact {

/// Isotropic elasticity of one body.
template <class Real>
struct ElasticityOf {
  Real youngs_modulus{};  ///< E [Pa]
  Real poisson_ratio{};   ///< nu [-]
};
using Elasticity = ElasticityOf<double>;

/// Plane-strain compliance (1 - nu^2)/E [1/Pa].
double compliance(const Elasticity& body);

/// Contact modulus E* [Pa] of two bodies, 1/E* the sum of their compliances.
///
/// Yao 2023's E' (46) is E*; Sandu 2018's E' (1.78) is 2 E*.
double contact_modulus(const Elasticity& body_1, const Elasticity& body_2);

/// Whether a Hertz contact could be computed, or the reason why not.
enum class HertzStatus : std::int64_t {
  ok,
  not_computed,
  not_finite,          ///< A curvature or the modulus is NaN or infinite.
  no_point_contact,    ///< The smaller relative curvature is zero: the bodies touch along a line.
  conforming_surface,  ///< The smaller relative curvature is negative: the bodies overlap nearby.
  no_stiffness,        ///< The contact modulus is not positive.
};

std::string_view name(HertzStatus status);

/// Load-independent constants of an elliptic Hertz contact.
template <class Real>
struct HertzConstantsOf {
  simd::EnumOf<HertzStatus, Real> status = HertzStatus::not_computed;
  Real ellipticity{};               ///< b/a, 0 < b/a <= 1 [-]
  Real hertz_constant{};            ///< k_0 of N = k_0 delta^1.5 [N/m^1.5]
  Real cbrt_constant{};             ///< k_0^(1/3) [N^(1/3)/m^(1/2)]
  Real semi_major_per_cbrt_load{};  ///< a/N^(1/3) [m/N^(1/3)]
  Real semi_minor_per_cbrt_load{};  ///< b/N^(1/3) [m/N^(1/3)]

  simd::Lanes<Real> ok() const { return status == HertzStatus::ok; }
};
using HertzConstants = HertzConstantsOf<double>;

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
};

/// The contact under the normal load N [N]; a load <= 0 leaves it open (all zero).
HertzContact at_load(const HertzConstants& constants, double normal_load);

/// Stresses on the normal through the centre of a contact ellipse, over its peak pressure,
/// compression negative; the three are principal there.
struct AxisStress {
  double along_major = 0.0;
  double along_minor = 0.0;
  double along_normal = 0.0;

  double largest_shear() const;  ///< Half the largest difference of two of them.
  double von_mises() const;
};

/// Frictionless elliptic Hertz contact, at the depth z below the centre. Over p_0, with
/// A^2 = a^2 + z^2, B^2 = b^2 + z^2 and I_a = int_{z^2}^inf dw/((a^2 + w) sqrt((a^2 + w)(b^2 + w)
/// w)):
///
///     sigma_z = -a b/(A B),
///     sigma_x = a b ((1 - nu) z I_a - nu z I_z - (1 - 2 nu)/(A (A + B))),
///     sigma_y = a b ((1 - nu) z I_b - nu z I_z - (1 - 2 nu)/(B (A + B))),
///     z (I_a + I_b + I_z) = 2/(A B),
///
/// x along the major axis: Boussinesq's potentials of a semi-ellipsoidal pressure (Thomas & Hoersch
/// 1930; Johnson 1985, section 3.4) in a form that holds through the circle. Only ratios matter, so
/// depth and axes may be in any one unit.
AxisStress stress_on_axis(double semi_major, double semi_minor, double depth, double poisson_ratio);

/// Largest shear stress on that normal and its depth.
struct SubsurfaceShear {
  double shear_over_pressure = 0.0;    ///< tau_max/p_0 [-]
  double depth_over_semi_minor = 0.0;  ///< z/b [-]
};

/// Largest shear on the normal through the centre of an ellipse b/a = `ellipticity`. For nu = 0.3: 0.310 p_0 at 0.48 b
/// in a circular contact, 0.300 p_0 at 0.79 b in a line contact, up to 0.325 p_0 in between. For nu below about 0.2
/// long ellipses have it near the surface.
SubsurfaceShear largest_subsurface_shear(double ellipticity, double poisson_ratio);

/// Largest von Mises stress on that normal and its depth.
struct SubsurfaceVonMises {
  double stress_over_pressure = 0.0;   ///< sigma_v/p_0 [-]
  double depth_over_semi_minor = 0.0;  ///< z/b [-]
};

/// Largest von Mises stress on that normal. For nu = 0.3: 0.620 p_0 at 0.48 b in a circular contact, 0.558 p_0 at 0.70
/// b in a line contact (Johnson 1985, sections 3.4 and 4.2).
SubsurfaceVonMises largest_subsurface_von_mises(double ellipticity, double poisson_ratio);

}  // namespace contact
