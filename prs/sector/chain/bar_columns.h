#pragma once

#include <cstddef>
#include <vector>

#include "prs/sector/sector_numbers.h"

namespace prs {

/// Sectors of bars with the same number of contacts, each number as a column of the designs. A
/// column of size 0 stands for zeros.
struct BarDesigns : SectorNumbers<std::vector<double>> {
  struct Flange {
    std::vector<double> from, to, axial_rigidity;
  };

  int contacts = 0;
  std::vector<double> axial_force;         ///< On the whole mechanism [N], > 0.
  std::vector<Flange> flanges;             ///< Ones that a design lacks have from = to.
  std::size_t flange_count = 0;            ///< Those in use.
  PerInterface<std::vector<double>> gaps;  ///< Of thread i of design k at `k * contacts + i`.

  std::size_t size() const { return axial_force.size(); }
};

}  // namespace prs
