#pragma once

#include "fe/newton_types.h"
#include "prs/sector/chain/bar_columns.h"
#include "prs/sector/chain/thread_loads.h"
#include "simd/architectures.h"

namespace prs {

/// Solves all designs, batch after batch; with `scalar` one by one. The workspace holds a record
/// and four numbers for each contact and number of the batch, and the history of `Sweep` where a
/// design has several loads.
struct BarDesignKernel {
  template <class Arch>
  void operator()(Arch, bool scalar, const BarDesigns& designs, const fe::NewtonOptions& options,
                  const ThreadLoads& results, double* workspace) const;
};

}  // namespace prs
