#pragma once

#include <string>

#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

enum class Direction { tension, compression };

/// Sense of the axial load on the screw along x, which points from the loaded end into the
/// mechanism: -1 in tension, +1 in compression.
constexpr double sense(Direction d) { return d == Direction::tension ? -1.0 : 1.0; }

constexpr std::string_view name(Direction d) { return d == Direction::tension ? "tension" : "compression"; }

/// Source of the power: force x speed x lead > 0 of a screw that drives its load.
enum class DrivenBy { screw, load };

constexpr std::string_view name(DrivenBy by) { return by == DrivenBy::screw ? "screw" : "load"; }

/// Loads on a full mechanism besides the axial force, and positions of its parts.
struct SpatialLoad {
  /// A side force [N] or a moment [N m] on the screw; at the loaded section where `at` is absent.
  struct Across {
    Lateral value;
    std::optional<double> at;  ///< x on the nut's axis [m].

    bool operator==(const Across&) const = default;
  };
  /// Loads averaged while the carrier turns by one spacing of the rollers.
  struct Orbit {
    int steps = 8;
    double exponent = 3.0;  ///< Exponent of equivalent loads.

    bool operator==(const Orbit&) const = default;
  };
  double carrier_angle = 0.0;  ///< Azimuth of the first roller, from y towards z [rad].
  Lateral eccentricity;        ///< Point of the loaded section where the axial force acts [m].
  Across side_force;
  Across moment;
  Lateral nut_tilt;    ///< Rotation of the seat of the nut [rad].
  Lateral nut_offset;  ///< Displacement of the seat of the nut [m].
  std::optional<Orbit> orbit;

  /// Whether threads carry load, and the screw moves, without any axial force.
  bool acts_across() const {
    return side_force.value != Lateral{} || moment.value != Lateral{} || nut_tilt != Lateral{} ||
           nut_offset != Lateral{};
  }
  bool operator==(const SpatialLoad&) const = default;
};

/// Positions of the turning mechanism, full mechanism only.
struct Travel {
  enum class Part { screw, nut };
  enum class SlipRatio {
    rolling,  ///< Ratio of rolling pitch cylinders: d_S/(d_S + d_N).
    ideal,    ///< Ratio at which the sliding interface slides least.
    solved,   ///< Ratio that the slip analysis finds.
  };
  int turns = 1;      ///< Turns of the screw against the nut; < 0 backwards.
  int steps = 36;     ///< Positions in a turn.
  double from = 0.0;  ///< Angle of the first position [rad].
  Part part = Part::screw;
  SlipRatio slip_ratio = SlipRatio::rolling;
  /// Slip ratio that replaces the above if it is a number.
  double stated_slip_ratio = std::numeric_limits<double>::quiet_NaN();

  /// M, number of the last position: there are M + 1 positions.
  int last() const { return std::abs(turns) * steps; }
  /// theta of position k [rad].
  double angle(int k) const { return from + (turns < 0 ? -2.0 : 2.0) * std::numbers::pi * k / steps; }
};

/// Axial support of the mechanism while it vibrates.
struct AxialSupport {
  enum class At {
    nut,
    screw,         ///< Fixed at the loaded section; the nut is free along the axis.
    screw_spring,  ///< On a spring at the loaded section; the nut is free along the axis.
  };
  At at = At::nut;
  double stiffness = 0.0;  ///< Stiffness of the spring [N/m].
};

/// Natural frequencies to compute, full mechanism only.
struct Modes {
  int count = 10;
  AxialSupport axial_support;
  bool prestress = false;
  std::optional<int> positions;  ///< Number of positions of the travel at which frequencies are computed.
};

/// Name of the back-driven load case that a written candidate has besides those of its cycle; headline values ignore
/// it.
inline constexpr std::string_view kBackDriving = "back-driving";

/// One load on the mechanism. A range in the input becomes one case per point.
struct LoadCase {
  /// Distribution of the load over the threads: solved from the structure, or assumed equal.
  enum class Share { solved, equal };

