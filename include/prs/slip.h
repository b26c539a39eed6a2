#pragma once

// Slip, friction, lost power and efficiency: `prs::analyze_slip`.
#include "prs/slip/slip.h"
#include "prs/slip/slip_at_speed.h"
#include "prs/slip/slip_pictures.h"
