#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "prs/loads/load_case_result.h"
#include "prs/model/case.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_designs.h"
#include "prs/threads/contact_batch.h"

namespace prs {

/// Designs of slip with equal shares whose contacts are found and whose rollers are balanced side
/// by side. Neither the case nor its conditions are kept. Memory stays from batch to batch.
class SlipBatch {
 public:
  explicit SlipBatch(simd::InstructionSet set) : contacts_(set), solver_(set), set_(set) {}

  /// Whether the load cases of a case, by their indices, can be answered so together with those
  /// that wait: one grid of patch points serves all.
  bool takes(const Case& c, std::span<const std::size_t> load_cases) const;

  /// `detail`: what answers need of the contacts.
  void clear(ContactDetail detail);
  /// `mechanism`: that of the case with all its radii.
  void add(std::size_t row, const Case& c, const Mechanism& mechanism,
           std::span<const std::size_t> load_cases);

  /// Calls `take(row, results, contacts)` of each design with the results of its load cases, and
  /// `leave(row)` of those that have no contacts, gears that break (2.14) or no equilibrium here.
  template <class Take, class Leave>
  void solve(const LoadDetail& loads, const SlipDetail& slips, Take take, Leave leave) {
    find();
    for (const Design& design : designs_)
      if (set_results(design, loads, slips))
        take(design.row, results_, found_);
      else
        leave(design.row);
  }

 private:
  struct Design {
    std::size_t row = 0;
    Mechanism mechanism;
    contact::MechanismGeometry threads;
    bool is_sound = false;
    std::size_t first_task = 0;  ///< First of the solver's tasks; one per load case.
  };

  void find();
  bool set_results(const Design& design, const LoadDetail& loads, const SlipDetail& slips);

  ContactBatch contacts_;
  SlipDesignSolver solver_;
  simd::InstructionSet set_;
  ContactDetail detail_ = ContactDetail::laws;
  int patch_points_ = 0;
  std::size_t load_cases_ = 0;  ///< Per design.
  std::vector<Design> designs_;
  std::vector<SlipModel> models_;        ///< One per design and load case; memory is kept.
  std::vector<double> forces_;           ///< One per load case.
  Contacts found_;                       ///< One design.
  SlipEquilibrium equilibrium_;          ///< One load case.
  std::vector<LoadCaseResult> results_;  ///< One design.
};

}  // namespace prs
