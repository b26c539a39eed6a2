#pragma once

// Results of a load case on all rollers besides the loads of its threads: `prs::FullLoads`.
#include "prs/loads/load_case_result.h"
