#pragma once

#include "prs/validation/validate.h"

namespace prs::reference_fe {

/// The three models of the bodies against the curves of `data/curves.csv`: discrepancies of
/// stiffness and load rates, statements on them, pictures, and every number thread by thread.
SourceExtension extension();

}  // namespace prs::reference_fe
