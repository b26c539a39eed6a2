#pragma once

#include "prs/sector/chain/shell_station.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/refined/nut_formulas.h"
#include "simd/architectures.h"

namespace prs {

/// Pointers to the numbers of a refined sector.
struct RefinedSector {
  const SectorNumbers<double>* numbers;
  const RefinedNumbers<double>* bodies;
  const double *sections, *outer_radius, *root;  ///< Members of NutLine and NutBore.
  PerInterface<const double*> gaps;              ///< Gaps of each thread.
};

/// Refined sectors with nuts of one shape, each under an axial force.
struct RefinedDesigns {
  std::span<const RefinedSector> sectors;
  std::span<const double> axial_forces;  ///< Forces on the whole mechanism [N], > 0.
  NutShape shape;
  std::span<const int> segment_of;  ///< Indices as in ChainSector.
};

/// Solves refined sectors, each in a lane of its own. The workspace holds `kNumbersOfContact` numbers for each contact
/// and `kNumbersOfNode` for each node of the nut's line, times the size of a batch.
struct RefinedKernel {
  using Station = ShellStation<double, ChainSector::Kind::shell>;
  /// Numbers for record, segment, support, compliance and gap at screw and nut.
  static constexpr std::size_t kNumbersOfContact =
      (sizeof(fe::ChainRecord<double, Station>) + sizeof(NutSegment<double>) + sizeof(NutSupport<double>)) /
          sizeof(double) +
      4;
  /// Numbers for section, outer and root radius, shell.
  static constexpr std::size_t kNumbersOfNode = 3 + sizeof(fe::ShellBlocks<double>) / sizeof(double);

  template <class Arch>
  void operator()(Arch, const RefinedDesigns& designs, const fe::NewtonOptions& options, ThreadLoads& results,
                  double* workspace) const;
};

}  // namespace prs
