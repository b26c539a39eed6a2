#pragma once

#include <string>

#include "prs/configurations/roller_spacing.h"

namespace prs {

/// What is known of a mechanism before it is drawn. SI units.
struct ConfigurationQuery {
  double screw_diameter = 0.0;                   ///< Pitch diameter [m], > 0.
  double lead = 0.0;                             ///< [m], not 0; > 0 right-handed.
  double flank_angle = 0.25 * std::numbers::pi;  ///< alpha_n of all parts [rad].
  std::optional<Mechanism::Type> type;           ///< Absent: both types.
  std::optional<int> screw_starts;               ///< Absent: 3 to 10.
  std::optional<int> roller_starts;              ///< Absent: 1 to 3.
  std::optional<int> rollers;                    ///< Absent: as many as fit.
  double gap = 0.0;  ///< Least gap between the crests of neighbouring rollers [m].
  std::optional<double> roller_profile_radius;  ///< r_BR [m]; absent: arcs about the axis.
};

/// A mechanism whose helix angles and gear ratio agree.
struct Configuration {
  /// Design mode, no backlash; straight screw and nut, convex rollers, sharp threads.
  Mechanism mechanism;
  /// Diameters that follow from the starts (Jung 2017, (2.16), (2.26); Sandu 2018, (1.52), (1.53)):
  /// d_S, d_R, d_N = d_S + 2 d_R [m].
  PerPart<double> rolling_diameter;
  /// Pitch diameters for no backlash [m]: the screw's is corrected in a standard mechanism, the
  /// nut's in an inverted one.
  PerPart<double> pitch_diameter;
  double centre_distance = 0.0;  ///< c [m], for no backlash.
  double gear_ratio = 0.0;       ///< Gamma = n_R/n_S = d_R/d_N or d_R/d_S (2.1).
  PerPart<double> lead;          ///< < 0 left-handed [m].
  PerPart<double> helix_angle;   ///< [rad], sign of the lead.
  int most_rollers = 0;          ///< Most rollers that fit with the gap; any smaller number meshes.
  double crest_gap = 0.0;        ///< Gap between neighbours with mechanism.rollers [m].
  double moderate_force = 0.0;   ///< Axial force for `kModeratePressure` with equal shares [N].
  std::vector<int> alike;        ///< Numbers of rollers that are all assembled at one angle.
  std::vector<GearPair> gears;   ///< Most suitable first.
};

/// Starts that give no sound mechanism, and why.
struct LeftOut {
  Mechanism::Type type = Mechanism::Type::standard;
  Mechanism::Starts starts;
  std::string reason;
  std::string detail;  ///< The reason with its numbers; may be empty.
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
