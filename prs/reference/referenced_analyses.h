#pragma once

#include "prs/reference/reference.h"

namespace prs {

/// Analyses whose responses references may have; those of load cases come before others that repeat them.
std::span<const AnyAnalysis> referenced_analyses();

}  // namespace prs
