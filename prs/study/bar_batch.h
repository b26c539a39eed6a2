#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "prs/loads/load_case_result.h"
#include "prs/model/case.h"
#include "prs/sector/chain/bar_designs.h"
#include "prs/threads/contact_batch.h"

namespace prs {

/// Designs of bars whose contacts are found and whose sectors are solved side by side. What is kept
/// of a design is its sectors and what its contacts are made of, not the case. Memory stays from
/// batch to batch.
class BarBatch {
 public:
  explicit BarBatch(simd::InstructionSet set) : contacts_(set), set_(set) {}

  /// Whether the load cases of a case, by their indices, can be answered so.
  static bool takes(const Case& c, std::span<const std::size_t> load_cases);

  /// `detail`: what answers need of the contacts.
  void clear(ContactDetail detail);
  /// `mechanism`: that of the case with all its radii.
  void add(std::size_t row, const Case& c, const Mechanism& mechanism,
           std::span<const std::size_t> load_cases);

  /// Calls `take(row, results, contacts)` of each design with the results of its load cases, and
  /// `leave(row)` of those that have no contacts or no equilibrium here.
  template <class Take, class Leave>
  void solve(BarDesignSolver& solver, const LoadDetail& detail, Take take, Leave leave) {
    set_laws();
    solver.tangent_stiffness = detail.tangent_stiffness;
    if (loads_.size() < forces_.size()) loads_.resize(forces_.size());
    solver.solve({sectors_.data(), forces_.size()}, forces_, {loads_.data(), forces_.size()});
    for (const Design& design : designs_)
      if (set_results(design, detail))
        take(design.row, results_, found_);
      else
        leave(design.row);
  }

 private:
  struct Design {
    std::size_t row = 0;
    std::size_t contacts = 0;  ///< Index among those that are found.
    std::size_t first_sector = 0;
    Mechanism mechanism;
    contact::MechanismGeometry threads;
    ContactOverrides overrides;
    PerInterface<ContactLawNumbers> laws;
    std::optional<std::size_t> offsets;  ///< Index, if threads are off their place.
    bool has_contacts = true;
  };
  struct Offsets {
    Deviations deviations;
    Materials materials;
  };

  void set_laws();
  void set_gaps(const Design& design);
  bool set_results(const Design& design, const LoadDetail& detail);

  ContactBatch contacts_;
  simd::InstructionSet set_;
  std::size_t load_cases_ = 0;  ///< Per design.
  std::vector<Design> designs_;
  std::vector<SectorModel> sectors_;        ///< One per design and load case.
  std::vector<double> forces_, positions_;  ///< One per sector in use.
  std::vector<Direction> directions_;
  std::vector<Offsets> offsets_;  ///< Memory is kept.
  std::size_t used_offsets_ = 0;
  ContactDetail detail_ = ContactDetail::laws;
  std::vector<LoadDistribution> loads_;
  Contacts found_;                       ///< One design, as far as results need it.
  std::vector<LoadCaseResult> results_;  ///< One design.
};

}  // namespace prs
