#pragma once

#include "prs/measures/measures.h"
#include "prs/record/record.h"

namespace prs {

// With a group, a title, a formula as the meaning, validity and source each.
Record<Measures> record_of(Type<Measures>);
Record<LoadMeasures> record_of(Type<LoadMeasures>);
Record<SystemStiffness> record_of(Type<SystemStiffness>);
Record<SystemStiffness::Contributions> record_of(Type<SystemStiffness::Contributions>);
Record<SystemStiffness::Contribution> record_of(Type<SystemStiffness::Contribution>);

/// What is computed from the thread loads of a case.
struct Computed {
  bool slip = false, life = false;  ///< By `prs slip` and `prs life`.
  bool static_safety = false;       ///< With the thread loads at the limit.
  bool thread_safety = false;       ///< With those under the load, or at the limit.
  bool thread_loads = false;        ///< Of every load case, by `prs solve`.
};

/// Keys of the measures that are estimates of what is computed. People see them where they ask for
/// all, so that each quantity has one headline.
std::vector<std::string> estimates_beside(const Computed& computed);

}  // namespace prs
