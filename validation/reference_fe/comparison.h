#pragma once

#include <filesystem>
#include <functional>

#include "prs/model/case.h"

namespace prs::reference_fe {

/// Setup of a curve over the load.
struct Setup {
  int config = 1;  ///< CONFIG 1 to 3.
  Direction direction = Direction::tension;
  Guidance::Kind guidance = Guidance::Kind::both_end_nodes;
  ModelOptions::RollerContacts contacts = ModelOptions::RollerContacts::opposite;

  bool operator==(const Setup&) const = default;
};

/// Words in the file: configuration, direction, guidance, contacts.
std::array<std::string, 4> words(const Setup& setup);
/// `1 tension both_end_nodes opposite`
std::string name(const Setup& setup);

/// One load of a curve. SI units.
struct CurvePoint {
  double load = 0.0;                            ///< [N]
  double displacement = 0.0;                    ///< [m]
  PerInterface<std::vector<double>> load_rate;  ///< Load rates [-], thread 1 first; empty without a result.

  bool is_solved() const { return !load_rate.screw.empty(); }
  double stiffness() const { return load / displacement; }  ///< Secant stiffness [N/m].
};

struct Curve {
  Setup setup;
  std::vector<CurvePoint> points;  ///< Points by ascending load.
};
using Curves = std::vector<Curve>;

/// Reads `curves.csv`, written by curves.py. Every row must be consistent: ascending loads, load rates that sum to 100
/// %, a stiffness that is load over displacement, all within the printed digits; every combination of setups must occur
/// once. Throws input::InputError.
Curves read_curves(const std::filesystem::path& file);

inline double percent(double share) { return share * "%"_per_si; }

/// Half widths of the interval that should contain the true value.
struct ErrorBar {
  double stiffness = 0.0;  ///< Relative half width.
  double load_rate = 0.0;  ///< Half width as a share of the sector load.
};

/// The curves of one model, at the setups and loads of the reference.
struct Model {
  std::string name;
  Curves curves;
};
using Models = std::vector<Model>;

/// The curves of the screw by one model, at the setups and loads of the reference. CONFIG k is the position of the
/// screw's load case `configK-DIRECTION`. A load without a result keeps its entry. Throws CaseError, also if the screw
/// has other threads than the reference.
Curves computed_curves(const Case& screw, ModelOptions::Bodies bodies, const Curves& reference);

/// Discrepancies of the load rates of an interface from the reference's.
struct LoadDiscrepancy {
  // Absolute differences, shares of the sector load.
  double mean = 0.0;
  double largest = 0.0;
  // Differences relative to the thread's own load, as in Abevi 2015 (sections 4.2, 4.3).
  double relative_mean = 0.0;
  double relative_highest = 0.0;
  double relative_lowest = 0.0;
};

struct Discrepancy {
  double stiffness = 0.0;  ///< Relative difference, > 0 if stiffer than the reference.
  PerInterface<LoadDiscrepancy> loads;
};

/// Discrepancy of two points at one load; absent if one of them has no result.
std::optional<Discrepancy> discrepancy(const CurvePoint& point, const CurvePoint& reference);

/// A discrepancy and its place.
struct Extreme {
  double value = 0.0;
  Setup setup;
  double load = 0.0;  ///< [N]
};

/// Statistics of the discrepancies of many points.
struct Summary {
  int points = 0;
  int unsolved = 0;  ///< Number of points without a result.
  double mean_stiffness = 0.0;
  Extreme least_stiff;
  Extreme stiffest;
  PerInterface<double> mean_load;
  PerInterface<double> largest_load;
  Extreme best_loads;  ///< Smallest and largest of the points' largest discrepancies.
  Extreme worst_loads;

  const Extreme& farthest_stiffness() const;
};

using Selection = std::function<bool(const Setup&, double load)>;

/// Compares curves at the same setups and loads.
Summary summary(const Curves& curves, const Curves& reference, const Selection& selection);

}  // namespace prs::reference_fe
