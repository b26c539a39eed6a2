#pragma once

#include <optional>

#include "contact/lubricant.h"
#include "contact/patch.h"
#include "prs/loads/result.h"
#include "prs/model/case.h"
#include "prs/slip/slip_equilibrium.h"

namespace prs {

/// Builds the models of slip of one case from its contacts and loads. The models refer to the grid
/// in here and to the contacts.
class SlipModels {
 public:
  /// The case must have passed the requirements of `slip`, the contacts must be its own.
  SlipModels(const Conditions& c, const Contacts& contacts);
  SlipModels(const SlipModels&) = delete;
  SlipModels& operator=(const SlipModels&) = delete;

  /// One patch for each thread that carries load; for equal shares one for all.
  SlipModel of(const LoadCaseResult& loaded) const;
  /// One patch that stands for all threads of an interface (Sandu 2018).
  SlipModel equal_shares(const LoadCase& load_case) const;

  const Conditions& conditions() const { return conditions_; }
  /// At operating temperature; absent where the case has none.
  const std::optional<contact::Lubricant>& lubricant() const { return lubricant_; }
  const contact::PatchGrid& grid() const { return grid_; }

 private:
  SlipModel unloaded(const LoadCase& load_case) const;
  void add_patch(SlipModel& model, Interface i, double axial_load) const;

  Conditions conditions_;
  const Contacts& contacts_;
  contact::PatchGrid grid_;
  std::optional<contact::Lubricant> lubricant_;
};

}  // namespace prs