  std::string name;
  double axial_force = 0.0;  ///< [N]; > 0 with `direction`, else signed (I2J1 if < 0).
  std::optional<Direction> direction = {};
  std::optional<double> position = {};  ///< Position of the first roller contact on the nut [m].
  Share share = Share::solved;
  std::optional<double> speed = {};  ///< Speed that replaces the operation's [rad/s].
  SpatialLoad spatial = {};
  std::optional<Travel> travel = {};
  std::optional<Modes> modes = {};
  std::string input_path = {};  ///< Path of the case in the input, e.g. `load_cases[2]`.

  bool is_solved() const { return share == Share::solved; }
};

/// Path of one of its inputs: `load_cases[2].axial_force`.
inline std::string path_in(const LoadCase& c, std::string_view key) {
  std::string path = c.input_path.empty() ? "load_cases[]" : c.input_path;
  return path.append(".").append(key);
}

/// F_N [N] of Sandu 2018: > 0 in tension (contacts I1J2), < 0 in compression (I2J1).
inline double axial_force_on_nut(const LoadCase& c) {
  return c.direction == Direction::compression ? -c.axial_force : c.axial_force;
}

template <class T>
struct PerDirection {
  T tension{};
  T compression{};

  T& operator[](Direction d) { return d == Direction::tension ? tension : compression; }
  const T& operator[](Direction d) const { return const_cast<PerDirection&>(*this)[d]; }
};

inline constexpr Direction kDirections[] = {Direction::tension, Direction::compression};

constexpr Direction opposite(Direction d) {
  return d == Direction::tension ? Direction::compression : Direction::tension;
}

/// Ring between the two nuts of a double nut, of the nut's material.
struct Spacer {
  double length = 0.0;          ///< [m]
  double inner_diameter = 0.0;  ///< [m]
  double outer_diameter = 0.0;  ///< [m]
};

/// External axial loads at equal distances, ends included; > 0 in tension [N].
struct LoadSweep {
  double from = 0.0;
  double to = 0.0;
  int steps = 41;
  std::vector<double> loads = {};  ///< Loads that replace the range, if any.
};

/// How play is removed from a mechanism, and the external loads of its curve. One of `force`, `interference` and
/// `backlash` is given.
struct Preload {
  enum class Arrangement {
    single_nut,  ///< Rollers wedged in the grooves of screw and nut, on both flanks.
    double_nut,  ///< Two nuts on one screw, each with its rollers, pushed apart by a spacer.
  };

  Arrangement arrangement = Arrangement::single_nut;
  std::optional<double> force;  ///< Axial load of each side without external load [N].
  /// Single nut: pitch diameter of the rollers above the one that just fills the grooves. Double
  /// nut: length of the spacer above the one that just touches [m].
  std::optional<double> interference;
  std::optional<double> backlash;  ///< Axial play instead of preload [m].
  double position = 0.0;           ///< Position of the first roller contact on the first nut [m].
  std::optional<Spacer> spacer;    ///< Ring of a double nut.
  /// Distance from the last contact of the first nut to the first contact of the second [m].
  std::optional<double> distance;
  LoadSweep load;
  /// Load case whose steady temperatures the curve is computed at, with `heat`; the first by default.
  std::optional<std::string> load_case;
  /// Load at which lost motion is read [N]; `kLostMotionShare` of the largest if absent.
  std::optional<double> lost_motion_load;
};

/// Default load at which lost motion is read, as a share of the largest load of the curve.
inline constexpr double kLostMotionShare = 0.05;

/// Axial position of the first contact on the second nut of a double nut [m].
inline double second_position(const Mechanism& m, const Structure::Nut& nut, const Preload& preload) {
  const double last = preload.position + (m.contacts_per_roller - 1) * axial_pitch(m);
  return *preload.distance - (nut.length - last) - preload.spacer->length;
}

/// A column of a file of comma-separated values, by its name in the heading.
struct CsvColumn {
  std::string column;
  std::string unit;

  bool operator==(const CsvColumn&) const = default;
};

