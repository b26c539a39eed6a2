#pragma once

#include <optional>
#include <string_view>

#include "prs/model/body_model.h"

namespace prs {

/// Effects that `kRefined` adds to the bars, each on its own (docs/refined.md).
struct RefinedEffects {
  bool core = true;           ///< Sections at the thread's root, not at the pitch diameter.
  bool shear = true;          ///< Shear in the roller's bending.
  bool hoop = true;           ///< The nut expands radially, as a shell on its hoop foundation.
  bool poisson = true;        ///< Axial stress and radial displacement are coupled.
  bool flange = true;         ///< The nut bends where its section changes and at its shoulder.
  bool radial = true;         ///< Walls of screw, roller and nut yield radially at a thread.
  bool concentration = true;  ///< Contacts are rows of points, not rings.
};

/// Fewest points along each axis of a contact patch for which the sum of its n x n loads is within 1.6 % of the load
/// (Sandu's weights are not normalised): 8 points miss it by 2.6 %, 5 by 6.5 %, one by 91 %, and the lost power
/// likewise. Odd and even numbers are equally good.
inline constexpr int kFewestPatchPoints = 9;

/// Choices of the model.
struct ModelOptions {
  using Bodies = const BodyModel*;  ///< Never null.
  enum class Roller { flexible, rigid_bending };
  /// Loads that slip and all results after it are computed from: a screw at rest, or one that turns with its friction.
  enum class Loads { at_rest, running };
  /// Positions at which the two loaded flanks of a roller tooth meet screw and nut. Half a turn of
  /// a helical roller is half a pitch times its starts, so that with an odd number of starts the
  /// contacts lie opposite each other; those of ring-shaped teeth lie half a pitch apart.
  enum class RollerContacts { opposite, half_pitch_apart };
  /// Deflection of the teeth on top of exact Hertz, which counts it twice: for comparison.
  struct ToothCompliance {
    enum class Kind { none, yamamoto };
    Kind kind = Kind::none;
    double width = 0.0;  ///< Width of thread loaded by a contact [m].
  };
  /// One roller with its share of screw and nut, or all rollers on a spatial screw and nut.
  enum class Mechanism { sector, full };
  /// Positions along the axis at which rollers of a full mechanism touch: all at the same places,
  /// or along the helix.
  enum class ContactPhase { equal, helical };
  /// Meshes of models by finite elements.
  enum class Accuracy { working, reference };

  Mechanism mechanism = Mechanism::sector;
  ContactPhase contact_phase = ContactPhase::equal;
  bool shear = false;  ///< Timoshenko beams in screw, nut and rollers of a full mechanism.
  Bodies bodies = &kBars;
  std::optional<Loads> loads;  ///< If absent: at rest for `solve`, running for slip and life.
  Roller roller = Roller::flexible;
  bool roller_shear = false;                      ///< Timoshenko instead of Euler-Bernoulli beams in the roller.
  std::optional<RollerContacts> roller_contacts;  ///< If absent: by the starts; bars: opposite.
  ToothCompliance tooth_compliance;
  RefinedEffects refined;
  Accuracy accuracy = Accuracy::working;
  int patch_points = 21;  ///< Points along each axis of a contact patch, kFewestPatchPoints or more.

  bool all_rollers() const { return mechanism == Mechanism::full; }
  // These are as `mechanism` has it.
  bool friction() const { return all_rollers() ? bodies->friction_on_all_rollers : bodies->friction; }
  bool side_by_side() const { return !all_rollers() && bodies->side_by_side; }
};

constexpr std::string_view name(ModelOptions::Loads loads) {
  return loads == ModelOptions::Loads::running ? "running" : "static";
}

/// The stated arrangement, else the one of a helical roller.
inline ModelOptions::RollerContacts roller_contacts(const ModelOptions& model, int roller_starts) {
  using enum ModelOptions::RollerContacts;
  return model.roller_contacts.value_or(roller_starts % 2 == 1 ? opposite : half_pitch_apart);
}

/// Name of a model: that of its bodies, or `full` for all rollers.
inline std::string_view name_of_model(const ModelOptions& m) { return m.all_rollers() ? "full" : m.bodies->name; }

/// Extent of a computed result.
enum class Detail {
  complete,
  numbers,  ///< Without warnings and without stresses below the surface, for studies.
};

/// Inputs of the design measures besides the mechanism, its structure and its loads. SI units.
struct MeasureOptions {
  /// Supports of the two ends of the loaded length of the screw.
  enum class Ends {
    fixed_free,
    supported_supported,
    fixed_supported,
    fixed_fixed,
  };
  struct Shaft {
    double length = 0.0;  ///< Largest distance between the supports of the screw [m].
    Ends ends = Ends::supported_supported;
    std::optional<double> stroke = {};               ///< Travel of the nut along the screw [m].
    std::optional<double> largest_compression = {};  ///< Besides those of the loads [N], > 0.
  };

  /// Elements in series with the mechanism between drive and load; an absent one is rigid.
  struct System {
    enum class Axial { one_end, both_ends };  ///< Ends at which axial bearings hold the shaft.
    /// Shaft from the loaded section of the screw to its bearings; unlike `MeasureOptions::shaft`, which is for
    /// buckling and critical speed and has a length of its own.
    struct Shaft {
      double length = 0.0;  ///< L to the one axial bearing, or between the two [m].
      Axial axial = Axial::one_end;
      std::optional<double> from_bearing;    ///< x from the nearer one of two bearings [m].
      std::optional<double> torsion_length;  ///< L_t to the section held against rotation; default L [m].
    };
    std::optional<Shaft> shaft;
    std::optional<double> support_bearing;  ///< Stiffness of all bearings of the shaft together [N/m].
    std::optional<double> housing;          ///< [N/m]
  };

  std::optional<double> loaded_width;          ///< Thread width loaded by one contact, for Yamamoto [m].
  std::optional<double> friction_coefficient;  ///< Coefficient for the estimate of efficiency.
  std::optional<double> yield_strength;        ///< [Pa]
  std::optional<Shaft> shaft;
  std::optional<System> system;
};

/// Axial bearings at the ends of the shaft.
struct Bearings {
  /// Bearing that holds the turning part along its axis, with axial values as makers of screw bearings print them.
  struct Fixed {
    std::optional<double> dynamic_capacity;  ///< C [N]
    std::optional<double> static_capacity;   ///< C_0 [N]
    double preload = 0.0;                    ///< F_V [N]
    std::optional<double> stiffness;         ///< [N/m]
    double exponent = 3.0;                   ///< Exponent p of its life.
  };
  Fixed fixed;
};

}  // namespace prs
