#pragma once

#include "prs/bodies/body_solver.h"
#include "prs/loads/full_result.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/sector/roller_guides.h"
#include "prs/slip/running_equilibrium.h"
#include "prs/slip/slip_model.h"

namespace prs {

/// Loads of the screw that turns under load: each contact carries its normal load N and the
/// friction that slip finds for it,
///
///     K q + sum B_i' N_i = f + sum_screw -(X_i' T_x,i + Y_i' T_y,i)
///                            + sum_nut    (X_i' T_x,i + Y_i' T_y,i) + f_c,
///     N_i = k_0 <w_i - g_i>^1.5,   T_i = N_i (n - m_i),
///
/// with m of (3.8) on the patch of N_i at the one slip ratio for which the moment on the roller
/// balances (3.38). T_x is Sandu's z component, T_y his x component; what acts along the orbit
/// stays in the balance of slip. Friction turns the force, the approach w is still measured along
/// the true normal: K + B't B stays symmetric with T as a given load.
///
/// A round of slip gives tau_i = T_i/N_i. The loads are solved with T = tau N: by steps with the
/// symmetric tangent, each of which leaves about max |tau| max(tan psi, cot psi) of the error, or by
/// Newton's method with the unsymmetric one (`fe::NewtonSolver::follow`); bodies that cannot follow
/// such loads take given T from step to step, by Anderson's acceleration. Then slip, which the loads
/// hardly change, is evaluated anew.
class RunningSolver {
 public:
  /// The case must have passed the requirements of `slip` and `solve`; contacts and models must be its own.
  RunningSolver(const Conditions& c, const Contacts& contacts, const SlipModels& models)
      : conditions_(c), contacts_(contacts), laws_(contact_laws(c, contacts)), models_(models) {}

  /// A load case with solved shares and all results other than slip; `running` has the outcome of the search, `slip`
  /// the slip if it converged. Under preload with both flanks, for two nuts the slip of the first.
  LoadCaseResult solve(const LoadCase& load_case, Detail detail, std::optional<SlipEquilibrium>& slip);
  /// Slip of the second nut of a double nut, of the last load case.
  const std::optional<SlipEquilibrium>& second_nut() const { return second_nut_; }

  /// A turn of the carrier under a load case on all rollers: each position is an equilibrium with
  /// its own slip ratio.
  Orbit turned(const LoadCase& load_case, const SpatialLoad::Orbit& wanted);

 private:
  struct SectorAt {
    explicit SectorAt(const LoadedSector& of)
        : sector(build_sector(of.model())), bodies(body_solver(of.conditions).running(of)) {
      if (sector.bends() && !sector.has_loose_guides()) guides.emplace(sector);
    }
    Sector sector;
    std::unique_ptr<RunningSector> bodies;
    std::optional<RollerGuides> guides;  ///< None for rollers that stay straight or whose guides have a clearance.
  };

  SectorAt& sector_at(Direction d, double position);
  LoadCaseResult of_sector(const LoadCase& load_case, std::optional<SlipEquilibrium>& slip);
  LoadCaseResult of_flanks(const LoadCase& load_case, std::optional<SlipEquilibrium>& slip);
  LoadCaseResult of_all_rollers(const LoadCase& load_case, Detail detail, std::optional<SlipEquilibrium>& slip);
  struct AllRunning;
  AllRunning all_rollers_at(const LoadCase& load_case, FullSolver& solver);
  /// Adds the loads of the same screw running under symmetric load.
  void set_symmetric(FullLoads& full, LoadCaseResult& result) const;

  const Conditions& conditions_;
  const Contacts& contacts_;
  PerInterface<ContactLaw> laws_;
  const SlipModels& models_;
  std::map<std::pair<Direction, double>, std::unique_ptr<SectorAt>> sectors_;
  std::optional<FlankSolver> flanks_;
  std::optional<SlipEquilibrium> second_nut_;
  SpinOfNuts last_spin_;
};

inline bool is_held(const Conditions& c, const LoadCase& load) { return screw_speed(c, load) == 0.0; }

/// Whether slip takes the loads of the running screw.
inline bool runs(const Conditions& c, const LoadCase& load) {
  return slip_takes_running_loads(c.model, load.share) && !is_held(c, load);
}

/// The conditions with the slip ratios of travels that are `ideal` or `solved` as numbers; none if there are no such
/// travels. Throws CaseError if slip finds none.
std::optional<Conditions> with_slip_ratios(const Conditions& c, const Contacts& contacts);

/// Result of `analyze`, with the loads that `model.loads` selects for `solve`.
Result analyze_loads(const Conditions& c, Contacts contacts, AnalysisOptions options = {});
inline Result analyze_loads(const Case& c, AnalysisOptions options = {}) {
  return analyze_loads(c, checked_contacts(c, options.detail), options);
}

}  // namespace prs
