#pragma once

// Slip, friction, lost power and efficiency: `prs::analyze_slip`.
#include "prs/slip/slip.h"
