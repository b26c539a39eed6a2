#pragma once

#include <array>

#include "contact/hertz.h"

namespace contact {

/// A body under a contact, and how the contact moves over it in the tangent plane.
struct HeatedBody {
  double conductivity = 0.0;   ///< k [W/(m K)]
  double density = 0.0;        ///< [kg/m^3]
  double specific_heat = 0.0;  ///< [J/(kg K)]
  double speed_major = 0.0;    ///< Of its surface along the major axis of the ellipse [m/s].
  double speed_minor = 0.0;    ///< [m/s]
};

/// Largest rise of the surface of one body [K] that takes all of `power` [W], which flows in as the
/// pressure of Hertz is spread, q = q_0 sqrt(1 - x^2/a^2 - y^2/b^2), q_0 = 3 P/(2 pi a b):
///
///     1/theta^2 = 1/theta_s^2 + 1/theta_f^2,
///     theta_s = 3 P K/(4 pi k a)                             at rest, exact,
///     theta_f = 1.23462 q_0 sqrt(l/(k rho c V))              fast: a band of half length l,
///
/// K the complete elliptic integral for b/a, l half of the ellipse's length along the motion
/// through its centre. The limits are combined with the exponent of Greenwood (Wear 150 (1991)
/// 153), for ellipses in any direction by Muzychka and Yovanovich (ASME J. Heat Transfer 123 (2001)
/// 624). Half spaces, steady.
double surface_rise(const HertzContact& ellipse, const HeatedBody& body, double power);

/// Flash temperature [K]: rise of both surfaces, which are equally hot (Blok 1937), where they
/// share the power [W]: 1/theta = 1/theta_1 + 1/theta_2 with all of it in each. Above the bodies'
/// own temperature.
double flash_temperature(const HertzContact& ellipse, const std::array<HeatedBody, 2>& bodies,
                         double power);

}  // namespace contact
