#pragma once

#include <optional>
#include <string>
#include <vector>

namespace prs {

/// Heat transfer of bare parts in still air, free convection and radiation together [W/(m^2 K)]: 5
/// to 15 for parts of some cm that are 20 to 80 K warmer than the room (Incropera, DeWitt,
/// Fundamentals of Heat and Mass Transfer, chapters 1 and 9).
inline constexpr double kStillAir = 10.0;

/// How the parts pass the heat of friction on, and the duty cycle that warms them. SI units.
struct Heat {
  /// Between two parts, or from a part to its surroundings [W/K].
  struct Conductance {
    double screw_ambient = 0.0;
    double nut_ambient = 0.0;
    double rollers_ambient = 0.0;
    double screw_rollers = 0.0;
    double rollers_nut = 0.0;

    double to_ambient() const { return screw_ambient + nut_ambient + rollers_ambient; }
  };
  /// A load case for a while, or a rest without motion.
  struct DutyStep {
    std::optional<std::string> load_case;  ///< Name of the load case; none: a rest.
    std::optional<double> duration;        ///< Duration of the load case [s].
    std::optional<double> rest;            ///< Duration of a rest [s].

    double time() const { return load_case ? *duration : *rest; }
  };
  /// Heat capacities [J/K]; `rollers`: all of them together.
  struct Capacity {
    double screw = 0.0;
    double rollers = 0.0;
    double nut = 0.0;
  };

  double ambient = 0.0;  ///< [K]
  Conductance conductance;
  std::vector<DutyStep> duty;  ///< Repeated without end; none: no cycle.
  std::optional<Capacity> capacity;
  std::optional<double> specific_heat;  ///< One for all parts, in place of `capacity` [J/(kg K)].
};

}  // namespace prs
