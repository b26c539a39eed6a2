#pragma once

#include "prs/input/fail_at.h"
#include "prs/input/source.h"
#include "prs/model/case_error.h"

namespace prs::input {

/// Runs `compute` on a case that came from `source`, so that what it finds wrong with the case is
/// reported where it stands.
template <class Compute>
auto compute_from(const Source& source, Compute compute) {
  try {
    return compute();
  } catch (const CaseError& error) {
    fail_at(source, error.path(), error.what());
  }
}

}  // namespace prs::input
