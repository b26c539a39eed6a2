#pragma once

#include <functional>

#include "modules/drive/curves.h"
#include "prs/loads/load_analysis.h"

namespace prs {

struct CurveOptions {
  std::optional<double> force = {};           ///< Largest force of both senses [N]; default: the case's.
  std::optional<double> speed = {};           ///< Largest speed of both senses [rad/s]; default: the case's.
  bool speed_along_axis = false;              ///< Whether `speed` is that of the travel [m/s].
  std::optional<std::string> load_case = {};  ///< Name; default: the first whose loads are solved.
  std::function<void(std::size_t points)> progress = {};  ///< Called with the number of points that are solved.
};

/// Nodes of one sense, as in `PrsBranch`.
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

/// Data of a screw for system models: force over deflection, torque over force and speed. SI units, tension positive.
/// `prs_force` and `prs_torque` evaluate them, here and in exported models.
struct SystemCurves {
  std::string load_case;  ///< Load case with the conditions; empty with preload.
  double lead = 0.0;      ///< [m]
  PerDirection<BranchTable> senses;
  FrictionTable friction;
  /// Largest errors between nodes at the last refinement but one: of the largest force, of the
  /// largest stiffness, of the largest torque.
  double force_error = 0.0, stiffness_error = 0.0, torque_error = 0.0;
  std::vector<Warning> warnings;

  /// The curves in the form for the functions of `curves.h`; valid as long as this object.
  PrsCurves view() const;
  /// Content of the file `curves.bin`.
  std::vector<double> data() const;
};

/// Largest number of nodes of a curve in one sense.
inline constexpr std::size_t kMostNodes = 800;
/// Errors between nodes to which the tables are refined.
inline constexpr double kForceTolerance = 1e-6, kStiffnessTolerance = 1e-4, kTorqueTolerance = 1e-4;

/// Solves loads of both senses until the curves between them are within the tolerances. With `preload` they are those
/// of `prs preload`, else those of `prs solve` under the conditions of one load case. The case must have passed the
/// requirements of `preload` or `solve`. Throws CaseError if a load does not converge, or friction has no equilibrium.
SystemCurves system_curves(const Case& c, const CurveOptions& options);

}  // namespace prs
