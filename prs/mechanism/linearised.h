#pragma once

#include "prs/indices.h"
#include "prs/mechanism/full_distribution.h"

namespace prs {

/// The loaded mechanism as linear springs in place of its contacts.
struct Linearised {
  std::vector<double> tangent;  ///< Tangent stiffness of each spring [N/m].
  std::vector<bool> closed;     ///< Whether it carries a significant load.

  bool all_closed() const { return !contains(closed, false); }
};

/// Linearised mechanism; contacts of idle rollers carry nothing.
Linearised linearised(const FullModel& model, const FullDistribution& d);

}  // namespace prs
