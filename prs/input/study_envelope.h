#pragma once

#include "prs/input/case_file.h"
#include "prs/input/document.h"

namespace prs::input {

/// Reads the envelope of a study whose factors are read, and adds what it needs to the responses
/// that are recorded. Adds an error for each value that does not suit the factors.
void read_envelope(const EnvelopeItem& item, const Node& root, Study& study, ErrorList& errors);

}  // namespace prs::input
