#pragma once

// Stresses below a contact: `contact::largest_subsurface_shear`.
#include "contact/hertz.h"
