#pragma once

#include "prs/sector/chain/shell_station.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/refined/nut_formulas.h"
#include "simd/architectures.h"

namespace prs {

/// Addresses of the numbers of a refined sector.
struct RefinedSector {
  const SectorNumbers<double>* numbers;
  const RefinedNumbers<double>* bodies;
  const double *sections, *outer_radius, *root;  ///< As in NutLine and NutBore.
  PerInterface<const double*> gaps;              ///< Gaps of each thread.
};

/// Refined sectors with nuts of one shape, each under an axial force.
struct RefinedDesigns {
  std::span<const RefinedSector> sectors;
  std::span<const double> axial_forces;  ///< On the whole mechanism [N], > 0.
  NutShape shape;
  std::span<const int> segment_of;  ///< As in ChainSector.
};

/// Solves refined sectors, each in a lane of its own. The workspace holds `kNumbersOfContact` for
/// each contact, `kNumbersOfNode` for each node of the nut's line, and number of a batch.
struct RefinedKernel {
  using Station = ShellStation<double, ChainSector::Kind::shell>;
  /// Record, segment, support, compliance and gap at screw and nut.
  static constexpr std::size_t kNumbersOfContact =
      (sizeof(fe::ChainRecord<double, Station>) + sizeof(NutSegment<double>) + sizeof(NutSupport<double>)) /
          sizeof(double) +
      4;
  /// Section, outer and root radius, shell.
  static constexpr std::size_t kNumbersOfNode = 3 + sizeof(fe::ShellBlocks<double>) / sizeof(double);

  template <class Arch>
  void operator()(Arch, const RefinedDesigns& designs, const fe::NewtonOptions& options, ThreadLoads& results,
                  double* workspace) const;
};

}  // namespace prs
