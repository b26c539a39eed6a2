#pragma once

#include "prs/input/study_reader.h"

namespace prs::input {

/// Reads the envelope of a study whose factors have been read, and adds the responses that it needs. Adds an error for
/// each value that does not fit the factors.
void read_envelope(const EnvelopeItem& item, const Node& root, Study& study, ErrorList& errors);

}  // namespace prs::input
