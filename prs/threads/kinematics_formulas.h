#pragma once

#include <numbers>

#include "contact/contact_formulas.h"
#include "prs/model/part.h"
#include "simd/dual.h"

/// Formulas of kinematics.h for numbers, batches with one mechanism per lane, and either with a
/// slope along the slip ratio.
namespace prs {

/// See `KinematicGeometry`.
template <class Real>
struct KinematicNumbers {
  Real standard{};  ///< 1 standard, 0 inverted.
  Real lead{}, gear_ratio{}, centre_distance{};
  PerInterface<contact::Vector2<Real>> points{};

  simd::Lanes<Real> is_standard() const { return standard > Real(0.0); }
};

/// Speed against the frame, by that against the nut: see `against_frame` of kinematics.h.
template <class Number, class Real>
Number against_frame_of(const simd::Lanes<Real>& is_standard, const Number& against_nut,
                        const Real& speed) {
  using simd::select;
  return select(is_standard, against_nut, Number(against_nut - speed));
}

/// See `Kinematics`.
template <class Number>
struct KinematicsOf {
  Number slip_ratio{}, screw_to_carrier{}, roller_to_carrier{}, nut_to_carrier{};
  simd::ValueOf<Number> screw_advance{}, nut_advance{};
};

template <class Number, class Real>
KinematicsOf<Number> kinematics_of(const KinematicNumbers<Real>& g, const Real& speed,
                                   const Number& slip_ratio) {
  using simd::select;
  const Real advance = -g.lead / (2.0 * std::numbers::pi) * speed;  // of the nut on the screw
  const auto standard = g.is_standard();
  const Number rest = 1.0 - slip_ratio;
  return {slip_ratio,
          rest * speed,
          -(select(standard, slip_ratio, rest) / g.gear_ratio * speed),
          -(slip_ratio * speed),
          select(standard, Real(-advance), Real(0.0)),
          select(standard, Real(0.0), advance)};
}

/// See `ContactMotion`.
template <class Number>
struct ContactMotionOf {
  contact::Vector3<Number> sliding, rolling;
  Number spin;
};

template <class Number, class Real>
ContactMotionOf<Number> contact_motion_of(const KinematicNumbers<Real>& g,
                                          const KinematicsOf<Number>& k, Interface i) {
  const bool at_screw = i == Interface::screw;
  const Number& body = at_screw ? k.screw_to_carrier : k.nut_to_carrier;
  const Number& roller = k.roller_to_carrier;
  const Number advance(at_screw ? k.screw_advance : k.nut_advance);
  const Real &x = g.points[i].x, &y = g.points[i].y, from_roller = x - g.centre_distance;
  return {{-((body - roller) * y), body * x - roller * from_roller, advance},
          {-((body + roller) * y), body * x + roller * from_roller, advance},
          body - roller};
}

}  // namespace prs
