#pragma once

#include "contact/friction_laws.h"
#include "simd/inlined.h"

/// Friction on a contact patch: formulas for numbers, for batches with one contact or one point per
/// lane, and for either with its slope along one variable, the slip ratio.
namespace contact {

/// Sliding of one body on the other in the tangent plane of a contact (Sandu 2018, (2.22)).
template <class Number>
struct PatchMotionOf {
  Number sliding_major{};  ///< v_M . t_1 at the centre [m/s]
  Number sliding_minor{};  ///< v_M . t_2 [m/s]
  Number spin{};           ///< Relative angular velocity about the normal t_1 x t_2 [rad/s]
  Number rolling_speed{};  ///< |u_M|, sum of the surface velocities in the tangent plane [m/s]
  Number along_major{};    ///< Share of |u_M|^2 along t_1.
};

/// Friction on a patch over its normal load N (equations of Sandu 2018). The friction acts on the
/// body that the other slides over, along the sliding velocity.
template <class Number>
struct PatchFrictionOf {
  using Real = simd::ValueOf<Number>;
  Number traction_major{};        ///< T . t_1/N [-] (3.6)
  Number traction_minor{};        ///< T . t_2/N [-]
  Number spin_arm{};              ///< C/N, moment about the centre along t_1 x t_2 [m] (3.10)
  Real power_per_load{};          ///< Lost power over N [m/s] (3.51)
  Real mean_friction{};           ///< mu_a over the points inside (2.40)
  Real max_sliding_speed{};       ///< Largest value over the points [m/s].
  Real sliding_under_pressure{};  ///< Integral of pressure times sliding speed over N [m/s]
};

/// Sliding velocity at (x, y): (major - spin_minor y, minor + spin_major x) [m/s].
template <class Number>
struct SlidingFieldOf {
  Number major{}, minor{};            ///< Velocity at the centre.
  Number spin_major{}, spin_minor{};  ///< Spin times semi-axis.
};

/// Sums over the points. With slopes, those that a balance needs alone.
template <class Number>
struct PatchSumsOf {
  using Real = simd::ValueOf<Number>;
  Number traction_major = Real(0.0);  ///< mu dome v_1/|v|
  Number traction_minor = Real(0.0);  ///< mu dome v_2/|v|
  Number moment_major = Real(0.0);    ///< x mu dome v_2/|v|
  Number moment_minor = Real(0.0);    ///< y mu dome v_1/|v|
  Real power = 0.0;                   ///< mu dome |v|
  Real friction = 0.0;                ///< mu
  Real sliding = 0.0;                 ///< dome |v|
  Real max_speed = 0.0;               ///< Largest |v|
};

/// Sliding slower than this has no direction, as at the centre of pure spin [m/s].
inline constexpr double kNoDirection = 1e-11;

/// A point of a patch in units of its semi-axes.
template <class Real>
struct PatchPoint {
  Real x, y;
  Real dome;          ///< sqrt(1 - x^2 - y^2)
  Real inverse_dome;  ///< 1/dome
  Real viscosity_ratio{};
};

/// `friction_at`: mu dome of a `FrictionPointOf`.
template <class Number, class Real, class Friction>
PRS_INLINED inline void add_point(PatchSumsOf<Number>& sums, const SlidingFieldOf<Number>& sliding,
                                  const PatchPoint<Real>& at, Friction friction_at) {
  using simd::max, simd::select, simd::value;
  const Number v_1 = sliding.major - sliding.spin_minor * at.y;
  const Number v_2 = sliding.minor + sliding.spin_major * at.x;
  const Number speed = simd::length(v_1, v_2);
  const Number friction = friction_at(FrictionPointOf<Number>{speed, at.dome, at.viscosity_ratio});
  const Number along = select(value(speed) >= Real(kNoDirection), Number(friction * (1.0 / speed)), Number(Real(0.0)));
  const Number friction_1 = along * v_1, friction_2 = along * v_2;
  sums.traction_major += friction_1;
  sums.traction_minor += friction_2;
  sums.moment_major += friction_2 * at.x;
  sums.moment_minor += friction_1 * at.y;
  if constexpr (std::is_same_v<Number, Real>) {
    sums.power += along * speed * speed;
    sums.friction += friction * at.inverse_dome;
    sums.sliding += at.dome * speed;
    sums.max_speed = max(sums.max_speed, speed);
  }
}

/// Friction from the sums over `points` points of cells that carry `cell_load` dome each.
template <class Number, class Real>
PatchFrictionOf<Number> patch_friction(const PatchSumsOf<Number>& sums, double cell_load, double points,
                                       const Real& semi_major, const Real& semi_minor) {
  const Real weight(cell_load);
  return {sums.traction_major * weight,
          sums.traction_minor * weight,
          (sums.moment_major * semi_major - sums.moment_minor * semi_minor) * weight,
          sums.power * weight,
          sums.friction / points,
          sums.max_speed,
          sums.sliding * weight};
}

template <class Number, class Real>
SlidingFieldOf<Number> sliding_field(const PatchMotionOf<Number>& motion, const Real& semi_major,
                                     const Real& semi_minor) {
  return {motion.sliding_major, motion.sliding_minor, motion.spin * semi_major, motion.spin * semi_minor};
}

/// Properties of a contact with this law and motion, for the friction at its points.
template <class Number, class Real>
RollingContactOf<Number> rolling_contact(const FrictionLawOf<Real>& law, const Real& peak_pressure,
                                         const PatchMotionOf<Number>& motion) {
  using simd::any, simd::select, simd::value;
  const Number none(Real(0.0)), &rolling_speed = motion.rolling_speed;
  RollingContactOf<Number> at{peak_pressure, law.oil.temperature, none, none, none};
  const auto has_film = law.has_film();
  if (!any(has_film)) return at;
  const auto rolls = has_film && value(rolling_speed) > Real(0.0);
  const MoesNumbersOf<Number> moes = moes_numbers(law.oil, law.film, rolling_speed);
  const Number thinned = film_factor(law.oil, law.film, peak_pressure, rolling_speed,
                                     simd::length(motion.sliding_major, motion.sliding_minor));
  at.shear_factor =
      select(rolls, sliding_factor_of(law.oil, law.film, Number(thinned * sandu_parameter(moes)), rolling_speed), none);
  at.eyring_stress = Number(select(has_film, Real(law.oil.eyring_stress / peak_pressure), Real(0.0)));
  const auto touches = law.is(Lubrication::mixed);
  if (!any(touches)) return at;
  const Number film = thinned * central_thickness(law.oil, law.film, moes, rolling_speed, motion.along_major);
  at.film_ratio = select(rolls && touches, Number(film / law.roughness), none);
  return at;
}

}  // namespace contact
