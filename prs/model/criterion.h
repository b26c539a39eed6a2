#pragma once

#include <fmt/format.h>

#include <set>

#include "prs/model/command.h"
#include "prs/model/limits.h"
#include "prs/model/units.h"

/// Criteria of the verdict. Each analysis returns what it finds of them (`Analysis::criteria`); the verdict
/// (prs/run/verdict.h) collects that, orders it by the rows below and holds it against their limits.
///
/// Where the case states a limit (`limits`), a criterion is green if the limit is met and red if
/// it is missed. Where it states none, the criterion is red if physics does not allow the value,
/// amber if the value falls short of the recommended one, and green otherwise. A criterion without
/// any of these limits is a plain number. A value that cannot be computed never meets a limit.

namespace prs {

constexpr double kLimitRounding = 1e-9;  ///< Relative, of a value that just meets its limit.

enum class Sense { least, greatest };
std::string_view name(Sense sense);

enum class LimitSource { stated, physics, recommended };
std::string_view name(LimitSource source);  ///< Word in documents: `case` for stated.

enum class Standing { green, amber, red, no_limit, not_computed, not_applicable };
std::string_view name(Standing standing);

/// A criterion as documents name it, and what its value is held against.
struct CriterionRow {
  std::string_view name;        ///< Name, also the key in `limits` where there is one.
  std::string_view title = {};  ///< `Static safety`; empty of what others follow from, which is not shown.
  std::string_view unit = {};   ///< Unit of value and limit; empty for ratios and fractions.
  Sense sense = Sense::least;   ///< Sense of the limit.
  std::optional<double> Limits::*limit = nullptr;  ///< Limit of the case; `life` has two.
  double factor = 1.0;                             ///< Factor from SI to the unit.
  double zero = 0.0;                               ///< Zero of the unit [K].
  bool is_plain = true;                            ///< Shown without a limit too.
  std::optional<double> physical = {}, recommended = {};
  Command needed = {};                        ///< Names what to add where no analysis says anything; none: left out.
  std::string_view why = {};                  ///< Reason why there is no value, or text in place of an empty note.
  std::string_view before = {};               ///< Words before a note.
  LimitSource source = LimitSource::physics;  ///< Source of a standing that the analysis gives.
  bool of_preload = false;                    ///< Without a value where the preload cannot be had.
  bool of_drive = false;                      ///< Might be worse in a drive that could not be computed.
  bool of_life = false;                       ///< Might be worse under a life or temperatures that are not known.
  bool of_history = false;                    ///< Might be worse under a history whose life is not known.
  bool last_of_equal = false;                 ///< Whether the last of several equal values is named.

