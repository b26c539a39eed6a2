#pragma once

// Springs that push and never pull, force = k approach^1.5: `fe::PowerLawSpring`.
#include "fe/power_law_spring.h"
