#pragma once

// Weight, stiffness terms, inertia, buckling, critical speed: `prs::analyze_measures`.
#include "prs/measures/measures.h"
