#pragma once

#include "prs/input/echo.h"
#include "prs/model/limits.h"
#include "prs/model/motor_duty.h"

namespace prs {

/// Values of a dimension of designs: a list or a range.
struct DesignValues {
  enum class Series { R5, R10, R20, R40 };  ///< Preferred numbers of ISO 3.
  struct Span {
    double from = 0.0, to = 0.0;
    std::optional<int> steps;
    std::optional<Series> series;
  };
  std::vector<double> list;
  std::optional<Span> span;  ///< Range, in place of the list.

  /// All values, ends included; a series counts in mm.
  std::vector<double> values() const;
};

/// Requirements on a screw, its motor and its brake, and the range of choice. SI units. Members that are absent after a
/// file is read have no default: there is no such criterion.
struct Requirement {
  struct Segment {
    std::optional<std::string> name;
    double duration = 0.0;   ///< [s]
    double end_speed = 0.0;  ///< [m/s], of a lever [rad/s].
    double force = 0.0;      ///< External force [N], > 0 against the positive sense.
    double torque = 0.0;     ///< External torque at a lever, in its place [N m].
  };
  struct ConstantLoad {
    std::optional<std::string> name;
    double force = 0.0;  ///< Force as in a segment [N].
    double speed = 0.0;  ///< [m/s]
    double share = 0.0;  ///< Share of the period.
  };
  struct History {
    std::string file;
    CsvColumn time{"time", ""}, speed{"speed", ""}, force{"force", ""};
    CsvColumn angle{"angle", ""}, torque{"torque", ""};  ///< Columns of a lever, in place of speed and force.
  };
  struct Motion {
    double start_speed = 0.0;           ///< [m/s], of a lever [rad/s].
    std::optional<double> start_angle;  ///< Angle of a lever before the first segment [rad].
    std::optional<std::vector<Segment>> segments;
    std::optional<History> history;
    std::optional<std::vector<ConstantLoad>> loads;
    double period = 3600.0;  ///< Period of the cycle of `loads` [s].
  };
  struct Load {
    double moved_mass = 0.0;   ///< [kg]
    double inertia = 0.0;      ///< Inertia of a lever about its joint, in place of the mass [kg m^2].
    double inclination = 0.0;  ///< Angle [rad], > 0: the positive sense is upwards.
    double guide_friction = 0.0;
    double resistance = 0.0;   ///< Force against the motion [N].
    double drag_torque = 0.0;  ///< Torque against the motion, at the turning part [N m].
    std::optional<Direction> positive_force;
  };
  struct Measures : MeasureOptions {
    Measures() {
      friction_coefficient = 0.01;
      yield_strength = 700e6;
    }
  };
  struct Shaft {
    std::optional<double> length;  ///< Length between its supports [m].
    MeasureOptions::Ends ends = MeasureOptions::Ends::fixed_supported;
  };
  enum class Basis { maker, threads };
  struct Life {
    std::optional<double> hours;     ///< Clock time [s].
    std::optional<double> distance;  ///< Distance in place of hours [m].
    double reliability = 0.90;
    double modification_factor = 1.0;
    std::optional<Basis> basis;  ///< `maker` if only a catalogue is ranked, else `threads`.
  };
  /// Limits by default: makers ask for a static safety of 1 to 3, more under shock; catalogues allow half of the
  /// buckling load, 80 % of the critical speed and n d up to 150,000 mm/min.
  struct Limits : prs::Limits {
    Limits() {
      static_safety = 1.5;
      buckling_safety = 2.0;
      critical_speed_share = 0.8;
      speed_times_diameter = 2.5;
    }
    BackDriving back_driving = BackDriving::allowed;
    std::optional<double> relubrication;  ///< Shortest interval [s].
  };
  enum class Losses { slip, catalogue };
  /// Stated conductances; others follow by the rule of `prs new` [W/K].
  struct Conductance {
    std::optional<double> screw_ambient, nut_ambient, rollers_ambient, screw_rollers, rollers_nut;
  };
  struct Relubrication {
    double static_load_factor = 0.0;
    double peak_force = 0.0;  ///< Printed peak force of the actuator [N].
  };
  struct Designs {
    std::vector<Mechanism::Type> type{Mechanism::Type::standard};
    DesignValues screw_diameter, lead;
    std::optional<DesignValues> starts;  ///< By the rule of `prs new` if absent.
  };
  struct Catalogue {
    std::string file;
    std::optional<std::string> source;  ///< Name that its rows have as their source; by default that of the file.
  };
  struct Candidates {
    std::optional<std::vector<Catalogue>> catalogue;
    std::optional<Designs> designs;  ///< Designs; without these and a file: the catalogue of the program.
  };
  /// Preload of a single nut, one of the two.
  struct Preload {
    std::optional<double> force;  ///< [N]
    std::optional<double> share;  ///< Share of C_a, of the row or else Lemor's.
  };
  enum class Objective { weight, nut_diameter, life, motor_torque, power_lost };

