#pragma once

#include <vector>

#include "prs/model/part.h"

namespace prs {

/// What pushes a roller that runs, in the plane of its axis and the screw's, besides the normal
/// loads of its contacts. x along the axis, y outwards, as the sector has them.
struct RollerPush {
  /// T_x and T_y, friction of each thread on the roller; an equal force acts back on screw or nut
  /// [N].
  PerInterface<std::vector<double>> axial, radial;
  bool per_normal_load = false;  ///< Whether these are T over N [-].
  bool is_trial = false;         ///< Whether it may have no equilibrium: given up early.
  /// m' c Omega^2 of the orbit, outwards, per length of thread and of heads [N/m].
  double of_thread = 0.0, of_heads = 0.0;
};

}  // namespace prs
