#pragma once

#include <string_view>

namespace prs {

/// A model of how screw, roller and nut deform: its words and what it knows, which callers ask for. The table of all
/// models is prs/bodies/body_models.h. Defaults are those of one-dimensional bodies on numbers of the sector
/// (prs/sector/sector_model.h).
struct BodyModel {
  std::string_view name;  ///< Word in files.
  std::string_view help;
  std::string_view bias = {};  ///< How far it is known to be off; empty: not known.
  std::string_view bias_of_all_rollers = bias;
  double least_pitch = 0.0;               ///< Pitch from which it was compared with finite elements [m].
  std::string_view bias_of_finer = bias;  ///< How far it is off with finer ones.

  bool grooves = true;           ///< Threads have roots, walls below them and two contacts on each roller tooth.
  bool effects = false;          ///< `ModelOptions::refined` counts.
  bool meshes = false;           ///< Finite elements, with `ModelOptions::accuracy`, which take long.
  bool masses = false;           ///< Natural modes.
  bool single_roller = true;     ///< A screw that no rollers around it hold in the middle.
  bool straight_rollers = true;  ///< `Roller::rigid_bending`
  bool both_flanks = true;       ///< Both sides of a preloaded nut in one model.
  bool derivatives = true;       ///< Derivatives by the tangent of a sector.
  bool side_by_side = true;      ///< Many designs at once, each of which takes hardly any time.
  bool friction = true;          ///< Loads of a running sector.

  bool all_rollers = true;                  ///< `Mechanism::full`
  bool friction_on_all_rollers = true;      ///< Running loads of the full mechanism.
  bool helical_contacts = true;             ///< `ContactPhase::helical`
  bool loose_guides_of_all_rollers = true;  ///< Guides with a clearance.
};

/// The model of Abevi 2015.
inline constexpr BodyModel kBars{
    .name = "bars",
    .help = "one-dimensional elements, as the paper",
    .bias =
        "17 to 32 % stiffer than finite elements on an inverted 21 x 5 mm screw; nearer: "
        "`model: {bodies: refined}`",
    .bias_of_all_rollers = "all rollers; about as much too stiff as `bars` of a sector",
    .grooves = false,
    .masses = true,
};

/// One dimension, and what bars miss (docs/refined.md).
inline constexpr BodyModel kRefined{
    .name = "refined",
    .help = "one-dimensional elements with what bars miss",
    .bias = "0.4 to 3.4 % stiffer than finite elements on an inverted 21 x 5 mm screw",
    .least_pitch = 1e-3,
    .bias_of_finer = "at 0.4 mm its largest pressures are 10 to 14 % too low",
    .effects = true,
};

}  // namespace prs
