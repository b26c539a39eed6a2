#pragma once

#include "prs/sector/refined/nut_formulas.h"
#include "prs/sector/sector_numbers.h"

namespace prs {

/// Where the numbers of a refined sector stand.
struct RefinedSector {
  const SectorNumbers<double>* numbers;
  const RefinedNumbers<double>* bodies;
  const double *sections, *outer_radius, *root;  ///< As in NutLine and NutBore.
  PerInterface<const double*> gaps;              ///< Of each thread.
};

/// Refined sectors with nuts of one shape, each under an axial force.
struct RefinedDesigns {
  std::span<const RefinedSector> sectors;
  std::span<const double> axial_forces;  ///< On the whole mechanism [N], > 0.
  NutShape shape;
  std::span<const int> segment_of;  ///< As in ChainSector.
};

}  // namespace prs
