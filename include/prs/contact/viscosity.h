#pragma once

// Viscosity of a lubricant over temperature.
#include "contact/viscosity.h"
