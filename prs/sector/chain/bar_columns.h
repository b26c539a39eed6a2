#pragma once

#include <cstddef>
#include <span>

#include "prs/model/part.h"

namespace prs {

/// Designs with the same number of contacts, each quantity as an array over the designs, with the
/// meanings of `BarSector`. An array of size 0 stands for zeros. There are as many designs as loads
/// divided by `loads`, and a result for each load.
struct BarDesigns {
  using Values = std::span<const double>;
  struct Section {
    Values axial, bending, shear;
  };
  struct Flange {
    Values from, to, axial_rigidity;
  };

  int contacts = 0;
  /// Of every design; they are solved one after the other, each from the extrapolation of those
  /// before it as far as they ascend.
  std::size_t loads = 1;
  Values axial_force;  ///< On the whole mechanism, load i of design k at `k * loads + i` [N], > 0.
  Values rollers;
  Values sense;  ///< s, -1 in tension and +1 in compression.
  Values pitch;
  Values screw_rigidity, free_length;
  Section thread, end;
  Values end_length, outer_guide, inner_guide;
  Values rigid_bending;  ///< 1 where v = theta = 0, else 0.
  Values roller_radius;
  Values nut_rigidity, nut_length, thrust, position;
  std::span<const Flange> flanges;  ///< Ones that a design lacks have from = to.
  PerInterface<Values> hertz_constant, cosine, sine, compliance;  ///< Of psi: cosine and sine.
  PerInterface<Values> gaps;  ///< Of thread i of design k at `k * contacts + i`.
};

}  // namespace prs
