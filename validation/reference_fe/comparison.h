#pragma once

#include <filesystem>
#include <functional>

#include "prs/model/case.h"

namespace prs::reference_fe {

/// What a curve over the load holds fixed.
struct Setup {
  int config = 1;  ///< CONFIG 1 to 3.
  Direction direction = Direction::tension;
  Guidance::Kind guidance = Guidance::Kind::both_end_nodes;
  ModelOptions::RollerContacts contacts = ModelOptions::RollerContacts::opposite;

  bool operator==(const Setup&) const = default;
};

/// Words of the file: configuration, direction, guidance, contacts.
std::array<std::string, 4> words(const Setup& setup);
/// `1 tension both_end_nodes opposite`
std::string name(const Setup& setup);

/// One load of a curve. SI units.
struct CurvePoint {
  double load = 0.0;                            ///< [N]
  double displacement = 0.0;                    ///< [m]
  PerInterface<std::vector<double>> load_rate;  ///< [-], thread 1 first; empty without an answer.

  bool is_solved() const { return !load_rate.screw.empty(); }
  double stiffness() const { return load / displacement; }  ///< Secant [N/m].
};

struct Curve {
  Setup setup;
  std::vector<CurvePoint> points;  ///< By ascending load.
};

/// Reads `curves.csv`, written by curves.py. Every row must be whole: loads that ascend, load rates
/// that sum to 100 %, a stiffness that is load over displacement, all within the printed digits;
/// every combination of setups must stand once. Throws input::InputError.
std::vector<Curve> read_curves(const std::filesystem::path& file);

inline double percent(double share) { return share * per_si::percent; }

/// Half widths of the interval in which the truth should lie.
struct ErrorBar {
  double stiffness = 0.0;  ///< Relative.
  double load_rate = 0.0;  ///< Share of the sector load.
};

/// The curves of one model, at the setups and loads of the reference.
struct Model {
  std::string name;
  std::vector<Curve> curves;
};

/// The curves of the screw by one model, at the setups and loads of the reference. CONFIG k is
/// where the screw's load case `configK-DIRECTION` stands. A load without an answer keeps its
/// place. Throws CaseError, also where the screw has other threads than the reference.
std::vector<Curve> computed_curves(const Case& screw, ModelOptions::Bodies bodies, const std::vector<Curve>& reference);

/// How far the load rates of an interface are from the reference's.
struct LoadDiscrepancy {
  // Absolute differences, shares of the sector load.
  double mean = 0.0;
  double largest = 0.0;
  // Differences over the thread's own load, as Abevi 2015 gives them (sections 4.2, 4.3).
  double relative_mean = 0.0;
  double relative_highest = 0.0;
  double relative_lowest = 0.0;
};

struct Discrepancy {
  double stiffness = 0.0;  ///< Relative, > 0 where stiffer than the reference.
  PerInterface<LoadDiscrepancy> loads;
};

/// Discrepancy of two points at one load; absent where one of them has no answer.
std::optional<Discrepancy> discrepancy(const CurvePoint& point, const CurvePoint& reference);

/// A discrepancy and where it is met.
struct Extreme {
  double value = 0.0;
  Setup setup;
  double load = 0.0;  ///< [N]
};

/// What the discrepancies of many points have in common.
struct Summary {
  int points = 0;
  int unsolved = 0;  ///< Points without an answer.
  double mean_stiffness = 0.0;
  Extreme least_stiff;
  Extreme stiffest;
  PerInterface<double> mean_load;
  PerInterface<double> largest_load;
  Extreme best_loads;  ///< Smallest and largest over the points of a point's largest discrepancy.
  Extreme worst_loads;

  const Extreme& farthest_stiffness() const;
};

using Selection = std::function<bool(const Setup&, double load)>;

/// Compares curves at the same setups and loads.
Summary summary(const std::vector<Curve>& curves, const std::vector<Curve>& reference, const Selection& selection);

}  // namespace prs::reference_fe
