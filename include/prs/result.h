#pragma once

// Results of a case: loads, pressures, displacement and stiffness of each load case; SI units.
#include "prs/loads/result.h"
