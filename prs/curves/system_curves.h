#pragma once

#include "modules/drive/curves.h"
#include "prs/loads/load_analysis.h"

namespace prs {

struct CurveOptions {
  std::optional<double> force = {};           ///< Largest of both senses [N]; else that of the case.
  std::optional<double> speed = {};           ///< Largest of both senses [rad/s]; else that of the case.
  bool speed_along_axis = false;              ///< `speed` is that of the travel [m/s].
  std::optional<std::string> load_case = {};  ///< Else the first whose loads are solved.
};

/// Nodes of one sense, as `PrsBranch` describes them.
struct BranchTable {
  double origin = 0.0;
  bool over_root = false;
  std::vector<double> at, force, slope;

  PrsBranch view() const;
  double deflection(std::size_t node) const;  ///< Magnitude [m].
  double stiffness(std::size_t node) const;   ///< [N/m]
};

/// Torque less force x lead / (2 pi) [N m], a row per speed; empty without friction.
struct FrictionTable {
  std::vector<double> root_force;         ///< Signed root of the force [N^0.5].
  std::vector<double> speed;              ///< Magnitude [rad/s].
  std::vector<double> forward, backward;  ///< Values for both senses of rotation.
};

/// What a model of a system needs of a screw: force over deflection, torque over force and speed.
/// SI units, tension positive. `prs_force` and `prs_torque` evaluate them, here and where they are
/// exported to.
struct SystemCurves {
  std::string load_case;  ///< Whose conditions hold; empty with preload.
  double lead = 0.0;      ///< [m]
  PerDirection<BranchTable> senses;
  FrictionTable friction;
  /// Largest errors between nodes at the last refinement but one: of the largest force, of the
  /// largest stiffness, of the largest torque.
  double force_error = 0.0, stiffness_error = 0.0, torque_error = 0.0;
  std::vector<Warning> warnings;

  /// The curves as the functions of `curves.h` take them; valid as long as this object.
  PrsCurves view() const;
  /// Content of the file `curves.bin`.
  std::vector<double> data() const;
};

/// Nodes of a curve in one sense, at the most.
inline constexpr std::size_t kMostNodes = 800;
/// Errors between nodes that the tables are refined to.
inline constexpr double kForceTolerance = 1e-6, kStiffnessTolerance = 1e-4, kTorqueTolerance = 1e-4;

/// Solves loads of both senses until the curves between them hold the tolerances. With `preload`
/// they are those of `prs preload`, else those of `prs solve` under the conditions of one load
/// case. The case must have passed the requirements of `preload` or `solve`. Throws CaseError where
/// a load does not converge, or friction has no equilibrium.
SystemCurves system_curves(const Case& c, const CurveOptions& options);

}  // namespace prs
