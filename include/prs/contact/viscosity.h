#pragma once

// Viscosity of a lubricant over temperature.
#include "contact/film.h"
