#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace prs::input {

/// Interval of admissible values, SI.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool greatest_excluded = false;
  bool zero_excluded = false;

  constexpr bool contain(double v) const {
    return (least_excluded ? v > least : v >= least) && (greatest_excluded ? v < greatest : v <= greatest) &&
           !(zero_excluded && v == 0.0);
  }
};

inline constexpr Bounds unbounded{};
inline constexpr Bounds positive{.least = 0.0, .least_excluded = true};
inline constexpr Bounds not_negative{.least = 0.0};
inline constexpr Bounds not_zero{.zero_excluded = true};

/// Interval without its ends.
constexpr Bounds between(double least, double greatest) { return {least, greatest, true, true, false}; }

/// Longest text of one line, in bytes.
inline constexpr int kLongestText = 100;

/// One unit and its spellings, the first of which is shown: SI = value * multiply / divide + offset. One of the two
/// factors is 1 for units that are powers of ten, so that conversion rounds once.
struct Unit {
  std::array<std::string_view, 3> spellings;
  double multiply = 1.0;
  double divide = 1.0;
  double offset = 0.0;
};

/// A physical dimension and the units in which it may be written; values are SI inside.
struct Dimension {
  std::string_view name;       ///< Name with its article: `a length`.
  std::string_view example;    ///< A typical value: `5 mm`.
  std::string_view canonical;  ///< The unit in which values are printed.
  std::span<const Unit> units;
  /// Dimension whose values are converted to this one by the lead of the screw, see `rotation`; or null.
  const Dimension* by_lead = nullptr;
};

namespace unit {
extern const Dimension length;
extern const Dimension force;
extern const Dimension angle;
extern const Dimension pressure;
extern const Dimension density;
extern const Dimension viscosity;
extern const Dimension kinematic_viscosity;
extern const Dimension pressure_viscosity;
extern const Dimension rotational_speed;
extern const Dimension travel_speed;
extern const Dimension hertz_constant;
extern const Dimension stiffness;
extern const Dimension tilt_stiffness;
extern const Dimension torque;
extern const Dimension temperature;
extern const Dimension thermal_expansion;
extern const Dimension duration;
extern const Dimension hours;  ///< Durations that are shown in hours.
extern const Dimension share;
extern const Dimension wear;
extern const Dimension thermal_conductance;
extern const Dimension thermal_conductivity;
extern const Dimension temperature_coefficient;
extern const Dimension heat_capacity;
extern const Dimension specific_heat;
extern const Dimension mass;
extern const Dimension speed;
extern const Dimension distance;
extern const Dimension inertia;
extern const Dimension frequency;
extern const Dimension rotational_damping;
extern const Dimension damping;
extern const Dimension stop_damping;
extern const Dimension position_gain;
extern const Dimension power;
extern const Dimension torque_constant;
extern const Dimension resistance;
extern const Dimension voltage;
extern const Dimension current;
}  // namespace unit

/// All dimensions, in the order in which they are shown.
std::span<const Dimension* const> dimensions();

/// Whether 0 means something else in each unit, as with temperatures.
bool zero_depends_on_unit(const Dimension& dimension);

/// The unit of a dimension with this spelling, or null.
const Unit* find_unit(std::string_view symbol, const Dimension& dimension);

/// Whether a unit of any dimension has this spelling.
bool is_unit(std::string_view symbol);

/// A number in a unit [SI]; none beyond the magnitudes allowed in texts.
std::optional<double> to_si(double number, const Unit& unit);

/// Result of reading a text: the value [SI], or else a hint how to fix the text.
struct ParsedQuantity {
  std::optional<double> value;
  std::string hint;
};

/// `45 kN` -> 45000. The whole text must be a decimal number, for inches and feet also one with a fraction (`1 1/4
/// in`), and a unit of the dimension; NaN, infinities and magnitudes outside 1e-30 .. 1e30 (SI) are refused, and so are
/// forces and stiffnesses whose point may separate thousands: `20.000 N`. Independent of the locale. By a typical
/// value the hint names the likeliest unit of a bare number, by default the dimension's.
ParsedQuantity parse_quantity(std::string_view text, const Dimension& dimension, std::string_view example = {});

/// The value [SI] in the canonical unit, with the fewest digits that read back to the same value.
std::string format_quantity(double value, const Dimension& dimension);

/// Whether a text is a speed along the axis: `200 mm/s`.
bool is_travel_speed(std::string_view text);

/// Speed of screw against nut [rad/s] for a speed along the axis v [m/s]. For either hand, force x v > 0 is then power
/// of the screw:
///   omega = 2 pi v/lead
double rotation(double travel_speed, double lead);

/// Number of a text that is one finite decimal number, without unit.
std::optional<double> parse_number(std::string_view text);

/// Number and unit of a text that starts with a finite decimal number: `5 mm` -> 5 and `mm`.
struct NumberAndUnit {
  double number = 0.0;
  std::string_view unit;  ///< Remaining text; empty for a bare number.
};
std::optional<NumberAndUnit> split_unit(std::string_view text);

/// Number of a text such as `500 N` in another unit of its dimension: 0.5 in `kN`. None if the units differ in
/// dimension; bare numbers go with the unit ``.
std::optional<double> number_in(std::string_view text, std::string_view unit);

/// Shown units of a dimension, separated by commas; those that depend on the lead at the end.
std::string unit_list(const Dimension& dimension);

/// Regular expression (ECMA-262 and Python) of texts that end in a unit of the dimension.
std::string unit_pattern(const Dimension& dimension);

}  // namespace prs::input
