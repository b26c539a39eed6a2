#pragma once

#include "prs/loads/result.h"
#include "prs/record/record.h"

namespace prs {

/// Which model of the bodies the loads were solved with, and what it is known to be off by.
struct ModelSummary {
  const Result* result = nullptr;
};

Record<ModelSummary> record_of(Type<ModelSummary>);

/// The same as a line for the terminal; empty where nothing was solved.
std::string model_line(const Result& result);

}  // namespace prs
