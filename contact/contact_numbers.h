#pragma once

#include <span>
#include <vector>

#include "contact/contact_formulas.h"
#include "contact/hertz_formulas.h"
#include "simd/instruction_set.h"

namespace contact {

struct MechanismGeometry;

/// A mechanism as numbers: its threads, the distance of their axes and the contact moduli E* [Pa], 0 if there are none.
template <class Real>
struct MechanismNumbers {
  ThreadNumbers<Real> screw, roller, nut;
  Real centre_distance;
  Real modulus_at_screw, modulus_at_nut;
};

/// Angle psi between a contact normal and the axis [rad], `ContactPoint::normal_angle`.
template <class Real>
struct NormalNumbers {
  Real angle{}, cosine{}, sine{};
};

template <class Real>
NormalNumbers<Real> normal_numbers(const Vector3<Real>& n) {
  const Real cosine = abs(n.z), sine = sqrt(n.x * n.x + n.y * n.y);
  return {atan2(sine, cosine), cosine, sine};
}

/// Contact of one interface, from its threads to Hertz's constants.
template <class Real>
struct ContactNumbers {
  InterfaceGeometryOf<Real> geometry;
  NormalNumbers<Real> normal;
  HertzConstantsOf<Real> hertz;
};

template <class Real>
ContactNumbers<Real> contact_numbers(const FlankPair<Real>& pair, const Real& modulus) {
  const InterfaceGeometryOf<Real> geometry = interface_at(pair, contact_point(pair));
  return {geometry, normal_numbers(geometry.point.normal), hertz_constants(geometry.relative, modulus)};
}

/// Both contacts of a mechanism (I1J2).
template <class Real>
struct MechanismContactNumbers {
  Real sound{};  ///< 1 if all three threads are possible; if 0, the contacts are undefined.
  ContactNumbers<Real> screw, nut;
};

template <class Real>
MechanismContactNumbers<Real> contact_numbers(const MechanismNumbers<Real>& m) {
  const auto sound = [](const ThreadNumbers<Real>& thread, const Flank<Real>& flank) {
    const simd::EnumOf<ThreadStatus, Real> status = status_of(thread, flank);
    return (status == ThreadStatus::ok || status == ThreadStatus::beyond_sharp_limit) &&
           flank.smallest_radius < flank.largest_radius;
  };
  const Flank<Real> screw = flank_of(m.screw, false), roller = flank_of(m.roller, false), nut = flank_of(m.nut, true);
  // I1J2: the top face of the roller touches the screw, the bottom face the nut.
  const FlankPair<Real> at_screw{screw, roller, m.centre_distance, -1.0}, at_nut{nut, roller, m.centre_distance, 1.0};
  return {select(sound(m.screw, screw) && sound(m.roller, roller) && sound(m.nut, nut), Real(1.0), Real(0.0)),
          contact_numbers(at_screw, m.modulus_at_screw), contact_numbers(at_nut, m.modulus_at_nut)};
}

MechanismNumbers<double> numbers_of(const MechanismGeometry& mechanism);

/// Contacts of many mechanisms, as many side by side as a batch has numbers. Results of a mechanism do not depend on
/// the others.
void find_contacts(std::span<const MechanismNumbers<double>> mechanisms,
                   std::span<MechanismContactNumbers<double>> contacts,
                   simd::InstructionSet set = simd::InstructionSet::best);

/// Approaches delta of contacts whose loads are k_0 delta^1.5, so that N^(1/3) is k_0^(1/3) sqrt(delta), without a cube
/// root per contact.
struct KnownApproach {
  std::span<const double> approach = {};  ///< Approaches [m]; empty: not known.
  double cbrt_constant = 0.0;             ///< k_0^(1/3) [N^(1/3)/m^(1/2)]
};

/// Ellipses and pressures under many loads, as many side by side as a batch has numbers.
void set_ellipses(const HertzConstants& constants, const std::vector<double>& normal_load,
                  std::vector<double>& semi_major, std::vector<double>& semi_minor, std::vector<double>& peak_pressure,
                  simd::InstructionSet set, const KnownApproach& known = {});

}  // namespace contact
