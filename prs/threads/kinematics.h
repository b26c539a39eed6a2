#pragma once

#include "prs/model/mechanism.h"
#include "simd/dual.h"

namespace prs {

/// Geometry of a mechanism that determines its stationary motion (Sandu 2018, section 2.2): for numbers and for batches
/// with one mechanism per lane.
template <class Real>
struct KinematicGeometryOf {
  simd::EnumOf<Mechanism::Type, Real> type = Mechanism::Type::standard;
  Real lead{};             ///< l_S, > 0 right-handed [m]
  Real gear_ratio{};       ///< Gamma, ratio of the gears' teeth: n_R/n_S; see `gear_ratio`.
  Real centre_distance{};  ///< c [m]
  Real lead_excess{};      ///< l_N - l_S, 0 for a consistent mechanism [m].
  /// Difference of the lead of the rollers, as their gears turn them, from that of the part that they are geared to, 0
  /// for a consistent mechanism: sgn(l_S) (|l_R|/Gamma - |l_N|), inverted sgn(l_S) (|l_R|/Gamma - |l_S|) [m]. Rollers
  /// with grooves run along the nut by its lead per orbit.
  Real migration_lead{};
  /// I and J in the carrier's frame across the screw's axis, x towards the roller [m].
  PerInterface<contact::Vector2<Real>> points{};

