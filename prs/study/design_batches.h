#pragma once

#include "prs/indices.h"
#include "prs/loads/load_case_result.h"
#include "prs/sector/chain/design_solvers.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_designs.h"
#include "prs/threads/contact_batch.h"

namespace prs {

/// Contacts of designs that are found together. Memory is kept from batch to batch.
class SharedContacts {
 public:
  explicit SharedContacts(simd::InstructionSet set) : found_(set) {}

  void clear() { found_.clear(); }
  /// Adds a mechanism and returns its number here; none if it has yet to be designed.
  std::optional<std::size_t> add(const Mechanism& mechanism, const std::optional<Materials>& materials);
  void find() { found_.find(); }
  /// Returns false if `checked_contacts` must find them or gives the reason why there are none.
  bool get(std::optional<std::size_t> k, ContactDetail detail, Contacts& contacts) const;

 private:
  struct Entry {
    Mechanism mechanism;
    contact::MechanismGeometry threads;
  };

  ContactBatch found_;
  std::vector<Entry> entries_;
};

/// Designs of bars whose contacts are found and whose sectors are solved side by side. Only a design's sectors and the
/// inputs of its contacts are kept, not the case. Memory is kept from batch to batch.
class BarBatch {
 public:
  explicit BarBatch(simd::InstructionSet set) : contacts_(set), solver_(set), set_(set) {}

  /// Whether the load cases of a case, by their indices, can be solved this way.
  static bool takes(const Case& c, std::span<const std::size_t> load_cases);

  /// `detail`: contacts needed for the results.
  void clear(ContactDetail detail);
  /// `mechanism`: that of the case with all its radii.
  void add(std::size_t row, const Case& c, const Mechanism& mechanism, std::span<const std::size_t> load_cases);

  /// Calls `take(row, results, contacts)` for each design with the results of its load cases, and `leave(row)` for
  /// those without contacts or equilibrium here.
  template <class Take, class Leave>
  void solve(const LoadDetail& detail, Take take, Leave leave) {
    set_laws();
    solver_.tangent_stiffness = detail.tangent_stiffness;
    if (loads_.size() < forces_.size()) loads_.resize(forces_.size());
    solver_.solve({sectors_.data(), forces_.size()}, forces_, {loads_.data(), forces_.size()});
    for (const Design& design : designs_)
      if (set_results(design, detail))
        take(design.row, results_, found_);
      else
        leave(design.row);
  }

 private:
  struct Design {
    std::size_t row = 0;
    std::size_t contacts = 0;  ///< Index among the found contacts.
    std::size_t first_sector = 0;
    Mechanism mechanism;
    contact::MechanismGeometry threads;
    ContactOverrides overrides;
    PerInterface<ContactLawNumbers> laws;
    std::optional<std::size_t> offsets;  ///< Index, if threads have offsets.
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
  BarDesignSolver solver_;
  simd::InstructionSet set_;
  std::size_t load_cases_ = 0;  ///< Number per design.
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

/// Designs of bars or refined bodies whose contacts are found and whose sectors are solved side by side. A design's
/// inputs of sectors are kept, or all its conditions, from which measures are computed. Memory is kept from batch to
/// batch.
class SectorBatch {
 public:
  struct Design {
    std::size_t row = 0;
    Conditions conditions;
    Contacts contacts;
    std::optional<std::size_t> shared;  ///< Number among the contacts that are found together.
    PerInterface<ContactLaw> laws;
    std::vector<LoadCaseResult> load_cases;  ///< Requested load cases.
    bool complete = false;                   ///< Whether no other solver is needed.
  };

  explicit SectorBatch(simd::InstructionSet set) : contacts_(set), bars_(set), refined_(set), set_(set) {}

  void clear() { used_ = 0, contacts_.clear(); }
  /// `load_cases`: indices, as far as the case has them. Contacts are found together with Detail::numbers, else here:
  /// throws CaseError if there are none.
  void add(std::size_t row, Case& c, const std::vector<std::size_t>& load_cases, bool is_measured, Detail detail);

  /// Calls `take(design)` for each solved design, and `leave(row)` for those without contacts, without a place among
  /// the sectors or without equilibrium here.
  template <class Take, class Leave>
  void solve(ContactDetail detail, bool tangent_stiffness, Take take, Leave leave) {
    if (used_ > 0) solve_sectors(detail, tangent_stiffness);
    for (const auto k : up_to(used_))
      if (designs_[k].complete)
        take(designs_[k]);
      else
        leave(designs_[k].row);
  }

 private:
  /// A waiting sector, and the destination of its result.
  struct Sector {
    std::size_t design = 0;
    std::size_t load_case = 0;  ///< Index among the design's load cases.
  };

  void solve_sectors(ContactDetail detail, bool tangent_stiffness);
  void prepare(std::size_t k, ContactDetail detail);
  bool add_sectors(std::size_t k);

  SharedContacts contacts_;
  BarDesignSolver bars_;
  RefinedDesignSolver refined_;
  simd::InstructionSet set_;
  std::size_t used_ = 0;  ///< Number of designs in use.
  std::vector<Design> designs_;
  std::vector<Sector> sectors_;
  std::vector<SectorModel> models_;  ///< One per sector, as the next two.
  std::vector<double> forces_;
  std::vector<LoadDistribution> loads_;
};

/// Designs of slip with equal shares whose contacts are found and whose rollers are balanced side by side. Neither the
/// case nor its conditions are kept. Memory is kept from batch to batch.
class SlipBatch {
 public:
  explicit SlipBatch(simd::InstructionSet set) : contacts_(set), solver_(set), set_(set) {}

  /// Whether the load cases of a case, by their indices, can be solved together with the waiting ones: all share one
  /// grid of patch points.
  bool takes(const Case& c, std::span<const std::size_t> load_cases) const;

  /// `detail`: contacts needed for the results.
  void clear(ContactDetail detail);
  /// `mechanism`: that of the case with all its radii.
  void add(std::size_t row, const Case& c, const Mechanism& mechanism, std::span<const std::size_t> load_cases);

  /// Calls `take(row, results, contacts)` for each design with the results of its load cases, and `leave(row)` for
  /// those without contacts, with gears that violate (2.14) or without equilibrium here.
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
    std::size_t first_task = 0;  ///< Index of the first of the solver's tasks; one per load case.
  };

  void find();
  bool set_results(const Design& design, const LoadDetail& loads, const SlipDetail& slips);

  ContactBatch contacts_;
  SlipDesignSolver solver_;
  simd::InstructionSet set_;
  ContactDetail detail_ = ContactDetail::laws;
  int patch_points_ = 0;
  std::size_t load_cases_ = 0;  ///< Number per design.
  std::vector<Design> designs_;
  std::vector<SlipModel> models_;        ///< One per design and load case; memory is kept.
  std::vector<double> forces_;           ///< One per load case.
  Contacts found_;                       ///< One design.
  SlipEquilibrium equilibrium_;          ///< One load case.
  std::vector<LoadCaseResult> results_;  ///< One design.
};

}  // namespace prs
