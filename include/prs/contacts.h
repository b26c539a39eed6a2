#pragma once

// Contact points, curvatures and Hertz constants of the threads: `prs::analyze_contacts`.
#include "prs/loads/analyze.h"
