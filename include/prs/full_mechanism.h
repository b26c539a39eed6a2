#pragma once

// What a load case on all rollers has besides the loads of its threads: `prs::FullLoads`.
#include "prs/loads/load_case_result.h"
