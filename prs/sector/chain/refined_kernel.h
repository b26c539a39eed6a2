#pragma once

#include "prs/sector/chain/refined_columns.h"
#include "prs/sector/chain/shell_station.h"
#include "prs/sector/chain/thread_loads.h"
#include "simd/architectures.h"

namespace prs {

/// Solves refined sectors, each in a lane of its own. The workspace holds `kNumbersOfContact` for
/// each contact, `kNumbersOfNode` for each node of the nut's line, and number of a batch.
struct RefinedKernel {
  using Station = ShellStation<double, ChainSector::Kind::shell>;
  /// Record, segment, support, compliance and gap at screw and nut.
  static constexpr std::size_t kNumbersOfContact =
      (sizeof(fe::ChainRecord<double, Station>) + sizeof(NutSegment<double>) +
       sizeof(NutSupport<double>)) /
          sizeof(double) +
      4;
  /// Section, outer and root radius, shell.
  static constexpr std::size_t kNumbersOfNode =
      3 + sizeof(fe::ShellBlocks<double>) / sizeof(double);

  template <class Arch>
  void operator()(Arch, const RefinedDesigns& designs, const fe::NewtonOptions& options,
                  ThreadLoads& results, double* workspace) const;
};

}  // namespace prs
