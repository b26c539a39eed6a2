#pragma once

#include <Eigen/Core>
#include <optional>

#include "contact/mechanism_geometry.h"
#include "prs/model/mechanism.h"
#include "prs/model/part.h"

namespace prs {

/// Geometry of a mechanism that its stationary motion depends on (Sandu 2018, section 2.2).
struct KinematicGeometry {
  Mechanism::Type type = Mechanism::Type::standard;
  double lead = 0.0;             ///< l_S, > 0 right-handed [m]
  double gear_ratio = 0.0;       ///< Gamma = |l_R|/l_S, by (2.14) also r_R/r_N or r_R/r_S.
  double centre_distance = 0.0;  ///< c [m]
  /// I and J in the carrier's frame: z along the screw's axis, x towards the roller [m].
  PerInterface<Eigen::Vector3d> points;
};

/// Speeds of the parts for one slip ratio. Rotations about z, positive anticlockwise [rad/s].
struct Kinematics {
  double slip_ratio = 0.0;         ///< epsilon = omega_p/n / omega_s/n (2.2)
  double screw_to_carrier = 0.0;   ///< omega_s/p
  double roller_to_carrier = 0.0;  ///< omega_r/p, from the gears (2.4)
  double nut_to_carrier = 0.0;     ///< omega_n/p
  /// Axial velocities against the carrier, which goes with the nut of a standard and with the screw
  /// of an inverted mechanism [m/s] (2.5).
  double screw_advance = 0.0;
  double nut_advance = 0.0;
};

// What turns against the frame. The screw of a standard mechanism turns and its nut is held against
// turning; of an inverted mechanism the nut turns and the screw is held. The part that is held
// travels, and the rollers with it. omega_s/n, the speed of screw against nut, has the same sign in
// both; against the frame a screw turns with omega_s/n, a nut with -omega_s/n.

/// Speed against the frame of what turns with `against_nut` against the nut [rad/s], where the
/// screw turns with `speed` against it: omega_x/n of a standard mechanism, omega_x/n - omega_s/n of
/// an inverted one.
double against_frame(Mechanism::Type type, double against_nut, double speed);

/// Speed against the frame of the part that turns [rad/s]: omega_s/n, or -omega_s/n of a nut.
double turning_speed(Mechanism::Type type, double speed);

/// Stationary motion of the parts for one slip ratio and the speed of the screw against the nut
/// omega_s/n [rad/s] (Sandu 2018, (2.2), (2.4), (2.5)).
Kinematics kinematics(const KinematicGeometry& geometry, double speed, double slip_ratio);

/// How body and roller move against each other where they touch.
struct ContactMotion {
  Eigen::Vector3d sliding =
      Eigen::Vector3d::Zero();  ///< v, body against roller [m/s] (2.10), (2.11)
  Eigen::Vector3d rolling = Eigen::Vector3d::Zero();  ///< u, sum of both [m/s] (2.32), (2.33)
  double spin = 0.0;  ///< Body against roller, about z [rad/s] (2.23), (2.24)
};

ContactMotion contact_motion(const KinematicGeometry& geometry, const Kinematics& motion,
                             Interface interface);

/// The interface that slides in a mechanism whose other contact lies at its pitch point: the screw
/// of a standard, the nut of an inverted one.
constexpr Interface sliding_interface(Mechanism::Type type) {
  return type == Mechanism::Type::standard ? Interface::screw : Interface::nut;
}

/// epsilon*, for which the sliding interface slides least (Sandu 2018, (2.16) standard, (2.17)
/// inverted). It does not depend on the speed.
double ideal_slip_ratio(const KinematicGeometry& geometry);

/// Slip ratios by formulas of geometry alone, for comparison with the ideal one.
struct SlipEstimates {
  double simple = 0.0;          ///< Contacts at the pitch points, (2.21) and its inverted analogue.
  std::optional<double> jones;  ///< (2.20), standard only.
};

/// Slip ratios by formulas of geometry alone: contacts at the pitch points, (1 - 2 Gamma)/(2 (1 -
/// Gamma)) (2.21), for the inverted mechanism 1/(2 (1 + Gamma)) by the same argument; and, for the
/// standard one, that of Jones et al. (2.20).
SlipEstimates slip_estimates(const KinematicGeometry& geometry);

/// Admissible slip ratios, from pure sliding at one end to the ideal one at the other.
struct SlipRange {
  double pure_sliding = 0.0;  ///< 0 standard, 1 inverted; the rollers do not turn.
  double ideal = 0.0;         ///< epsilon*
};
SlipRange slip_range(const KinematicGeometry& geometry);

/// Share of the way from pure sliding to the ideal slip ratio (Sandu 2018, (2.19)):
///
///     (epsilon + chi - 1)/(epsilon* + chi - 1),   chi = 1 standard, 0 inverted.
double optimality(const SlipRange& range, double slip_ratio);

}  // namespace prs
