#pragma once

// Temperatures of the parts: `prs::analyze_heat`.
#include "prs/heat/analyze_heat.h"
