#pragma once

#include <span>

#include "fe/newton_types.h"
#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/thread_loads.h"
#include "simd/architectures.h"

namespace prs {

/// Solves ascending loads on one sector; with `scalar` one after another. Each lane of the batches
/// takes a run of neighbouring loads, so that its start can be extrapolated from those before it.
struct SectorKernel {
  template <class Arch>
  void operator()(Arch, bool scalar, const ChainSector& sector,
                  std::span<const double> axial_forces, const fe::NewtonOptions& options,
                  const ThreadLoads& results, double* workspace) const;
};

}  // namespace prs
