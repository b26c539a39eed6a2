#pragma once

#include <optional>

namespace prs {

/// What the design measures need besides the mechanism, its structure and its loads. SI units.
struct MeasureOptions {
  /// How the two ends of the loaded length of the screw are held.
  enum class Ends {
    fixed_free,
    supported_supported,
    fixed_supported,
    fixed_fixed,
  };
  struct Shaft {
    double length = 0.0;  ///< Greatest distance between the supports of the screw [m].
    Ends ends = Ends::supported_supported;
  };

  /// What stands in series with the mechanism between drive and load; what is left out is rigid.
  struct System {
    enum class Axial { one_end, both_ends };  ///< Where axial bearings hold the shaft.
    /// From the loaded section of the screw to its bearings; unlike `MeasureOptions::shaft`, which
    /// is for buckling and critical speed and has a length of its own.
    struct Shaft {
      double length = 0.0;  ///< L to the one axial bearing, or between the two [m].
      Axial axial = Axial::one_end;
      std::optional<double> from_bearing;    ///< x from the nearer one of two bearings [m].
      std::optional<double> torsion_length;  ///< L_t to where rotation is held; default L [m].
    };
    std::optional<Shaft> shaft;
    std::optional<double> support_bearing;  ///< All bearings of the shaft together [N/m].
    std::optional<double> housing;          ///< [N/m]
  };

  std::optional<double> loaded_width;  ///< Thread width that one contact loads, for Yamamoto [m].
  std::optional<double> friction_coefficient;  ///< For the estimate of efficiency.
  std::optional<double> yield_strength;        ///< [Pa]
  std::optional<Shaft> shaft;
  std::optional<System> system;
};

}  // namespace prs
