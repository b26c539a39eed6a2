#pragma once

// Elliptic contacts of elastic bodies: `contact::hertz_constants` and `contact::at_load`.
#include "contact/hertz.h"