  /// See `contact::TypeFacts`.
  simd::Lanes<Real> carrier_on_nut() const { return !(type == Mechanism::Type::inverted); }
};
using KinematicGeometry = KinematicGeometryOf<double>;

/// Speeds of the parts for one slip ratio, with or without their slope along it. Rotations about z,
/// positive anticlockwise [rad/s].
template <class Number>
struct KinematicsOf {
  Number slip_ratio{};         ///< epsilon = omega_p/n / omega_s/n (2.2)
  Number screw_to_carrier{};   ///< omega_s/p
  Number roller_to_carrier{};  ///< omega_r/p, from the gears (2.4); of rollers without teeth see `kinematics`.
  Number nut_to_carrier{};     ///< omega_n/p
  /// Axial velocities against the carrier, which goes with the nut or with the screw, see `carrier_part` [m/s] (2.5).
  Number screw_advance{};
  Number nut_advance{};
  Number roller_advance{};  ///< Migration, 0 for a consistent mechanism.
};
using Kinematics = KinematicsOf<double>;

/// Speed against the frame of a part that turns with `against_nut` against the nut [rad/s], where the screw turns with
/// `speed` against the nut: omega_x/n with the carrier on the nut, omega_x/n - omega_s/n with the carrier on the screw.
/// The screw turns and the nut is held against turning; in an inverted mechanism the nut turns and the screw is held.
/// The held part travels, and the rollers with it. omega_s/n has the same sign in both; against the frame a screw turns
/// with omega_s/n, a nut with -omega_s/n.

template <class Number, class Real>
Number against_frame(const simd::Lanes<Real>& carrier_on_nut, const Number& against_nut, const Real& speed) {
  using simd::select;
  return select(carrier_on_nut, against_nut, Number(against_nut - speed));
}

/// Speed against the frame of the part that turns [rad/s]: omega_s/n, or -omega_s/n of a nut.
double turning_speed(Mechanism::Type type, double speed);

/// Share of the turns of the screw against the nut that the rollers roll off on the part that they are geared to:
/// epsilon on the nut, 1 - epsilon on the screw.
template <class Number, class Real>
Number geared_turns(const KinematicGeometryOf<Real>& g, const Number& slip_ratio) {
  using simd::select;
  return select(g.carrier_on_nut(), slip_ratio, Number(1.0 - slip_ratio));
}

/// Travel of the nut on the screw per turn of the screw against the nut, against z where > 0 [m]:
/// l_S + epsilon (l_N - l_S), as helicoids that stay in contact keep z - l theta/(2 pi) in step. For equal
/// leads (2.5).
template <class Number, class Real>
Number travel_per_turn(const KinematicGeometryOf<Real>& g, const Number& slip_ratio) {
  return g.lead + slip_ratio * g.lead_excess;
}

/// Stationary motion of the parts for one slip ratio and the speed of the screw against the nut
/// omega_s/n [rad/s] (Sandu 2018, (2.2), (2.4), (2.5)). For unequal leads surfaces stay in contact as
/// the rollers migrate (2.12). `spin`: turns of a roller without teeth per turn of the screw, against the carrier and
/// in its sense of rolling, beyond those with which its pitch cylinder rolls off on the nut.
template <class Number, class Real>
KinematicsOf<Number> kinematics(const KinematicGeometryOf<Real>& g, const std::type_identity_t<Real>& speed,
                                const Number& slip_ratio,
                                const std::type_identity_t<Number>& spin = Number(Real(0.0))) {
  using simd::select;
  const Number advance = -travel_per_turn(g, slip_ratio) / (2.0 * std::numbers::pi) * speed;  // advance of the nut
  const auto on_nut = g.carrier_on_nut();
  const Number turns = geared_turns(g, slip_ratio), none(Real(0.0));
  return {slip_ratio,
          (1.0 - slip_ratio) * speed,
          -((turns / g.gear_ratio + spin) * speed),
          -(slip_ratio * speed),
          select(on_nut, Number(-advance), none),
          select(on_nut, none, advance),
          select(on_nut, Real(-g.migration_lead), g.migration_lead) / (2.0 * std::numbers::pi) * turns * speed};
}

/// Relative motion of body and roller at their contact.
template <class Number>
struct ContactMotionOf {
  contact::Vector3<Number> sliding{};  ///< v, velocity of body against roller [m/s] (2.10), (2.11).
  contact::Vector3<Number> rolling{};  ///< u, sum of both velocities [m/s] (2.32), (2.33).
  Number spin{};                       ///< Spin of body against roller, about z [rad/s] (2.23), (2.24).
};
using ContactMotion = ContactMotionOf<double>;

template <class Number, class Real>
ContactMotionOf<Number> contact_motion(const KinematicGeometryOf<Real>& g, const KinematicsOf<Number>& k, Interface i) {
  const bool at_screw = i == Interface::screw;
  const Number& body = at_screw ? k.screw_to_carrier : k.nut_to_carrier;
  const Number& roller = k.roller_to_carrier;
  const Number& advance = at_screw ? k.screw_advance : k.nut_advance;
  const Real &x = g.points[i].x, &y = g.points[i].y, from_roller = x - g.centre_distance;
  return {{-((body - roller) * y), body * x - roller * from_roller, advance - k.roller_advance},
          {-((body + roller) * y), body * x + roller * from_roller, advance + k.roller_advance},
          body - roller};
}

/// The interface that slides in a mechanism whose other contact lies at its pitch point: that with the part that turns.
constexpr Interface sliding_interface(Mechanism::Type type) {
  return carrier_part(type) == Part::nut ? Interface::screw : Interface::nut;
}

/// epsilon*, at which the sliding interface slides least (Sandu 2018, (2.16) standard, (2.17) inverted). It does not
/// depend on the speed. Rollers with grooves slide at both interfaces: where their pitch cylinders roll on both.
double ideal_slip_ratio(const KinematicGeometry& geometry);

/// Slip ratios by formulas of geometry alone, for comparison with the ideal one.
struct SlipEstimates {
  double simple = 0.0;          ///< Estimate for contacts at the pitch points, (2.21) and its inverted analogue.
  std::optional<double> jones;  ///< Estimate (2.20), standard only.
};

/// Slip ratios by formulas of geometry alone: contacts at the pitch points, (1 - 2 Gamma)/(2 (1 - Gamma)) (2.21), for
/// the inverted mechanism 1/(2 (1 + Gamma)) by the same argument; and, for the standard one, Jones et al. (2.20).
SlipEstimates slip_estimates(const KinematicGeometry& geometry);

/// Admissible slip ratios, from pure sliding at one end to the ideal one at the other.
struct SlipRange {
  double pure_sliding = 0.0;  ///< 0, or 1 inverted; the rollers do not turn.
  double ideal = 0.0;         ///< epsilon*
};
SlipRange slip_range(const KinematicGeometry& geometry);

/// Share of the distance from pure sliding to the ideal slip ratio (Sandu 2018, (2.19)):
///
///     (epsilon + chi - 1)/(epsilon* + chi - 1),   chi = 1 standard, 0 inverted.
double optimality(const SlipRange& range, double slip_ratio);

}  // namespace prs
