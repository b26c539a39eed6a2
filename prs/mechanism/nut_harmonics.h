#pragma once

#include "prs/sector/refined/nut_shell.h"

namespace prs {

/// The nut's wall as it goes out of round, w(x) cos(n phi) and w(x) sin(n phi) alike.
struct NutHarmonic {
  int order = 2;                          ///< n
  std::vector<fe::ShellMatrix> segments;  ///< Of the whole nut, between the nodes of its line.
};

/// Harmonics up to this one: the wall of the screw of lesson 1 dies out over a fifth of its radius
/// beyond.
inline constexpr int kHighestNutHarmonic = 5;

/// Those of n = 2 .. `highest` that equal rollers do not excite, no multiples of their number: what
/// those do is in the sector's model. The ends of the nut, its flanges and its thrust section move
/// freely in them.
std::vector<NutHarmonic> nut_harmonics(const NutLine& line, const NutBore& bore,
                                       const Material& material, int rollers,
                                       int highest = kHighestNutHarmonic);

}  // namespace prs
