#pragma once

#include "prs/model/load_case.h"
#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

template <class T>
struct PerDirection {
  T tension{};
  T compression{};

  T& operator[](Direction d) { return d == Direction::tension ? tension : compression; }
  const T& operator[](Direction d) const { return const_cast<PerDirection&>(*this)[d]; }
};

inline constexpr Direction kDirections[] = {Direction::tension, Direction::compression};

constexpr Direction opposite(Direction d) {
  return d == Direction::tension ? Direction::compression : Direction::tension;
}

/// Ring between the two nuts of a double nut, of the nut's material.
struct Spacer {
  double length = 0.0;          ///< [m]
  double inner_diameter = 0.0;  ///< [m]
  double outer_diameter = 0.0;  ///< [m]
};

/// External axial loads at equal distances, ends included; > 0 in tension [N].
struct LoadSweep {
  double from = 0.0;
  double to = 0.0;
  int steps = 41;
};

/// How a mechanism is rid of its play, and the loads that it is asked about. One of `force`,
/// `interference` and `backlash` is given.
struct Preload {
  enum class Arrangement {
    single_nut,  ///< Rollers wedged in the grooves of screw and nut, on both flanks.
    double_nut,  ///< Two nuts on one screw, each with its rollers, pushed apart by a spacer.
  };

  Arrangement arrangement = Arrangement::single_nut;
  std::optional<double> force;  ///< Axial load of each side without external load [N].
  /// Single nut: pitch diameter of the rollers above the one that just fills the grooves. Double
  /// nut: length of the spacer above the one that just touches [m].
  std::optional<double> interference;
  std::optional<double> backlash;  ///< Axial play in place of preload [m].
  double position = 0.0;           ///< First roller contact on the first nut [m].
  std::optional<Spacer> spacer;    ///< Double nut only.
  std::optional<double> distance;  ///< Last contact of the first nut to the second's first [m].
  LoadSweep load;
  /// With `heat`: the load case at whose steady temperatures the curve holds; the first by default.
  std::optional<std::string> load_case;
  std::optional<double> lost_motion_load;  ///< [N]; `kLostMotionShare` of the largest if absent.
};

/// Share of the largest load of the curve at which the lost motion is read where none is given.
inline constexpr double kLostMotionShare = 0.05;

/// Axial position of the first contact on the second nut of a double nut [m].
inline double second_position(const Mechanism& m, const Structure::Nut& nut,
                              const Preload& preload) {
  const double last = preload.position + (m.contacts_per_roller - 1) * axial_pitch(m);
  return *preload.distance - (nut.length - last) - preload.spacer->length;
}

}  // namespace prs
