#pragma once

#include "prs/input/source.h"
#include "prs/record/delivery.h"
#include "prs/record/record.h"

namespace prs {

/// Contents of the document of two cases after its head.
const RecordInfo& case_comparison_record();

/// Two cases side by side: the inputs in which they differ and the numbers of every command for which both have all
/// inputs, with the change from the first to the second; curves of the second in grey behind those of the first. Load
/// cases are paired by their names or, if no names are equal, by index. Throws InputError.
Delivery compare_cases(const input::Source& first, const input::Source& second);

}  // namespace prs
