#pragma once

#include "prs/measures/measures.h"
#include "prs/quantities/record.h"

namespace prs {

// With a group, a title, a formula as the meaning, validity and source each.
template <>
Record<Measures> record_of();
template <>
Record<LoadMeasures> record_of();

}  // namespace prs
