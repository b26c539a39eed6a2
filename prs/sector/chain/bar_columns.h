#pragma once

#include <cstddef>
#include <span>

#include "prs/sector/sector_numbers.h"

namespace prs {

/// Sectors of bars with the same number of contacts, each number as a column of the designs. A
/// column of size 0 stands for zeros. There are as many designs as loads divided by `loads`, and a
/// result for each load.
struct BarDesigns : SectorNumbers<std::span<const double>> {
  using Values = std::span<const double>;
  struct Flange {
    Values from, to, axial_rigidity;
  };

  int contacts = 0;
  /// Of every design; they are solved one after the other, each from the extrapolation of those
  /// before it as far as they ascend.
  std::size_t loads = 1;
  Values axial_force;  ///< On the whole mechanism, load i of design k at `k * loads + i` [N], > 0.
  std::span<const Flange> flanges;  ///< Ones that a design lacks have from = to.
  PerInterface<Values> gaps;        ///< Of thread i of design k at `k * contacts + i`.
};

}  // namespace prs
