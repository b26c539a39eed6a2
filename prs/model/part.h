#pragma once

#include <limits>
#include <optional>

#include "contact/hertz.h"

namespace prs {

/// The three threaded parts of a planetary roller screw.
enum class Part { screw, roller, nut };

/// The two contact interfaces of a roller: `screw` is the roller-screw interface (I in Sandu 2018,
/// k in Abevi 2015), `nut` the roller-nut interface (J, g).
enum class Interface { screw, nut };

inline constexpr Interface kInterfaces[] = {Interface::screw, Interface::nut};
inline constexpr Part kParts[] = {Part::screw, Part::roller, Part::nut};

template <class T>
struct PerPart {
  T screw{};
  T roller{};
  T nut{};

  T& operator[](Part p) { return p == Part::screw ? screw : p == Part::roller ? roller : nut; }
  const T& operator[](Part p) const { return const_cast<PerPart&>(*this)[p]; }
  bool operator==(const PerPart&) const = default;
};

template <class T>
struct PerInterface {
  T screw{};
  T nut{};

  T& operator[](Interface i) { return i == Interface::screw ? screw : nut; }
  const T& operator[](Interface i) const { return const_cast<PerInterface&>(*this)[i]; }
  bool operator==(const PerInterface&) const = default;
};

template <class T>
constexpr PerInterface<T> at_both(const T& value) {
  return {value, value};
}

/// The part that the roller touches at an interface.
constexpr Part body_of(Interface i) { return i == Interface::screw ? Part::screw : Part::nut; }

constexpr std::string_view name(Part p) { return p == Part::screw ? "screw" : p == Part::roller ? "roller" : "nut"; }

constexpr std::string_view name(Interface i) { return i == Interface::screw ? "screw" : "nut"; }

/// Components across the axis. A rotation turns about y or z, from z to x and from x to y.
struct Lateral {
  double y = 0.0;
  double z = 0.0;

  bool operator==(const Lateral&) const = default;
};

/// Component along the direction at the azimuth `angle`, from y towards z.
inline double along(const Lateral& l, double angle) { return l.y * std::cos(angle) + l.z * std::sin(angle); }

/// Stiffness of a support that does not give.
inline constexpr double kRigid = std::numeric_limits<double>::infinity();

/// Values at the near and at the far end of the rollers.
template <class T>
struct PerEnd {
  T near{};
  T far{};
};

/// Linear elastic, isotropic material. SI units.
struct Material {
  double youngs_modulus = 0.0;    ///< E [Pa]
  double poisson_ratio = 0.0;     ///< nu
  std::optional<double> density;  ///< Density [kg/m^3], for weight, centrifugal force, flash temperature.
  /// Thermal expansion [1/K]; needed if temperatures are given.
  std::optional<double> thermal_expansion = std::nullopt;
  std::optional<double> conductivity = std::nullopt;   ///< Thermal conductivity [W/(m K)], for flash temperatures.
  std::optional<double> specific_heat = std::nullopt;  ///< Specific heat [J/(kg K)], for flash temperatures.

  /// Peak pressure that a contact may have at rest [Pa]; if absent that of bearing steel, for steel only.
  std::optional<double> static_pressure_limit = std::nullopt;

  operator contact::Elasticity() const { return {youngs_modulus, poisson_ratio}; }
};

using Materials = PerPart<Material>;

/// Contact pressure beyond which the static capacity of through-hardened steel is exceeded: a
/// permanent deformation of 1e-4 of the element's diameter at 4.0 GPa (ISO 76:2006, roller
/// bearings).
inline constexpr double kStaticPressureLimit = 4.0e9;

/// Whether rules from tests with bearing steel apply to a material: capacities, 4 GPa, permanent deformation.
inline bool is_steel(const Material& m) { return m.youngs_modulus >= 190e9 && m.youngs_modulus <= 230e9; }
inline bool is_steel(const Materials& m) { return is_steel(m.screw) && is_steel(m.roller) && is_steel(m.nut); }

/// Peak pressure that contacts of two parts may have at rest: the smaller of the stated limits and, for steel,
/// `kStaticPressureLimit`. Absent if no limit is known for one of the parts.
inline std::optional<double> static_pressure_limit(const Material& a, const Material& b) {
  std::optional<double> limit;
  for (const Material* m : {&a, &b}) {
    if (!m->static_pressure_limit && !is_steel(*m)) return std::nullopt;
    limit = std::min(m->static_pressure_limit.value_or(kStaticPressureLimit), limit.value_or(HUGE_VAL));
  }
  return limit;
}

}  // namespace prs