  bool is_worse(double a, double b) const;
};

/// All criteria in the order in which they are shown. Recommended limits: makers ask for a static safety of 1 to 3,
/// catalogues for half of the buckling load and 80 % of the critical speed; grease and seals do not last above 120
/// degC.
inline constexpr CriterionRow kCriteria[] = {
    {.name = "life", .title = "Life", .unit = "h", .needed = Command::life},
    {.name = "bearing_life", .title = "Life of the bearing", .unit = "h"},
    {.name = "static_safety",
     .title = "Static safety",
     .limit = &Limits::static_safety,
     .physical = 1.0,
     .recommended = 1.5,
     .needed = Command::measures,
     .why = "no load whose thread loads are known",
     .of_preload = true,
     .of_life = true,
     .last_of_equal = true},
    {.name = "bearing_static_safety",
     .title = "Static safety of the bearing",
     .limit = &Limits::static_safety,
     .physical = 1.0,
     .recommended = 1.5,
     .of_history = true},
    {.name = "flank_edge",
     .title = "Safety against edge loading",
     .recommended = 1.0,
     .needed = Command::measures,
     .why = "no load whose thread loads are known",
     .of_preload = true,
     .of_life = true,
     .last_of_equal = true},
    {.name = "peak_pressure",
     .title = "Peak pressure",
     .unit = "MPa",
     .sense = Sense::greatest,
     .limit = &Limits::peak_pressure,
     .factor = "MPa"_per_si,
     .needed = Command::solve,
     .why = "no load whose thread loads are known",
     .of_preload = true,
     .of_drive = true,
     .of_life = true},
    {.name = "buckling_safety",
     .title = "Buckling safety",
     .limit = &Limits::buckling_safety,
     .physical = 1.0,
     .recommended = 2.0,
     .needed = Command::measures,
     .of_history = true},
    {.name = "critical_speed_share",
     .title = "Share of the critical speed",
     .sense = Sense::greatest,
     .limit = &Limits::critical_speed_share,
     .physical = 1.0,
     .recommended = 0.8,
     .needed = Command::measures},
    {.name = "speed_times_diameter",
     .title = "Speed times diameter",
     .unit = "mm/min",
     .sense = Sense::greatest,
     .limit = &Limits::speed_times_diameter,
     .factor = 60.0 * "mm"_per_si,
     .is_plain = false},
    {.name = "nut_diameter",
     .title = "Nut diameter",
     .unit = "mm",
     .sense = Sense::greatest,
     .limit = &Limits::nut_diameter,
     .factor = "mm"_per_si,
     .is_plain = false},
    {.name = "nut_length",
     .title = "Nut length",
     .unit = "mm",
     .sense = Sense::greatest,
     .limit = &Limits::nut_length,
     .factor = "mm"_per_si,
     .is_plain = false},
    {.name = "weight",
     .title = "Weight",
     .unit = "kg",
     .sense = Sense::greatest,
     .limit = &Limits::weight,
     .is_plain = false,
     .needed = Command::measures},
    {.name = "stiffness",
     .title = "Axial stiffness",
     .unit = "N/um",
     .limit = &Limits::stiffness,
     .factor = "N/µm"_per_si,
     .needed = Command::solve},
    {.name = "efficiency", .title = "Efficiency", .limit = &Limits::efficiency, .needed = Command::slip},
    {.name = "temperature",
     .title = "Temperature",
     .unit = "degC",
     .sense = Sense::greatest,
     .limit = &Limits::temperature,
     .zero = 273.15,
     .physical = kHottest - 273.15,
     .recommended = 120.0,
     .needed = Command::slip,
     .last_of_equal = true},
    {.name = "stroke", .title = "Stroke over the nut's length", .recommended = 1.5},
    {.name = "film", .title = "Film ratio", .recommended = 1.0, .needed = Command::slip},
    {.name = "motor_speed", .title = "Motor speed", .unit = "rpm", .sense = Sense::greatest, .is_plain = false},
    {.name = "motor_torque", .title = "Motor torque", .unit = "N m", .sense = Sense::greatest, .is_plain = false},
    {.name = "motor_peak_torque",
     .title = "Motor peak torque",
     .unit = "N m",
     .sense = Sense::greatest,
     .is_plain = false},
    {.name = "motor_voltage", .title = "Motor voltage", .unit = "V", .sense = Sense::greatest, .is_plain = false},
    {.name = "motor_current", .title = "Motor current", .unit = "A", .sense = Sense::greatest, .is_plain = false},
    {.name = "motor_rms_current",
     .title = "Motor rms current",
     .unit = "A",
     .sense = Sense::greatest,
     .is_plain = false},
    {.name = "back_driving", .title = "Back driving", .source = LimitSource::stated},
    {.name = "brake", .title = "Brake", .is_plain = false},
    {.name = "references",
     .title = "Deviation over tolerance",
     .sense = Sense::greatest,
     .source = LimitSource::stated},
    {.name = "axial_play", .title = "Least play of an interface", .unit = "mm"},
    {.name = "convergence", .title = "Convergence", .why = "all converged", .before = "not converged: "},
    {.name = "contacts_per_roller", .title = "Contacts per roller", .source = LimitSource::recommended},
    {.name = "rollers", .title = "Rollers", .source = LimitSource::recommended},
    {.name = "shaft_length", .title = "Distance between the shaft's supports", .unit = "mm"},
    {.name = "roller_ends", .title = "Diameter of the rollers' ends", .unit = "mm", .sense = Sense::greatest},
    {.name = "input", .title = "Input"},
    {.name = "largest_speed", .sense = Sense::greatest, .of_drive = true},        ///< [rad/s]
    {.name = "largest_compression", .sense = Sense::greatest, .of_drive = true},  ///< [N]
    {.name = "largest_tension", .sense = Sense::greatest, .of_drive = true},      ///< [N]
};

/// The row of a criterion; a name that no row has does not compile.
struct CriterionKey {
  consteval CriterionKey(const char* name) : row(std::ranges::find(kCriteria, name, &CriterionRow::name)) {
    if (row == std::end(kCriteria)) throw "no such criterion";
  }
  const CriterionRow* row;
};

/// Result of an analysis for a criterion: the worst value, or why there is none.
struct FoundCriterion {
  FoundCriterion(CriterionKey key) : row(key.row) {}
  FoundCriterion(CriterionKey key, std::string_view reason) : FoundCriterion(*key.row, reason) {}
  FoundCriterion(const CriterionRow& of, std::string_view reason) : row(&of), why(reason) {}

