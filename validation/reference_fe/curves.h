#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "prs/model/load_case.h"
#include "prs/model/model_options.h"
#include "prs/model/part.h"
#include "prs/model/structure.h"

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

}  // namespace prs::reference_fe
