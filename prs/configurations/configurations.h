#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "prs/configurations/gear_pairs.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"

namespace prs {

/// What is known of a mechanism before it is drawn. SI units.
struct ConfigurationQuery {
  double screw_diameter = 0.0;                   ///< Pitch diameter [m], > 0.
  double lead = 0.0;                             ///< [m], not 0; > 0 right-handed.
  double flank_angle = 0.25 * std::numbers::pi;  ///< alpha_n of all parts [rad].
  std::optional<Mechanism::Type> type;           ///< Both where absent.
  std::optional<int> screw_starts;               ///< 3 to 10 where absent.
  std::optional<int> roller_starts;              ///< 1 to 3 where absent.
  std::optional<int> rollers;                    ///< As many as fit where absent.
  double gap = 0.0;  ///< Between the crests of neighbouring rollers [m], at least.
  std::optional<double> roller_profile_radius;  ///< r_BR [m]; arcs about the axis where absent.
};

/// Case-hardened bearing steel, with which contacts are judged.
inline constexpr Material kSteel{210e9, 0.3, std::nullopt};

/// Peak pressure of a first proposal [Pa].
inline constexpr double kModeratePressure = 1.8e9;

/// A mechanism whose helix angles and gear ratio agree.
struct Configuration {
  /// Design mode, no backlash; straight screw and nut, convex rollers, sharp threads.
  Mechanism mechanism;
  /// That the starts ask for (Jung 2017, (2.16), (2.26); Sandu 2018, (1.52), (1.53)):
  /// d_S, d_R, d_N = d_S + 2 d_R [m].
  PerPart<double> rolling_diameter;
  /// With the one that is rectified for no backlash: the screw's in a standard, the nut's in an
  /// inverted mechanism [m].
  PerPart<double> pitch_diameter;
  double centre_distance = 0.0;  ///< c [m], for no backlash.
  double gear_ratio = 0.0;       ///< Gamma = n_R/n_S = d_R/d_N or d_R/d_S (2.1).
  PerPart<double> lead;          ///< < 0 left-handed [m].
  PerPart<double> helix_angle;   ///< [rad], sign of the lead.
  int most_rollers = 0;          ///< That fit with the gap; every number up to it meshes.
  double crest_gap = 0.0;        ///< Between neighbours, with mechanism.rollers [m].
  double moderate_force = 0.0;   ///< Axial, for `kModeratePressure` with equal shares [N].
  std::vector<int> alike;        ///< Numbers of rollers that all go in turned the same way.
  std::vector<GearPair> gears;   ///< Most suitable first.
};

/// Starts that give no sound mechanism, and why.
struct LeftOut {
  Mechanism::Type type = Mechanism::Type::standard;
  Mechanism::Starts starts;
  std::string reason;
  std::string detail;  ///< With the numbers; may be empty.
};

struct Configurations {
  std::vector<Configuration> found;  ///< Standard before inverted, then by starts.
  std::vector<LeftOut> left_out;
};

/// Every combination of starts that gives a sound mechanism: rollers no thicker than the screw, at
/// least three of them (or the number asked for) with the gap between their crests, point contact
/// at both interfaces with no backlash, and nothing that `prs check` would find unusual.
Configurations configurations(const ConfigurationQuery& query);

}  // namespace prs
