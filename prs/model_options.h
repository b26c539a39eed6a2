#pragma once

namespace prs {

/// Choices of the model.
struct ModelOptions {
  /// How screw, roller and nut deform. `bars` is the model of Abevi 2015.
  enum class Bodies { bars };
  enum class Roller { flexible, rigid_bending };
  Bodies bodies = Bodies::bars;
  Roller roller = Roller::flexible;
  bool roller_shear = false;  ///< Timoshenko instead of Euler-Bernoulli beams in the roller.
  int patch_points = 21;      ///< Points along each axis of a contact patch.
};

}  // namespace prs
