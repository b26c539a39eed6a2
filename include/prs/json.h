#pragma once

// The document of `prs solve --json`: `prs::document_of(prs::solve_analysis(), result, {})` and
// `prs::json_text`.
#include "prs/losses/solve_analysis.h"
