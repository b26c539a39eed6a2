#pragma once

// Weight, stiffness terms, inertia, buckling, critical speed: `prs::analyze_measures`.
#include "prs/measures/analyze_measures.h"
