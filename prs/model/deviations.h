#pragma once

#include <vector>

#include "prs/model/part.h"

namespace prs {

/// amplitude sin(2 pi k/period + phase) at contact k = 0, 1, ..
struct PitchWave {
  double amplitude = 0.0;  ///< [m]
  double period = 0.0;     ///< Threads.
  double phase = 0.0;      ///< [rad]
};

/// Axial position error of a part's threads along the loaded length: the sum of the three members.
struct PitchError {
  double linear = 0.0;  ///< Error at the last contact, 0 at the first [m].
  std::optional<PitchWave> periodic;
  std::vector<double> list;  ///< One per contact, or none [m].
  /// One list per roller of a full mechanism in place of `list`, or none.
  std::vector<std::vector<double>> lists = {};
};

/// Straight taper of the roller's pitch radius at both ends.
struct EndRelief {
  double drop = 0.0;  ///< Drop of the radius at the outermost contact [m].
  int threads = 1;    ///< Number of relieved contacts at each end.
};

/// An error that turns with its part: `amount` at the azimuth `angle` of the part.
struct TurningError {
  double amount = 0.0;  ///< [m], [rad]
  double angle = 0.0;   ///< [rad]

  bool operator==(const TurningError&) const = default;
};

/// amplitude sin(order alpha + phase) over a turn of the part.
struct LeadHarmonic {
  int order = 1;
  double amplitude = 0.0;  ///< [m]
  double phase = 0.0;      ///< [rad]

  bool operator==(const LeadHarmonic&) const = default;
};

/// amplitude sin(2 pi xi/length + phase) along the part.
struct LeadWave {
  double length = 0.0;     ///< [m]
  double amplitude = 0.0;  ///< [m]
  double phase = 0.0;      ///< [rad]

  bool operator==(const LeadWave&) const = default;
};

/// Measured lead error, linear between the places `at`.
struct MeasuredLead {
  std::vector<double> at;         ///< xi, rising [m].
  std::vector<double> deviation;  ///< [m]

  bool operator==(const MeasuredLead&) const = default;
};

/// Errors of the thread of screw or nut that turn with it. xi along the part is counted from the place of the first
/// contact before anything turns.
struct TurningThread {
  TurningError eccentricity;
  TurningError wobble;
  std::optional<double> wobble_at;  ///< xi that the wobble leaves in place; the middle if absent.
  double per_300_mm = 0.0;          ///< Lead deviation over 300 mm, > 0: threads too far apart [m].
  std::vector<LeadHarmonic> harmonics;
  std::vector<LeadWave> waves;
  std::optional<MeasuredLead> measured;

  bool operator==(const TurningThread&) const = default;
};

/// One value for all rollers, or one for each.
struct RollerValue {
  double one = 0.0;
  std::vector<double> many;

  double of(std::size_t roller) const { return many.empty() ? one : many[roller]; }
  bool operator==(const RollerValue&) const = default;
};

/// Errors of the rollers' threads that turn with them.
struct TurningRollers {
  struct Error {
    RollerValue amount, angle;
    bool operator==(const Error&) const = default;
  };
  struct Harmonic {
    int order = 1;
    RollerValue amplitude, phase;
    bool operator==(const Harmonic&) const = default;
  };
  Error eccentricity, wobble;
  std::vector<Harmonic> harmonics;

  bool operator==(const TurningRollers&) const = default;
};

/// Errors of a full mechanism that turn with their part.
struct Turning {
  PerInterface<TurningThread> thread;
  TurningRollers rollers;

  bool operator==(const Turning&) const = default;
};

/// Largest error of position, as a share of the pitch: a larger one means other threads, or a wrong unit.
inline constexpr double kMostDeviation = 0.25;

/// Deviations of the real parts of one sector from their nominal geometry. SI units.
struct Deviations {
  PerPart<PitchError> pitch_error;  ///< Positive away from the loaded end of the screw.
  double roller_diameter = 0.0;     ///< Excess of the pitch diameter over the nominal one [m].
  double crowning = 0.0;            ///< Parabolic drop of the roller's pitch radius at first and last contact [m].
  std::optional<EndRelief> end_relief;
  std::optional<PerPart<double>> temperature;  ///< Temperature, uniform in each part [K].
  double reference_temperature = 293.15;       ///< Temperature of the nominal geometry [K].

  // Members from here on: full mechanism only.
  std::vector<double> roller_diameters;         ///< One per roller in place of `roller_diameter`, or none.
  PerEnd<std::vector<double>> roller_position;  ///< Outward displacement, one per roller, or none [m].
  std::vector<int> missing_rollers;             ///< Numbers of the missing rollers, from 1.
  /// Axial position error of each start, or none [m].
  PerInterface<std::vector<double>> index_error;
  PerInterface<Lateral> thread_eccentricity;  ///< Offset of the thread's axis on screw and nut [m].
  Turning turning;
};

}  // namespace prs
