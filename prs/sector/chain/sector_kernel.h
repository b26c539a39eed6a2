#pragma once

#include "prs/sector/chain/bar_columns.h"
#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/thread_loads.h"
#include "simd/architectures.h"

namespace prs {

/// Solves chains. The workspace holds `kStationNumbers` for each contact and number of a batch.
struct SectorKernel {
  /// One design a lane; with `scalar` one design after the other.
  template <class Arch>
  void operator()(Arch, bool scalar, const BarDesigns& designs, const fe::NewtonOptions& options,
                  ThreadLoads& results, double* workspace) const;

  /// One load on one sector.
  template <class Arch>
  void operator()(Arch, bool, const ChainSector& sector, double axial_force,
                  const fe::NewtonOptions& options, ThreadLoads& results, double* workspace) const;
};

}  // namespace prs