/// Loads over time or travel, from a file: one row per sample. The screw's turning between two samples follows from
/// `position`, from `speed` and the time, or from the operation's speed and the time.
struct HistorySource {
  std::string file;                        ///< Path relative to the input file.
  std::optional<std::string> sha256 = {};  ///< Expected SHA-256 of the file, hexadecimal.
  CsvColumn force;                         ///< Column of the force, > 0 in tension.
  std::optional<CsvColumn> time;
  std::optional<double> interval;  ///< Time between two samples [s], if there is no column `time`.
  std::optional<CsvColumn> position;
  std::optional<CsvColumn> speed;
  /// Source of the power under running loads. `travel`: position grows as the screw moves out at its loaded end, so
  /// that the load drives if force x change > 0; a speed counts as in slip.
  enum class DrivenBy { travel, screw, load };
  std::optional<DrivenBy> driven_by;  ///< If absent: travel where position or speed shows it.
  double hysteresis = 0.0;            ///< Largest range that does not count as a load cycle [N].
  int bins = 32;                      ///< Number of classes of the cycle matrix, along range and mean.

  bool operator==(const HistorySource&) const = default;
};

/// A load of a spectrum and how long it acts; one of the last four members before `driven_by` is given.
struct SpectrumLoad {
  double force = 0.0;  ///< [N], > 0; 0 under preload alone
  Direction direction = Direction::tension;
  std::optional<double> revolutions = {};  ///< Revolutions of the screw against the nut.
  std::optional<double> distance = {};     ///< Travel under the load [m].
  std::optional<double> duration = {};     ///< Time at the operation's speed [s].
  std::optional<double> share = {};        ///< Share of all revolutions.
  DrivenBy driven_by = DrivenBy::screw;    ///< Source of the power under running loads.
};

/// Temperatures of the parts in `life` if there is a block `heat`.
enum class LifeTemperatures {
  heat,       ///< Temperatures from the mean heat of the whole spectrum.
  reference,  ///< The reference temperature of all parts.
};

/// Inputs of `prs life`. One of `history` and `spectrum` is given.
struct Life {
  std::optional<HistorySource> history;
  std::vector<SpectrumLoad> spectrum;
  LoadCase::Share share = LoadCase::Share::solved;
  LifeTemperatures temperatures = LifeTemperatures::heat;
  std::optional<double> position;  ///< Position of the first roller contact on the nut [m].
  /// Clock time of one pass of the spectrum, with rests and travel without force [s].
  std::optional<double> period;
  std::optional<double> travel;            ///< Travel of one pass in both senses, with travel without force [m].
  std::optional<double> stroke;            ///< Distance between the extreme positions under load [m].
  std::optional<double> dynamic_capacity;  ///< C_a of a catalogue [N], replaces Lemor's.
  std::optional<double> static_capacity;   ///< C_0 of a catalogue [N].
  double reliability = 0.90;               ///< Probability of reaching the rated life.
  double modification_factor = 1.0;        ///< a_ISO of ISO 281, of the rated life.
  std::optional<double> contamination;     ///< e_C of ISO 281, for an a_ISO that is shown besides.
  /// Load case whose side loads, misalignment and orbit apply to all forces; full mechanism only.
  std::optional<std::string> load_case;
  /// Whether the temperatures of the parts follow from a block `heat`.
  bool takes_heat(bool has_heat) const {
    return has_heat && share == LoadCase::Share::solved && temperatures == LifeTemperatures::heat;
  }
  double fatigue_slope = 5.0;  ///< Exponent k of the equivalent load range: FKM, steel, normal stress.
};

/// Samples of a load over time or travel, SI units. Members without a column in the file are empty.
struct LoadHistory {
  std::vector<double> force;       ///< > 0 in tension [N]
  std::vector<double> time;        ///< [s], not decreasing
  std::vector<double> position;    ///< [m]
  std::vector<double> speed;       ///< [rad/s], of either sign
  bool speed_along_axis = false;   ///< Whether speeds are those of the travel [m/s].
  std::optional<double> interval;  ///< Time between two samples [s], if `time` is empty.
};

}  // namespace prs
