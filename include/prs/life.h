#pragma once

// Rolling contact fatigue and static safety: `prs::analyze_life`.
#include "prs/life/analyze_life.h"
