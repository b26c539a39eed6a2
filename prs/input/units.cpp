#include "prs/input/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "prs/indices.h"
#include "prs/model/units.h"

namespace prs::input {
namespace {

using std::numbers::pi;

constexpr double kLargest = 1e30;
constexpr double kSmallest = 1e-30;
constexpr double kThousandTo1_5 = 31622.776601683793;  // (m/mm)^1.5

constexpr Unit kLength[] = {{{"mm"}, 1.0, 1e3},    {{"m"}},
                            {{"cm"}, 1.0, 1e2},    {{"um", "µm", "μm"}, 1.0, 1e6},
                            {{"nm"}, 1.0, 1e9},    {{"in"}, 254.0, 1e4},
                            {{"ft"}, 3048.0, 1e4}, {{"uin", "µin", "μin"}, 254.0, 1e10}};

constexpr Unit kForce[] = {{{"N"}}, {{"kN"}, 1e3}, {{"MN"}, 1e6}, {{"lbf"}, kPoundForce}};

constexpr Unit kAngle[] = {{{"deg", "°"}, pi, 180.0}, {{"rad"}}, {{"mrad"}, 1.0, 1e3}};

constexpr Unit kPressure[] = {{{"Pa", "N/m^2"}},
                              {{"kPa"}, 1e3},
                              {{"MPa", "N/mm^2", "N/mm2"}, 1e6},
                              {{"GPa"}, 1e9},
                              {{"bar"}, 1e5},
                              {{"psi", "lbf/in^2"}, kPoundForce / (kInch * kInch)},
                              {{"ksi"}, 1e3 * kPoundForce / (kInch * kInch)}};

constexpr Unit kDensity[] = {
    {{"kg/m^3"}}, {{"g/cm^3", "kg/dm^3", "t/m^3"}, 1e3}, {{"lb/in^3"}, kPound / (kInch * kInch * kInch)}};

constexpr Unit kViscosity[] = {{{"Pa s", "Pa*s", "Pa.s"}}, {{"mPa s", "mPa*s", "mPa.s"}, 1.0, 1e3}, {{"cP"}, 1.0, 1e3}};

constexpr Unit kKinematicViscosity[] = {{{"mm^2/s"}, 1.0, 1e6}, {{"cSt"}, 1.0, 1e6}, {{"m^2/s"}}};

constexpr Unit kPressureViscosity[] = {
    {{"1/Pa", "Pa^-1", "m^2/N"}}, {{"1/MPa", "MPa^-1", "mm^2/N"}, 1.0, 1e6}, {{"1/GPa", "GPa^-1"}, 1.0, 1e9}};

constexpr Unit kRotationalSpeed[] = {
    {{"rpm", "rev/min"}, pi, 30.0}, {{"1/min", "min^-1"}, pi, 30.0}, {{"rad/s"}}, {{"deg/s"}, pi, 180.0}};

constexpr Unit kTravelSpeed[] = {{{"mm/s"}, 1.0, 1e3},          {{"m/s"}},
                                 {{"m/min"}, 1.0, 60.0},        {{"mm/min"}, 1.0, 6e4},
                                 {{"in/s", "ips"}, 254.0, 1e4}, {{"in/min", "ipm"}, 254.0, 6e5}};

constexpr Unit kHertzConstant[] = {{{"N/mm^1.5", "N/mm^(3/2)"}, kThousandTo1_5},
                                   {{"kN/mm^1.5", "kN/mm^(3/2)"}, 1e3 * kThousandTo1_5},
                                   {{"N/m^1.5", "N/m^(3/2)"}},
                                   {{"N/um^1.5", "N/µm^1.5", "N/μm^1.5"}, 1e9}};

constexpr Unit kStiffness[] = {{{"N/m"}},
                               {{"N/mm", "kN/m"}, 1e3},
                               {{"N/um", "N/µm", "N/μm"}, 1e6},
                               {{"kN/mm", "MN/m"}, 1e6},
                               {{"kN/um", "kN/µm", "kN/μm"}, 1e9},
                               {{"lbf/in"}, kPoundForce / kInch},
                               {{"lbf/uin", "lbf/µin", "lbf/μin"}, 1e6 * kPoundForce / kInch}};

constexpr Unit kTorque[] = {{{"N m", "Nm", "N*m"}},
                            {{"N mm", "Nmm", "N*mm"}, 1.0, 1e3},
                            {{"mN m", "mNm", "mN*m"}, 1.0, 1e3},
                            {{"kN m", "kNm", "kN*m"}, 1e3},
                            {{"lbf in", "in lbf", "lbf*in"}, kPoundForce* kInch},
                            {{"lbf ft", "ft lbf", "lbf*ft"}, kPoundForce * 12.0 * kInch}};

constexpr Unit kTiltStiffness[] = {
    {{"N m/rad", "Nm/rad"}}, {{"kN m/rad", "kNm/rad"}, 1e3}, {{"lbf in/rad", "in lbf/rad"}, kPoundForce* kInch}};

constexpr Unit kThermalExpansion[] = {
    {{"um/m/K", "ppm/K"}, 1.0, 1e6}, {{"1/K"}}, {{"uin/in/degF", "ppm/degF"}, 1.8, 1e6}};

constexpr Unit kDuration[] = {{{"s"}},         {{"ms"}, 1.0, 1e3}, {{"us", "µs", "μs"}, 1.0, 1e6},
                              {{"min"}, 60.0}, {{"h"}, 3600.0},    {{"d"}, 86400.0}};

constexpr Unit kWear[] = {{{"mm^3/(N m)", "mm^3/Nm", "mm³/(N m)"}, 1.0, 1e9},
                          {{"um^3/(N m)", "µm^3/(N m)", "μm^3/(N m)"}, 1.0, 1e18},
                          {{"m^3/(N m)", "m^3/Nm"}},
                          {{"in^3/(lbf in)"}, kInch* kInch / kPoundForce}};

constexpr Unit kThermalConductance[] = {{{"W/K"}}, {{"mW/K"}, 1.0, 1e3}};

constexpr Unit kThermalConductivity[] = {{{"W/(m K)", "W/m/K", "W/(m*K)"}}};

constexpr Unit kTemperatureCoefficient[] = {{{"1/K"}}, {{"%/K"}, 1.0, 100.0}};

constexpr Unit kHeatCapacity[] = {{{"J/K"}}, {{"kJ/K"}, 1e3}};

constexpr Unit kSpecificHeat[] = {{{"J/(kg K)", "J/kg/K", "J/(kg*K)"}}, {{"kJ/(kg K)", "kJ/kg/K", "kJ/(kg*K)"}, 1e3}};

constexpr Unit kTemperature[] = {
    {{"degC", "°C", "C"}, 1.0, 1.0, 273.15}, {{"K"}}, {{"degF", "°F"}, 5.0, 9.0, 459.67 * 5.0 / 9.0}};

constexpr Unit kShare[] = {{{"%"}, 1.0, 100.0}};

constexpr Unit kMass[] = {{{"kg"}}, {{"g"}, 1.0, 1e3}, {{"t"}, 1e3}, {{"lb"}, kPound}};

constexpr Unit kSpeed[] = {{{"mm/min"}, 1.0, 60e3},    {{"m/min"}, 1.0, 60.0}, {{"mm/s"}, 1.0, 1e3},     {{"m/s"}},
                           {{"in/min"}, kInch / 60.0}, {{"in/s"}, kInch},      {{"ft/min"}, kInch / 5.0}};

constexpr Unit kDistance[] = {{{"km"}, 1e3}, {{"m"}}};

constexpr Unit kPower[] = {{{"W"}}, {{"kW"}, 1e3}, {{"mW"}, 1.0, 1e3}};

constexpr Unit kInertia[] = {{{"kg m^2", "kg*m^2"}},
                             {{"kg cm^2", "kg*cm^2"}, 1.0, 1e4},
                             {{"kg mm^2", "kg*mm^2"}, 1.0, 1e6},
                             {{"g cm^2", "g*cm^2"}, 1.0, 1e7},
                             {{"lb in^2", "lb*in^2"}, kPound* kInch* kInch}};

constexpr Unit kFrequency[] = {{{"Hz"}}, {{"kHz"}, 1e3}};

constexpr Unit kRotationalDamping[] = {{{"N m s/rad", "Nm s/rad", "N*m*s/rad"}},
                                       {{"lbf in s/rad", "in lbf s/rad"}, kPoundForce* kInch}};

constexpr Unit kDamping[] = {{{"N s/m", "N*s/m"}}, {{"N s/mm", "N*s/mm"}, 1e3}, {{"lbf s/in"}, kPoundForce / kInch}};

constexpr Unit kStopDamping[] = {{{"s/m"}}, {{"s/mm"}, 1e3}, {{"s/in"}, 1.0 / kInch}};

constexpr Unit kPositionGain[] = {{{"1/s", "s^-1"}}};

constexpr Unit kTorqueConstant[] = {{{"N m/A", "Nm/A", "N*m/A"}}, {{"mN m/A", "mNm/A", "mN*m/A"}, 1.0, 1e3}};

constexpr Unit kResistance[] = {{{"Ohm", "ohm", "Ω"}}, {{"mOhm", "mohm", "mΩ"}, 1.0, 1e3}};

constexpr Unit kVoltage[] = {{{"V"}}, {{"mV"}, 1.0, 1e3}};

constexpr Unit kCurrent[] = {{{"A"}}, {{"mA"}, 1.0, 1e3}};

}  // namespace

namespace unit {
const Dimension length{"a length", "5 mm", "mm", kLength};
const Dimension force{"a force", "10 kN", "N", kForce};
const Dimension angle{"an angle", "45 deg", "deg", kAngle};
const Dimension pressure{"a pressure", "210 GPa", "MPa", kPressure};
const Dimension density{"a density", "7810 kg/m^3", "kg/m^3", kDensity};
const Dimension viscosity{"a dynamic viscosity", "160 mPa s", "mPa s", kViscosity};
const Dimension kinematic_viscosity{"a kinematic viscosity", "46 mm^2/s", "mm^2/s", kKinematicViscosity};
const Dimension pressure_viscosity{"a pressure-viscosity coefficient", "30 1/GPa", "1/GPa", kPressureViscosity};
const Dimension rotational_speed{"a rotational speed", "400 rpm", "rpm", kRotationalSpeed, &travel_speed};
const Dimension travel_speed{"a speed along the axis", "200 mm/s", "mm/s", kTravelSpeed};
const Dimension hertz_constant{"a Hertz constant", "3.6e5 N/mm^1.5", "N/mm^1.5", kHertzConstant};
const Dimension stiffness{"a stiffness", "2e4 N/mm", "N/mm", kStiffness};
const Dimension tilt_stiffness{"a tilting stiffness", "2e5 N m/rad", "N m/rad", kTiltStiffness};
const Dimension torque{"a torque", "0.1 N m", "N m", kTorque};
const Dimension temperature{"a temperature", "60 degC", "degC", kTemperature};
const Dimension thermal_expansion{"a coefficient of thermal expansion", "11.5 um/m/K", "um/m/K", kThermalExpansion};
const Dimension duration{"a duration", "1 h", "s", kDuration};
const Dimension hours{"a duration", "20000 h", "h", kDuration};
const Dimension share{"a share", "95 %", "%", kShare};
const Dimension mass{"a mass", "12 kg", "kg", kMass};
const Dimension speed{"a speed", "150000 mm/min", "mm/min", kSpeed};
const Dimension distance{"a distance", "500 km", "km", kDistance};
const Dimension inertia{"a moment of inertia", "5 kg cm^2", "kg cm^2", kInertia};
const Dimension frequency{"a frequency", "100 Hz", "Hz", kFrequency};
const Dimension rotational_damping{"a rotational damping", "0.01 N m s/rad", "N m s/rad", kRotationalDamping};
const Dimension damping{"a damping", "200 N s/m", "N s/m", kDamping};
const Dimension stop_damping{"a damping of a stop", "0.2 s/m", "s/m", kStopDamping};
const Dimension position_gain{"a position gain", "80 1/s", "1/s", kPositionGain};
const Dimension power{"a power", "50 W", "W", kPower};
const Dimension torque_constant{"a torque constant", "0.5 N m/A", "N m/A", kTorqueConstant};
const Dimension resistance{"a resistance", "0.8 Ohm", "Ohm", kResistance};
const Dimension voltage{"a voltage", "48 V", "V", kVoltage};
const Dimension current{"a current", "15 A", "A", kCurrent};
const Dimension wear{"a wear coefficient", "1e-8 mm^3/(N m)", "mm^3/(N m)", kWear};
const Dimension thermal_conductance{"a thermal conductance", "8 W/K", "W/K", kThermalConductance};
const Dimension thermal_conductivity{"a thermal conductivity", "45 W/(m K)", "W/(m K)", kThermalConductivity};
const Dimension temperature_coefficient{"a temperature coefficient", "0.035 1/K", "1/K", kTemperatureCoefficient};
const Dimension heat_capacity{"a heat capacity", "400 J/K", "J/K", kHeatCapacity};
const Dimension specific_heat{"a specific heat", "460 J/(kg K)", "J/(kg K)", kSpecificHeat};
}  // namespace unit

namespace {

constexpr const Dimension* kDimensions[] = {&unit::length,
                                            &unit::force,
                                            &unit::angle,
                                            &unit::pressure,
                                            &unit::density,
                                            &unit::viscosity,
                                            &unit::kinematic_viscosity,
                                            &unit::pressure_viscosity,
                                            &unit::rotational_speed,
                                            &unit::travel_speed,
                                            &unit::hertz_constant,
                                            &unit::stiffness,
                                            &unit::tilt_stiffness,
                                            &unit::torque,
                                            &unit::temperature,
                                            &unit::thermal_expansion,
                                            &unit::duration,
                                            &unit::share,
                                            &unit::wear,
                                            &unit::thermal_conductance,
                                            &unit::thermal_conductivity,
                                            &unit::temperature_coefficient,
                                            &unit::heat_capacity,
                                            &unit::specific_heat,
                                            &unit::mass,
                                            &unit::speed,
                                            &unit::distance,
                                            &unit::inertia,
                                            &unit::frequency,
                                            &unit::rotational_damping,
                                            &unit::damping,
                                            &unit::stop_damping,
                                            &unit::position_gain,
                                            &unit::power,
                                            &unit::torque_constant,
                                            &unit::resistance,
                                            &unit::voltage,
                                            &unit::current};

const Dimension* dimension_of(std::string_view symbol) {
  for (const Dimension* d : kDimensions)
    if (find_unit(symbol, *d)) return d;
  return nullptr;
}

/// Removes a whole number from the head of a text and returns it.
std::optional<double> take_whole(std::string_view& text) {
  const std::size_t size = std::min(text.find_first_not_of("0123456789"), text.size());
  double number = 0.0;
  if (size == 0 || size > 6) return std::nullopt;
  std::from_chars(text.data(), text.data() + size, number);
  text.remove_prefix(size);
  return number;
}

/// Decimal number at the head of a text, and the remaining text.
struct Head {
  std::optional<double> number;
  bool representable = true;
  std::string_view rest;
};

/// Text without leading blanks, typographic ones included.
std::string_view without_blanks(std::string_view text) {
  for (std::size_t length = 1; length > 0; text.remove_prefix(length)) {
    length = 0;
    for (const std::string_view blank : {" ", "\u00A0", "\u2009", "\u202F"})
      if (text.starts_with(blank)) length = blank.size();
  }
  return text;
}

/// Whether a unit takes fractions: inches and feet alone, also with misspelt names.
bool takes_fractions(std::string_view unit) {
  constexpr std::string_view kUnits[] = {"in", "ft", "inch", "inches", "foot", "feet"};
  return contains(kUnits, unit);
}

/// `1 1/4 in`, `1-1/4 in`, `5/8 in`. `rest` follows the first number.
std::optional<Head> split_fraction(std::string_view text, std::string_view rest) {
  if (rest.empty() || std::string_view(" -/").find(rest[0]) == std::string_view::npos) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::optional<double> first = take_whole(text);
  std::optional<double> numerator = first;
  if (text.data() != rest.data()) return std::nullopt;  // `1.5 1/4`
  if (rest[0] != '/') {
    text.remove_prefix(1);
    numerator = take_whole(text);
  }
  if (!first || !numerator || !text.starts_with('/')) return std::nullopt;
  text.remove_prefix(1);
  const std::optional<double> denominator = take_whole(text);
  const std::string_view unit = without_blanks(text);
  const bool is_proper = rest[0] == '/' || *numerator < denominator.value_or(0.0);
  if (!(denominator > 0.0) || !is_proper || !takes_fractions(unit)) return std::nullopt;
  const double number = *numerator / *denominator + (rest[0] == '/' ? 0.0 : *first);
  return Head{negative ? -number : number, true, text};
}

Head split_number(std::string_view text) {
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const std::string_view unsigned_digits =
      digits.starts_with('-') && digits.size() == text.size() ? digits.substr(1) : digits;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (unsigned_digits.empty() || !(is_digit(unsigned_digits[0]) || unsigned_digits[0] == '.'))
    return {};  // Refuses `inf`, `nan` and a second sign too.
  double number = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (error == std::errc::invalid_argument) return {};
  const std::string_view rest(stop, static_cast<std::size_t>(end - stop));
  if (std::optional<Head> inches = split_fraction(digits, rest)) return *inches;
  return {number, error == std::errc{}, rest};
}

/// Whether a number is ambiguous: one to three digits, a point and three zeros, where the point may separate thousands.
bool may_be_thousands(std::string_view number) {
  if (!number.ends_with(".000")) return false;
  number.remove_suffix(4);
  if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
  return !number.empty() && number.size() <= 3 && number[0] != '0';
}

/// Whether a text is `nan`, `-inf`, `.Inf`, ..
bool names_no_number(std::string_view text) {
  std::string word;
  for (char c : text.substr(0, 8))
    if (c != '.' && c != '+' && c != '-') word += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return word.starts_with("nan") || word.starts_with("inf");
}

/// Other common spellings of a unit, and the replacement.
struct Slang {
  std::string_view written, unit, remark = {};
};

constexpr Slang kSlang[] = {{"inch", "in"},
                            {"inches", "in"},
                            {"\"", "in"},
                            {"''", "in"},
                            {"foot", "ft"},
                            {"feet", "ft"},
                            {"micron", "um"},
                            {"microns", "um"},
                            {"lb", "lbf"},
                            {"lbs", "lbf"},
                            {"degree", "deg"},
                            {"degrees", "deg"},
                            {"u/min", "rpm"},
                            {"r/min", "rpm"},
                            {"sec", "s"},
                            {"hr", "h"},
                            {"hours", "h"},
                            {"celsius", "degC"},
                            {"kgf", "N", "; 1 kgf is 9.80665 N"},
                            {"kp", "N", "; 1 kp is 9.80665 N"}};

/// Symbol without the differences between spellings of a unit: capital letters, `^`, blanks, typographic signs.
std::string plain_spelling(std::string_view symbol) {
  std::string plain;
  for (std::size_t k = 0; k < symbol.size(); ++k) {
    constexpr std::pair<std::string_view, std::string_view> kSigns[] = {{"²", "2"}, {"³", "3"}, {"µ", "u"},
                                                                        {"μ", "u"}, {"·", ""},  {"°", "deg"}};
    const auto* const sign =
        std::ranges::find_if(kSigns, [&](const auto& s) { return symbol.substr(k).starts_with(s.first); });
    if (sign != std::end(kSigns)) {
      plain += sign->second;
      k += sign->first.size() - 1;
    } else if (const char c = symbol[k]; std::string_view("^* .").find(c) == std::string_view::npos) {
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    }
  }
  return plain;
}

/// Correct spelling of the unit that a text probably means; empty if it is none.
std::string unit_meant(std::string_view symbol, const Dimension& dimension) {
  const std::string plain = plain_spelling(symbol.substr(0, 40));
  for (const auto& [written, unit, remark] : kSlang)
    if (plain == written && find_unit(unit, dimension)) return fmt::format("write `{}`{}", unit, remark);
  for (const Unit& u : dimension.units)
    for (const std::string_view spelling : u.spellings) {
      if (spelling.empty() || plain_spelling(spelling) != plain) continue;
      // `mPa` may have been meant.
      const bool is_milli = symbol[0] == 'm' && spelling[0] == 'M';
      return fmt::format("{} `{}`{}", is_milli ? "did you mean" : "write", spelling, is_milli ? "?" : "");
    }
  return {};
}

}  // namespace

std::span<const Dimension* const> dimensions() { return kDimensions; }

const Unit* find_unit(std::string_view symbol, const Dimension& dimension) {
  if (symbol.empty()) return nullptr;
  for (const Unit& u : dimension.units)
    for (std::string_view spelling : u.spellings)
      if (spelling == symbol) return &u;
  return nullptr;
}

std::optional<double> to_si(double number, const Unit& unit) {
  const double value = number * unit.multiply / unit.divide + unit.offset;
  const double magnitude = std::abs(value);
  if (!(magnitude <= kLargest) || (magnitude < kSmallest && number != 0.0 && unit.offset == 0.0)) return std::nullopt;
  return value;
}

bool zero_depends_on_unit(const Dimension& dimension) {
  return std::ranges::any_of(dimension.units, [](const Unit& u) { return u.offset != 0.0; });
}

/// The printed unit or that of the example, whichever brings a number nearer to the example.
std::string_view likely_unit(double number, const Dimension& dimension, std::string_view typical) {
  const auto example = split_unit(typical.empty() ? dimension.example : typical);
  const Unit &printed = *find_unit(dimension.canonical, dimension), &common = *find_unit(example->unit, dimension);
  const double size = *to_si(example->number, common);
  const auto distance = [&](const Unit& unit) {
    return std::abs(std::log(std::abs(to_si(number, unit).value_or(0.0) / size)));
  };
  return distance(common) < distance(printed) ? example->unit : dimension.canonical;
}

ParsedQuantity parse_quantity(std::string_view text, const Dimension& dimension, std::string_view example) {
  const Head head = split_number(text);
  if (!head.number) return {std::nullopt, names_no_number(text) ? "NaN and infinity are no values" : ""};
  if (head.rest.empty()) {
    const bool fraction = &dimension == &unit::share && *head.number <= 1.0;
    return {std::nullopt,
            fmt::format("write the unit, for example `{} {}` (units: {})",
                        fraction ? fmt::format("{:g}", 100.0 * *head.number) : std::string(text.substr(0, 40)),
                        likely_unit(*head.number, dimension, example), unit_list(dimension))};
  }
  if (head.rest.starts_with(','))
    return {std::nullopt, "write the decimal mark as a point, without thousands separators"};

  const std::string_view symbol = without_blanks(head.rest);
  const Unit* u = find_unit(symbol, dimension);
  if (!u) {
    if (dimension.by_lead && find_unit(symbol, *dimension.by_lead))
      if (ParsedQuantity along_axis = parse_quantity(text, *dimension.by_lead); !along_axis.value) return along_axis;
    const Dimension* other = dimension_of(symbol);
    if (symbol.starts_with('\t')) return {std::nullopt, "there is a tab between number and unit; write a blank"};
    const std::string meant = unit_meant(symbol, dimension);
    return {std::nullopt, fmt::format("`{}` is {}; {}", symbol.substr(0, 40),
                                      other ? fmt::format("the unit of {}", other->name) : "not a known unit",
                                      meant.empty() ? "use one of the units " + unit_list(dimension) : meant)};
  }
  const std::string_view number = text.substr(0, text.size() - head.rest.size());
  if ((&dimension == &unit::force || &dimension == &unit::stiffness) && may_be_thousands(number)) {
    const std::string_view whole = number.substr(0, number.find('.'));
    return {std::nullopt, fmt::format("some read {0} {1}, others {0}000 {1}; write one of the two", whole, symbol)};
  }
  const std::optional<double> value = head.representable ? to_si(*head.number, *u) : std::nullopt;
  if (!value) return {std::nullopt, "its magnitude is beyond any machine; check number and unit"};
  return {value, {}};
}

std::string format_quantity(double value, const Dimension& dimension) {
  const Unit& u = *find_unit(dimension.canonical, dimension);
  const double shown = (value - u.offset) / u.multiply * u.divide;
  std::string text;
  // An offset leaves rounding errors in more digits than a factor does.
  for (int digits = u.offset == 0.0 ? 15 : 6; digits <= 17; ++digits) {
    text = fmt::format("{:.{}g} {}", shown, digits, dimension.canonical);
    if (parse_quantity(text, dimension).value == value) break;
  }
  return text;
}

bool is_travel_speed(std::string_view text) {
  const std::optional<NumberAndUnit> split = split_unit(text);
  return split && find_unit(split->unit, unit::travel_speed);
}

double rotation(double travel_speed, double lead) { return 2.0 * pi * travel_speed / lead; }

std::optional<double> parse_number(std::string_view text) {
  const Head head = split_number(text);
  if (!head.number || !head.representable || !head.rest.empty()) return std::nullopt;
  return head.number;
}

std::optional<NumberAndUnit> split_unit(std::string_view text) {
  const Head head = split_number(text);
  if (!head.number || !head.representable) return std::nullopt;
  return NumberAndUnit{*head.number, without_blanks(head.rest)};
}

bool is_unit(std::string_view symbol) { return dimension_of(symbol) != nullptr; }

std::optional<double> number_in(std::string_view text, std::string_view unit) {
  const std::optional<NumberAndUnit> split = split_unit(text);
  if (!split) return std::nullopt;
  if (split->unit == unit) return split->number;
  for (const Dimension* dimension : kDimensions) {
    const Unit* from = find_unit(split->unit, *dimension);
    const Unit* to = find_unit(unit, *dimension);
    if (from && to)
      return (split->number * from->multiply / from->divide + from->offset - to->offset) / to->multiply * to->divide;
  }
  return std::nullopt;
}

std::string unit_list(const Dimension& dimension) {
  std::string list;
  for (const Unit& u : dimension.units)
    fmt::format_to(std::back_inserter(list), "{}{}", list.empty() ? "" : ", ", u.spellings[0]);
  return dimension.by_lead ? list + ", " + unit_list(*dimension.by_lead) : list;
}

std::string unit_pattern(const Dimension& dimension) {
  std::string pattern;
  for (const Unit& u : dimension.units)
    for (std::string_view spelling : u.spellings) {
      if (spelling.empty()) continue;
      pattern += pattern.empty() ? "(" : "|";
      for (char c : spelling) {
        if (std::string_view("^$.*+?()[]{}|/\\").find(c) != std::string_view::npos) pattern += '\\';
        pattern += c;
      }
    }
  if (dimension.by_lead) pattern += "|" + unit_pattern(*dimension.by_lead);
  return pattern + ")";
}

}  // namespace prs::input