  std::optional<PrsLinkage> linkage;  ///< Linkage of a lever whose angle and torque `motion` has.
  Motion motion;
  Load load;
  std::optional<double> stroke;  ///< [m]
  Measures measures;
  Shaft shaft;
  std::optional<Bearings> bearings;
  Life life;
  Limits limits;
  DriveMotor motor;
  std::optional<double> brake_torque;  ///< Torque at the motor's shaft [N m].
  double brake_safety = 1.5;           ///< Least brake torque over the holding torque.
  std::optional<Preload> preload;
  Losses losses = Losses::slip;
  ModelOptions::Loads loads = ModelOptions::Loads::running;
  std::optional<Friction> friction;
  std::optional<Lubricant> lubricant;
  std::optional<PerPart<double>> roughness;  ///< Rq [m].
  Carrier carrier;
  struct Surroundings {
    double ambient = 298.15;  ///< [K]
    Conductance conductance;
    std::optional<int> cycles;             ///< Number of cycles of a mission, see `Heat::cycles`.
    std::optional<PerPart<double>> start;  ///< [K]
  };
  std::optional<Surroundings> heat;  ///< Surroundings, without which no temperature is known.
  /// Whether temperatures are those of a mission.
  bool has_mission() const { return heat && heat->cycles && losses == Losses::slip; }
  std::optional<Relubrication> relubrication;
  Candidates candidates;
  Objective objective = Objective::weight;
};

constexpr std::string_view name(Requirement::Basis basis) {
  return basis == Requirement::Basis::maker ? "maker" : "threads";
}
std::string name(Requirement::Objective objective);

/// One segment of constant acceleration, or a class of many samples. SI units.
struct MotionSegment {
  std::string name;
  double duration = 0.0, start_speed = 0.0, end_speed = 0.0, external_force = 0.0;
  double force = 0.0;                     ///< Axial force on the screw, > 0 if it pushes in the positive sense.
  std::size_t shown_as = 0;               ///< Index among the shown segments; for classes that of the class.
  std::optional<double> own_travel = {};  ///< Travel of a class, or between two samples of a lever.
  /// Larger magnitude of the external forces of two samples, of which `external_force` is the mean [N].
  double force_of_samples = 0.0;

  double acceleration() const { return (end_speed - start_speed) / duration; }
  double travel() const { return own_travel.value_or(0.5 * (start_speed + end_speed) * duration); }
  int sense() const { return travel() > 0.0 ? 1 : travel() < 0.0 ? -1 : 0; }
  double mean_speed() const { return std::abs(travel()) / duration; }
  double largest_speed() const { return std::max(std::abs(start_speed), std::abs(end_speed)); }
  double work() const { return std::abs(force * travel()); }
  DrivenBy driven_by() const { return force * sense() < 0.0 ? DrivenBy::load : DrivenBy::screw; }
};

/// One cycle of the axis, the same for all candidates. SI units.
struct MotionCycle {
  std::vector<MotionSegment> all;    ///< All segments, cut where the speed changes its sign.
  std::vector<MotionSegment> shown;  ///< Shown segments: all, or classes of many.
  bool in_classes = false;

  double duration = 0.0, moving = 0.0;          ///< [s]
  double travel = 0.0, loaded_travel = 0.0;     ///< Travel in both senses [m].
  double way = 0.0;                             ///< Distance between the extreme positions [m].
  double left_over = 0.0;                       ///< Distance from the first position to the last [m].
  double loaded_way = 0.0;                      ///< Distance under more than half of the mean load [m].
  std::optional<double> mean_load, mean_speed;  ///< Absent if nothing moves under force.
  double largest_force = 0.0, largest_speed = 0.0, rms_speed = 0.0;
  double largest_sign = 1.0;         ///< Sign of the largest force.
  double holding_force = 0.0;        ///< Largest force at rest, else the weight along the axis [N].
  double largest_compression = 0.0;  ///< Largest force that compresses the screw, for buckling [N].
  bool closed = true;                ///< Whether it ends with its initial speed.
  double moved_mass = 0.0;           ///< Mass along the axis; of a lever in the middle of its motion [kg].
  std::optional<std::array<double, 2>> angles = {};  ///< Smallest and largest angle of a lever [rad].

  bool moves() const { return largest_speed > 0.0; }
  /// Speed of the load case `back-driving` [m/s] and its force [N].
  double driving_speed() const { return mean_speed.value_or(1e-3); }
  double driving_force() const { return mean_load.value_or(largest_force); }
};

/// A requirement as it was read, with its defaults filled in.
struct SizeInput {
  input::Source source;
  Requirement values;
  MotionCycle cycle;
  std::vector<input::EchoEntry> fields;  ///< Entry of every value.
  std::vector<Warning> warnings;
};

/// Keys under which a requirement names its files.
inline constexpr std::string_view kHistoryFile = "motion.history.file";
inline constexpr std::string_view kCatalogueFile = "candidates.catalogue.file";

/// Sense of the cycle's axial force F in a case.
Direction direction_of(const Requirement& r, double force);

/// Segments cut where the speed changes its sign, with their axial forces on the screw
///
///     F = m a + m g sin(theta) + sgn (mu m g |cos(theta)| + f) + F_ext,    at rest sgn = 0
///
/// (THK general catalogue, axial loads), and values that follow from them: the cubic mean load over travel, speeds, the
/// holding force. More than 60 are combined in classes by senses, 12 steps of force and 8 of speed.
MotionCycle cycle_of(std::vector<MotionSegment> segments, const Requirement& r);

/// Key of the file of one of several catalogues.
std::string catalogue_file_key(const std::vector<Requirement::Catalogue>& all, std::size_t number);

/// Reads and checks a requirement. Throws InputError.
SizeInput read_requirement(const input::Source& source);

/// Texts of the files that a requirement names: history and catalogue.
std::vector<std::string> requirement_files(const input::Source& source);

/// Every key of a requirement, like `schema` for a case.
nlohmann::ordered_json requirement_schema();
/// The requirement with overrides and defaults in place. Throws InputError.
nlohmann::ordered_json resolved_requirement(const input::Source& source);

}  // namespace prs
