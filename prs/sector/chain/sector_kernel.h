#pragma once

#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/thread_loads.h"
#include "simd/architectures.h"

namespace prs {

/// Sectors of bars with the same number of contacts, each number as a column over the designs. A column of size 0 means
/// zeros.
struct BarDesigns : SectorNumbers<std::vector<double>> {
  struct Flange {
    std::vector<double> from, to, axial_rigidity;
  };

  int contacts = 0;
  std::vector<double> axial_force;         ///< Forces on the whole mechanism [N], > 0.
  std::vector<Flange> flanges;             ///< Flanges; those that a design lacks have from = to.
  std::size_t flange_count = 0;            ///< Number of flanges in use.
  PerInterface<std::vector<double>> gaps;  ///< Gap of thread i of design k at `k * contacts + i`.

  std::size_t size() const { return axial_force.size(); }
};

/// Solves chains. The workspace holds `kStationNumbers` numbers for each contact, times the size of a batch.
struct SectorKernel {
  /// Solves one design per lane; with `scalar` one design after the other.
  template <class Arch>
  void operator()(Arch, bool scalar, const BarDesigns& designs, const fe::NewtonOptions& options, ThreadLoads& results,
                  double* workspace) const;

  /// Solves one load on one sector.
  template <class Arch>
  void operator()(Arch, bool, const ChainSector& sector, double axial_force, const fe::NewtonOptions& options,
                  ThreadLoads& results, double* workspace) const;
};

}  // namespace prs