  const CriterionRow* row;
  std::optional<double> value = {}, best = {};  ///< Worst and best value, in the unit of the row.
  std::string where = {}, note = {}, why = {};  ///< Load case of the worst; what limits it; why there is no value.
  std::string_view title = {}, unit = {};       ///< Title and unit in place of those of the row.
  std::optional<double> limit = {};             ///< Limit that is stated elsewhere than in `limits`.
  std::optional<double> physical = {};          ///< Physical limit of the place, where the row has none.
  std::optional<Standing> standing = {};        ///< Standing that no comparison gives; the limit is then shown alone.
  bool applies = true;
  bool is_partial = false;  ///< Whether something that may be worse was not computed: then never met.

  /// Takes the worst and the best value. NaN is no value. `bound`: the physical limit of its place; values of places
  /// with different ones compare by their shares of these, one without a limit as if it were just met.
  void take(std::optional<double> v, std::string_view load_case, std::string_view what = {},
            std::optional<double> bound = {});
  /// Adds what another analysis finds.
  void add(const FoundCriterion& other);

 private:
  bool is_worse(double v, std::optional<double> bound) const;
};

/// `thread loads of 1 of 3 load cases` of what did not converge; all of it stands in the verdict.
FoundCriterion convergence(const std::string& failed);

/// Inputs without which no limit of the contact pressure of a part is known, `materials.nut.static_pressure_limit`;
/// empty where none lacks.
std::string lacking_pressure_limits(const std::optional<Materials>& materials);

/// Length of the nut, or of the rollers' threads that travel in an inverted one [m]; none where there is no stroke.
std::optional<double> loaded_length(const Case& c);
/// Criterion of the stroke under load over that length, titled by what it is the length of.
FoundCriterion stroke_criterion(const Case& c, std::string_view reason = {});

/// A case for which analyses return their criteria.
struct JudgedCase {
  const Case& c;
  Limits limits = {};
  std::set<std::string> preloaded = {};  ///< Load cases judged under preload; values without it are left out.
  bool is_warm = false;                  ///< Whether values at rest are those at the temperatures of `slip`.

  /// Words for values at rest: their temperatures, and whether they lack the preload; a play is no preload.
  std::string at_rest() const {
    return fmt::format("at rest{}{}", is_warm ? " at the temperatures of `slip`" : "",
                       c.preload && !c.preload->backlash ? ", without the preload" : "");
  }
};

/// A criterion and how it stands to its limit.
struct Criterion {
  std::string_view name, title, unit;  ///< See `CriterionRow`.
  Sense sense = Sense::least;
  std::optional<double> value = {};  ///< The worst.
  std::optional<double> best = {};   ///< Best of all load cases, if there are several.
  std::optional<double> limit = {};
  std::optional<LimitSource> source = {};
  Standing standing = Standing::no_limit;
  std::string load_case = {};  ///< Load case with the worst value.
  std::string reason = {};     ///< Reason of the limit, or why there is no value.
};

}  // namespace prs
