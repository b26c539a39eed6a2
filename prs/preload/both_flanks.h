#pragma once

#include <map>

#include "prs/loads/result.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/sector/roller_guides.h"

namespace prs {

/// Load cases of a mechanism under preload, at rest: both flanks of its threads, or both nuts. The
/// fit is that of `preload.position`, the loads are those at the load case's. The case must have
/// passed `check_case` and the requirements of `preload`.
class FlankSolver {
 public:
  FlankSolver(const Conditions& c, const Contacts& contacts);

  /// Loads of the flank that the direction names, and of the other one. A load of 0 has no
  /// stiffness but the tangent and no shares.
  LoadCaseResult solve(const LoadCase& load_case);

  /// Both sides of the last load case under pushes on the rollers, from the last state on. Those of
  /// a single nut are of one roller: the centrifugal force stands in one of them.
  PreloadPoint go_on(const LoadCase& load_case, const PerDirection<RollerPush>& push);

  /// R_near and R_far of the roller, or of one of each nut, that of the named direction first; none
  /// where rollers stay straight [N].
  std::vector<std::array<double, 2>> guide_forces(const PreloadPoint& point, Direction named,
                                                  const PerDirection<RollerPush>& push) const;

 private:
  struct At {
    PreloadedMechanism mechanism;
    PerDirection<std::optional<RollerGuides>> guides;
  };

  const Conditions& conditions_;
  const Contacts& contacts_;
  PerInterface<ContactLaw> laws_;
  PreloadSectors fitted_at_;  ///< With the fit's first contact.
  Fit fit_;
  std::map<double, At> at_position_;
  At* last_ = nullptr;
  PreloadSolver* solver_ = nullptr;
};

/// The result of a load case from both its sides.
LoadCaseResult both_flanks_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws, PreloadPoint point);

}  // namespace prs
